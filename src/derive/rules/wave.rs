//! Sines, hyperbolic sines and exponentials of kr times powers of r: Bessel and Struve functions.

use super::laurent::{Combination, Law, Member, member};
use super::moments::{self, Moments};
use super::reading;
use crate::derive::rule::{Answer, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::{Expr, Node};

const PARAMETERS: &[Parameter] = &[
    Parameter { name: "A", lowest: 0.1, highest: 2.0 },
    Parameter { name: "C", lowest: 0.1, highest: 2.0 },
    Parameter { name: "k", lowest: 0.3, highest: 2.0 },
];
const GENERAL: &[&str] =
    &["general formula, Popov & Heß (3.27)", "DLMF 10.9, 11.5: integral representations of Bessel and Struve functions"];

pub(super) static CIRCULAR: Rule = Rule {
    id: "sine-cosine",
    title: "Sine or cosine times a power",
    pattern: "A*sin(k*r)+C*(1-cos(k*r))",
    equivalent: "pi/2*k*x*(A*besselj(0,k*x)+C*struveh(0,k*x))",
    force: "pi*E*a*(A*(k*a*besselj(0,k*a)-besselj(1,k*a))+C*(k*a*struveh(0,k*a)-struveh(1,k*a)))",
    pressure: None,
    parameters: PARAMETERS,
    guard: "f′ = c r^m sin(kr) or c r^m cos(kr), whole m ≥ 0",
    reference: GENERAL,
    specializes: None,
    apply: |term| apply(term, &[("sin", Kernel::Sine), ("cos", Kernel::Cosine)]),
};

pub(super) static HYPERBOLIC: Rule = Rule {
    id: "hyperbolic-sine-cosine",
    title: "Hyperbolic sine or cosine times a power",
    pattern: "A*sinh(k*r)+C*(cosh(k*r)-1)",
    equivalent: "pi/2*k*x*(A*besseli(0,k*x)+C*struvel(0,k*x))",
    force: "pi*E*a*(A*(k*a*besseli(0,k*a)-besseli(1,k*a))+C*(k*a*struvel(0,k*a)-struvel(1,k*a)))",
    pressure: None,
    parameters: PARAMETERS,
    guard: "f′ = c r^m sinh(kr) or c r^m cosh(kr), whole m ≥ 0",
    reference: GENERAL,
    specializes: None,
    apply: |term| apply(term, &[("sinh", Kernel::HyperbolicSine), ("cosh", Kernel::HyperbolicCosine)]),
};

pub(super) static EXPONENTIAL: Rule = Rule {
    id: "exponential",
    title: "Exponential growth or decay times a power",
    pattern: "A*(exp(q*r)-1)+C*(1-exp(-k*r))",
    equivalent: "pi/2*x*(A*q*(besseli(0,q*x)+struvel(0,q*x))+C*k*(besseli(0,k*x)-struvel(0,k*x)))",
    force: "pi*E*a*(A*(q*a*(besseli(0,q*a)+struvel(0,q*a))-besseli(1,q*a)-struvel(1,q*a))\
            +C*(k*a*(besseli(0,k*a)-struvel(0,k*a))-besseli(1,k*a)+struvel(1,k*a)))",
    pressure: None,
    // Of e^(kr) and e^(−kr) together the recognition form makes hyperbolic functions.
    parameters: &[
        Parameter { name: "A", lowest: 0.1, highest: 2.0 },
        Parameter { name: "C", lowest: 0.1, highest: 2.0 },
        Parameter { name: "q", lowest: 0.3, highest: 0.9 },
        Parameter { name: "k", lowest: 1.0, highest: 2.0 },
    ],
    guard: "f′ = c r^m exp(kr), k of either sign, whole m ≥ 0",
    reference: GENERAL,
    specializes: None,
    apply: |term| apply(term, &[("exp", Kernel::Exponential)]),
};

/// Kernels φ with φ′ = ±ψ: what the moment of order 0, (π/2) B_0, becomes under derivatives with respect to k.
#[derive(Clone, Copy, PartialEq)]
enum Kernel {
    Sine,
    Cosine,
    HyperbolicSine,
    HyperbolicCosine,
    Exponential,
    Decay,
}

/// The function B_0 of a kernel.
#[derive(Clone, Copy, PartialEq)]
enum Family {
    Bessel,
    Struve,
    ModifiedBessel,
    ModifiedStruve,
    Growth,
    Decay,
}

/// f′ = c·r^m·φ(kr).
fn apply(term: &Term, kernels: &[(&str, Kernel)]) -> Option<Answer> {
    let (part, m) = moments::whole(term)?;
    let Node::Function(function, _) = part.kernel.node() else { return None };
    let (_, kernel) = kernels.iter().find(|(name, _)| *name == function.name())?;
    let [argument] = reading::call(&part.kernel, function.name())? else { return None };
    let (k, negative) = moments::wavenumber(argument)?;
    let (kernel, coefficient) = match kernel {
        Kernel::Exponential if negative => (Kernel::Decay, part.coefficient.clone()),
        Kernel::Sine | Kernel::HyperbolicSine if negative => (*kernel, -&part.coefficient),
        _ => (*kernel, part.coefficient.clone()),
    };
    let moment = |m: i64| kernel.moment(m);
    let members = |m: i64, y: &Expr| kernel.base(m).0.members(y);
    Some(moments::answer(&coefficient, m, &Moments { scale: k, moment: &moment, members: &members, shown: &members, apart: false }))
}

impl Kernel {
    /// The family and the sign of the kernel φ_0 with φ_0^(m) = ±φ.
    fn base(self, m: i64) -> (Family, i64) {
        let (even, alternating) = (m % 2 == 0, if m / 2 % 2 == 0 { 1 } else { -1 });
        match self {
            Self::Sine if even => (Family::Struve, alternating),
            Self::Sine => (Family::Bessel, -alternating),
            Self::Cosine if even => (Family::Bessel, alternating),
            Self::Cosine => (Family::Struve, alternating),
            Self::HyperbolicSine if even => (Family::ModifiedStruve, 1),
            Self::HyperbolicSine => (Family::ModifiedBessel, 1),
            Self::HyperbolicCosine if even => (Family::ModifiedBessel, 1),
            Self::HyperbolicCosine => (Family::ModifiedStruve, 1),
            Self::Exponential => (Family::Growth, 1),
            Self::Decay => (Family::Decay, if even { 1 } else { -1 }),
        }
    }

    /// y^m ∫₀^(π/2) sin^m t φ(y sin t) dt = ±y^m (d/dy)^m (π/2) B_0(y).
    fn moment(self, m: i64) -> Combination {
        let (family, sign) = self.base(m);
        let law = family.law();
        (0..m).fold(Combination::single(0, sign, 1, 0), |moment, _| moment.derivative(&law)).scaled(1, 1, m)
    }
}

impl Family {
    /// (π/2) B_0, (π/2) B_1 and 1.
    fn members(self, y: &Expr) -> Vec<Member> {
        let own = |order: i64| {
            let call = |name| Expr::call(name, [Expr::integer(order), y.clone()]);
            match self {
                Self::Bessel => call("besselj"),
                Self::Struve => call("struveh"),
                Self::ModifiedBessel => call("besseli"),
                Self::ModifiedStruve => call("struvel"),
                Self::Growth => call("besseli") + call("struvel"),
                Self::Decay => call("bessel_struve"),
            }
        };
        let half_pi = Expr::pi() / Expr::integer(2);
        vec![member(half_pi.clone(), own(0)), member(half_pi, own(1)), member(Expr::one(), Expr::one())]
    }

    /// B_0′ = ±B_1 + c·2/π and B_1′ = B_0 − B_1/y.
    fn law(self) -> Law {
        let (next, constant) = match self {
            Self::Bessel => (-1, 0),
            Self::Struve => (-1, 1),
            Self::ModifiedBessel => (1, 0),
            Self::ModifiedStruve | Self::Growth => (1, 1),
            Self::Decay => (1, -1),
        };
        let single = Combination::single;
        vec![single(1, next, 1, 0).plus(&single(2, constant, 1, 0)), single(0, 1, 1, 0).plus(&single(1, -1, 1, -1)), Combination::default()]
    }
}
