//! Coefficients of explicit Runge–Kutta methods.

/// Stage i is taken at node c_i from Σ_j a_ij k_j, the step ends with Σ b_i k_i.
#[derive(Debug)]
pub(crate) struct Tableau {
    /// Order of the step.
    pub(crate) order: u8,
    /// c.
    pub(crate) nodes: &'static [f64],
    /// a, the strictly lower triangle row by row, from the second stage on.
    pub(crate) stages: &'static [&'static [f64]],
    /// b.
    pub(crate) weights: &'static [f64],
    /// b − b̂ of the embedded method of one order less, where there is one. Then the last stage is the end of the step.
    pub(crate) error: &'static [f64],
    /// b − b̂ of embedded methods of orders 5 and 3, by which [`RungeKutta`](super::runge_kutta::RungeKutta) estimates the
    /// error, where there are some.
    pub(crate) embedded: Option<[&'static [f64]; 2]>,
}

impl Tableau {
    /// The method of this order; `None` if there is none here.
    pub(crate) fn of_order(order: u8) -> Option<&'static Self> {
        [&CLASSICAL, &BUTCHER6, &DORMAND_PRINCE8]
            .into_iter()
            .find(|tableau| tableau.order == order)
    }
}

/// The classical method of order 4 (Kutta 1901).
pub(crate) static CLASSICAL: Tableau = Tableau {
    order: 4,
    nodes: &[0.0, 0.5, 0.5, 1.0],
    stages: &[&[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]],
    weights: &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
    error: &[],
    embedded: None,
};

/// Order 5 with an embedded method of order 4 (Dormand & Prince, J. Comput. Appl. Math. 6, 1980, 19–26).
pub(crate) static DORMAND_PRINCE5: Tableau = Tableau {
    order: 5,
    nodes: &[0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0],
    stages: &[
        &[0.2],
        &[3.0 / 40.0, 9.0 / 40.0],
        &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
        &[
            19372.0 / 6561.0,
            -25360.0 / 2187.0,
            64448.0 / 6561.0,
            -212.0 / 729.0,
        ],
        &[
            9017.0 / 3168.0,
            -355.0 / 33.0,
            46732.0 / 5247.0,
            49.0 / 176.0,
            -5103.0 / 18656.0,
        ],
        &[
            35.0 / 384.0,
            0.0,
            500.0 / 1113.0,
            125.0 / 192.0,
            -2187.0 / 6784.0,
            11.0 / 84.0,
        ],
    ],
    weights: &[
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
        0.0,
    ],
    error: &[
        71.0 / 57600.0,
        0.0,
        -71.0 / 16695.0,
        71.0 / 1920.0,
        -17253.0 / 339200.0,
        22.0 / 525.0,
        -1.0 / 40.0,
    ],
    embedded: None,
};

/// Order 6 in seven stages (Butcher 1964; Hairer, Nørsett, Wanner: Solving Ordinary Differential Equations I, II.5).
static BUTCHER6: Tableau = Tableau {
    order: 6,
    nodes: &[0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0, 0.5, 0.5, 1.0],
    stages: &[
        &[1.0 / 3.0],
        &[0.0, 2.0 / 3.0],
        &[1.0 / 12.0, 1.0 / 3.0, -1.0 / 12.0],
        &[-1.0 / 16.0, 9.0 / 8.0, -3.0 / 16.0, -3.0 / 8.0],
        &[0.0, 9.0 / 8.0, -3.0 / 8.0, -3.0 / 4.0, 0.5],
        &[
            9.0 / 44.0,
            -9.0 / 11.0,
            63.0 / 44.0,
            18.0 / 11.0,
            0.0,
            -16.0 / 11.0,
        ],
    ],
    weights: &[
        11.0 / 120.0,
        0.0,
        27.0 / 40.0,
        27.0 / 40.0,
        -4.0 / 15.0,
        -4.0 / 15.0,
        11.0 / 120.0,
    ],
    error: &[],
    embedded: None,
};

