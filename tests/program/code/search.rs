//! The search for the contact radius in generated code: steep and slow profiles, kinks, maxima, ends of domains.

use super::{assert_in_c, is_installed, place, run};
use sneddon::code::{Language, program, write};
use sneddon::contact::Quantity;
use sneddon::parse;
use sneddon::transform::{Profile, derive};
use std::fs;

/// At small depths the contact radius of a worn sphere rounds to b, and F(d) = 2 E* b d.
#[test]
fn the_search_ends_at_every_depth() {
    let mut conditions = Vec::new();
    for b in [0.5, 0.5_f64.next_up(), 0.3, 0.3_f64.next_up(), 0.7] {
        for d in [1e-12, 1e-20, 1e-100, 1e-290] {
            let flat = 3.0 * b * d;
            conditions.push(format!("fabs(sneddon_F_of_d({d:e}, 1.5, 1.0, {b:?}) - {flat:e}) < 1e-15*{flat:e}"));
        }
    }
    assert_in_c("search", "piecewise(0, r<b, sqrt(R^2-b^2)-sqrt(R^2-r^2))", &[Quantity::ForceOfDepth], &conditions);
}

/// A depth of 0 has a contact radius only for parameters in their domain.
#[test]
fn the_search_checks_the_parameters_first() {
    let conditions = ["sneddon_a(0.0, 5.0, 0.8) == 0.8", "isnan(sneddon_a(0.0, -5.0, -0.8))", "isnan(sneddon_a(0.0, 5.0, 6.0))"];
    let shape = "piecewise(0, r<b, sqrt(R^2-b^2)-sqrt(R^2-r^2))";
    assert_in_c("parameters", shape, &[Quantity::Radius], &conditions.map(str::to_owned));
}

/// g decreases beyond the kink, where it is 2b²: at smaller depths the contact radius is that of the inner paraboloid, √(d/2).
#[test]
fn the_search_finds_the_root_before_a_kink() {
    let depths = [1e-9, 0.1, 0.3, 0.41, 0.44, 0.47, 0.499];
    let conditions = depths.map(|d| format!("fabs(sneddon_a({d}, 0.5, 0.35) - sqrt({d}/2.0)) < 1e-16"));
    assert_in_c("kink", "piecewise(r^2, r<b, k*(r-b)+b^2)", &[Quantity::Radius], &conditions);
}

/// g has its maximum, 1.1684, just before the end of the profile, where it is 1.1118: depths between them have a contact radius (mpmath).
#[test]
fn the_search_finds_the_root_before_a_maximum_at_the_end() {
    let radii = [(1.11, 1.500601063369778), (1.1388, 1.543155608607756), (1.1649, 1.600092587454632), (1.168, 1.61296406515)];
    let conditions: Vec<String> = radii
        .into_iter()
        .map(|(d, a)| format!("fabs(sneddon_a({d}, 1.7, 0.7, 1.35) - {a:?}) < 1e-13"))
        .chain(["isnan(sneddon_a(1.17, 1.7, 0.7, 1.35))".to_owned()])
        .collect();
    assert_in_c("maximum", "h*(1-(1-r^2/R^2)^p)", &[Quantity::Radius], &conditions);
}

/// Python raises `OverflowError` where a step of the search overflows; the other languages have an infinity there.
///
/// The references are roots by mpmath with 40 digits, of 64/315 x¹⁰ + 35π/96 x⁷ - 3π/20 x³ + x² = 1e98 and of √π h x/w exp(x²/w²) erf(x/w) = 1e290.
#[test]
fn the_search_overflows_in_python() {
    if !is_installed("python3") {
        return;
    }
    let cases = [
        ("polynomial", "r^10/20+r^7/3-r^3/5+r^2/2", "1e98", "7399682026.846388"),
        ("grown", "h*(exp(r^2/w^2)-1)", "1e290, 0.4, 1.3", "33.51993536806811"),
    ];
    for (name, shape, arguments, radius) in cases {
        let solution = derive(&Profile::new(&parse::profile(shape).unwrap()).unwrap()).unwrap();
        let place = place(name);
        fs::write(place.join("a.py"), write(&program(&solution, &[Quantity::Radius], Language::Python, shape).unwrap())).unwrap();
        run("python3", &["-B", "-c", &format!("import a; x = a.a({arguments}); assert abs(x/{radius} - 1.0) < 1e-14, x")], &place);
    }
}

/// At the last double below R, g(a) is 22.892499233290874 within a rounding; mpmath has F = 96.80698970165 there.
#[test]
fn the_search_reaches_the_end_of_the_profile() {
    let (depth, radii) = ("22.892499233290874", "2.114382311559954, 2.1143820299444025");
    let conditions = [
        format!("sneddon_a({depth}, {radii}) == 2.1143823115599535"),
        format!("fabs(sneddon_F_of_d({depth}, 1.0, {radii}) - 96.80698970165) < 1e-9"),
    ];
    let shape = "piecewise(0, r<b, sqrt(R^2-b^2)-sqrt(R^2-r^2))";
    assert_in_c("end", shape, &[Quantity::Radius, Quantity::ForceOfDepth], &conditions);
}

/// At no depth a worn tip touches with its flat, whose radius is b; a sharp one touches at a point.
#[test]
fn the_radius_at_no_depth_is_that_of_the_flat() {
    let flat = ["sneddon_a(0.0, 2.0, 0.75) == 0.75", "sneddon_F_of_d(0.0, 1.0, 2.0, 0.75) == 0.0"].map(str::to_owned);
    let quantities = [Quantity::Radius, Quantity::ForceOfDepth];
    assert_in_c("flat", "piecewise(0, r<b, (r^2-b^2)/(2*R))", &quantities, &flat);
    assert_in_c("point", "r^2/(2*R)", &quantities, &["sneddon_a(0.0, 2.0) == 0.0".to_owned()]);
}

