//! The reader of the small language in which the stable forms are written down, once for every target.

use super::tree::{Comparison, Operator, Routine, Statement, Test, Value};

/// Every routine of a text; `None` if it cannot be read.
pub(super) fn routines(text: &str) -> Option<Vec<Routine>> {
    let mut reader = Reader { tokens: tokens(text)?, at: 0 };
    let mut all = Vec::new();
    while reader.at < reader.tokens.len() {
        all.push(reader.routine()?);
    }
    Some(all)
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Comment(String),
    Name(String),
    Number(f64),
    Sign(String),
}

fn tokens(text: &str) -> Option<Vec<Token>> {
    let mut all = Vec::new();
    let characters: Vec<char> = text.chars().collect();
    let mut at = 0;
    let take = |from: usize, fits: &dyn Fn(char) -> bool| -> String { characters.iter().skip(from).take_while(|c| fits(**c)).collect() };
    while let Some(first) = characters.get(at).copied() {
        let next = characters.get(at + 1).copied();
        if first.is_whitespace() {
            at += 1;
        } else if first == '/' && next == Some('/') {
            let line = take(at, &|c| c != '\n');
            at += line.chars().count();
            all.push(Token::Comment(line.trim_start_matches('/').trim().to_owned()));
        } else if first.is_ascii_alphabetic() || first == '_' {
            let word = take(at, &|c| c.is_ascii_alphanumeric() || c == '_');
            at += word.len();
            all.push(Token::Name(word));
        } else if first.is_ascii_digit() {
            let mut word = take(at, &|c| c.is_ascii_alphanumeric() || c == '.');
            if word.ends_with('e') && characters.get(at + word.len()) == Some(&'-') {
                word = format!("{word}-{}", take(at + word.len() + 1, &|c| c.is_ascii_digit()));
            }
            at += word.len();
            all.push(Token::Number(word.parse().ok()?));
        } else {
            let double = next.map(|next| format!("{first}{next}")).filter(|own| ["<=", ">=", "==", "&&", "||"].contains(&own.as_str()));
            let sign = double.unwrap_or_else(|| first.to_string());
            at += sign.chars().count();
            all.push(Token::Sign(sign));
        }
    }
    Some(all)
}

struct Reader {
    tokens: Vec<Token>,
    at: usize,
}

impl Reader {
    fn is(&self, sign: &str) -> bool {
        matches!(self.tokens.get(self.at), Some(Token::Sign(own)) if own == sign)
    }

    fn takes(&mut self, sign: &str) -> bool {
        let found = self.is(sign);
        self.at += usize::from(found);
        found
    }

    fn expect(&mut self, sign: &str) -> Option<()> {
        self.takes(sign).then_some(())
    }

    fn word(&mut self) -> Option<String> {
        match self.tokens.get(self.at)? {
            Token::Name(name) => {
                self.at += 1;
                Some(name.clone())
            }
            _ => None,
        }
    }

    fn routine(&mut self) -> Option<Routine> {
        let mut comment = Vec::new();
        while let Some(Token::Comment(line)) = self.tokens.get(self.at) {
            comment.push(line.clone());
            self.at += 1;
        }
        (self.word()? == "fn").then_some(())?;
        let name = self.word()?;
        self.expect("(")?;
        let mut parameters = Vec::new();
        while !self.takes(")") {
            parameters.push(self.word()?);
            self.takes(",");
        }
        let body = self.block()?;
        Some(Routine { name, parameters, body, comment })
    }

    fn block(&mut self) -> Option<Vec<Statement>> {
        self.expect("{")?;
        let mut all = Vec::new();
        while !self.takes("}") {
            all.push(self.statement()?);
        }
        Some(all)
    }

