//! Tests of numbers and their error bounds: closed forms, quadrature, series, slices, curves, closures and tables.

mod axial_stress;
mod blocks;
mod closures;
mod curve;
mod energy;
mod estimates;
mod extremes;
mod features;
mod finite;
mod honesty;
mod poles;
mod quadrature_counts;
mod random_profiles;
mod second;
mod series;
mod singular;
mod slices;
mod slope_angles;
mod slopes;
mod solved_kinks;
mod sufficient;
mod tables;
mod typed;
mod typed_quadrature;
mod units;
mod ways;
