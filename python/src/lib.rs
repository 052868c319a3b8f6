//! The compiled part of the Python package `sneddon`: formulas, numbers over arrays, and scenes.
//!
//! Shapes, broadcasting and classes are in the Python files beside it; what is here takes flat arrays of 64-bit floats and text.
#![deny(unsafe_code)]

mod engine;
mod error;
mod formulas;
mod interrupt;
mod scenes;

use pyo3::prelude::*;

#[pymodule]
fn _sneddon(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<engine::Engine>()?;
    module.add_function(wrap_pyfunction!(formulas::derive, module)?)?;
    module.add_function(wrap_pyfunction!(formulas::compare, module)?)?;
    module.add_function(wrap_pyfunction!(formulas::invert, module)?)?;
    module.add_function(wrap_pyfunction!(formulas::inverted, module)?)?;
    module.add_function(wrap_pyfunction!(formulas::parameters, module)?)?;
    module.add_function(wrap_pyfunction!(formulas::rules, module)?)?;
    module.add_function(wrap_pyfunction!(engine::quantities, module)?)?;
    module.add_function(wrap_pyfunction!(scenes::solve, module)?)?;
    module.add_function(wrap_pyfunction!(scenes::reference, module)?)?;
    module.add_function(wrap_pyfunction!(scenes::validate, module)?)?;
    Ok(())
}
