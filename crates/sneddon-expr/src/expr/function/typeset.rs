//! How the name and the arguments of a function are set in mathematics, for every notation at once.

/// The letters of a function's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Letters {
    /// The letters themselves, Greek ones as such.
    pub text: &'static str,
    /// Their font.
    pub font: Font,
    /// A fixed index, or an empty string.
    pub index: &'static str,
}

/// The font of a function's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Font {
    /// A name of several letters, or a letter that is set like one.
    Upright,
    /// A single letter, set like a variable.
    Italic,
    /// A bold upright letter.
    Bold,
}

/// How a function and its arguments are set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    /// sin(z), Γ(z), R_C(x, y): the name before its arguments.
    Operator,
    /// J₀(z): the first argument is an index of the name.
    Indexed,
    /// ψ⁽ᵐ⁾(z): the first argument is a superscript in parentheses.
    Ordered,
    /// κₙ: the only argument is an index of the name.
    Index,
    /// F(φ | m): the last argument is a parameter behind a bar.
    Parameter,
    /// eᶻ.
    Exponential,
    /// |z|.
    Absolute,
    /// ₂F₁(a, b; c; z), or B(a, b; z₁, z₂): groups of arguments of the given sizes, separated by semicolons.
    Groups(&'static [usize]),
    /// The same with the sizes of the first two groups as the first two arguments.
    CountedGroups,
}

/// How one function is typeset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Typeset {
    /// The name.
    pub letters: Letters,
    /// The arguments.
    pub setting: Setting,
}

impl Typeset {
    /// A function that is set in this way instead.
    pub(super) const fn set(self, setting: Setting) -> Self {
        Self { setting, ..self }
    }

    /// The same name with a fixed index.
    pub(super) const fn with_index(self, index: &'static str) -> Self {
        Self { letters: Letters { index, ..self.letters }, ..self }
    }
}

const fn named(text: &'static str, font: Font) -> Typeset {
    Typeset { letters: Letters { text, font, index: "" }, setting: Setting::Operator }
}

/// An upright name before its arguments.
pub(super) const fn upright(text: &'static str) -> Typeset {
    named(text, Font::Upright)
}

/// An italic letter before its arguments.
pub(super) const fn italic(text: &'static str) -> Typeset {
    named(text, Font::Italic)
}

/// A bold letter before its arguments.
pub(super) const fn bold(text: &'static str) -> Typeset {
    named(text, Font::Bold)
}
