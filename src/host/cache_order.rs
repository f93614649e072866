//! Triangles in an order that suits a vertex cache.

use std::vec;
use std::vec::Vec;

use super::MeshData;

/// No vertex.
const NONE: usize = usize::MAX;

impl MeshData {
    /// Puts triangles into an order in which a [`VertexCache`](crate::VertexCache) of so many slots finds
    /// most vertices again, and vertices into the order in which triangles name them; those that none
    /// names come last. What would not gain by it stays as it is.
    ///
    /// Such a cache has a place for each number modulo its slots: numbered by their first use, vertices
    /// leave it in the order in which they came. The order of triangles is "Tipsify": Sander, Nehab,
    /// Barczak, *Fast Triangle Reordering for Vertex Locality and Reduced Overdraw*, SIGGRAPH 2007, without
    /// its second part. It is worth its while where the cache is smaller than the mesh, as the 32 slots
    /// that [`Pass::draw`](crate::Pass::draw) brings.
    ///
    /// Corners keep their order within a triangle. Where triangles have the same depth at a pixel, another
    /// of them may be seen. A mesh whose normals or indices do not match it is left alone.
    ///
    /// ```
    /// use microraster::host::{MeshData, Model};
    ///
    /// for mut part in MeshData::of_model(&Model::teapot(4), false) {
    ///     let before = part.vertices_made(32);
    ///     part.order_for_cache(32);
    ///     assert!(part.vertices_made(32) <= before);
    /// }
    /// ```
    pub fn order_for_cache(&mut self, slots: usize) {
        let vertices = self.positions.len();
        let (triangles, rest) = self.indices.as_chunks::<3>();
        let normals = if self.by_face { triangles.len() } else { vertices };
        let in_range = self.indices.iter().all(|index| usize::from(*index) < vertices);
        if self.normals.len() != normals || !rest.is_empty() || !in_range {
            return;
        }
        let triangles: Vec<_> = triangles.iter().map(|corners| corners.map(usize::from)).collect();
        let orders = [(0..triangles.len()).collect(), order(&triangles, vertices, slots)];
        let ordered = orders.map(|order| self.ordered(&triangles, &order));
        for mesh in ordered {
            if mesh.vertices_made(slots) < self.vertices_made(slots) {
                *self = mesh;
            }
        }
    }

    /// How many times a [`VertexCache`](crate::VertexCache) of so many slots has a vertex made while all
    /// triangles are drawn.
    pub fn vertices_made(&self, slots: usize) -> usize {
        let mut cache = vec![None; slots.max(1)];
        let made = self.indices.iter().filter(|index| {
            let place = usize::from(**index) % cache.len();
            cache[place].replace(**index) != Some(**index)
        });
        made.count()
    }

    /// The same mesh in another order of `triangles`, which are its own.
    #[allow(clippy::cast_possible_truncation, reason = "as many numbers as before")]
    fn ordered(&self, triangles: &[[usize; 3]], order: &[usize]) -> Self {
        let corners = || order.iter().flat_map(|triangle| triangles[*triangle]);
        let mut numbers = vec![NONE; self.positions.len()];
        let mut named = Vec::with_capacity(self.positions.len());
        for vertex in corners().chain(0..self.positions.len()) {
            if numbers[vertex] == NONE {
                numbers[vertex] = named.len();
                named.push(vertex);
            }
        }
        let normals = if self.by_face { order } else { &named };
        Self {
            positions: named.iter().map(|vertex| self.positions[*vertex]).collect(),
            normals: normals.iter().map(|number| self.normals[*number]).collect(),
            indices: corners().map(|vertex| numbers[vertex] as u16).collect(),
            ..*self
        }
    }
}

/// The numbers of triangles in their new order.
fn order(triangles: &[[usize; 3]], vertices: usize, slots: usize) -> Vec<usize> {
    let users = Users::new(triangles, vertices);
    // Triangles of each vertex that are still to come.
    let mut left: Vec<usize> = (0..vertices).map(|vertex| users.of(vertex).len()).collect();
    // When each vertex came into the cache: so many vertices before.
    let mut came = vec![0; vertices];
    let mut time = slots + 1;
    let mut done = vec![false; triangles.len()];
    let mut order = Vec::with_capacity(triangles.len());
    let (mut behind, mut next) = (Vec::new(), 0);
    let mut fan = 0;
    while order.len() < triangles.len() {
        let first = order.len();
        for &triangle in users.of(fan) {
            // Also where it names the vertex twice.
            if core::mem::replace(&mut done[triangle], true) {
                continue;
            }
            order.push(triangle);
            for vertex in triangles[triangle] {
                behind.push(vertex);
                left[vertex] -= 1;
                if time - came[vertex] > slots {
                    came[vertex] = time;
                    time += 1;
                }
            }
        }
        // Of the vertices about this one the one that came first and is still there when all of its
        // triangles have been drawn, each of which may bring two others.
        let about = order[first..].iter().flat_map(|triangle| triangles[*triangle]);
        let about = about.filter(|vertex| left[*vertex] > 0);
        let age = |vertex: usize| {
            let age = time - came[vertex];
            if age + 2 * left[vertex] <= slots {
                age
            } else {
                0
            }
        };
        fan = match about.max_by_key(|vertex| age(*vertex)) {
            Some(vertex) => vertex,
            // A dead end: back the way it came, or on to the next of all.
            None => loop {
                let vertex = behind.pop().unwrap_or_else(|| {
                    next += 1;
                    next - 1
                });
                if left.get(vertex).is_none_or(|left| *left > 0) {
                    break vertex;
                }
            },
        };
    }
    order
}

