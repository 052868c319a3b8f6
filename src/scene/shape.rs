//! Named shapes: their parameters, f(r) and sources.

use super::SceneError;
use crate::scene::file::document::nearest;

/// A named shape.
#[derive(Debug)]
pub struct Shape {
    /// The name in scene files.
    pub name: &'static str,
    /// A phrase that describes the shape.
    pub title: &'static str,
    /// The source of the formulas.
    pub source: &'static str,
    /// The parametrizations; the first one is the default.
    pub ways: &'static [Way],
    /// The parameter that is also the radius of the vertical side.
    pub rim: Option<&'static str>,
}

/// A parametrization of a shape.
#[derive(Debug)]
pub struct Way {
    /// f(r) in the grammar of profiles.
    pub f: &'static str,
    /// The parameters.
    pub parameters: &'static [Parameter],
}

/// A parameter of a named shape.
#[derive(Debug)]
pub struct Parameter {
    /// The name in f.
    pub name: &'static str,
    /// An example value for a new scene.
    pub example: &'static str,
    /// A description.
    pub meaning: &'static str,
}

impl Parameter {
    /// Returns true for an angle between a flank and the surface, or the axis.
    pub(super) fn is_angle(&self) -> bool {
        self.example.ends_with("deg")
    }
}

const fn p(name: &'static str, example: &'static str, meaning: &'static str) -> Parameter {
    Parameter { name, example, meaning }
}

