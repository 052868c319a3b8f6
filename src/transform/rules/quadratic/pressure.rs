//! Pressures that close: g rational in x², and g = x times odd powers of √(ρ² + σx²).

use super::laurent::{Laurent, Values, Variable};
use super::moments::{Form, Piece};
use super::pieces::Field;
use crate::expr::{Expr, normal};
use crate::transform::{Branches, Pair};
use Variable::{AtEnd, Length, Square};

/// ∫_r^a g′/√(x²−r²) dx for g = x·(moment), where g is a polynomial in 1/s², s² = ρ² + σx².
///
/// With x² = r² + v²: 2k c² T_(k+1) = w/S^(2k) + (2k−1) T_k for T_k = ∫₀ʷ dv/(c²+σv²)^k, c² = Q(r), S² = Q(a), w = √(a²−r²).
pub(super) fn rational(form: &Form, field: &Field) -> Option<Branches> {
    if !form.at(Piece::First).is_zero() || !form.at(Piece::Second).is_zero() {
        return None;
    }
    let sigma = field.sigma;
    // The root at the axis is xρ; one x more makes g of it.
    let slope = form.at(Piece::Root).at_axis().times(Variable::X, 2).times(Length, 1);
    let (mut with_root, mut with_arc) = (Laurent::default(), Laurent::default());
    for (power, coefficient) in slope.in_square(sigma)? {
        if power == 0 {
            continue;
        }
        let k = i64::from(-power);
        if k < 0 {
            return None;
        }
        // (s^(−2k))′ = −2kσ x s^(−2k−2)
        let (root, arc) = arc_moment(k + 1);
        with_root = with_root.plus(&product(&root, &coefficient).scaled(-2 * k * sigma, 1));
        with_arc = with_arc.plus(&product(&arc, &coefficient).scaled(-2 * k * sigma, 1));
    }
    let (w, c) = (leg(), (&field.square_length + Expr::integer(sigma) * Expr::symbol("r").power(2)).sqrt());
    let name = if sigma > 0 { "atan" } else { "atanh" };
    let terms = [expression(&with_root, field) * &w, expression(&with_arc, field) * Expr::call(name, [&w / &c]) / c];
    Some(collected(&terms))
}

/// T_k as multiples of w and of T_1.
fn arc_moment(k: i64) -> (Laurent, Laurent) {
    let (mut root, mut arc) = (Laurent::default(), Laurent::one());
    for own in 1..k {
        let step = |part: &Laurent| part.times(AtEnd, -1).scaled(1, 2 * own);
        root = step(&root.scaled(2 * own - 1, 1).plus(&Laurent::one().times(Square, -own as i32)));
        arc = step(&arc.scaled(2 * own - 1, 1));
    }
    (root, arc)
}

/// ∫_r^a g′/√(x²−r²) dx for g = x·(moment) with the moment A(x²) π/(2ρs) + B(x²) π/2: elliptic integrals and powers.
pub(super) fn elliptic(form: &Form, field: &Field) -> Option<Branches> {
    let sigma = field.sigma;
    let mut total: [Laurent; 3] = std::array::from_fn(|_| Laurent::default());
    let mut add = |n: i64, coefficient: &Laurent| {
        for (own, part) in total.iter_mut().zip(elliptic_moment(n, sigma)) {
            *own = own.plus(&product(&part, coefficient));
        }
    };
    for (power, coefficient) in form.at(Piece::First).at_axis().in_square(sigma)? {
        // (x s^(−n))′ = (1−n) s^(−n) + n ρ² s^(−n−2)
        let n = 1 - 2 * i64::from(power);
        add(n, &coefficient.scaled(1 - n, 1));
        add(n + 2, &coefficient.times(Length, 2).scaled(n, 1));
    }
    let [first, second, root] = &total;
    let (r, a, length) = (Expr::symbol("r"), Expr::symbol("a"), field.square_length.sqrt());
    let at = |end: &Expr| &field.square_length + Expr::integer(sigma) * end.power(2);
    let (angle, parameter) = if sigma > 0 {
        (leg() / at(&r).sqrt(), -(&field.square_length / r.power(2)))
    } else {
        (leg() / at(&a).sqrt(), Expr::one() - &field.square_length / r.power(2))
    };
    let angle = Expr::call("atan", [angle]);
    let factor = Expr::pi() / (Expr::integer(2) * length);
    let mut terms = vec![
        expression(first, field) / &r * Expr::call("ellipf", [angle.clone(), parameter.clone()]) * &factor,
        expression(second, field) * &r * Expr::call("ellipe", [angle, parameter]) * &factor,
        expression(root, field) * &a * leg() / at(&a).sqrt() * &factor,
    ];
    // (x^(2k+1))′ = (2k+1) x^(2k)
    for (power, coefficient) in form.at(Piece::Second).at_axis().in_x()? {
        let moment = Expr::call("pressure_power", [Expr::integer(i64::from(power)), r.clone(), a.clone()]);
        let coefficient = expression(&coefficient, field) * Expr::integer(i64::from(power) + 1) * Expr::pi() / Expr::integer(2);
        terms.push(coefficient * moment);
    }
    Some(collected(&terms))
}

