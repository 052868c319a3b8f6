//! A scene whose loads increase evenly from zero to its largest load, for curves over the load.

use super::{Loads, Quantity, Scene, Steps};
use crate::contact::Kind;

impl Scene {
    /// Returns the same scene with `count` loads from 0 to the largest one, and all quantities per load requested.
    ///
    /// ```
    /// use sneddon::scene::{Loads, Scene};
    /// use sneddon::{parse, transform::Profile};
    /// let scene = Scene::of(Profile::new(&parse::profile("r^2/2").unwrap()).unwrap());
    /// let swept = Scene { loads: Loads::List(vec![3.0, 2.0]), ..scene }.swept(4);
    /// assert_eq!(swept.loads.iter().collect::<Vec<_>>(), [0.0, 1.0, 2.0, 3.0]);
    /// ```
    #[must_use]
    pub fn swept(&self, count: usize) -> Self {
        let largest = self.loads.extremes().map_or(0.0, |(_, largest)| largest);
        let mut swept = self.clone();
        swept.loads = Loads::Range(Steps::new(0.0.into(), largest.into(), count, false));
        swept.outputs.data = Quantity::ALL.iter().copied().filter(|own| own.kind() == Kind::Number).collect();
        swept.outputs.curves.clear();
        swept.shown = None;
        swept
    }
}
