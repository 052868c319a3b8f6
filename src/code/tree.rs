//! A small program: routines over doubles, of assignments, branches and loops, which every language can say.

/// The four operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
}

/// A number that is computed.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// A literal, and whether it is meant exactly; a constant such as π is not.
    Number(f64, bool),
    Name(String),
    Binary(Operator, Box<Value>, Box<Value>),
    /// A function of the language, of its library, or a routine of the program.
    Call(String, Vec<Value>),
    /// An element of an array; the index is a whole number.
    Element(String, Box<Value>),
}

/// How two numbers compare; a comparison with NaN is false.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Comparison {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
}

/// A condition.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Test {
    Compare(Comparison, Value, Value),
    All(Vec<Test>),
    Any(Vec<Test>),
    Not(Box<Test>),
}

/// A step of a routine.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    /// A new variable.
    Let(String, Value),
    /// A new value of a variable.
    Set(String, Value),
    /// A new array of [`LENGTH`] zeros.
    Array(String),
    /// A new array with these numbers, which do not change.
    Table(String, Vec<f64>),
    /// A new value of an element of an array.
    SetElement(String, Value, Value),
    If(Test, Vec<Statement>, Vec<Statement>),
    While(Test, Vec<Statement>),
    Return(Value),
}

/// A function of doubles that returns a double; NaN outside its domain.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Routine {
    pub(super) name: String,
    pub(super) parameters: Vec<String>,
    pub(super) body: Vec<Statement>,
    /// The description, one entry per line.
    pub(super) comment: Vec<String>,
}

/// How many elements an array has.
pub(super) const LENGTH: usize = 110;

/// The name of the constant NaN in value trees.
pub(super) const NAN: &str = "nan";

impl Value {
    pub(super) fn name(name: &str) -> Self {
        Self::Name(name.to_owned())
    }

    pub(super) fn call(name: &str, arguments: Vec<Value>) -> Self {
        Self::Call(name.to_owned(), arguments)
    }

    pub(super) fn binary(operator: Operator, left: Value, right: Value) -> Self {
        Self::Binary(operator, Box::new(left), Box::new(right))
    }

    /// The number of operations.
    pub(super) fn size(&self) -> usize {
        match self {
            Self::Number(..) | Self::Name(_) => 0,
            Self::Binary(_, left, right) => 1 + left.size() + right.size(),
            Self::Call(_, arguments) => 1 + arguments.iter().map(Self::size).sum::<usize>(),
            Self::Element(_, index) => index.size(),
        }
    }

    /// Visits every value in it, itself first.
    pub(super) fn visit(&self, see: &mut impl FnMut(&Value)) {
        see(self);
        match self {
            Self::Number(..) | Self::Name(_) => {}
            Self::Binary(_, left, right) => {
                left.visit(see);
                right.visit(see);
            }
            Self::Call(_, arguments) => arguments.iter().for_each(|own| own.visit(see)),
            Self::Element(_, index) => index.visit(see),
        }
    }
}

impl Test {
    fn visit(&self, see: &mut impl FnMut(&Value)) {
        match self {
            Self::Compare(_, left, right) => {
                left.visit(see);
                right.visit(see);
            }
            Self::All(list) | Self::Any(list) => list.iter().for_each(|own| own.visit(see)),
            Self::Not(own) => own.visit(see),
        }
    }
}

impl Statement {
    /// Returns true for a condition with nothing to do in either case.
    pub(super) fn is_idle(&self) -> bool {
        matches!(self, Self::If(_, yes, no) if yes.iter().chain(no).all(Self::is_idle))
    }

    fn visit(&self, see: &mut impl FnMut(&Value)) {
        let mut block = |list: &[Statement]| list.iter().for_each(|own| own.visit(see));
        match self {
            Self::Let(_, value) | Self::Set(_, value) | Self::Return(value) => value.visit(see),
            Self::Array(_) | Self::Table(..) => {}
            Self::SetElement(_, index, value) => {
                index.visit(see);
                value.visit(see);
            }
            Self::If(test, yes, no) => {
                block(yes);
                block(no);
                test.visit(see);
            }
            Self::While(test, body) => {
                block(body);
                test.visit(see);
            }
        }
    }

    /// Replaces the assignment of `placeholder` by that of `value`, preceded by the statements that compute it.
    pub(super) fn replace(&mut self, placeholder: &Value, before: &[Statement], value: &Value) {
        let (Self::If(_, yes, _) | Self::While(_, yes)) = self else { return };
        let place = yes.iter().position(|own| matches!(own, Self::Set(_, own) if own == placeholder));
        if let Some((place, Self::Set(_, own))) = place.and_then(|place| Some((place, yes.get_mut(place)?))) {
            *own = value.clone();
            yes.splice(place..place, before.iter().cloned());
        }
        yes.iter_mut().for_each(|own| own.replace(placeholder, before, value));
    }

