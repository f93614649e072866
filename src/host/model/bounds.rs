//! The box around a model.

/// An axis-aligned box in the units of the model file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The smallest x, y and z.
    pub min: [f32; 3],
    /// The largest x, y and z.
    pub max: [f32; 3],
}

impl Bounds {
    /// The box around `positions`; `None` if there is none.
    ///
    /// ```
    /// use microraster::host::Bounds;
    ///
    /// let bounds = Bounds::of(&[[0.0, 1.0, 2.0], [4.0, 0.0, 2.0]]).unwrap();
    /// assert_eq!(bounds.center(), [2.0, 0.5, 2.0]);
    /// assert_eq!(bounds.size(), [4.0, 1.0, 0.0]);
    /// assert_eq!(bounds.largest_side(), 4.0);
    /// ```
    #[must_use]
    pub fn of(positions: &[[f32; 3]]) -> Option<Self> {
        let (first, rest) = positions.split_first()?;
        let mut bounds = Self { min: *first, max: *first };
        for position in rest {
            for ((&p, min), max) in position.iter().zip(&mut bounds.min).zip(&mut bounds.max) {
                *min = min.min(p);
                *max = max.max(p);
            }
        }
        Some(bounds)
    }

    /// The middle. Halves are added, so no finite box overflows.
    #[must_use]
    pub fn center(&self) -> [f32; 3] {
        self.each(|min, max| min / 2.0 + max / 2.0)
    }

    /// The sides, each at least 0.
    ///
    /// # Range
    ///
    /// Infinite where the two ends lie further apart than the largest `f32`.
    #[must_use]
    pub fn size(&self) -> [f32; 3] {
        self.each(|min, max| max - min)
    }

    /// The longest of the three sides; 0 for a single point.
    #[must_use]
    pub fn largest_side(&self) -> f32 {
        self.size().into_iter().fold(0.0, f32::max)
    }

    fn each(&self, f: impl Fn(f32, f32) -> f32) -> [f32; 3] {
        let ([a, b, c], [d, e, g]) = (self.min, self.max);
        [f(a, d), f(b, e), f(c, g)]
    }
}