/// Slope angles of π/2 or more are outside the domain, including those with a positive tangent, such as 3.5.
#[test]
fn angles_are_acute() {
    let values = |angle: f64| {
        let calls = [format!("g(1.0, {angle})"), format!("F(1.0, 1.0, {angle})"), format!("F_of_d(1.0, 1.0, {angle})")];
        calls.map(|own| format!("isnan(sneddon_{own})"))
    };
    let quantities = [Quantity::Equivalent, Quantity::Force, Quantity::ForceOfDepth];
    let acute = values(1.5).map(|own| format!("!{own}"));
    let conditions: Vec<String> = acute.into_iter().chain(values(2.0)).chain(values(3.5)).collect();
    assert_in_c("angles", "r*tan(theta)", &quantities, &conditions);
}

/// g = 3π/2 x (1 - J₀(x)) falls beyond x = 4.624, where 1 - J₀ + x J₁ = 0, and rises far out between its waves. A claim beyond the first
/// maximum held at no depth with several contact radii.
#[test]
fn claims_of_contact_radii_end_at_the_first_maximum() {
    for text in ["(r - sin(r))*3", "0.96*(r-sin(r))"] {
        let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
        for quantity in [Quantity::Radius, Quantity::ForceOfDepth] {
            let made = write(&program(&solution, &[quantity], Language::C, text).unwrap());
            let range = made.split("for a from ").nth(1).unwrap();
            let end: f64 = range.split("to ").nth(1).unwrap().split(',').next().unwrap().trim().parse().unwrap();
            assert!((1.0..4.624).contains(&end), "{text} {}: {end}", quantity.key());
        }
    }
}

/// Class "generated code searches differently": radii by mpmath with 40 digits, roots of 2 h x/w D(x/w), of π/2 x L₀(x/c), and of the integral
/// for a rounded edge, which `eval` and Python find as well.
#[test]
fn the_search_finds_the_radii_of_humps_catenaries_and_edges() {
    let near = |call: &str, radius: f64| format!("fabs(sneddon_a({call})/{radius:e} - 1.0) < 1e-14");
    let hump = [near("1.076, 1.0, 0.1", 0.099_982_791_198_995_2), "isnan(sneddon_a(1.3, 1.0, 0.1))".to_owned()];
    assert_in_c("hump", "h*(1-exp(-r^2/w^2))", &[Quantity::Radius], &hump);
    let catenary =
        [("1e-6, 1e-3", 3.162_102_005_203_696e-5), ("1.0, 1e-3", 0.006_424_751_496_558_347), ("1e100, 1e-3", 0.234_903_499_739_970_96)];
    assert_in_c("catenary", "c*(cosh(r/c)-1)", &[Quantity::Radius], &catenary.map(|(call, radius)| near(call, radius)));
    let edge = [near("1e-9, 2e-7, 1e-6", 1.003_552_272_207_992_4e-6)];
    assert_in_c("edge", "piecewise(0,r<b,(r-b)^2/(2*R))", &[Quantity::Radius], &edge);
}

/// Far out, g of a hump is what its terms leave of each other, and no root: humps that never reach the depth have no contact radius, whether
/// g is requested or not.
#[test]
fn humps_have_no_root_far_out() {
    let humps: [(&str, &str, &[&str]); 3] = [
        ("C*r*exp(-r/w)", "1.0, 1.0", &["0.5", "1.01", "3.0"]),
        ("C*r^2*exp(-r^2/w^2)", "0.7, 1.3", &["2.0", "100.0"]),
        ("h*r^2/(r^2+w^2)^2", "1.0, 1.0", &["0.5", "1.0", "1e9"]),
    ];
    for (shape, parameters, depths) in humps {
        for (quantity, modulus) in [(Quantity::Radius, ""), (Quantity::ForceOfDepth, "1.0, ")] {
            let conditions: Vec<String> =
                depths.iter().map(|d| format!("isnan(sneddon_{}({d}, {modulus}{parameters}))", quantity.key())).collect();
            assert_in_c("humps", shape, &[quantity], &conditions);
        }
    }
}

/// The first root is found among waves that are short beside it. The references are roots of h k x π/2 H₀(kx) = d by mpmath with 40 digits,
/// beside a scan of a hundred points per wave.
#[test]
fn the_search_finds_the_first_of_many_waves() {
    let near = |call: &str, value: &str| format!("fabs({call}/{value} - 1.0) < 1e-15");
    let radii = ["sneddon_a(2.0, 0.4, 2.2)", "sneddon_a(3.78, 0.4, 2.2)"];
    let roots = ["6.529048564202900089", "21.00613275622547120"];
    let conditions: Vec<String> = radii.iter().zip(roots).map(|(call, value)| near(call, value)).collect();
    assert_in_c("waves", "h*(1-cos(k*r))", &[Quantity::Radius], &conditions);
    assert_in_c("waves", "h*sin(r/w)^2", &[Quantity::Radius], &[near("sneddon_a(20.0, 1.0, 1.0)", "484.9629460455292738")]);
    let force = near("sneddon_F_of_d(3.78, 1.0, 0.4, 2.2)", "142.3549477076796251");
    assert_in_c("waves", "h*(1-cos(k*r))", &[Quantity::ForceOfDepth], &[force]);
}

/// The smallest positive double is a depth, which g has at the radius that is found.
#[test]
fn the_search_ends_at_the_smallest_depth() {
    let depth = "sneddon_g(sneddon_a(5e-324)) == 5e-324".to_owned();
    assert_in_c("smallest", "r^10/20+r^7/3-r^3/5+r^2/2", &[Quantity::Equivalent, Quantity::Radius], &[depth]);
}
