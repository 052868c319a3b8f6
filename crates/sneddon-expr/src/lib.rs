//! Formulas: expression trees, how they are read, printed and evaluated.

pub mod eval;
pub mod expr;
pub mod parse;
pub mod print;

use sneddon_num as num;