    /// Visits every statement in it, itself first.
    pub(super) fn steps(&self, see: &mut impl FnMut(&Statement)) {
        see(self);
        match self {
            Self::If(_, yes, no) => yes.iter().chain(no).for_each(|own| own.steps(see)),
            Self::While(_, body) => body.iter().for_each(|own| own.steps(see)),
            Self::Let(..) | Self::Set(..) | Self::Return(_) | Self::Array(_) | Self::Table(..) | Self::SetElement(..) => {}
        }
    }
}

impl Routine {
    /// The names of everything that it calls, each once, in the order of their first use.
    pub(super) fn calls(&self) -> Vec<String> {
        let mut found: Vec<String> = Vec::new();
        let mut see = |value: &Value| {
            if let Value::Call(name, _) = value
                && !found.contains(name)
            {
                found.push(name.clone());
            }
        };
        self.body.iter().for_each(|own| own.visit(&mut see));
        found
    }

    /// The variables that it makes, each once.
    pub(super) fn variables(&self) -> Vec<String> {
        self.names(|own| if let Statement::Let(name, _) = own { Some(name) } else { None })
    }

    /// The arrays that it makes.
    pub(super) fn arrays(&self) -> Vec<String> {
        self.names(|own| if let Statement::Array(name) = own { Some(name) } else { None })
    }

    /// The tables that it makes, with the number of their elements.
    pub(super) fn tables(&self) -> Vec<(String, usize)> {
        let mut found = Vec::new();
        self.body.iter().for_each(|own| {
            own.steps(&mut |own| {
                if let Statement::Table(name, values) = own {
                    found.push((name.clone(), values.len()));
                }
            })
        });
        found
    }

    /// The variables that change.
    pub(super) fn changed(&self) -> Vec<String> {
        self.names(|own| if let Statement::Set(name, _) = own { Some(name) } else { None })
    }

    /// The names that are picked from its statements, each once.
    fn names(&self, pick: impl Fn(&Statement) -> Option<&String>) -> Vec<String> {
        let mut found: Vec<String> = Vec::new();
        let mut see = |own: &Statement| found.extend(pick(own).filter(|name| !found.contains(name)).cloned());
        self.body.iter().for_each(|own| own.steps(&mut see));
        found
    }

    /// Whether a parameter is read.
    pub(super) fn reads(&self, name: &str) -> bool {
        let mut found = false;
        self.body.iter().for_each(|own| own.visit(&mut |value| found |= *value == Value::name(name)));
        found
    }
}

/// New names of variables.
type Renaming = std::collections::BTreeMap<String, String>;

fn new_name(name: &str, renaming: &Renaming) -> String {
    renaming.get(name).cloned().unwrap_or_else(|| name.to_owned())
}

impl Value {
    fn renamed(&self, renaming: &Renaming) -> Self {
        match self {
            Self::Number(..) => self.clone(),
            Self::Name(name) => Self::Name(new_name(name, renaming)),
            Self::Binary(operator, left, right) => Self::binary(*operator, left.renamed(renaming), right.renamed(renaming)),
            Self::Call(name, arguments) => Self::Call(name.clone(), arguments.iter().map(|own| own.renamed(renaming)).collect()),
            Self::Element(name, index) => Self::Element(new_name(name, renaming), Box::new(index.renamed(renaming))),
        }
    }
}

impl Test {
    fn renamed(&self, renaming: &Renaming) -> Self {
        let every = |list: &[Test]| list.iter().map(|own| own.renamed(renaming)).collect();
        match self {
            Self::Compare(comparison, left, right) => Self::Compare(*comparison, left.renamed(renaming), right.renamed(renaming)),
            Self::All(list) => Self::All(every(list)),
            Self::Any(list) => Self::Any(every(list)),
            Self::Not(own) => Self::Not(Box::new(own.renamed(renaming))),
        }
    }
}

impl Statement {
    /// The same with other names of variables.
    pub(super) fn renamed(&self, renaming: &Renaming) -> Self {
        let every = |list: &[Statement]| list.iter().map(|own| own.renamed(renaming)).collect();
        match self {
            Self::Let(name, value) => Self::Let(new_name(name, renaming), value.renamed(renaming)),
            Self::Set(name, value) => Self::Set(new_name(name, renaming), value.renamed(renaming)),
            Self::If(test, yes, no) => Self::If(test.renamed(renaming), every(yes), every(no)),
            Self::While(test, body) => Self::While(test.renamed(renaming), every(body)),
            Self::Return(value) => Self::Return(value.renamed(renaming)),
            Self::Array(name) => Self::Array(new_name(name, renaming)),
            Self::Table(name, values) => Self::Table(new_name(name, renaming), values.clone()),
            Self::SetElement(name, index, value) => {
                Self::SetElement(new_name(name, renaming), index.renamed(renaming), value.renamed(renaming))
            }
        }
    }
}
