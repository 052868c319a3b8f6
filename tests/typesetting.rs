//! LaTeX as a careful author sets it: judged formula by formula, then properties of all.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use sneddon::{parse, print};

fn latex(text: &str) -> String {
    print::latex(&parse::formula(text).unwrap_or_else(|error| panic!("{text}: {error} at {:?}", error.span())))
}

/// What is typed, what is printed as LaTeX, what is printed as text.
const TABLE: &[(&str, &str, &str)] = &[
    // Numbers, powers, roots.
    ("3/2", r"\frac{3}{2}", "3/2"),
    ("-3/2", r"-\frac{3}{2}", "-3/2"),
    ("0.7*r", r"0.7 r", "0.7*r"),
    ("1e-6*r", r"10^{-6} r", "1e-6*r"),
    ("2.5e-6*r", r"2.5 \cdot 10^{-6} r", "2.5e-6*r"),
    ("3*2^n", r"3 \cdot 2^{n}", "3*2^n"),
    ("(3/2)^n", r"\left(\frac{3}{2}\right)^{n}", "(3/2)^n"),
    ("r^n", "r^{n}", "r^n"),
    ("r^(n+1)", "r^{n + 1}", "r^(n + 1)"),
    ("r^(n/2)", "r^{n/2}", "r^(n/2)"),
    ("r^(3/2)", "r^{3/2}", "r^(3/2)"),
    ("(x-b)^(1/n)", "(x - b)^{1/n}", "(x - b)^(1/n)"),
    ("c^(-1/n)", r"\frac{1}{c^{1/n}}", "1/c^(1/n)"),
    ("(d/C)^(1/n)", r"\left(\frac{d}{C}\right)^{1/n}", "(d/C)^(1/n)"),
    ("r^1.5", "r^{1.5}", "r^1.5"),
    ("sqrt(2)*r", r"\sqrt{2}\, r", "sqrt(2)*r"),
    ("sqrt(2*R)*d^(3/2)", r"\sqrt{2 R}\, d^{3/2}", "sqrt(2*R)*d^(3/2)"),
    ("sqrt(2*pi)*x", r"\sqrt{2 \pi}\, x", "sqrt(2*pi)*x"),
    ("sqrt(R*d)", r"\sqrt{R d}", "sqrt(R*d)"),
    ("sqrt((x-b)*(x+b))", r"\sqrt{(x + b) (x - b)}", "sqrt((x + b)*(x - b))"),
    ("x/R*sqrt(R)*sqrt(x^2-b^2)", r"\frac{x}{\sqrt{R}} \sqrt{x^{2} - b^{2}}", "x/sqrt(R)*sqrt(x^2 - b^2)"),
    ("(b+c)/(r+b)*ln(r/b)", r"\frac{b + c}{r + b} \ln\left(\frac{r}{b}\right)", "(b + c)/(r + b)*ln(r/b)"),
    ("r/sqrt(2)", r"\frac{\sqrt{2}}{2} r", "sqrt(2)/2*r"),
    ("r^(1/3)", r"\sqrt[3]{r}", "r^(1/3)"),
    ("(r^2+b^2)^(1/3)", r"\sqrt[3]{r^{2} + b^{2}}", "(r^2 + b^2)^(1/3)"),
    ("(r^2+b^2)^(3/2)", r"(r^{2} + b^{2})^{3/2}", "(r^2 + b^2)^(3/2)"),
    ("1/r^2", r"\frac{1}{r^{2}}", "1/r^2"),
    ("1/sqrt(r)", r"\frac{1}{\sqrt{r}}", "1/sqrt(r)"),
    ("E^2*a", r"{E^{*}}^{2} a", "E^2*a"),
    // The formulas of contact mechanics.
    ("r^2/(2*R)", r"\frac{r^{2}}{2 R}", "r^2/(2*R)"),
    ("x^2/R", r"\frac{x^{2}}{R}", "x^2/R"),
    ("4/3*E*sqrt(R)*d^(3/2)", r"\frac{4}{3} E^{*} \sqrt{R}\, d^{3/2}", "4/3*E*sqrt(R)*d^(3/2)"),
    ("4*E*a^3/(3*R)", r"\frac{4 E^{*} a^{3}}{3 R}", "4*E*a^3/(3*R)"),
    ("2*E*a", r"2 E^{*} a", "2*E*a"),
    ("2*E*a*d", r"2 E^{*} a d", "2*E*a*d"),
    ("pi/2*x*tan(theta)", r"\frac{\pi}{2} x \tan\theta", "pi/2*x*tan(theta)"),
    ("tan(theta)*E*a^2", r"E^{*} a^{2} \tan\theta", "E*a^2*tan(theta)"),
    ("2*E*d^2/(pi*tan(theta))", r"\frac{2 E^{*} d^{2}}{\pi \tan\theta}", "2*E*d^2/(pi*tan(theta))"),
    ("x^2/R + pi/2*x*tan(theta)", r"\frac{x^{2}}{R} + \frac{\pi}{2} x \tan\theta", "x^2/R + pi/2*x*tan(theta)"),
    ("R - sqrt(R^2-r^2)", r"R - \sqrt{R^{2} - r^{2}}", "R - sqrt(R^2 - r^2)"),
    ("x/R*sqrt(x^2-b^2)", r"\frac{x}{R} \sqrt{x^{2} - b^{2}}", "x/R*sqrt(x^2 - b^2)"),
    ("x*atanh(x/R)", r"x \operatorname{artanh}\left(\frac{x}{R}\right)", "x*atanh(x/R)"),
    ("x*tan(theta)*acos(b/x)", r"x \arccos\left(\frac{b}{x}\right) \tan\theta", "x*acos(b/x)*tan(theta)"),
    ("h*(1-exp(-r^2/w^2))", r"h (1 - e^{-r^{2}/w^{2}})", "h*(1 - exp(-r^2/w^2))"),
    ("h*exp(-r^2/(2*w^2))", r"h e^{-r^{2}/(2 w^{2})}", "h*exp(-r^2/(2*w^2))"),
    ("sqrt(pi)*h*x/w*erf(x/w)", r"\frac{\sqrt{\pi}\, h x}{w} \operatorname{erf}\left(\frac{x}{w}\right)", "sqrt(pi)*h*x/w*erf(x/w)"),
    ("2*E/(pi*R)*sqrt(a^2-r^2)", r"\frac{2 E^{*}}{\pi R} \sqrt{a^{2} - r^{2}}", "2*E/(pi*R)*sqrt(a^2 - r^2)"),
    ("E*d/(pi*sqrt(a^2-r^2))", r"\frac{E^{*} d}{\pi \sqrt{a^{2} - r^{2}}}", "E*d/(pi*sqrt(a^2 - r^2))"),
    ("E/2*tan(theta)*acosh(a/r)", r"\frac{E^{*}}{2} \operatorname{arcosh}\left(\frac{a}{r}\right) \tan\theta", "E/2*acosh(a/r)*tan(theta)"),
    (
        "E*((a^2+R^2)*atanh(a/R)-a*R)",
        r"E^{*} \left((a^{2} + R^{2}) \operatorname{artanh}\left(\frac{a}{R}\right) - R a\right)",
        "E*((a^2 + R^2)*atanh(a/R) - R*a)",
    ),
    (
        "sqrt(pi)/2*gamma(n/2+1)/gamma(n/2+1/2)",
        r"\frac{\sqrt{\pi}\, \Gamma\left(\frac{n}{2} + 1\right)}{2 \Gamma\left(\frac{n}{2} + \frac{1}{2}\right)}",
        "sqrt(pi)*gamma(n/2 + 1)/(2*gamma(n/2 + 1/2))",
    ),
    ("C*r^n", "C r^{n}", "C*r^n"),
    // Functions.
    ("sin(theta)^2", r"\sin^{2}\theta", "sin(theta)^2"),
    ("sin(k*r)", r"\sin(k r)", "sin(k*r)"),
    ("sin(k*r)^2/r", r"\frac{\sin^{2}(k r)}{r}", "sin(k*r)^2/r"),
    ("sin(r/w)", r"\sin\left(\frac{r}{w}\right)", "sin(r/w)"),
    ("sqrt(tan(theta))", r"\sqrt{\tan\theta}", "sqrt(tan(theta))"),
    ("1/tan(theta)^2", r"\frac{1}{\tan^{2}\theta}", "1/tan(theta)^2"),
    ("ln(2)*r", r"r \ln 2", "r*ln(2)"),
    ("ln(r)", r"\ln r", "ln(r)"),
    ("r*ln(1+r/b)", r"r \ln\left(1 + \frac{r}{b}\right)", "r*ln(1 + r/b)"),
    ("exp(-x*tan(theta)/2)", r"e^{-x \tan(\theta)/2}", "exp(-x/2*tan(theta))"),
    ("exp(r)*sin(r)*(b+c)", r"(b + c) e^{r} \sin r", "(b + c)*exp(r)*sin(r)"),
    ("abs(r-b)", r"\left|r - b\right|", "abs(r - b)"),
    ("max(0, r-b)", r"\max(0, r - b)", "max(0, r - b)"),
    ("gamma(n)^2", r"\Gamma^{2}(n)", "gamma(n)^2"),
    ("x*struveh(0, k*x)", r"x \mathbf{H}_{0}(k x)", "x*struveh(0, k*x)"),
    ("x*struvel(1, k*x)", r"x \mathbf{L}_{1}(k x)", "x*struvel(1, k*x)"),
    ("x*besselj(0, x/w)", r"x J_{0}\left(\frac{x}{w}\right)", "x*besselj(0, x/w)"),
    ("x/w*dawson(x/w)", r"\frac{x}{w} \operatorname{D}\left(\frac{x}{w}\right)", "x/w*dawson(x/w)"),
    ("erfi(k*x)", r"\operatorname{erfi}(k x)", "erfi(k*x)"),
    ("fresnelc(k*x)-fresnels(k*x)", r"C(k x) - S(k x)", "fresnelc(k*x) - fresnels(k*x)"),
    ("digamma(n)", r"\psi(n)", "digamma(n)"),
    ("polygamma(2, n)", r"\psi^{(2)}(n)", "polygamma(2, n)"),
    ("betainc(n, 1/2, 0, z)", r"\operatorname{B}\left(n, \frac{1}{2}; 0, z\right)", "betainc(n, 1/2, 0, z)"),
    ("hyp1f1(n, 2, -k)", r"{}_{1}F_{1}(n; 2; -k)", "hyp1f1(n, 2, -k)"),
    ("hyp2f1(n, 1, 1/2, -k)", r"{}_{2}F_{1}\left(n, 1; \frac{1}{2}; -k\right)", "hyp2f1(n, 1, 1/2, -k)"),
    ("hyper([n], [1/2, k], z)", r"{}_{1}F_{2}\left(n; \frac{1}{2}, k; z\right)", "hyper([n], [1/2, k], z)"),
    ("ellipk(k)", "K(k)", "ellipk(k)"),
    ("ellipe(phi, k)", r"E(\phi \mid k)", "ellipe(phi, k)"),
    ("ellipf(phi, b/c)", r"F\left(\phi \mid \frac{b}{c}\right)", "ellipf(phi, b/c)"),
    ("elliprc(b, c)", r"R_{C}(b, c)", "elliprc(b, c)"),
    ("polylog(2, z)", r"\operatorname{Li}_{2}(z)", "polylog(2, z)"),
    ("clsin(2, theta)", r"\operatorname{Cl}_{2}(\theta)", "clsin(2, theta)"),
    // Signs and sums.
    ("-r", "-r", "-r"),
    ("-(r+b)/2", r"-\frac{r + b}{2}", "-(r + b)/2"),
    ("(r+b)/(2*c)", r"\frac{r + b}{2 c}", "(r + b)/(2*c)"),
    ("r/2-b/3", r"\frac{r}{2} - \frac{b}{3}", "r/2 - b/3"),
    ("b^2-x^2", "b^{2} - x^{2}", "b^2 - x^2"),
    ("x^2-b^2", "x^{2} - b^{2}", "x^2 - b^2"),
    ("-x^2-b^2", "-x^{2} - b^{2}", "-x^2 - b^2"),
    ("1+r^2/w^2", r"1 + \frac{r^{2}}{w^{2}}", "1 + r^2/w^2"),
    ("1-cos(k*r)", r"1 - \cos(k r)", "1 - cos(k*r)"),
    ("cosh(k*r)-1", r"\cosh(k r) - 1", "cosh(k*r) - 1"),
    ("n+1", "n + 1", "n + 1"),
    ("c_2*r^4+c_1*r^2", "c_{2} r^{4} + c_{1} r^{2}", "c_2*r^4 + c_1*r^2"),
    ("2*(b+c)*r", "2 r (b + c)", "2*r*(b + c)"),
    ("x-2*(b+c)", "x - 2 (b + c)", "x - 2*(b + c)"),
    // Pieces and integrals.
    ("piecewise(0, r<b, r-b)", r"\begin{cases} 0, & r < b \\ r - b, & r \ge b \end{cases}", "piecewise(0, r < b, r - b)"),
    (
        "piecewise(0, x<b, x/2, x<c, 1)",
        r"\begin{cases} 0, & x < b \\ \frac{x}{2}, & b \le x < c \\ 1, & x \ge c \end{cases}",
        "piecewise(0, x < b, x/2, x < c, 1)",
    ),
    ("x^2 - piecewise(0, x<b, x)", r"x^{2} + \begin{cases} 0, & x < b \\ -x, & x \ge b \end{cases}", "x^2 + piecewise(0, x < b, -x)"),
    (
        "2*E*integral(r^2/sqrt(a^2-r^2), r, 0, a)",
        r"2 E^{*} \int_{0}^{a} \frac{r^{2}}{\sqrt{a^{2} - r^{2}}} \,\mathrm{d}r",
        "2*E*integral(r^2/sqrt(a^2 - r^2), r, 0, a)",
    ),
    ("x - 2/pi*integral(t+1, t, b, x)", r"x - \frac{2}{\pi} \int_{b}^{x} (t + 1) \,\mathrm{d}t", "x - 2/pi*integral(t + 1, t, b, x)"),
];

