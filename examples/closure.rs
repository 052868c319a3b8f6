//! A profile as Rust code: force and pressure of a tip f = ln cosh r, which has no closed form.

use sneddon::contact::Contact;
use sneddon::transform::Profile;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let tip = Profile::from_fn(|r| r.cosh().ln()).tolerance(1e-12).profile()?;
    let contact = Contact::new(tip, 1.0, None, 1e-12);
    let a = contact.contact_radius(0.5)?.estimate.value;
    let force = contact.force(a)?.estimate;
    println!("d = 0.5: a = {a}, F = {} ± {:.0e}", force.value, force.error);
    if let Ok(p) = contact.pressure(0.0, a)? {
        println!("p(0) = {} ± {:.0e}", p.estimate.value, p.estimate.error);
    }
    Ok(())
}