/// The method of order 8 in twelve stages of the code DOP853 (Dormand & Prince; Hairer, Nørsett, Wanner: Solving Ordinary
/// Differential Equations I, II.10).
static DORMAND_PRINCE8: Tableau = Tableau {
    order: 8,
    nodes: &[
        0.0,
        0.526001519587677318785587544488e-1,
        0.789002279381515978178381316732e-1,
        0.118350341907227396726757197510,
        0.281649658092772603273242802490,
        1.0 / 3.0,
        0.25,
        4.0 / 13.0,
        127.0 / 195.0,
        0.6,
        6.0 / 7.0,
        1.0,
    ],
    stages: &[
        &[5.26001519587677318785587544488e-2],
        &[
            1.97250569845378994544595329183e-2,
            5.91751709536136983633785987549e-2,
        ],
        &[
            2.95875854768068491816892993775e-2,
            0.0,
            8.87627564304205475450678981324e-2,
        ],
        &[
            2.41365134159266685502369798665e-1,
            0.0,
            -8.84549479328286085344864962717e-1,
            9.24834003261792003115737966543e-1,
        ],
        &[
            1.0 / 27.0,
            0.0,
            0.0,
            1.70828608729473871279604482173e-1,
            1.25467687566822425016691814123e-1,
        ],
        &[
            19.0 / 512.0,
            0.0,
            0.0,
            1.70252211019544039314978060272e-1,
            6.02165389804559606850219397283e-2,
            -9.0 / 512.0,
        ],
        &[
            3.70920001185047927108779319836e-2,
            0.0,
            0.0,
            1.70383925712239993810214054705e-1,
            1.07262030446373284651809199168e-1,
            -1.53194377486244017527936158236e-2,
            8.27378916381402288758473766002e-3,
        ],
        &[
            6.24110958716075717114429577812e-1,
            0.0,
            0.0,
            -3.36089262944694129406857109825,
            -8.68219346841726006818189891453e-1,
            2.75920996994467083049415600797e1,
            2.01540675504778934086186788979e1,
            -4.34898841810699588477366255144e1,
        ],
        &[
            4.77662536438264365890433908527e-1,
            0.0,
            0.0,
            -2.48811461997166764192642586468,
            -5.90290826836842996371446475743e-1,
            2.12300514481811942347288949897e1,
            1.52792336328824235832596922938e1,
            -3.32882109689848629194453265587e1,
            -2.03312017085086261358222928593e-2,
        ],
        &[
            -9.3714243008598732571704021658e-1,
            0.0,
            0.0,
            5.18637242884406370830023853209,
            1.09143734899672957818500254654,
            -8.14978701074692612513997267357,
            -1.85200656599969598641566180701e1,
            2.27394870993505042818970056734e1,
            2.49360555267965238987089396762,
            -3.0467644718982195003823669022,
        ],
        &[
            2.27331014751653820792359768449,
            0.0,
            0.0,
            -1.05344954667372501984066689879e1,
            -2.00087205822486249909675718444,
            -1.79589318631187989172765950534e1,
            2.79488845294199600508499808837e1,
            -2.85899827713502369474065508674,
            -8.87285693353062954433549289258,
            1.23605671757943030647266201528e1,
            6.43392746015763530355970484046e-1,
        ],
    ],
    weights: &[
        5.42937341165687622380535766363e-2,
        0.0,
        0.0,
        0.0,
        0.0,
        4.45031289275240888144113950566,
        1.89151789931450038304281599044,
        -5.8012039600105847814672114227,
        3.1116436695781989440891606237e-1,
        -1.52160949662516078556178806805e-1,
        2.01365400804030348374776537501e-1,
        4.47106157277725905176885569043e-2,
    ],
    error: &[],
    embedded: Some([
        &[
            0.1312004499419488073250102996e-1,
            0.0,
            0.0,
            0.0,
            0.0,
            -0.1225156446376204440720569753e1,
            -0.4957589496572501915214079952,
            0.1664377182454986536961530415e1,
            -0.3503288487499736816886487290,
            0.3341791187130174790297318841,
            0.8192320648511571246570742613e-1,
            -0.2235530786388629525884427845e-1,
        ],
        &[
            5.42937341165687622380535766363e-2 - 0.244094488188976377952755905512,
            0.0,
            0.0,
            0.0,
            0.0,
            4.45031289275240888144113950566,
            1.89151789931450038304281599044,
            -5.8012039600105847814672114227,
            3.1116436695781989440891606237e-1 - 0.733846688281611857341361741547,
            -1.52160949662516078556178806805e-1,
            2.01365400804030348374776537501e-1,
            4.47106157277725905176885569043e-2 - 0.220588235294117647058823529412e-1,
        ],
    ]),
};

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [&Tableau; 4] = [&CLASSICAL, &DORMAND_PRINCE5, &BUTCHER6, &DORMAND_PRINCE8];

    #[test]
    fn nodes_are_sums_of_rows() {
        for tableau in ALL {
            assert_eq!(tableau.nodes.len(), tableau.weights.len());
            assert_eq!(tableau.nodes.len(), tableau.stages.len() + 1);
            for (node, row) in tableau.nodes[1..].iter().zip(tableau.stages) {
                assert!((node - row.iter().sum::<f64>()).abs() < 2e-14);
            }
        }
    }

    /// Σ b c^{k−1} = 1/k up to the order, and not beyond.
    #[test]
    fn quadrature_has_the_order() {
        for tableau in ALL {
            let moment = |k: i32| -> f64 {
                let pairs = tableau.weights.iter().zip(tableau.nodes);
                pairs.map(|(b, c)| b * c.powi(k - 1)).sum::<f64>() - 1.0 / f64::from(k)
            };
            for k in 1..=i32::from(tableau.order) {
                assert!(moment(k).abs() < 1e-14, "{} {k}", tableau.order);
            }
        }
    }

    /// Σ (b − b̂) c^{k−1} = 0 up to the order of the embedded method, and not beyond.
    #[test]
    fn embedded_methods_have_their_orders() {
        let Some(embedded) = DORMAND_PRINCE8.embedded else {
            unreachable!("it has two");
        };
        for (differences, order) in embedded.into_iter().zip([5, 3]) {
            let moment = |k: i32| -> f64 {
                let pairs = differences.iter().zip(DORMAND_PRINCE8.nodes);
                pairs.map(|(b, c)| b * c.powi(k - 1)).sum()
            };
            for k in 1..=order {
                assert!(moment(k).abs() < 1e-14, "{order} {k}: {}", moment(k));
            }
            assert!(moment(order + 1).abs() > 1e-4);
        }
    }
}
