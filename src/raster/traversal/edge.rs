use crate::raster::Triangle;

/// One edge function over pixels: `floor((E - bias) / 16)` at a pixel's centre, in 32 bits.
///
/// All pixel centres differ by multiples of 16 subpixels, so that the quotient keeps the sign of
/// the test and steps by whole numbers: -dy to the right, dx downwards.
#[derive(Clone, Copy, Debug)]
struct Edge {
    /// At pixel (0, 0).
    origin: i32,
    right: i32,
    down: i32,
}

/// The three edge functions of a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edges([Edge; 3]);

impl Edges {
    pub(super) fn new(triangle: &Triangle) -> Self {
        let [a, b, c] = triangle.vertices();
        Self([(a, b), (b, c), (c, a)].map(|(from, to)| {
            let dx = to.x_bits().wrapping_sub(from.x_bits());
            let dy = to.y_bits().wrapping_sub(from.y_bits());
            let top_or_left = dy < 0 || (dy == 0 && dx > 0);
            let (x, y) = (8_i32.wrapping_sub(from.x_bits()), 8_i32.wrapping_sub(from.y_bits()));
            // The offset from the corner as 16 q + r, so that nothing exceeds 32 bits for long:
            // what wraps here comes back where the pixel is added.
            let rest = dx
                .wrapping_mul(y & 15)
                .wrapping_sub(dy.wrapping_mul(x & 15))
                .wrapping_sub(i32::from(!top_or_left));
            let origin = (rest >> 4)
                .wrapping_add(dx.wrapping_mul(y >> 4))
                .wrapping_sub(dy.wrapping_mul(x >> 4));
            Edge { origin, right: dy.wrapping_neg(), down: dx }
        }))
    }

    /// The three values at a pixel; it is covered if none is negative.
    pub(super) fn at(&self, x: i32, y: i32) -> [i32; 3] {
        self.0.map(|edge| {
            edge.origin
                .wrapping_add(edge.right.wrapping_mul(x))
                .wrapping_add(edge.down.wrapping_mul(y))
        })
    }

    /// Steps to the right neighbour.
    pub(super) fn step_right(&self, values: &mut [i32; 3]) {
        for (value, edge) in values.iter_mut().zip(&self.0) {
            *value = value.wrapping_add(edge.right);
        }
    }

    /// Whether a pixel is covered.
    pub(super) fn covers(&self, x: i32, y: i32) -> bool {
        self.at(x, y).iter().all(|value| *value >= 0)
    }

    /// Whether some edge has all pixels of a square on its outer side, and whether all edges have
    /// all of them on their inner one. Extremes of a linear function lie in corners.
    pub(super) fn block(&self, x: i32, y: i32, side: i32) -> (bool, bool) {
        let last = side - 1;
        let corners = [(0, 0), (last, 0), (0, last), (last, last)]
            .map(|(dx, dy)| self.at(x.wrapping_add(dx), y.wrapping_add(dy)));
        let outside = (0..3).any(|edge| corners.iter().all(|corner| corner[edge] < 0));
        let inside = corners.iter().flatten().all(|value| *value >= 0);
        (outside, inside)
    }
}
