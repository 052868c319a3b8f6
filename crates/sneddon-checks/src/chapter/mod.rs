//! Equations of the source's chapter 3 that state a result, as printed and in the program's grammar, with what the program is asked for.

pub mod side_by_side;

use sneddon::contact::Quantity;

/// An equation of the chapter and its counterpart.
pub struct Equation {
    /// Its number, in parentheses.
    pub number: &'static str,
    /// What it states.
    pub title: &'static str,
    /// The equation as the chapter prints it, in LaTeX.
    pub latex: &'static str,
    /// Its right side in the program's grammar; a pressure, positive in compression, for a stress.
    pub typed: &'static str,
    /// Names on its right side with their values, of which each may use those before it.
    pub given: &'static [(&'static str, &'static str)],
    /// The counterpart.
    pub ours: Ours,
    /// Sentences about the comparison; may be empty.
    pub note: &'static str,
}

/// What the program is asked for.
pub enum Ours {
    /// A formula.
    Formula {
        /// f(r).
        profile: &'static str,
        /// The name of the depth of a punch with a rim.
        depth: Option<&'static str>,
        /// The quantity.
        quantity: Quantity,
        /// True for logarithms in place of inverse hyperbolic functions.
        logarithms: bool,
    },
    /// The number E* of a transversely isotropic half-space, of which there is no formula.
    Modulus,
}

const fn smooth(profile: &'static str, quantity: Quantity) -> Ours {
    Ours::Formula { profile, depth: None, quantity, logarithms: false }
}

const fn punch(profile: &'static str, depth: &'static str, quantity: Quantity) -> Ours {
    Ours::Formula { profile, depth: Some(depth), quantity, logarithms: false }
}

const POWER: &str = "C*r^n";
const CONE: &str = "r*tan(theta)";
const BOTH: &str = "r^2/(2*R)+r*tan(theta)";
const WORN: &str = "piecewise(0, r<b, (r^2-b^2)/(2*R))";
const CONCAVE: &str = "-h*r^2/a^2";
const SPHERE: &str = "R-sqrt(R^2-r^2)";

const KAPPA: &[(&str, &str)] = &[("kappa_n", "sqrt(pi)/2*n*gamma(n/2)/gamma(n/2+1/2)")];
/// (3.66)–(3.69), in an order in which each uses those before it.
const INVARIANTS: &[(&str, &str)] = &[
    ("C_13m", "(C_11*C_33)^(1/2)"),
    ("I_0", "C_13m-C_13-2*C_44"),
    ("nu_1", "((C_13m-C_13)*(2*C_13m-I_0)/(4*C_33*C_44))^(1/2)+((C_13m+C_13)*I_0/(4*C_33*C_44))^(1/2)"),
    ("nu_2", "((C_13m-C_13)*(2*C_13m-I_0)/(4*C_33*C_44))^(1/2)-((C_13m+C_13)*I_0/(4*C_33*C_44))^(1/2)"),
];

