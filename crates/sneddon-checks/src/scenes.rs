//! Random scenes: named shapes and formulas, materials, cylinders, units and loads, as scene files.

use crate::random::Stream;

/// A scene file without its load, and what the laws need to know of it.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The profile's table.
    profile: String,
    /// Another formula of the same lengths, which superposes.
    pub other: String,
    /// The material's and the counterbody's tables.
    material: String,
    /// A length of the profile, in metres: about the largest contact radius.
    pub reach: f64,
    /// The contact radius as a part of the reach.
    pub part: f64,
    /// The units of lengths and moduli.
    units: (&'static str, f64, &'static str),
}

const LENGTHS: [(&str, f64); 4] = [("nm", 1e-9), ("um", 1e-6), ("mm", 1e-3), ("m", 1.0)];
const PRESSURES: [&str; 3] = ["MPa", "GPa", "kPa"];

/// Formulas over the lengths h, w and R, h below w; nothing about them is a special case.
const FORMULAS: [&str; 14] = [
    "r^2/(2*R)+h*(r/w)^3",
    "r^2/(2*R)+h*(1-cos(2*r/w))/8",
    "h*(1-exp(-r^2/w^2))",
    "h*ln(1+r^2/w^2)",
    "h*(cosh(r/w)-1)",
    "h*r/w*atan(r/w)",
    "h*(r/w)^(5/2)+r^2/(2*R)",
    "h*asinh(r/w)",
    "h*((1+r^2/w^2)^(3/2)-1)",
    "h*(exp(r/w)-1)",
    "r*h/w+r^2/(2*R)",
    "h*(1-besselj(0,r/w))",
    "h*ln(cosh(r/w))",
    "h*tanh(r^2/w^2)",
];

impl Drawn {
    pub fn new(stream: &mut Stream) -> Self {
        let unit = *stream.pick(&LENGTHS);
        let size = stream.short(0.5, 40.0);
        let length = |factor: f64| format!("\"{:?} {}\"", factor * size, unit.0);
        let (part, own) = (stream.short(0.05, 0.9), |stream: &mut Stream| stream.short(0.2, 0.8));
        let (one, two) = (own(stream), own(stream));
        let theta = format!("\"{:?} deg\"", stream.short(1.0, 40.0));
        let shape = |name: &str, parameters: &str| format!("[profile]\nshape = \"{name}\"\nparameters = {{ {parameters} }}\n");
        let (r, b, h) = (length(1.25), length(one), length(0.125 * two));
        let profile = match stream.whole(0, 19) {
            0 => shape("cone", &format!("theta = {theta}")),
            1 => shape("paraboloid", &format!("R = {r}")),
            2 => shape("sphere", &format!("R = {r}")),
            3 => shape("ellipsoid", &format!("b = {b}, c = {r}")),
            4 => shape("hyperboloid", &format!("h = {h}, b = {b}")),
            5 => {
                let n = *stream.pick(&["1/2", "3/2", "2", "5/2", "3", "4"]);
                format!("[profile]\nf = \"h*(r/w)^({n})\"\nparameters = {{ h = {h}, w = {} }}\n", length(1.0))
            }
            6 => shape("truncated-cone", &format!("b = {b}, theta = {theta}")),
            7 => shape("truncated-paraboloid", &format!("b = {b}, R = {r}")),
            8 => shape("cone-with-spherical-cap", &format!("R = {}, theta = {theta}", length(0.75))),
            9 => shape("cone-with-parabolic-cap", &format!("b = {b}, theta = {theta}")),
            10 => shape("paraboloid-with-parabolic-cap", &format!("P = {}, b = {b}, R = {r}", length(2.5))),
            11 => shape("flat-with-rounded-edge", &format!("b = {b}, R = {r}")),
            12 => shape("wavy-paraboloid", &format!("R = {r}, h = {}, lambda = {}", length(0.001), length(one))),
            _ => {
                let formula = *stream.pick(&FORMULAS);
                let needs = |name: &str, value: &str| if formula.contains(name) { format!("{name} = {value}, ") } else { String::new() };
                let list = [needs("h", &h), needs("w", &length(0.75)), needs("R", &r)].concat();
                format!("[profile]\nf = \"{formula}\"\nparameters = {{ {} }}\n", list.trim_end_matches(", "))
            }
        };
        let other = format!("[counterbody]\nf = \"r^2/(2*R)\"\nparameters = {{ R = {} }}\n", length(stream.short(1.0, 8.0)));
        Self { profile, other, material: material(stream), reach: size * unit.1, part, units: (unit.0, unit.1, *stream.pick(&PRESSURES)) }
    }

    /// The file with a contact radius; `radius` of a vertical side as a part of the reach, `more` a counterbody's shape.
    pub fn file(&self, rim: Option<f64>, more: &str) -> String {
        let (unit, factor, pressure) = self.units;
        let at = |part: f64| format!("\"{:?} {unit}\"", part * (self.reach / factor));
        let side = rim.map_or_else(String::new, |part| format!("radius = {}\n", at(part)));
        let units = format!("units = {{ length = \"{unit}\", force = \"N\", pressure = \"{pressure}\" }}");
        let quantities = "quantities = [\"d\", \"F\", \"a\", \"k\", \"p\", \"g\", \"f\"]\nat = [";
        format!(
            "{}{side}{more}{}[load]\ncontact_radius = {}\n[outputs]\n{quantities}{}]\n{units}\n",
            self.profile,
            self.material,
            at(self.part),
            at(0.5 * self.part)
        )
    }

    /// The same scene with every length a thousand times as long.
    pub fn file_of_longer(&self) -> String {
        let from = self.units.0;
        let to = LENGTHS.iter().map(|(name, _)| *name).skip_while(|name| *name != from).nth(1).unwrap_or("km");
        self.file(None, "").replace(&format!(" {from}\""), &format!(" {to}\""))
    }

    /// The second shape alone.
    pub fn file_of_other(&self) -> String {
        Self { profile: self.other.replace("[counterbody]", "[profile]"), ..self.clone() }.file(None, "")
    }
}

fn material(stream: &mut Stream) -> String {
    let isotropic = |stream: &mut Stream| format!("E = \"{:?} GPa\"\nnu = {:?}\n", stream.short(0.01, 400.0), stream.short(0.0, 0.5));
    match stream.whole(0, 3) {
        0 => format!("[material]\neffective_modulus = \"{:?} MPa\"\n", stream.short(1.0, 1e5)),
        1 => format!(
            "[material]\nC11 = \"166 GPa\"\nC12 = \"64 GPa\"\nC13 = \"{:?} GPa\"\nC33 = \"166 GPa\"\nC44 = \"80 GPa\"\n",
            stream.short(40.0, 80.0)
        ),
        _ => format!("[material]\n{}", isotropic(stream)),
    }
}
