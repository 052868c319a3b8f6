//! The exact pressure of a worn tip on one's own grid: five lines for whoever writes a solver.

use sneddon::scene::{Control, Loads, Quantity, Run, Scene};
use sneddon::{parse, transform::Profile};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let profile = Profile::new(&parse::profile("piecewise(0, r<1/2, (r^2-1/4)/(2*10))")?)?;
    let scene = Scene { effective_modulus: 3.0, control: Control::Force, loads: Loads::List(vec![0.2]), ..Scene::of(profile) };
    let solution = scene.solution()?;
    let run = Run::new(&scene, &solution)?;
    let state = run.state(0, false).ok_or("no valid contact exists for this force")?;
    println!("d = {:?}, a = {:?}, {:?}", state.depth, state.radius, state.boundary);
    let radii: Vec<f64> = (0..10).map(|step| f64::from(step) * 0.1).collect();
    for (r, point) in radii.iter().zip(run.points(Quantity::Pressure, Some(&state), &radii)) {
        match point.value {
            Ok((pressure, error)) => println!("p({r:.1}) = {pressure:?} with an error of at most {error:.1e}"),
            Err(why) => println!("p({r:.1}): {why}"),
        }
    }
    Ok(())
}