    fn statement(&mut self) -> Option<Statement> {
        let word = self.word()?;
        let read = match word.as_str() {
            "if" => {
                let (test, yes) = (self.test()?, self.block()?);
                let otherwise = matches!(self.tokens.get(self.at), Some(Token::Name(own)) if own == "else");
                let no = if otherwise {
                    self.at += 1;
                    self.block()?
                } else {
                    Vec::new()
                };
                return Some(Statement::If(test, yes, no));
            }
            "while" => return Some(Statement::While(self.test()?, self.block()?)),
            "return" => Statement::Return(self.sum()?),
            "let" => {
                let name = self.word()?;
                self.expect("=")?;
                Statement::Let(name, self.sum()?)
            }
            "array" => Statement::Array(self.word()?),
            "table" => self.table()?,
            _ if self.takes("[") => {
                let index = self.sum()?;
                self.expect("]")?;
                self.expect("=")?;
                Statement::SetElement(word, index, self.sum()?)
            }
            _ => {
                self.expect("=")?;
                Statement::Set(word, self.sum()?)
            }
        };
        self.expect(";")?;
        Some(read)
    }

    fn table(&mut self) -> Option<Statement> {
        let name = self.word()?;
        self.expect("=")?;
        let mut values = Vec::new();
        loop {
            let Token::Number(value) = self.tokens.get(self.at)? else { return None };
            values.push(*value);
            self.at += 1;
            if !self.takes(",") {
                return Some(Statement::Table(name, values));
            }
        }
    }

    /// Comparisons joined by && or by ||, never by both; `!` precedes a comparison in parentheses.
    fn test(&mut self) -> Option<Test> {
        let first = self.comparison()?;
        let (mut all, sign) = (vec![first], if self.is("||") { "||" } else { "&&" });
        while self.takes(sign) {
            all.push(self.comparison()?);
        }
        match (all.len(), sign) {
            (1, _) => all.pop(),
            (_, "||") => Some(Test::Any(all)),
            _ => Some(Test::All(all)),
        }
    }

    fn comparison(&mut self) -> Option<Test> {
        if self.takes("!") {
            self.expect("(")?;
            let own = self.test()?;
            self.expect(")")?;
            return Some(Test::Not(Box::new(own)));
        }
        let left = self.sum()?;
        let known = [
            ("<=", Comparison::LessOrEqual),
            (">=", Comparison::GreaterOrEqual),
            ("<", Comparison::Less),
            (">", Comparison::Greater),
            ("==", Comparison::Equal),
        ];
        let (_, comparison) = known.into_iter().find(|(sign, _)| self.takes(sign))?;
        Some(Test::Compare(comparison, left, self.sum()?))
    }

    fn sum(&mut self) -> Option<Value> {
        let mut total = self.product()?;
        loop {
            if self.takes("+") {
                total = Value::binary(Operator::Add, total, self.product()?);
            } else if self.takes("-") {
                total = Value::binary(Operator::Subtract, total, self.product()?);
            } else {
                return Some(total);
            }
        }
    }

    fn product(&mut self) -> Option<Value> {
        let mut total = self.operand()?;
        loop {
            if self.takes("*") {
                total = Value::binary(Operator::Multiply, total, self.operand()?);
            } else if self.takes("/") {
                total = Value::binary(Operator::Divide, total, self.operand()?);
            } else {
                return Some(total);
            }
        }
    }

    fn operand(&mut self) -> Option<Value> {
        if self.takes("-") {
            return Some(Value::binary(Operator::Subtract, Value::Number(0.0, true), self.operand()?));
        }
        if self.takes("(") {
            let own = self.sum()?;
            self.expect(")")?;
            return Some(own);
        }
        if let Some(Token::Number(number)) = self.tokens.get(self.at) {
            let number = *number;
            self.at += 1;
            return Some(Value::Number(number, is_short(number)));
        }
        let name = self.word()?;
        if self.takes("[") {
            let index = self.sum()?;
            self.expect("]")?;
            return Some(Value::Element(name, Box::new(index)));
        }
        if !self.takes("(") {
            return Some(Value::Name(name));
        }
        let mut arguments = Vec::new();
        while !self.takes(")") {
            arguments.push(self.sum()?);
            self.takes(",");
        }
        Some(Value::Call(name, arguments))
    }
}

/// Returns true if the number is a multiple of 2^-30, which a double represents exactly; other numbers are treated as rounded.
fn is_short(number: f64) -> bool {
    (number * f64::from(1 << 30)).fract() == 0.0
}
