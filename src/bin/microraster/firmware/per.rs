//! What the figure of a measured scene is counted by.

use super::facts::Line;
use std::fmt;

/// What instructions are divided by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Per {
    /// Pixels written.
    Pixel,
    /// Triangles submitted.
    Triangle,
    /// Vertices, of scenes that draw each as a point.
    Vertex,
    /// Frames.
    Frame,
}

impl Per {
    /// By triangle for grids of small ones, by vertex for the vertex stage, by frame for meshes
    /// and clears, by pixel for all else.
    pub(crate) fn of(scene: &str) -> Self {
        if scene.starts_with('S') {
            Self::Triangle
        } else if scene.starts_with("vertex") {
            Self::Vertex
        } else if scene.starts_with('M') || scene == "clear" {
            Self::Frame
        } else {
            Self::Pixel
        }
    }

    /// How many of it a scene's frames have in all.
    pub(crate) fn count(self, line: &Line) -> u64 {
        match self {
            Self::Pixel => line.pixels(),
            Self::Triangle | Self::Vertex => line.triangles(),
            Self::Frame => line.frames(),
        }
        .max(1)
    }

    /// A figure as the tables write it.
    pub(crate) fn text(self, figure: f64) -> String {
        match self {
            Self::Pixel => format!("{figure:.2}"),
            Self::Triangle | Self::Vertex => format!("{figure:.0}"),
            Self::Frame if figure < 1e6 => format!("{:.1} k", figure / 1e3),
            Self::Frame => format!("{:.2} M", figure / 1e6),
        }
    }
}

impl fmt::Display for Per {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Pixel => "pixel",
            Self::Triangle => "triangle",
            Self::Vertex => "vertex",
            Self::Frame => "frame",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_is_counted_by_what_it_is_made_of() {
        for (scene, per, text) in [
            ("F5m", Per::Pixel, "9.88"),
            ("S1-raster", Per::Triangle, "10"),
            ("vertex-sun", Per::Vertex, "10"),
            ("M1-bunny", Per::Frame, "0.0 k"),
            ("stencil", Per::Pixel, "9.88"),
        ] {
            assert_eq!(Per::of(scene), per, "{scene}");
            assert_eq!(per.text(9.876), text, "{scene}");
        }
        assert_eq!(Per::Frame.text(56_789.0), "56.8 k", "below a million");
        assert_eq!(Per::Frame.text(1_834_567.0), "1.83 M", "above it");
    }
}