/// E_n = ∫_r^a s^(−n)/√(x²−r²) dx for odd n as multiples of F/r, r E and a w/S.
///
/// n ρ²c² E_(n+2) = (2−n) E_(n−2) + (n−1)(ρ²+c²) E_n − σ a w S^(−n).
fn elliptic_moment(n: i64, sigma: i64) -> [Laurent; 3] {
    let none = Laurent::default;
    let one = [Laurent::one(), none(), none()];
    // E_(−1): c² F/r − r E + a w/S for σ = 1, R² F/r − r E for σ = −1.
    let minus_one = if sigma > 0 {
        [Laurent::one().times(AtEnd, 1), Laurent::ratio(-1, 1), Laurent::one()]
    } else {
        [Laurent::one().times(Length, 2), Laurent::ratio(-1, 1), none()]
    };
    let combine = |(old, p): (&[Laurent; 3], i64), (near, q): (&[Laurent; 3], i64), (own, end): (i64, i64)| {
        let mut next: [Laurent; 3] = std::array::from_fn(|_| none());
        for ((slot, old), near) in next.iter_mut().zip(old).zip(near) {
            let middle = near.times(Length, 2).plus(&near.times(AtEnd, 1));
            *slot = old.scaled(p, 1).plus(&middle.scaled(q, 1));
        }
        if let Some(root) = next.last_mut() {
            // a w S^(−n) = (a w/S) S^(1−n)
            *root = root.plus(&Laurent::ratio(end * sigma, 1).times(Square, ((1 - own) / 2) as i32));
        }
        next
    };
    if n >= 1 {
        let (mut before, mut now) = (minus_one, one);
        for own in (1..n).step_by(2) {
            let next = combine((&before, 2 - own), (&now, own - 1), (own, -1));
            before = std::mem::replace(&mut now, next.map(|part| part.times(Length, -2).times(AtEnd, -1).scaled(1, own)));
        }
        return now;
    }
    let (mut before, mut now, mut own) = (one, minus_one, -1);
    while own > n {
        let far = before.map(|part| part.times(Length, 2).times(AtEnd, 1));
        let next = combine((&far, own), (&now, 1 - own), (own, 1));
        before = std::mem::replace(&mut now, next.map(|part| part.scaled(1, 2 - own)));
        own -= 2;
    }
    now
}

/// The product of a coefficient with one in powers of ρ alone.
fn product(part: &Laurent, factor: &Laurent) -> Laurent {
    factor.monomials().fold(Laurent::default(), |total, (length, number)| total.plus(&part.times(Length, length).times_number(number)))
}

/// √(a² − r²).
fn leg() -> Expr {
    (Expr::symbol("a").power(2) - Expr::symbol("r").power(2)).sqrt()
}

/// With x for a and e for r.
fn expression(part: &Laurent, field: &Field) -> Expr {
    let values = Values { x: Expr::symbol("a"), square_length: field.square_length.clone(), end: Expr::symbol("r"), sigma: field.sigma };
    part.to_expr(&values)
}

fn collected(terms: &[Expr]) -> Branches {
    let (content, rest) = normal::common_content(terms);
    Branches::endless(Pair::same(content * Expr::sum(rest)))
}
