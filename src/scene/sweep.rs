//! A scene whose loads increase evenly from zero to its largest load, for curves over the load.

use super::{Loads, Quantity, Scene, Steps};

impl Scene {
    /// Returns the same scene with `count` loads from 0 to the largest one, and these quantities per load.
    ///
    /// ```
    /// use sneddon::scene::{Loads, Quantity, Scene};
    /// use sneddon::{parse, transform::Profile};
    /// let scene = Scene::of(Profile::new(&parse::profile("r^2/2").unwrap()).unwrap());
    /// let swept = Scene { loads: Loads::List(vec![3.0, 2.0]), ..scene }.swept(4, &[Quantity::Force]);
    /// assert_eq!(swept.loads.iter().collect::<Vec<_>>(), [0.0, 1.0, 2.0, 3.0]);
    /// ```
    #[must_use]
    pub fn swept(&self, count: usize, data: &[Quantity]) -> Self {
        let largest = self.loads.extremes().map_or(0.0, |(_, largest)| largest);
        let mut swept = self.clone();
        swept.loads = Loads::Range(Steps::new(0.0.into(), largest.into(), count, false));
        swept.outputs.data = data.to_vec();
        swept.outputs.curves.clear();
        swept.shown = None;
        swept
    }
}
