//! The laws that every solved scene keeps, whatever its shape.

use crate::random::Stream;
use crate::scenes::Drawn;
use sneddon::contact::{Boundary, SpringFoundation, State};
use sneddon::expr::Bindings;
use sneddon::num::quadrature::{Options, Panel, Point, integrate};
use sneddon::num::{Bounded, NumError};
use sneddon::scene::{Control, Loads, Quantity, Run, Scene, scene};
use sneddon::transform::{Evaluator, Method, Solution};
use std::f64::consts::{FRAC_PI_2, PI};

/// The laws, and how far a scene may be from each, relative to the value.
pub const LAWS: [(&str, f64); 8] = [
    ("dF/dd = 2E*a", 1e-6),
    ("F = 2π∫p r dr", 1e-7),
    ("f = (2/π)∫g(r sin t) dt", 1e-8),
    ("F = 2E*(a d − ∫g dx)", 1e-9),
    ("lengths and moduli scale", 1e-11),
    ("d and F superpose at equal a", 1e-12),
    ("d and F give a back", 1e-9),
    ("springs", 5e-3),
];

/// The results of all scenes.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    pub scenes: usize,
    /// Rows that were judged invalid; the laws still hold formally.
    pub invalid: usize,
    /// Scenes without a state, or numbers without a reliable digit.
    pub refused: usize,
    /// Per law: how often it was tested, and the largest deviation.
    pub laws: [(usize, f64); LAWS.len()],
    pub faults: Vec<String>,
}

impl Tally {
    pub fn add(&mut self, other: Self) {
        self.scenes += other.scenes;
        self.invalid += other.invalid;
        self.refused += other.refused;
        for (own, more) in self.laws.iter_mut().zip(other.laws) {
            *own = (own.0 + more.0, own.1.max(more.1));
        }
        self.faults.extend(other.faults);
    }

    fn hold(&mut self, law: usize, deviation: f64, said: impl Fn() -> String) {
        let own = &mut self.laws[law];
        *own = (own.0 + 1, own.1.max(deviation));
        if deviation.is_nan() || deviation > LAWS[law].1 {
            self.faults.push(format!("{}: {deviation:.1e} in {}", LAWS[law].0, said()));
        }
    }
}

/// Draws a scene and holds it to every law.
pub fn examine(seed: u64) -> Tally {
    let mut stream = Stream::new(seed);
    let drawn = Drawn::new(&mut stream);
    let mut tally = Tally { scenes: 1, ..Tally::default() };
    let rim = (stream.whole(0, 4) == 0).then(|| drawn.part * stream.short(0.4, 0.9));
    let (text, said) = (drawn.file(None, ""), || drawn.file(rim, ""));
    let own = match scene(&text) {
        Ok(own) => own,
        Err(error) => {
            tally.faults.push(format!("{error} in {text}"));
            return tally;
        }
    };
    if laws(&own, &drawn, &mut tally, &said).is_none() {
        tally.refused += 1;
    }
    if let Some(rim) = rim
        && with_rim(&own, rim / drawn.part, &mut tally, &said).is_none()
    {
        tally.refused += 1;
    }
    tally
}

fn state_of(scene: &Scene) -> Option<(State, bool)> {
    let solution = scene.solution().ok()?;
    let run = Run::new(scene, &solution).ok()?;
    let row = run.row(0)?;
    Some((row.indented.state?, row.is_valid()))
}

fn loaded(scene: &Scene, control: Control, load: f64) -> Scene {
    Scene { control, loads: Loads::List(vec![load]), ..scene.clone() }
}