/// The equations, in the order of the chapter.
pub const EQUATIONS: &[Equation] = &[
    Equation {
        number: "(3.16)",
        title: "the equivalent profile of a power",
        latex: r"\tilde{c}_n = \kappa_n c_n, \quad \kappa_n = \frac{\sqrt{\pi}}{2} \frac{n\, \Gamma\left(\frac{n}{2}\right)}{\Gamma\left(\frac{n}{2} + \frac{1}{2}\right)}",
        typed: "sqrt(pi)/2*n*gamma(n/2)/gamma(n/2+1/2)*C*x^n",
        given: &[],
        ours: smooth(POWER, Quantity::Equivalent),
        note: "The chapter states the factor of $x^n$; it is compared and counted with $c_n = C$ and with $x^n$ from (3.15).",
    },
    Equation {
        number: "(3.30)",
        title: "the equivalent profile of a worn paraboloid",
        latex: r"g(x) = \begin{cases} 0 & \text{for } 0 \le |x| < b \\ \frac{|x|}{R} \sqrt{x^2 - b^2} & \text{for } b \le |x| \le a \end{cases}",
        typed: "piecewise(0, x<b, x/R*sqrt(x^2-b^2))",
        given: &[],
        ours: smooth(WORN, Quantity::Equivalent),
        note: "",
    },
    Equation {
        number: "(3.34)",
        title: "the force of a worn paraboloid",
        latex: r"F_N(a) = \frac{2E^{*}}{3R} \left(2a^2 + b^2\right) \cdot \sqrt{a^2 - b^2}",
        typed: "2*E/(3*R)*(2*a^2+b^2)*sqrt(a^2-b^2)",
        given: &[],
        ours: smooth(WORN, Quantity::Force),
        note: "Both are compared and counted for $a \\ge b$.",
    },
    Equation {
        number: "(3.35)",
        title: "the force of a worn paraboloid at a depth",
        latex: r"F_N(d) = \frac{\sqrt{2} E^{*} b^3}{3R} \left(2 + \sqrt{1 + \left(\frac{2R}{b^2} d\right)^2}\right) \cdot \sqrt{-1 + \sqrt{1 + \left(\frac{2R}{b^2} d\right)^2}}",
        typed: "sqrt(2)*E*b^3/(3*R)*(2+sqrt(1+(2*R/b^2*d)^2))*sqrt(-1+sqrt(1+(2*R/b^2*d)^2))",
        given: &[],
        ours: smooth(WORN, Quantity::ForceOfDepth),
        note: "The chapter's form loses digits for small $d$; the program's does not.",
    },
    Equation {
        number: "(3.43)",
        title: "the contact radius of a cone at a depth",
        latex: r"a = \frac{2}{\pi} \frac{d}{\tan\theta}",
        typed: "2/pi*d/tan(theta)",
        given: &[],
        ours: smooth(CONE, Quantity::Radius),
        note: "",
    },
    Equation {
        number: "(3.44)",
        title: "the force of a cone at a depth",
        latex: r"F_N = 2E^{*} \int_0^a u_z(x)\,dx = 2E^{*} \int_0^a \left(d - (\pi/2) \tan\theta \cdot x\right) dx = \frac{2}{\pi} E^{*} \frac{d^2}{\tan\theta}",
        typed: "2/pi*E*d^2/tan(theta)",
        given: &[],
        ours: smooth(CONE, Quantity::ForceOfDepth),
        note: "The last form is compared.",
    },
    Equation {
        number: "(3.45)",
        title: "the contact radius of a power at a depth",
        latex: r"a = \left(\frac{d}{C \kappa_n}\right)^{1/n}",
        typed: "(d/(C*kappa_n))^(1/n)",
        given: KAPPA,
        ours: smooth(POWER, Quantity::Radius),
        note: "The chapter abbreviates $\\kappa_n$, which (3.16) defines; the program writes it out.",
    },
    Equation {
        number: "(3.46)",
        title: "the force of a power at a depth",
        latex: r"F_N = 2E^{*} \int_0^a u_z(x)\,dx = 2E^{*} \int_0^a \left(d - C \kappa_n x^n\right) dx = \frac{2n}{n + 1} \frac{E^{*} d^{\frac{n+1}{n}}}{(C \kappa_n)^{1/n}}",
        typed: "2*n/(n+1)*E*d^((n+1)/n)/(C*kappa_n)^(1/n)",
        given: KAPPA,
        ours: smooth(POWER, Quantity::ForceOfDepth),
        note: "The last form is compared.\nThe chapter abbreviates $\\kappa_n$, which (3.16) defines; the program writes it out.",
    },
    Equation {
        number: "(3.47)",
        title: "the equivalent profile of a paraboloid and a cone",
        latex: r"g(x) = \kappa_2 \frac{x^2}{2R} + \kappa_1 |x| \tan\theta = \frac{x^2}{R} + \frac{\pi}{2} |x| \tan\theta",
        typed: "x^2/R+pi/2*x*tan(theta)",
        given: &[],
        ours: smooth(BOTH, Quantity::Equivalent),
        note: "The last form is compared.",
    },
    Equation {
        number: "(3.48)",
        title: "the depth of a paraboloid and a cone",
        latex: r"g(a) = \frac{a^2}{R} + \frac{\pi}{2} a \tan\theta = d",
        typed: "a^2/R+pi/2*a*tan(theta)",
        given: &[],
        ours: smooth(BOTH, Quantity::Depth),
        note: "",
    },
    Equation {
        number: "(3.49)",
        title: "the contact radius of a paraboloid and a cone at a depth",
        latex: r"a = \sqrt{\left(\frac{\pi}{4} R \tan\theta\right)^2 + Rd} - \frac{\pi}{4} R \tan\theta",
        typed: "sqrt((pi/4*R*tan(theta))^2+R*d)-pi/4*R*tan(theta)",
        given: &[],
        ours: smooth(BOTH, Quantity::Radius),
        note: "The chapter's form loses digits for small $d$; the program's does not.",
    },
    Equation {
        number: "(3.51)",
        title: "the force of a paraboloid and a cone",
        latex: r"F_N = 2E^{*} \left(da - \frac{a^3}{3R} - \frac{\pi}{4} a^2 \tan\theta\right)",
        typed: "2*E*(d*a-a^3/(3*R)-pi/4*a^2*tan(theta))",
        given: &[("d", "a^2/R+pi/2*a*tan(theta)")],
        ours: smooth(BOTH, Quantity::Force),
        note: "The chapter's form contains $d$, which (3.48) gives; the program's contains $a$ alone.",
    },
    Equation {
        number: "(3.52)",
        title: "the force of a paraboloid and a cone at a depth",
        latex: r"F_N = \frac{\pi^3 R^2 (\tan\theta)^3 E^{*}}{96} \left(\sqrt{1 + \frac{16d}{\pi^2 R (\tan\theta)^2}} - 1\right) \left(1 + \frac{32d}{R \pi^2 (\tan\theta)^2} - \sqrt{1 + \frac{16d}{\pi^2 R (\tan\theta)^2}}\right)",
        typed: "pi^3*R^2*tan(theta)^3*E/96*(sqrt(1+16*d/(pi^2*R*tan(theta)^2))-1)\
                *(1+32*d/(R*pi^2*tan(theta)^2)-sqrt(1+16*d/(pi^2*R*tan(theta)^2)))",
        given: &[],
        ours: smooth(BOTH, Quantity::ForceOfDepth),
        note: "The chapter's form loses digits for small $d$; the program's does not.",
    },
    Equation {
        number: "(3.56)",
        title: "the stress under a flat punch",
        latex: r"\sigma_{zz}(r) = \frac{1}{\pi} \frac{F_N}{2a} = \begin{cases} -\frac{1}{\sqrt{a^2 - r^2}}, & \text{for } |r| < a \\ 0, & \text{for } |r| > a \end{cases}",
        typed: "1/pi*F_N/(2*a)*1/sqrt(a^2-r^2)",
        given: &[("F_N", "2*a*(E*d)")],
        ours: punch("0", "d", Quantity::Pressure),
        note: "The second equality sign is a misprint for a product; the stress inside the contact is compared.\n\
               The chapter's form contains $F_N = 2a\\,q$ of (3.53), where $q = E^{*}d$; the program's contains $d$.",
    },
    Equation {
        number: "(3.58)",
        title: "the stress under a cone",
        latex: r"\sigma_{zz}(r) = \begin{cases} -\frac{1}{2} E^{*} \tan\theta \cdot \ln\left(\frac{a}{r} + \sqrt{\left(\frac{a}{r}\right)^2 - 1}\right), & \text{for } r < a \\ 0, & \text{for } r > a \end{cases}",
        typed: "1/2*E*tan(theta)*ln(a/r+sqrt((a/r)^2-1))",
        given: &[],
        ours: smooth(CONE, Quantity::Pressure),
        note: "The stress inside the contact is compared.",
    },
    Equation {
        number: "(3.61)",
        title: "the force of a concave punch",
        latex: r"F_N = 2E^{*} \int_0^a \left[d_o - g(x)\right] dx = 2E^{*} \int_0^a \left(d_o + 2\frac{h}{a^2} x^2\right) dx = 2E^{*} a \left(d_o + \frac{2}{3} h\right)",
        typed: "2*E*a*(d_o+2/3*h)",
        given: &[],
        ours: punch(CONCAVE, "d_o", Quantity::Force),
        note: "The last form is compared.",
    },
    Equation {
        number: "(3.63)",
        title: "the stress under a concave punch",
        latex: r"\sigma_{zz}(r) = -\frac{E^{*}}{\pi} \cdot \frac{d_o - 2h + 4h \left(\frac{r}{a}\right)^2}{\sqrt{a^2 - r^2}}",
        typed: "E/pi*(d_o-2*h+4*h*(r/a)^2)/sqrt(a^2-r^2)",
        given: &[],
        ours: punch(CONCAVE, "d_o", Quantity::Pressure),
        note: "",
    },
    Equation {
        number: "(3.65)",
        title: "the modulus of a transversely isotropic medium",
        latex: r"E^{*} = \frac{2 \left(\bar{C}_{13}^2 - C_{13}^2\right)}{\bar{C}_{13} (\nu_1 + \nu_2)}",
        typed: "2*(C_13m^2-C_13^2)/(C_13m*(nu_1+nu_2))",
        given: INVARIANTS,
        ours: Ours::Modulus,
        note: "(3.66)–(3.69) define $\\nu_1$, $\\nu_2$, $\\bar{C}_{13}$ and $I_0$; all points have $I_0 > 0$, because $\\nu_1$ and $\\nu_2$ are complex for $I_0 < 0$.",
    },
    Equation {
        number: "(3.70)",
        title: "the modulus of a transversely isotropic medium in terms of its stiffnesses",
        latex: r"E^{*} = \frac{2 \sqrt{C_{44}} \left(C_{11} C_{33} - C_{13}^2\right)}{\sqrt{C_{11}} \sqrt{\left(\sqrt{C_{11} C_{33}} - C_{13}\right) \left(C_{13} + 2C_{44} + \sqrt{C_{11} C_{33}}\right)}}",
        typed: "2*sqrt(C_44)*(C_11*C_33-C_13^2)/(sqrt(C_11)*sqrt((sqrt(C_11*C_33)-C_13)*(C_13+2*C_44+sqrt(C_11*C_33))))",
        given: &[],
        ours: Ours::Modulus,
        note: "",
    },
    Equation {
        number: "(3.74)",
        title: "the equivalent profile of a sphere",
        latex: r"g(x) = x \cdot \operatorname{arsinh}\left(\frac{x}{\sqrt{R^2 - x^2}}\right)",
        typed: "x*asinh(x/sqrt(R^2-x^2))",
        given: &[],
        ours: smooth(SPHERE, Quantity::Equivalent),
        note: "",
    },
    Equation {
        number: "(3.74), second form",
        title: "the same with a logarithm",
        latex: r"g(x) = \frac{1}{2} x \ln\left(\frac{R + x}{R - x}\right)",
        typed: "1/2*x*ln((R+x)/(R-x))",
        given: &[],
        ours: Ours::Formula { profile: SPHERE, depth: None, quantity: Quantity::Equivalent, logarithms: true },
        note: "",
    },
    Equation {
        number: "(3.75)",
        title: "the depth of a sphere",
        latex: r"d = g(a) = \frac{1}{2} a \ln\left(\frac{R + a}{R - a}\right)",
        typed: "1/2*a*ln((R+a)/(R-a))",
        given: &[],
        ours: smooth(SPHERE, Quantity::Depth),
        note: "",
    },
    Equation {
        number: "(3.77)",
        title: "the force of a sphere, with the depth",
        latex: r"F_N = 2E^{*} a \left[d - \frac{R}{2} + \frac{R^2 - a^2}{4a} \ln\left(\frac{R + a}{R - a}\right)\right]",
        typed: "2*E*a*(d-R/2+(R^2-a^2)/(4*a)*ln((R+a)/(R-a)))",
        given: &[("d", "1/2*a*ln((R+a)/(R-a))")],
        ours: smooth(SPHERE, Quantity::Force),
        note: "The chapter's form contains $d$, which (3.75) gives; the program's contains $a$ alone.\n\
               Both printed forms lose digits for $a \\ll R$, and the program computes numbers with a form that does not.",
    },
    Equation {
        number: "(3.78)",
        title: "the force of a sphere",
        latex: r"F_N(a) = E^{*} \frac{R^2 + a^2}{2} \ln\left(\frac{R + a}{R - a}\right) - E^{*} R a",
        typed: "E*(R^2+a^2)/2*ln((R+a)/(R-a))-E*R*a",
        given: &[],
        ours: smooth(SPHERE, Quantity::Force),
        note: "Both printed forms lose digits for $a \\ll R$, and the program computes numbers with a form that does not.",
    },
];

