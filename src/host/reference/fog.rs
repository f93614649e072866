/// How a colour fades into the distance, by the formulas that the crate's [`Fog`](crate::Fog)
/// stands for.
///
/// Source: OpenGL 1.5, section 3.10.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fog {
    /// All is seen up to the distance `start`, nothing from `end` on.
    Linear {
        /// Where fog begins.
        start: f64,
        /// From where on there is nothing else.
        end: f64,
    },
    /// `e^(-density d)` is seen at distance d.
    Exponential {
        /// By unit of distance.
        density: f64,
    },
    /// `e^(-(density d)^2)` is seen at distance d.
    ExponentialSquared {
        /// By unit of distance.
        density: f64,
    },
}

impl Fog {
    /// How much is seen at a distance along the view, 0 to 1.
    #[must_use]
    pub fn seen(&self, distance: f64) -> f64 {
        let seen = match self {
            Self::Linear { start, end } => (end - distance) / (end - start),
            Self::Exponential { density } => (-density * distance).exp(),
            Self::ExponentialSquared { density } => (-(density * distance).powi(2)).exp(),
        };
        seen.clamp(0.0, 1.0)
    }

    /// A colour seen through fog of another, at a distance.
    ///
    /// ```
    /// use microraster::host::reference::Fog;
    ///
    /// let fog = Fog::Linear { start: 10.0, end: 20.0 };
    /// assert_eq!(fog.over([200.0, 0.0, 40.0], [0.0, 100.0, 40.0], 15.0), [100.0, 50.0, 40.0]);
    /// ```
    #[must_use]
    pub fn over(&self, color: [f64; 3], fog: [f64; 3], distance: f64) -> [f64; 3] {
        let seen = self.seen(distance);
        [0, 1, 2].map(|i| color[i] * seen + fog[i] * (1.0 - seen))
    }
}