fn laws(scene: &Scene, drawn: &Drawn, tally: &mut Tally, said: &impl Fn() -> String) -> Option<()> {
    let solution = scene.solution().ok()?;
    let run = Run::new(scene, &solution).ok()?;
    let row = run.row(0)?;
    let state = row.indented.state?;
    tally.invalid += usize::from(!row.is_valid());
    let modulus = scene.effective_modulus;
    if state.force <= 0.0 {
        return Some(());
    }
    if let Some(deviation) = stiffness(scene, &state) {
        tally.hold(0, deviation, said);
    }
    tally.hold(1, (force_of_pressure(&run, &state, &breakpoints(&solution, state.radius)?)? / state.force - 1.0).abs(), said);
    let g = |x: f64| height(&run, Quantity::Equivalent, x);
    let f = height(&run, Quantity::Profile, state.radius);
    let edges: Vec<f64> = std::iter::once(0.0).chain(breakpoints(&solution, state.radius)?).collect();
    let last = edges.last().copied()?;
    let back = panels(&edges, state.radius, |x| {
        // Only in the last panel is the upper end a itself.
        let rest = if x.x > last { x.from_upper } else { state.radius - x.x };
        g(x.x) / (rest * (state.radius + x.x)).sqrt()
    })? * 2.0
        / PI;
    let scale = f.abs().max(1e-3 * state.depth);
    tally.hold(2, (back - f).abs() / scale, said);
    let area = panels(&edges, state.radius, |x| g(x.x))?;
    tally.hold(3, (2.0 * modulus * (state.radius * state.depth - area) / state.force - 1.0).abs(), said);
    scaled(drawn, scene, &state, tally, said);
    superposed(drawn, scene, &state, tally, said);
    if row.is_valid() {
        for (control, load) in [(Control::Depth, state.depth), (Control::Force, state.force)] {
            let (again, _) = state_of(&loaded(scene, control, load))?;
            tally.hold(6, (again.radius / state.radius - 1.0).abs(), said);
        }
        springs(&g, state.radius, &state, modulus, tally, said);
    }
    Some(())
}

/// f or g in computed units.
fn height(run: &Run<'_>, curve: Quantity, at: f64) -> f64 {
    run.points(curve, None, &[at])
        .first()
        .map_or(f64::NAN, |own| own.value.map_or(f64::NAN, |(value, _)| value / run.scene().system.out(curve.dimension())))
}

/// (F(a₊) − F(a₋))/(d(a₊) − d(a₋)) against 2E*a, at two steps: what does not shrink with the step is a fault.
fn stiffness(scene: &Scene, state: &State) -> Option<f64> {
    let deviation = |step: f64| {
        let at = |a: f64| state_of(&loaded(scene, Control::ContactRadius, a)).map(|(state, _)| state);
        let (up, down) = (at(state.radius * (1.0 + step))?, at(state.radius * (1.0 - step))?);
        let slope = (up.force - down.force) / (up.depth - down.depth);
        Some((slope / (2.0 * scene.effective_modulus * state.radius) - 1.0).abs())
    };
    let (wide, narrow) = (deviation(1e-3)?, deviation(1e-4)?);
    Some(if narrow < 0.2 * wide { wide.min(narrow).min(1e-7) } else { narrow })
}

/// 2π∫p r dr = 2π a² ∫ p sin t cos t dt, with panels at the breakpoints.
fn force_of_pressure(run: &Run<'_>, state: &State, breaks: &[f64]) -> Option<f64> {
    let a = state.radius;
    let edges: Vec<f64> = std::iter::once(0.0).chain(breaks.iter().map(|b| (b / a).asin())).collect();
    let value = |t: Point| {
        let (sine, cosine) = (t.x.sin(), t.x.cos());
        run.points(Quantity::Pressure, Some(state), &[a * sine])
            .first()
            .map_or(f64::NAN, |own| own.value.map_or(f64::NAN, |(p, _)| p * sine * cosine))
    };
    let factor = run.scene().system.out(Quantity::Pressure.dimension());
    Some(2.0 * PI * a * a * panels(&edges, FRAC_PI_2, value)? / factor)
}

/// The breakpoints of the profile below `a`.
fn breakpoints(solution: &Solution, a: f64) -> Option<Vec<f64>> {
    Evaluator::new(solution, &Bindings::default(), Method::Auto, 1e-12).ok().map(|own| own.breakpoints_below(a))
}

