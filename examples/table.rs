//! A profile as a table of points: depth and force of a measured tip.

use sneddon::contact::Contact;
use sneddon::transform::{Interpolation, Profile};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let r: Vec<f64> = (0..10_000).map(|i| 3e-4 * f64::from(i)).collect();
    let z: Vec<f64> = r.iter().map(|r| r.cosh().ln()).collect();
    let tip = Profile::from_points(&r, &z, Interpolation::MonotoneCubic)?;
    let contact = Contact::new(tip, 1.0, None, 1e-12);
    for a in [0.5, 1.0, 2.0] {
        let (d, force) = (contact.depth(a)?.estimate, contact.force(a)?.estimate);
        println!("a = {a}: d = {} ± {:.0e}, F = {} ± {:.0e}", d.value, d.error, force.value, force.error);
    }
    Ok(())
}
