//! Small scenes, one for each kind of structure.
