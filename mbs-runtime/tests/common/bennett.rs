//! A Bennett linkage by bodies, in the coordinates that a test asks for.

macro_rules! bennett {
    ($coordinates:ident) => {
        ::mbs_runtime::mechanism!(Bennett {
            doc: "Four bodies in a loop that only its special axes let move: three of its rows follow from the others.",
            world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = $coordinates),
            one: Body(
                mass = 1.0_kg,
                inertia = diag(0.02, 0.03, 0.025),
                at = [0.043412044416732604, 0.24620193825305201, 0.0]
            ),
            two: Body(
                mass = 1.0_kg,
                inertia = diag(0.02, 0.03, 0.025),
                at = [-0.10490018406208018, 0.20384099094128061, 0.116385746205799]
            ),
            three: Body(
                mass = 1.0_kg,
                inertia = diag(0.02, 0.03, 0.025),
                at = [
                    -0.51378777849919866,
                    -0.042360947311771251,
                    0.116385746205799
                ]
            ),
            j0: Revolute(ground, one, at = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 1]),
            j1: Revolute(
                one,
                two,
                at = [0.086824088833465207, 0.49240387650610401, 0.0],
                axis = [
                    0.63302222155948895,
                    -0.11161889704894969,
                    0.76604444311897801
                ]
            ),
            j2: Revolute(
                two,
                three,
                at = [
                    -0.29662445695762557,
                    -0.084721894623542793,
                    0.232771492411598
                ],
                axis = [
                    -0.31845015678697797,
                    0.52887609041857986,
                    0.78668899739726061
                ]
            ),
            j3: Revolute(
                ground,
                three,
                at = [-0.73095110004077168, 2.9143354396410359e-16, 0.0],
                axis = [
                    4.4408920985006262e-16,
                    0.93969262078590832,
                    0.34202014332566882
                ]
            ),
        });
    };
}
pub(crate) use bennett;