#[test]
fn formulas_are_set_as_a_careful_author_sets_them() {
    let mut wrong = Vec::new();
    for (typed, expected, expected_text) in TABLE {
        let formula = parse::formula(typed).unwrap_or_else(|error| panic!("{typed}: {error} at {:?}", error.span()));
        for (found, expected) in [(print::latex(&formula), expected), (print::text(&formula), expected_text)] {
            if found != *expected {
                wrong.push(format!("{typed}\n   found    {found}\n   expected {expected}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn conditions_are_set() {
    let formula = |text: &str| parse::formula(text).unwrap().as_closed().unwrap().clone();
    let condition = sneddon::expr::Condition::less(formula("r"), formula("R_tip"));
    assert_eq!(print::latex_condition(&condition), r"r < R_{\mathrm{tip}}");
    assert_eq!(print::text_condition(&condition), "r < R_tip");
}

#[test]
fn the_printed_text_is_set_alike() {
    for (typed, ..) in TABLE {
        let text = print::text(&parse::formula(typed).unwrap());
        assert_eq!(latex(&text), latex(typed));
    }
}

/// What is typed, and how Unicode and Typst show it.
const OTHER_NOTATIONS: &[(&str, &str, &str)] = &[
    ("r^2/(2*R)", "r²/(2·R)", "frac(r^(2), 2 R)"),
    ("1e-6*r^(n/2)", "10⁻⁶·r^(n/2)", "10^(-6) r^(n slash 2)"),
    ("-(r+b)/2", "−(r + b)/2", "-frac(r + b, 2)"),
    ("E^2*sqrt(2*R)", "E*²·√(2·R)", "(E^*)^(2) sqrt(2 R)"),
    ("(r^2+b^2)^(1/3)", "³√(r² + b²)", "root(3, r^(2) + b^(2))"),
    ("x*tan(theta_0)", "x·tan θ₀", "x tan θ_(0)"),
    ("sin(k*r)^2", "sin²(k·r)", "sin^(2) lr((k r))"),
    ("R_tip*exp(-r^2/w^2)", "R_tip·e^(−r²/w²)", "upright(\"tip\")"),
    ("x*struveh(0, k*x)", "x·H₀(k·x)", "x upright(bold(H))_(0) lr((k x))"),
    ("ellipf(phi, k)", "F(φ | k)", "F lr((φ | k))"),
    ("hyp2f1(n, 1, b, -k)", "₂F₁(n, 1; b; −k)", "attach(F, bl: 2, br: 1) lr((n, 1\\; b\\; -k))"),
    ("abs(r-b)", "|r − b|", "abs(r - b)"),
    ("piecewise(0, r<b, r-b)", "{ 0 for r < b; r − b beyond }", "cases(0 & \"if\" r < b, r - b & \"if\" r >= b)"),
    ("integral(r+1, r, 0, a)", "∫[0, a] (1 + r) dr", "integral_(0)^(a) (1 + r) dif r"),
];

#[test]
fn unicode_and_typst_show_the_same_formulas() {
    for (typed, unicode, typst) in OTHER_NOTATIONS {
        let formula = parse::formula(typed).unwrap_or_else(|error| panic!("{typed}: {error}"));
        assert_eq!(print::unicode(&formula), *unicode);
        assert!(print::typst(&formula).contains(typst), "{typed}: {}", print::typst(&formula));
    }
}

#[test]
fn mathml_is_well_formed_and_has_every_number_and_name() {
    let rules =
        sneddon::transform::rules::RULES.iter().flat_map(|rule| [rule.pattern, rule.slope, rule.force].into_iter().chain(rule.pressure));
    for typed in TABLE.iter().map(|(typed, ..)| *typed).chain(rules) {
        let formula = parse::formula(typed).unwrap_or_else(|error| panic!("{typed}: {error}"));
        let mathml = print::mathml(&formula);
        let mut open = Vec::new();
        for part in mathml.split('<').skip(1) {
            let (tag, _) = part.split_once('>').unwrap_or_else(|| panic!("{typed}: {part}"));
            match tag.strip_prefix('/') {
                Some(name) => assert_eq!(open.pop(), Some(name), "{typed}: {mathml}"),
                None if tag.ends_with('/') => {}
                None => open.push(tag.split(' ').next().unwrap()),
            }
        }
        assert!(open.is_empty(), "{typed}: {open:?}");
        // A fraction, a power and an index have exactly two parts each.
        assert_eq!(mathml.matches("<mfrac>").count(), print::latex(&formula).matches("\\frac").count(), "{typed}");
        assert_eq!(mathml.matches("<msqrt>").count(), print::latex(&formula).matches("\\sqrt{").count(), "{typed}");
    }
}
