//! Every way to a number alone: whatever it returns, its bound holds, and the answer is that of the way that it names.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::contact::{Contact, ContactError, Quantity, Reason};
use sneddon::expr::{Bindings, Formula};
use sneddon::num::{Bound, Estimate, work};
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Solution, TransformError, WAYS, Way, derive};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::formulas::bindings;
use sneddon_checks::profiles::sample;
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::{cases, takes};
use std::collections::BTreeMap;

const TOLERANCE: f64 = 1e-13;
/// A way alone may cost seconds where the cheapest one costs microseconds.
const MOST_STEPS: u64 = 20_000_000;

fn contact<'a>(solution: &'a Solution, set: &Bindings, method: Method) -> Contact<'a> {
    Contact::new(Evaluator::new(solution, set, method, TOLERANCE).unwrap(), 1.0, None, TOLERANCE)
}

/// What a way returns; `None` where it says that it has no answer, or takes too long.
fn alone(contact: &Contact<'_>, quantity: Quantity, at: f64, radius: f64) -> Option<Estimate> {
    match work::apart(MOST_STEPS, || quantity.number(contact, at, radius)) {
        (Ok(Ok(own)), _, true) => Some(own.estimate),
        (Ok(Err(Reason::Apex | Reason::Kink | Reason::ConcaveApex | Reason::ConcaveKink)), ..) => None,
        (Ok(Err(reason)), _, true) => panic!("{reason:?}"),
        _ => None,
    }
}

/// How far a value moves while its place and the contact radius, decimals in the catalogue, are rounded to doubles.
fn moved(contact: &Contact<'_>, quantity: Quantity, at: f64, radius: f64) -> f64 {
    let value = |at: f64, radius: f64| alone(contact, quantity, at, radius).map_or(f64::NAN, |own| own.value);
    let step = 1e-5;
    let by_place = (value(at * (1.0 + step), radius) - value(at * (1.0 - step), radius)).abs();
    let by_radius = (value(at, radius * (1.0 + step)) - value(at, radius * (1.0 - step))).abs();
    (by_place + by_radius) / (2.0 * step) * 0.51 * f64::EPSILON
}

