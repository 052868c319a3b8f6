//! Tests of scenes, named shapes, measured tips and reference data.

mod columns;
mod random_scenes;
mod reference;
mod scene_extremes;
mod scene_shapes;
mod tips;
mod units;