/// All named shapes.
pub const SHAPES: &[Shape] = &[
    Shape {
        name: "flat",
        title: "flat cylindrical punch",
        source: "Popov & Heß (3.1), (3.53)–(3.56)",
        ways: &[Way { f: "0", parameters: &[p("c", "1 um", "radius of the cylinder")] }],
        rim: Some("c"),
    },
    Shape {
        name: "cone",
        title: "cone",
        source: "Popov & Heß (3.43)–(3.44), (3.57)–(3.58)",
        ways: &[
            Way { f: "r*tan(theta)", parameters: &[p("theta", "12 deg", "angle between flank and surface")] },
            Way { f: "r/tan(alpha)", parameters: &[p("alpha", "78 deg", "half-opening angle")] },
        ],
        rim: None,
    },
    Shape {
        name: "berkovich",
        title: "cone with the area of a Berkovich pyramid at every depth (half-angle 70.3 deg)",
        source: "Oliver & Pharr (1992): A = 3 sqrt(3) tan(65.27 deg)^2 h^2 = pi r^2",
        ways: &[Way { f: "r*sqrt(pi/(3*sqrt(3)))/tan(65.27*pi/180)", parameters: &[] }],
        rim: None,
    },
    Shape {
        name: "vickers",
        title: "cone with the area of a Vickers pyramid at every depth (half-angle 70.3 deg)",
        source: "faces at 68 deg to the axis: A = 4 tan(68 deg)^2 h^2 = pi r^2",
        ways: &[Way { f: "r*sqrt(pi)/(2*tan(68*pi/180))", parameters: &[] }],
        rim: None,
    },
    Shape {
        name: "cube-corner",
        title: "cone with the area of the corner of a cube at every depth (half-angle 42.3 deg)",
        source: "faces whose angle to the axis has the tangent 1/sqrt(2): A = (3 sqrt(3)/2) h^2 = pi r^2",
        ways: &[Way { f: "r*sqrt(2*pi/(3*sqrt(3)))", parameters: &[] }],
        rim: None,
    },
    Shape {
        name: "oliver-pharr",
        title: "tip with the area function A = C0 h^2 + C1 h of Oliver and Pharr, its first two terms",
        source: "Oliver & Pharr (1992), solved for h with A = pi r^2: a hyperboloid",
        ways: &[Way {
            f: "(sqrt(C1^2+4*pi*C0*r^2)-C1)/(2*C0)",
            parameters: &[p("C0", "24.5", "coefficient of h^2, 24.5 for a Berkovich tip"), p("C1", "1 um", "coefficient of h, a length")],
        }],
        rim: None,
    },
    Shape {
        name: "paraboloid",
        title: "paraboloid: a sphere for a contact that is small compared with R",
        source: "Popov & Heß (3.6)–(3.13)",
        ways: &[Way { f: "r^2/(2*R)", parameters: &[p("R", "10 um", "radius of curvature at the tip")] }],
        rim: None,
    },
    Shape {
        name: "sphere",
        title: "sphere, exactly",
        source: "Popov & Heß (3.71)–(3.78)",
        ways: &[Way { f: "R-sqrt(R^2-r^2)", parameters: &[p("R", "10 um", "radius")] }],
        rim: None,
    },
    Shape {
        name: "ellipsoid",
        title: "ellipsoid of revolution",
        source: "a stretched sphere: Popov & Heß (3.71)–(3.78), scaling of lengths",
        ways: &[Way {
            f: "b*(1-sqrt(1-r^2/c^2))",
            parameters: &[p("b", "5 um", "semi-axis along the axis of symmetry"), p("c", "10 um", "semi-axis across it")],
        }],
        rim: None,
    },
    Shape {
        name: "hyperboloid",
        title: "hyperboloid of revolution, a cone with a smooth tip",
        source: "Sneddon (1965); Segedin's integral with arctan in place of artanh",
        ways: &[Way {
            f: "h*(sqrt(1+r^2/b^2)-1)",
            parameters: &[
                p("h", "1 um", "semi-axis along the axis of symmetry"),
                p("b", "5 um", "semi-axis across it; far away the slope is h/b"),
            ],
        }],
        rim: None,
    },
    Shape {
        name: "power",
        title: "power law",
        source: "Popov & Heß (3.14)–(3.24), (3.45)–(3.46)",
        ways: &[Way {
            f: "C*r^n",
            parameters: &[p("C", "0.1 um^-0.5", "coefficient, a length to the power 1 - n"), p("n", "1.5", "exponent")],
        }],
        rim: None,
    },
    Shape {
        name: "truncated-cone",
        title: "cone with a flat end",
        source: "Popov & Heß (3.27)–(3.28)",
        ways: &[Way {
            f: "piecewise(0, r<b, (r-b)*tan(theta))",
            parameters: &[p("b", "1 um", "radius of the flat end"), p("theta", "12 deg", "angle between flank and surface")],
        }],
        rim: None,
    },
    Shape {
        name: "truncated-paraboloid",
        title: "paraboloid with a flat end: a worn sphere for a contact that is small compared with R",
        source: "Popov & Heß (3.29)–(3.35)",
        ways: &[Way {
            f: "piecewise(0, r<b, (r^2-b^2)/(2*R))",
            parameters: &[p("b", "1 um", "radius of the flat end"), p("R", "10 um", "radius of curvature")],
        }],
        rim: None,
    },
    Shape {
        name: "worn-sphere",
        title: "sphere with a flat end, exactly",
        source: "pieces of Popov & Heß (3.71)–(3.78)",
        ways: &[Way {
            f: "piecewise(0, r<b, sqrt(R^2-b^2)-sqrt(R^2-r^2))",
            parameters: &[p("b", "1 um", "radius of the flat end"), p("R", "10 um", "radius of the sphere")],
        }],
        rim: None,
    },
    Shape {
        name: "cone-with-spherical-cap",
        title: "cone that ends in a sphere, without a kink",
        source: "pieces of Popov & Heß (3.43) and (3.71)",
        ways: &[Way {
            f: "piecewise(R-sqrt(R^2-r^2), r<R*sin(theta), (r-R*sin(theta))*tan(theta)+R-R*cos(theta))",
            parameters: &[p("R", "0.2 um", "radius of the tip"), p("theta", "12 deg", "angle between flank and surface")],
        }],
        rim: None,
    },
    Shape {
        name: "cone-with-parabolic-cap",
        title: "cone that ends in a paraboloid, without a kink",
        source: "pieces of Popov & Heß (3.6) and (3.43)",
        ways: &[
            Way {
                f: "piecewise(r^2*tan(theta)/(2*b), r<b, (r-b/2)*tan(theta))",
                parameters: &[
                    p("b", "0.2 um", "radius at which the cap meets the flank"),
                    p("theta", "12 deg", "angle between flank and surface"),
                ],
            },
            Way {
                f: "piecewise(r^2/(2*R), r<R*tan(theta), (r-R*tan(theta)/2)*tan(theta))",
                parameters: &[p("R", "1 um", "radius of curvature at the tip"), p("theta", "12 deg", "angle between flank and surface")],
            },
        ],
        rim: None,
    },
    Shape {
        name: "paraboloid-with-parabolic-cap",
        title: "paraboloid whose tip has another radius of curvature",
        source: "pieces of Popov & Heß (3.6)",
        ways: &[Way {
            f: "piecewise(r^2/(2*P), r<b, r^2/(2*R)+b^2/(2*P)-b^2/(2*R))",
            parameters: &[
                p("P", "20 um", "radius of curvature of the cap"),
                p("b", "0.5 um", "radius at which the cap ends"),
                p("R", "10 um", "radius of curvature beyond it"),
            ],
        }],
        rim: None,
    },
    Shape {
        name: "flat-with-rounded-edge",
        title: "flat punch with a rounded edge",
        source: "pieces: (r - b)^2/(2 R) beyond the flat part",
        ways: &[Way {
            f: "piecewise(0, r<b, (r-b)^2/(2*R))",
            parameters: &[p("b", "1 um", "radius of the flat part"), p("R", "5 um", "radius of curvature of the edge")],
        }],
        rim: None,
    },
    Shape {
        name: "concave-paraboloid",
        title: "cylinder with a concave parabolic end",
        source: "Popov & Heß (3.59)–(3.63)",
        ways: &[Way { f: "-h*r^2/c^2", parameters: &[p("h", "0.05 um", "depth of the hollow"), p("c", "5 um", "radius of the cylinder")] }],
        rim: Some("c"),
    },
    Shape {
        name: "wavy-paraboloid",
        title: "paraboloid with concentric waves",
        source: "Popov & Heß (3.6) with waves: g gains (pi/2) h k x H0(k x)",
        ways: &[
            Way {
                f: "r^2/(2*R)+h*(1-cos(2*pi*r/lambda))",
                parameters: &[p("R", "10 um", "radius of curvature"), p("h", "1 nm", "amplitude"), p("lambda", "2 um", "wavelength")],
            },
            Way {
                f: "r^2/(2*R)+h*(1-cos(k*r))",
                parameters: &[p("R", "10 um", "radius of curvature"), p("h", "1 nm", "amplitude"), p("k", "3 um^-1", "wave number")],
            },
        ],
        rim: None,
    },
];