/// Definitions and intermediate steps: number, LaTeX, and what the program has in their place.
pub const DERIVATION_STEPS: &[(&str, &str, &str)] = &[
    (
        "(3.50)",
        r"F_N = 2E^{*} \int_0^a u_z(x)\,dx = 2E^{*} \int_0^a \left(d - \frac{x^2}{R} - \frac{\pi}{2} |x| \tan\theta\right) dx",
        "This is the sum of the spring forces, which (3.51) evaluates.\n\
         The derivation with `--steps` states it as the definition of $F(a)$.",
    ),
    (
        "(3.66)",
        r"\nu_1 = \left[\frac{(\bar{C}_{13} - C_{13})(2\bar{C}_{13} - I_0)}{4C_{33}C_{44}}\right]^{1/2} + \left[\frac{(\bar{C}_{13} + C_{13}) I_0}{4C_{33}C_{44}}\right]^{1/2}",
        "This abbreviation in (3.65) has no counterpart in the program, which uses the real form (3.70).",
    ),
    (
        "(3.67)",
        r"\nu_2 = \left[\frac{(\bar{C}_{13} - C_{13})(2\bar{C}_{13} - I_0)}{4C_{33}C_{44}}\right]^{1/2} - \left[\frac{(\bar{C}_{13} + C_{13}) I_0}{4C_{33}C_{44}}\right]^{1/2}",
        "This abbreviation in (3.65) has no counterpart in the program either.\n\
         It enters (3.65) only through $\\nu_1 + \\nu_2$, in which the second terms cancel.",
    ),
    (
        "(3.68)",
        r"\bar{C}_{13} = (C_{11} C_{33})^{1/2}",
        "This is the geometric mean of two stiffnesses, which the program computes as a number for (3.70).",
    ),
    (
        "(3.69)",
        r"I_0 = \bar{C}_{13} - C_{13} - 2C_{44}",
        "The sign of this difference decides whether (3.66) and (3.67) are real; the program does not need it.",
    ),
    (
        "(3.76)",
        r"F_N = E^{*} \int_{-a}^{a} \left[d - g(x)\right] dx = 2E^{*} da - E^{*} \int_0^a x \ln\left(\frac{R + x}{R - x}\right) dx",
        "This is the sum of the spring forces under the sphere, which (3.77) and (3.78) evaluate.\n\
         The derivation with `--steps` states it as the definition of $F(a)$.",
    ),
];
