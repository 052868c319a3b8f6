//! Taylor series of I_0 − L_0 about tabulated points, between the reach of the difference and of the asymptotic series.

use crate::double_double::{DoubleDouble, Precise, words};
use crate::special::carried::{TWO_OVER_PI, UNIT, multiple, quotient};

/// K = I_0 − L_0 and its derivative K′ = I_1 − L_(−1) = I_1 − L_1 − 2/π, for 4 <= z <= 82.
///
/// z K″ + K′ − z K = −2/π gives the Taylor coefficients (DLMF 11.2.9). Steps are at most 15 % of z.
pub(crate) fn difference_pair(z: DoubleDouble) -> (Precise, Precise) {
    let near = |anchor: &&(f64, DoubleDouble, DoubleDouble)| (anchor.0 - z.hi).abs() / anchor.0;
    let Some((at, value, slope)) = ANCHORS.iter().min_by(|a, b| near(a).total_cmp(&near(b))) else {
        return (Precise::nan(), Precise::nan());
    };
    let h = z.sub((*at).into());
    let scale = DoubleDouble::ONE.div((*at).into());
    // c_(m+2) = (z c_m + c_(m−1) − (m+1)² c_(m+1) − (2/π) δ_(m0)) / (z (m+1)(m+2)).
    let (mut before, mut now, mut next) = (DoubleDouble::from(0.0), *value, *slope);
    let (mut power, mut sum, mut derivative) = (DoubleDouble::ONE, *value, *slope);
    for m in 0..200_u32 {
        let m = f64::from(m);
        let mut top = multiple(now, *at).add(before).sub(multiple(next, (m + 1.0) * (m + 1.0)));
        if m == 0.0 {
            top = top.sub(TWO_OVER_PI);
        }
        let after = quotient(top.mul(scale), (m + 1.0) * (m + 2.0));
        power = power.mul(h);
        sum = sum.add(next.mul(power));
        derivative = derivative.add(multiple(after.mul(power), m + 2.0));
        if (after.hi * power.hi * (m + 2.0)).abs() < 1e-37 && m > 4.0 {
            break;
        }
        (before, now, next) = (now, next, after);
    }
    // The roundings of the coefficients grow as I_0 does; measured below an eighth of this.
    let growth = UNIT * 64.0 * h.hi.abs().exp();
    (Precise { value: sum, error: growth * sum.hi.abs() }, Precise { value: derivative, error: growth * derivative.hi.abs() })
}

/// z, (I_0 − L_0)(z) and its derivative, to 32 digits.
const ANCHORS: [(f64, DoubleDouble, DoubleDouble); 14] = [
    (4.0, words(0.170_871_748_887_747_06, 5.110_436_589_526_719_5e-18), words(-0.046_432_430_401_816_17, -6.387_414_947_096_723e-19)),
    (5.0, words(0.133_954_697_046_300_34, 5.183_239_229_291_847e-18), words(-0.029_193_410_325_336_59, 7.399_430_826_668_273e-19)),
    (6.25, words(0.105_242_217_146_318_39, -4.918_566_277_462_471_5e-18), words(-0.018_021_917_108_167_248, -1.586_825_594_694_866_7e-18)),
    (7.75, words(0.083_815_980_753_142_66, 1.421_237_212_044_489_4e-18), words(-0.011_318_168_317_414_966, 2.049_935_489_075_739e-20)),
    (9.75, words(0.066_073_624_687_343_49, -5.644_851_201_338_131_5e-18), words(-0.006_959_811_500_472_74, -2.202_758_596_886_395e-19)),
    (12.0, words(0.053_449_421_441_089_58, 2.213_290_691_882_650_6e-18), words(-0.004_526_619_618_483_696_5, 4.115_375_015_581_226e-19)),
    (15.0, words(0.042_638_635_513_618_475, -1.712_901_821_909_993_3e-18), words(-0.002_870_250_635_171_291, 8.503_040_274_765_452e-20)),
    (
        19.0,
        words(0.033_601_623_083_346_355, -1.976_986_217_490_560_7e-18),
        words(-0.001_778_828_096_479_661_8, -2.389_028_531_234_183_6e-20),
    ),
    (
        24.0,
        words(0.026_572_629_567_123_283, -1.045_857_334_042_286_8e-20),
        words(-0.001_111_159_388_291_990_8, 4.477_809_017_592_264_5e-20),
    ),
    (
        30.0,
        words(0.021_244_480_317_825_293, -1.063_366_860_208_350_4e-18),
        words(-0.000_709_754_100_610_239_9, -4.481_886_854_449_494_4e-20),
    ),
    (37.0, words(0.017_218_592_239_642_973, 1.453_010_433_927_562_6e-18), words(-0.000_466_055_912_726_300_1, 1.022_068_911_791_323_9e-20)),
    (46.0, words(0.013_846_128_858_843_839, 1.844_165_381_454_628_3e-19), words(-0.000_301_289_631_274_675_1, 2.321_113_298_405_672_3e-20)),
    (57.0, words(0.011_172_215_134_825_537, -4.819_221_361_664_632e-19), words(-0.000_196_125_068_013_417_47, -6.298_964_975_662_419e-21)),
    (71.0, words(0.008_968_257_568_404_72, 6.805_952_653_467_841e-20), words(-0.000_126_363_771_635_571_73, -7.855_742_730_173_852e-21)),
];
