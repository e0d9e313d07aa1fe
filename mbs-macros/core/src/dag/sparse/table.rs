//! The pattern of an elimination as tables.

use super::Elimination;

/// The pattern, as the runtime reads it.
#[derive(Debug, Clone, Default)]
pub struct Table {
    /// Where each column begins, with its pivot, and where the last one ends.
    pub starts: Vec<u32>,
    /// The position of each slot; of a pivot, that of its column.
    pub positions: Vec<u32>,
    /// Where the list of each position begins in `crossings`, and where the last one ends.
    pub lists: Vec<u32>,
    /// Columns, and slots in them, that stand below a pivot at a position.
    pub crossings: Vec<[u32; 2]>,
    /// 1 for the positions of rows of A.
    pub is_row: Vec<u8>,
}

impl Table {
    /// Of an elimination.
    pub(super) fn of(elimination: &Elimination) -> Table {
        let columns = &elimination.columns;
        let mut table = Table::default();
        let mut lists: Vec<Vec<[u32; 2]>> = vec![Vec::new(); columns.len()];
        for (at, column) in columns.iter().enumerate() {
            table.starts.push(column.pivot as u32);
            table.positions.push(at as u32);
            for (place, &(below, _)) in column.below.iter().enumerate() {
                table.positions.push(below as u32);
                lists[below].push([at as u32, (column.pivot + 1 + place) as u32]);
            }
            table.is_row.push(u8::from(column.is_row));
        }
        table.starts.push(elimination.slots as u32);
        table.lists.push(0);
        for list in lists {
            table.crossings.extend(list);
            table.lists.push(table.crossings.len() as u32);
        }
        table
    }
}