fn panels(edges: &[f64], end: f64, value: impl Fn(Point) -> f64) -> Option<f64> {
    let ends: Vec<f64> = edges.iter().copied().chain([end]).collect();
    let list: Vec<Panel> = ends.windows(2).map(|pair| Panel::singular(pair[0], pair[1])).collect();
    let options = Options { rel_tol: 1e-9, charge_x: false, max_evaluations: 4000, ..Options::default() };
    let mut inside = |point: Point| {
        let own = value(point);
        // A node that rounding moved onto an end weighs nothing.
        Bounded::exact(if own.is_finite() { own } else { 0.0 })
    };
    match integrate(&mut inside, &list, &options) {
        Ok(found) => Some(found.value),
        // Noise of the values may keep a law's quadrature from its tolerance, which is at most that of the law.
        Err(NumError::ToleranceNotReached { value, error, .. } | NumError::EvaluationLimit { value, error, .. })
            if error < 1e-7 * value.abs() =>
        {
            Some(value)
        }
        Err(_) => None,
    }
}

/// Lengths a thousand times as long and moduli eight times as large: a force 8·10⁶ times as large, to the rounding of the
/// numbers.
fn scaled(drawn: &Drawn, first: &Scene, state: &State, tally: &mut Tally, said: &impl Fn() -> String) {
    let Ok(own) = scene(&drawn.file_of_longer()) else {
        tally.faults.push(format!("longer lengths are refused in {}", said()));
        return;
    };
    if let Some((again, _)) = state_of(&Scene { effective_modulus: 8.0 * first.effective_modulus, ..own }) {
        tally.hold(4, (again.force / (8e6 * state.force) - 1.0).abs().max((again.depth / (1e3 * state.depth) - 1.0).abs()), said);
    }
}

fn superposed(drawn: &Drawn, first: &Scene, state: &State, tally: &mut Tally, said: &impl Fn() -> String) {
    let read = |text: String| scene(&text).ok().map(|own| Scene { effective_modulus: first.effective_modulus, ..own });
    let (Some(both), Some(second)) = (read(drawn.file(None, &drawn.other)), read(drawn.file_of_other())) else {
        tally.faults.push(format!("a second body is refused in {}", said()));
        return;
    };
    let radius = |own: &Scene| state_of(&loaded(own, Control::ContactRadius, state.radius)).map(|(state, _)| state);
    if let (Some(both), Some(second)) = (radius(&both), radius(&second)) {
        let sum = (state.force + second.force, state.depth + second.depth);
        tally.hold(5, (both.force / sum.0 - 1.0).abs().max((both.depth / sum.1 - 1.0).abs()), said);
    }
}

/// A few hundred springs: the error of their sum falls with the square of the spacing and, because of the edge, with the power 3/2 of the spacing.
fn springs(g: &impl Fn(f64) -> f64, reach: f64, state: &State, modulus: f64, tally: &mut Tally, said: &impl Fn() -> String) {
    if let Ok(foundation) = SpringFoundation::new(g, reach, 600, modulus) {
        let found = foundation.indent(state.depth);
        tally.hold(7, (found.force / state.force - 1.0).abs(), said);
    }
}

/// A cylinder pressed beyond g(c): F grows by 2E*c per depth, p gains its edge, and the sum of both is the force.
fn with_rim(smooth: &Scene, part: f64, tally: &mut Tally, said: &impl Fn() -> String) -> Option<()> {
    let (state, _) = state_of(smooth)?;
    let c = part * state.radius;
    let own = Scene { rim: Some(c), ..loaded(smooth, Control::Depth, state.depth) };
    let (pressed, _) = state_of(&own)?;
    if pressed.boundary != Boundary::Rim || pressed.force <= 0.0 {
        return Some(());
    }
    let deeper = state_of(&loaded(&own, Control::Depth, 1.5 * state.depth))?.0;
    let slope = (deeper.force - pressed.force) / (deeper.depth - pressed.depth);
    tally.hold(0, (slope / (2.0 * own.effective_modulus * c) - 1.0).abs(), said);
    let solution = own.solution().ok()?;
    let run = Run::new(&own, &solution).ok()?;
    tally.hold(1, (force_of_pressure(&run, &pressed, &breakpoints(&solution, c)?)? / pressed.force - 1.0).abs(), said);
    let g = |x: f64| height(&run, Quantity::Equivalent, x);
    springs(&g, c, &pressed, own.effective_modulus, tally, said);
    Some(())
}