/// The triangles of each vertex.
struct Users {
    triangles: Vec<usize>,
    /// Where those of each vertex begin, and the end of the last.
    starts: Vec<usize>,
}

impl Users {
    fn new(triangles: &[[usize; 3]], vertices: usize) -> Self {
        let mut starts = vec![0; vertices + 1];
        for vertex in triangles.iter().flatten() {
            starts[vertex + 1] += 1;
        }
        for vertex in 0..vertices {
            starts[vertex + 1] += starts[vertex];
        }
        let mut places = starts.clone();
        let mut users = vec![0; 3 * triangles.len()];
        for (number, corners) in triangles.iter().enumerate() {
            for vertex in corners {
                users[places[*vertex]] = number;
                places[*vertex] += 1;
            }
        }
        Self { triangles: users, starts }
    }

    fn of(&self, vertex: usize) -> &[usize] {
        match self.starts.get(vertex..=vertex + 1) {
            Some(&[start, end]) => &self.triangles[start..end],
            _ => &[],
        }
    }
}

#[cfg(test)]
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "random numbers are cut to what is wanted"
)]
mod tests {
    use super::super::Model;
    use super::*;
    use crate::math::hard_numbers::Random;

    /// A triangle's corners with what belongs to them.
    type Drawn = ([[i16; 3]; 3], Vec<[i8; 3]>);

    /// What is drawn, whatever the order.
    fn drawn(mesh: &MeshData) -> Vec<Drawn> {
        let triangles = mesh.indices.chunks(3).enumerate().map(|(number, corners)| {
            let at = |corner: usize| usize::from(corners[corner]);
            let normals = if mesh.by_face {
                vec![mesh.normals[number]]
            } else {
                [0, 1, 2].map(|corner| mesh.normals[at(corner)]).to_vec()
            };
            ([0, 1, 2].map(|corner| mesh.positions[at(corner)]), normals)
        });
        let mut triangles: Vec<_> = triangles.collect();
        triangles.sort();
        triangles
    }

    #[test]
    fn a_teapot_in_any_order_has_its_vertices_made_little_more_than_once() {
        let mut random = Random::new(40);
        for by_face in [false, true] {
            for mut part in MeshData::of_model(&Model::teapot(8), by_face) {
                let triangles: Vec<_> = part
                    .indices
                    .chunks(3)
                    .map(|corners| [0, 1, 2].map(|at| corners[at].into()))
                    .collect();
                let mut shuffled: Vec<_> = (0..triangles.len()).collect();
                shuffled.sort_by_cached_key(|_| random.word());
                part = part.ordered(&triangles, &shuffled);
                let (before, scattered) = (drawn(&part), part.vertices_made(32));
                part.order_for_cache(32);
                assert!(before == drawn(&part), "the same triangles");
                let (made, vertices) = (part.vertices_made(32), part.positions.len());
                assert!(made * 2 < vertices * 3, "{made} of {vertices}, {scattered} before");
                assert!(scattered > 2 * made, "{scattered}");
            }
        }
    }

    /// Any indices at all, with the same vertex twice in a triangle, vertices that nobody names and
    /// triangles that are there twice.
    #[test]
    fn whatever_the_triangles_are_they_stay() {
        let mut random = Random::new(41);
        for round in 0..3000 {
            let mut number = |below: usize| random.word() as usize % below;
            let (vertices, triangles, slots) = (1 + number(40), number(60), number(20));
            let by_face = round % 2 == 0;
            let mut normal = || [number(100) as i8, 0, 0];
            let normals = if by_face { triangles } else { vertices };
            let normals = (0..normals).map(|_| normal()).collect();
            let mut mesh = MeshData {
                color: crate::color::Rgb::WHITE,
                positions: (0..vertices).map(|at| [at as i16, number(9) as i16, 0]).collect(),
                normals,
                indices: (0..3 * triangles).map(|_| number(vertices) as u16).collect(),
                by_face,
                scale: 1.0,
                offset: crate::math::Vec3::ZERO,
            };
            let (before, made) = (drawn(&mesh), mesh.vertices_made(slots));
            mesh.order_for_cache(slots);
            assert!(before == drawn(&mesh), "round {round}");
            assert_eq!(mesh.positions.len(), vertices, "all vertices stay");
            assert!(mesh.vertices_made(slots) <= made, "round {round}");
        }
    }

    #[test]
    fn what_does_not_match_is_left_alone() {
        let mut mesh = MeshData::of_model(&Model::teapot(1), false).swap_remove(0);
        mesh.indices.push(0);
        let odd = mesh.clone();
        mesh.order_for_cache(32);
        assert_eq!(mesh, odd, "no whole triangles");
        mesh.indices.pop();
        mesh.indices[4] = u16::MAX;
        let beyond = mesh.clone();
        mesh.order_for_cache(32);
        assert_eq!(mesh, beyond, "no such vertex");
    }
}