/// Returns the shape with this name, or an error that suggests the closest one.
///
/// # Errors
/// [`SceneError`] for an unknown name.
pub fn known_shape(name: &str) -> Result<&'static Shape, SceneError> {
    shape(name).ok_or_else(|| {
        let plain = name.trim().to_lowercase().replace([' ', '_'], "-");
        let meant = OTHER_NAMES.iter().find(|(other, _)| *other == plain).map(|(_, own)| *own);
        let names: Vec<&str> = SHAPES.iter().map(|shape| shape.name).collect();
        let near = meant.or_else(|| nearest(&plain, &names)).map_or(String::new(), |near| format!("did you mean {near}? "));
        let shown: String = name.chars().take(60).collect();
        SceneError::value(format!("unknown shape {shown:?}"))
            .help(format!("{near}run `sneddon scene new` for a list of the {} shapes", names.len()))
    })
}

/// Common names that do not identify a shape uniquely.
const OTHER_NAMES: &[(&str, &str)] = &[
    ("rounded-cone", "cone-with-spherical-cap"),
    ("blunt-cone", "cone-with-spherical-cap"),
    ("blunted-cone", "cone-with-spherical-cap"),
    ("conospherical", "cone-with-spherical-cap"),
    ("spheroconical", "cone-with-spherical-cap"),
    ("worn-cone", "truncated-cone"),
    ("frustum", "truncated-cone"),
    ("truncated-sphere", "worn-sphere"),
    ("worn-paraboloid", "truncated-paraboloid"),
    ("ball", "sphere"),
    ("pyramid", "berkovich"),
    ("area-function", "oliver-pharr"),
    ("rounded-punch", "flat-with-rounded-edge"),
    ("spheroid", "ellipsoid"),
];

impl Shape {
    /// Returns the parametrization with all of these names, or the default parametrization.
    pub fn way(&self, names: &[&str]) -> Option<&'static Way> {
        let fits = |way: &&Way| names.iter().all(|name| way.parameters.iter().any(|known| known.name == *name));
        self.ways.iter().find(fits).or(self.ways.first())
    }
}

/// Normalizes the name of a shape; blanks and underscores are treated as hyphens.
pub fn shape(name: &str) -> Option<&'static Shape> {
    let own = name.trim().to_lowercase().replace([' ', '_'], "-");
    let own = match own.as_str() {
        "flat-punch" | "cylinder" | "punch" => "flat",
        "conical" => "cone",
        "parabola" | "parabolic" | "hertz" => "paraboloid",
        "spherical" => "sphere",
        "power-law" => "power",
        "concave" => "concave-paraboloid",
        "berkovich-equivalent-cone" => "berkovich",
        "vickers-equivalent-cone" => "vickers",
        "cube-corner-equivalent-cone" => "cube-corner",
        "rounded-flat" | "rounded-edge-punch" | "flat-punch-with-rounded-edge" => "flat-with-rounded-edge",
        other => other,
    };
    SHAPES.iter().find(|shape| shape.name == own)
}
