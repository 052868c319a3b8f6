//! Creates a commented scene file for a named shape.

use crate::scene::Shape;
use std::fmt::Write;

/// Returns the text of a scene file in which every key is explained.
///
/// ```
/// let text = sneddon::scene::template(sneddon::scene::shape("sphere").unwrap());
/// assert!(text.contains("shape = \"sphere\""));
/// ```
pub fn template(shape: &Shape) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write(shape, &mut text);
    text
}

fn write(shape: &Shape, out: &mut String) -> std::fmt::Result {
    writeln!(out, "# A contact scene: {}.", shape.title)?;
    writeln!(out, "# Source: {}.", shape.source)?;
    writeln!(out, "# Either all numbers have units or none has; without units, all numbers are in one consistent system.\n")?;
    writeln!(out, "[profile]")?;
    writeln!(out, "shape = \"{}\"", shape.name)?;
    for (index, way) in shape.ways.iter().enumerate() {
        let list: Vec<String> = way
            .parameters
            .iter()
            .map(|own| {
                if own.example.contains(' ') {
                    format!("{} = \"{}\"", own.name, own.example)
                } else {
                    format!("{} = {}", own.name, own.example)
                }
            })
            .collect();
        writeln!(out, "{}f(r) = {}", if index == 0 { "# " } else { "# or: " }, way.f)?;
        for own in way.parameters {
            writeln!(out, "#   {}: {}", own.name, own.meaning)?;
        }
        if list.is_empty() {
            continue;
        }
        writeln!(out, "{}parameters = {{ {} }}", if index == 0 { "" } else { "# " }, list.join(", "))?;
    }
    match shape.rim {
        Some(name) => writeln!(out, "# {name} is also the radius of the vertical side and may be given as radius = … instead.\n")?,
        None => writeln!(out, "# radius = \"5 um\"   # radius of a vertical side; without it the profile has no edge\n")?,
    }
    out.push_str(
        "# Material of the half-space: Young's modulus and Poisson's ratio, or effective_modulus, or C11 C12 C13 C33 C44.
[material]
E = \"72 GPa\"
nu = 0.17

# The counterbody is rigid unless it has elastic constants; it may also have a shape.
# [counterbody]
# E = \"210 GPa\"
# nu = 0.3

# One of depth, force and contact_radius: a number, a list, or a range.
[load]
",
    );
    let depths = if shape.name == "concave-paraboloid" { ("0.2 um", "0.4 um") } else { ("10 nm", "80 nm") };
    writeln!(out, "depth = {{ start = \"{}\", stop = \"{}\", count = 8 }}   # spacing = \"log\"", depths.0, depths.1)?;
    writeln!(out, "# depth_from = \"first_touch\"   # instead of the displacement at r = 0; the two differ for concave shapes\n")?;
    out.push_str(
        "# Numbers per load: d F a k p_mean U. Curves per load: g f p u at the radii `at`, and sigma_zz on the axis at `depths`.
[outputs]
quantities = [\"F\", \"a\", \"k\"]
# at = { start = \"0 um\", stop = \"2 um\", count = 101 }
# depths = { start = \"0 um\", stop = \"5 um\", count = 101 }
units = { length = \"um\", force = \"mN\", pressure = \"GPa\" }

# [method]
# name = \"auto\"        # exact, quadrature
# tolerance = 1e-12
",
    );
    Ok(())
}
