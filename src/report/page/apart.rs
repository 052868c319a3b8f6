//! Parameters whose letters a page also needs for a quantity or a special function are set apart by an index.

use super::{Block, Page, Range};
use crate::expr::{Bindings, Expr, Formula, Node, Symbol, shown_as_mathematics};
use crate::print::Prose;
use std::collections::BTreeSet;

impl Page {
    /// The page with indices for parameters that would be read as a quantity or a function, and a remark for each below the first equation.
    pub(super) fn apart(&self) -> Self {
        let used = self.letters();
        let mut taken: BTreeSet<String> = self.formulas().flat_map(Formula::symbols).map(|own| own.name().to_owned()).collect();
        let mut bindings = Bindings::default();
        let mut remarks = Vec::new();
        for name in self.parameters.iter().filter(|own| used.contains(own.as_str())) {
            let free = (0..).map(|index| format!("{name}_{index}")).find(|own| !taken.contains(own));
            let Some(new) = free else { continue };
            bindings.insert(Symbol::new(name), Expr::symbol(&new));
            remarks.push(Block::Remark(Prose::read(&format!("${new}$ is the parameter {name} of the shape"))));
            taken.insert(new);
        }
        if remarks.is_empty() {
            return self.clone();
        }
        let formula = |own: &Formula| own.substitute(&bindings);
        let range = |own: &Range| Range { variable: own.variable.clone(), from: bindings.apply(&own.from) };
        let block = |own: &Block| match own {
            Block::Equation { key, left, right, range: own, sources } => Block::Equation {
                key: key.clone(),
                left: left.clone(),
                right: formula(right),
                range: own.as_ref().map(range),
                sources: sources.clone(),
            },
            Block::Where(parts) => Block::Where(parts.iter().map(|(name, own)| (name.clone(), formula(own))).collect()),
            Block::Sentence(own) => Block::Sentence(own.substitute(&bindings)),
            Block::Remark(own) => Block::Remark(own.substitute(&bindings)),
            Block::Item(kind, own) => Block::Item(kind, own.substitute(&bindings)),
            Block::Heading(..) | Block::Table(..) => own.clone(),
        };
        let mut blocks: Vec<Block> = self.blocks.iter().map(block).collect();
        let first = blocks.iter().position(|own| matches!(own, Block::Equation { .. })).map_or(0, |place| place + 1);
        blocks.splice(first..first, remarks);
        Self { blocks, ..self.clone() }
    }

    fn formulas(&self) -> impl Iterator<Item = &Formula> {
        self.blocks.iter().filter_map(|own| if let Block::Equation { right, .. } = own { Some(right) } else { None })
    }

    /// The letters of the quantities on the left of equations, and of the functions in them.
    fn letters(&self) -> BTreeSet<String> {
        let lefts = self.blocks.iter().filter_map(|own| if let Block::Equation { left, .. } = own { Some(left.as_str()) } else { None });
        let quantity =
            |left: &str| left.split(|letter: char| !letter.is_alphanumeric() && letter != '_').next().unwrap_or_default().to_owned();
        let mut letters: BTreeSet<String> = lefts.map(quantity).collect();
        for expr in self.formulas().flat_map(Formula::expressions) {
            for own in shown_as_mathematics(expr).parts() {
                let Node::Function(function, _) = own.node() else { continue };
                // The index of R_F tells it from a radius R.
                let printed = function.row().typeset.letters;
                letters.extend(printed.index.is_empty().then(|| printed.text.to_owned()));
            }
        }
        letters
    }
}
