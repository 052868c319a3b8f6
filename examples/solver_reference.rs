//! Exact reference data for a contact solver: pressure on a grid, in a handful of lines.

use sneddon::contact::Contact;
use sneddon::expr::Bindings;
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, derive};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let profile = Profile::new(&parse::profile("r^2/(2*R)")?)?.substitute(&Bindings::one("R", parse::constant("2")?))?;
    let solution = derive(&profile)?;
    let contact = Contact::new(Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13)?, 1.0, None, 1e-13);
    for i in 0..5 {
        let r = 0.2 * f64::from(i);
        if let Ok(p) = contact.pressure(r, 1.0)? {
            println!("{r:.1} {:.15} ± {:.1e}", p.estimate.value, p.estimate.error);
        }
    }
    Ok(())
}