/// How often each way answered.
#[derive(Default)]
struct Seen(BTreeMap<&'static str, usize>);

impl Seen {
    fn add(&mut self, way: &'static Way, found: Estimate) {
        *self.0.entry(way.key).or_default() += 1;
        // Where f′ is 0 up to the place nothing is computed.
        assert!(found.bound >= way.bound || found == Estimate::exact(0.0).by(way.key), "{} claims more than it may: {found:?}", way.key);
    }
}

/// Against the 40 digits of the catalogue, at its places.
#[test]
fn bounds_hold_over_the_catalogue() {
    let list: serde_json::Value = serde_json::from_str(include_str!("../data/profiles.json")).unwrap();
    let truth: serde_json::Value = serde_json::from_str(include_str!("../data/truth.json")).unwrap();
    let (mut seen, mut faults) = (Seen::default(), Vec::new());
    for (index, item) in list.as_array().unwrap().iter().enumerate() {
        let (id, truth) = (item["id"].as_str().unwrap(), &truth[item["id"].as_str().unwrap()]);
        let number = |text: &str| match parse::profile(text).unwrap() {
            Formula::Closed(expr) => expr,
            other => panic!("{other:?}"),
        };
        let set: Bindings =
            item["params"].as_object().unwrap().iter().map(|(name, own)| (name.as_str(), number(own.as_str().unwrap()))).collect();
        let solution = derive(&Profile::new(&parse::profile(item["f"].as_str().unwrap()).unwrap()).unwrap()).unwrap();
        let a: f64 = truth["a"].as_str().unwrap().parse().unwrap();
        let mut places = vec![(Quantity::Force, a, &truth["F"]), (Quantity::Integral, a, &truth["G"])];
        for (quantity, key) in [(Quantity::Equivalent, "g"), (Quantity::Pressure, "p")] {
            places.extend(truth[key].as_object().unwrap().iter().map(|(at, own)| (quantity, at.parse().unwrap(), own)));
        }
        let auto = contact(&solution, &set, Method::Auto);
        let moved: Vec<f64> = places.iter().map(|(quantity, at, _)| moved(&auto, *quantity, *at, a)).collect();
        for way in WAYS.iter() {
            let contact = contact(&solution, &set, Method::Only(way));
            for (place, ((quantity, at, exact), moved)) in places.iter().zip(&moved).enumerate() {
                if !takes(index + place, 3) {
                    continue;
                }
                let Some(found) = alone(&contact, *quantity, *at, a) else { continue };
                seen.add(way, found);
                let off = Decimal::read(exact.as_str().unwrap()).distance(found.value).abs();
                let within = off <= found.error + moved;
                if !within {
                    faults.push(format!("{id} {quantity:?}({at}) by {}: {found:?}, off by {off:e}", way.key));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    println!("{:?}", seen.0);
    let never: Vec<&str> = WAYS.iter().filter(|way| !seen.0.contains_key(way.key)).map(|way| way.key).collect();
    assert!(never.is_empty(), "{never:?} never answered");
}

/// Class "the double next to a kink": decimals and roots are exact, points are rounded, and a double may lie on either side of the kink c.
///
/// With δ = x − c, f = max(0, r − c)ⁿ has g = n B(n, 1/2) x δ^(n − 1/2)/√(2c) and F/(2E*) = 2c g/2 up to δ/c, and 0 for x < c. The distances are
/// by mpmath.
#[test]
fn doubles_next_to_a_kink_lie_on_their_side_of_it() {
    let places = [
        ("0.3", 0.3, -1.1e-17),
        ("1/3", 1.0 / 3.0, -1.8e-17),
        ("0.1", 0.1, 5.551_115_123_125_783e-18),
        ("sqrt(2)", std::f64::consts::SQRT_2, 9.667_293_313_452_913e-17),
        ("sqrt(10486)", 102.401_171_868_294_55, 1.097_737_112_015_710_2e-18),
        ("sqrt(48007)", 219.104_997_660_938_8, 5.313_353_849_436_471e-19),
    ];
    for (kink, x, distance) in places {
        for (n, factor) in [("1", 2.0), ("1.5", 0.75 * std::f64::consts::PI), ("2", 8.0 / 3.0), ("3", 3.2)] {
            let solution = derive(&Profile::new(&parse::profile(&format!("max(0,r-{kink})^{n}")).unwrap()).unwrap()).unwrap();
            let power = n.parse::<f64>().unwrap() - 0.5;
            let g = if distance < 0.0 { 0.0 } else { factor * x * f64::powf(distance, power) / (2.0 * x).sqrt() };
            let auto = contact(&solution, &Bindings::default(), Method::Auto);
            for (quantity, truth) in [(Quantity::Equivalent, g), (Quantity::Force, 2.0 * x * g)] {
                let answer = alone(&auto, quantity, x, x).unwrap();
                let off = (answer.value - truth).abs();
                // The power is accurate to some units in the last place, and to δ/c.
                assert!(off <= answer.error + 1e-14 * truth && answer.error <= 1e-9 * truth, "{kink} {n}: {answer:?}, {truth:e}");
                for way in WAYS.iter() {
                    let Some(found) = alone(&contact(&solution, &Bindings::default(), Method::Only(way)), quantity, x, x) else { continue };
                    assert!((found.value - truth).abs() <= found.error + 1e-14 * truth, "{kink} {n} {}: {found:?}, {truth:e}", way.key);
                }
            }
        }
    }
}

/// Class "the double next to a kink": a contact that ends within a unit in the last place beyond the kink of a cone has its logarithm.
/// The values are by mpmath with 40 digits, for `max(0, r − 7/3)` and a = 2.333…3335.
#[test]
fn pressures_of_a_contact_that_ends_next_to_a_kink_are_within_their_bounds() {
    let solution = derive(&Profile::new(&parse::profile("max(0,r-7/3)").unwrap()).unwrap()).unwrap();
    let a = 7.0 / 3.0;
    for (r, truth) in [
        (1.166_666_666_666_666_7, 4.140_192_973_869_184e-9),
        (2.333_333_333_333_332_6, 0.137_989_679_454_441_1),
        (2.333_333_333_333_333, 0.209_600_359_139_491_38),
    ] {
        for way in WAYS.iter() {
            let Some(found) = alone(&contact(&solution, &Bindings::default(), Method::Only(way)), Quantity::Pressure, r, a) else {
                continue;
            };
            assert!((found.value - truth).abs() <= found.error + 2.0 * f64::EPSILON * truth, "{r} {}: {found:?}", way.key);
        }
        let answer = alone(&contact(&solution, &Bindings::default(), Method::Auto), Quantity::Pressure, r, a).unwrap();
        assert!(answer.relative_error() < 2e-14, "{r}: {answer:?}");
    }
}

/// Random profiles: no two ways differ by more than their bounds, and the answer lies within those of all.
#[test]
fn no_two_ways_disagree() {
    let (mut seen, mut faults) = (Seen::default(), Vec::new());
    for seed in 0..cases(9, 400) {
        let mut stream = Stream::new(3_100_000 + seed);
        let profile = sample(&mut stream);
        let Ok(formula) = parse::profile(&profile.text) else { continue };
        let set = formula.substitute(&bindings(&profile.values));
        let Ok(solution) = Profile::new(&set).and_then(|profile| derive(&profile)) else { continue };
        let auto = contact(&solution, &Bindings::default(), Method::Auto);
        let end = auto.evaluator().limit().min(3.5);
        let a = stream.short(0.02, 0.98 * end);
        let r = stream.short(0.03 * a, 0.97 * a);
        let alone_by: Vec<_> = WAYS.iter().map(|way| (way, contact(&solution, &Bindings::default(), Method::Only(way)))).collect();
        let places =
            [(Quantity::Profile, r), (Quantity::Equivalent, a), (Quantity::Force, a), (Quantity::Integral, a), (Quantity::Pressure, r)];
        // Of radii the first is the answer, in every way that finds one.
        let depth = alone(&auto, Quantity::Equivalent, 0.5 * a, a).map(|own| (Quantity::Radius, own.value)).filter(|(_, d)| *d > 0.0);
        for (quantity, at) in places.into_iter().chain(depth.filter(|_| seed % 7 == 0)) {
            let Some(answer) = alone(&auto, quantity, at, a) else { continue };
            for (way, contact) in &alone_by {
                let Some(found) = alone(contact, quantity, at, a) else { continue };
                seen.add(way, found);
                let off = (found.value - answer.value).abs();
                let within = off <= found.error + answer.error;
                if !within {
                    faults.push(format!("{profile:?} {quantity:?}({at}), a = {a}, by {}: {found:?} against {answer:?}", way.key));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    println!("{:?}", seen.0);
    // Only the long sample has profiles that are straight between kinks; `straight.rs` has more.
    assert_eq!(seen.0.len(), WAYS.len() - cases(1, 0), "{:?}", seen.0);
}

/// One profile for each way that `auto` may take: it names the way, which gives the same number alone.
#[test]
fn the_answer_is_that_of_the_way_that_it_names() {
    for (text, quantity, at, way) in [
        ("r^2/4", Quantity::Equivalent, 1.0, "doubles"),
        ("r-atan(r)", Quantity::Force, 0.05, "thirty-digits"),
        ("1e-200*r^30", Quantity::Force, 1e10, "wide-exponent"),
        ("r^2/(1+r^4)^3", Quantity::Pressure, 0.3, "legendre"),
        ("ln(1+r^3)", Quantity::Equivalent, 0.5, "gauss"),
        ("max(0,r-0.3)+ln(1+r^3)", Quantity::Force, 0.5, "mixed"),
        ("r^2*besselj(0,r)", Quantity::Pressure, 0.0, "pieces"),
        ("max(0,r-0.3)+abs(r-0.2)", Quantity::Pressure, 0.5, "straight"),
    ] {
        let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
        let auto = alone(&contact(&solution, &Bindings::default(), Method::Auto), quantity, at, 1.0).unwrap();
        assert_eq!(auto.way, way, "{text}: {auto:?}");
        let way = Way::of(way).unwrap();
        let own = alone(&contact(&solution, &Bindings::default(), Method::Only(way)), quantity, at, 1.0).unwrap();
        assert!((own.value - auto.value).abs() <= own.error + auto.error, "{text}: {own:?} against {auto:?}");
    }
}

/// A way that cannot answer says so: another quantity, or no closed form.
#[test]
fn a_way_without_an_answer_is_an_error() {
    let solution = derive(&Profile::new(&parse::profile("ln(1+r^3)").unwrap()).unwrap()).unwrap();
    let by = |key: &str| contact(&solution, &Bindings::default(), Method::Only(Way::of(key).unwrap()));
    let other = by("legendre").force(0.5);
    assert!(matches!(other, Err(ContactError::Transform(TransformError::NoSuchWay { way: "legendre", quantity: "F" }))), "{other:?}");
    // Theory makes the pressure infinite at a pointed apex, and a way that does not compute pressures is refused there as well.
    let cone = derive(&Profile::new(&parse::profile("r").unwrap()).unwrap()).unwrap();
    let apex = contact(&cone, &Bindings::default(), Method::Only(Way::of("gauss").unwrap())).pressure(0.0, 0.9);
    assert!(matches!(apex, Err(ContactError::Transform(TransformError::NoSuchWay { way: "gauss", quantity: "p" }))), "{apex:?}");
    let none = by("doubles").force(0.5);
    assert!(matches!(none, Err(ContactError::Transform(TransformError::NotThisWay { way: "doubles", .. }))), "{none:?}");
    // No search for a radius takes that for a proof that there is none.
    let none = |found| matches!(found, Err(ContactError::Transform(TransformError::NotThisWay { .. })));
    assert!(none(by("doubles").contact_radius(0.5)));
    // Beyond the range of the series there may be roots; the second search knows what stopped the first.
    let series = by("series");
    assert!(series.contact_radius(0.1).is_ok() && none(series.contact_radius(10.0)) && none(series.contact_radius(10.0)));
    // 1 − cos r reaches 0.9 at 1.004… for the first time, and again beyond the next crest.
    let waves = derive(&Profile::new(&parse::profile("1-cos(r)").unwrap()).unwrap()).unwrap();
    let contact = |method| contact(&waves, &Bindings::default(), method).contact_radius(0.9);
    let (first, found) = (contact(Method::Auto).unwrap().estimate, contact(Method::Only(Way::of("series").unwrap())));
    assert!(found.is_err() || found.is_ok_and(|own| (own.estimate.value - first.value).abs() <= own.estimate.error + first.error));
    assert!(Bound::Proven < Bound::Estimated && by("gauss").contact_radius(0.5).is_ok());
}
