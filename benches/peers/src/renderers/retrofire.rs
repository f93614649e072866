//! retrofire: floats, scanlines between edges, perspective by its own division of varyings.
//!
//! It has no flat varyings, so that colours of triangles are those of three vertices of their own.
//! Varyings are floats: three of colour, two of a texture.

use alloc::boxed::Box;
use alloc::vec::Vec;

use retrofire_core::geom::{tri, vertex, Tri, Vertex};
use retrofire_core::math::mat::RealToReal;
use retrofire_core::math::{pt2, pt3, rgb, Color3f, Mat4, Point3, ProjMat3};
use retrofire_core::render::ctx::FaceCull;
use retrofire_core::render::tex::{uv, SamplerRepeatPot};
use retrofire_core::render::{
    render, shader, Colorbuf, Context, Frag, Framebuf, Model, Ndc, Screen, TexCoord, Texture,
};
use retrofire_core::util::pixfmt::Rgb565;
use retrofire_core::util::{Buf2, Dims};

use super::{light, lit, Renderer};
use crate::scene::{self, Rgb, Scene, Shading, Size, SIDE, TEXELS};

/// What a vertex has its colour from.
#[derive(Clone, Copy)]
enum From {
    Color([f32; 3]),
    Normal([f32; 3]),
}

enum Vertices {
    Colored(Vec<Vertex<Point3<Model>, From>>),
    Textured(Vec<Vertex<Point3<Model>, TexCoord>>),
}

struct Ready {
    scene: Scene,
    size: Size,
    vertices: Vertices,
    triangles: Vec<Tri<usize>>,
    /// Whether no triangles share a vertex.
    own_vertices: bool,
    texture: Texture<Buf2<retrofire_core::math::Color3>>,
    target: Framebuf<Colorbuf<Buf2<u16>, Rgb565>, Buf2<f32>>,
}

/// Triangles with vertices of their own that are handed over at a time: it allocates several times
/// what it is given.
const AT_ONCE: usize = 1024;

/// All scenes but those that filter or blend.
pub(super) fn make(scene: &Scene, size: Size) -> Option<Box<dyn Renderer>> {
    let place = |index: usize| {
        let [x, y, z] = scene.positions[index];
        pt3(x, y, z)
    };
    let level = |color: &Rgb| From::Color(color.map(|c| f32::from(c) / 255.0));
    // One vertex for all triangles that share it, or three of each triangle.
    let shared = |from: &dyn Fn(usize) -> From| {
        let vertices = (0..scene.positions.len()).map(|index| vertex(place(index), from(index)));
        Vertices::Colored(vertices.collect())
    };
    let apart = |from: &dyn Fn(usize) -> From| {
        let numbered = scene.triangles.iter().enumerate();
        let corners = numbered.flat_map(|(number, t)| t.map(|index| (number, index)));
        let vertices = corners.map(|(number, index)| vertex(place(index), from(number)));
        Vertices::Colored(vertices.collect())
    };
    let mut own_vertices = false;
    let vertices = match &scene.shading {
        Shading::Solid(color) => shared(&|_| level(color)),
        Shading::Smooth(colors) => shared(&|index| level(&colors[index])),
        Shading::Lit { normals, smooth: true } => shared(&|index| From::Normal(normals[index])),
        Shading::Lit { normals, smooth: false } => {
            own_vertices = true;
            apart(&|number| From::Normal(normals[scene.triangles[number][0]]))
        }
        Shading::Faces(colors) => {
            own_vertices = true;
            apart(&|number| level(&colors[number]))
        }
        // Neither filters nor blending are its own.
        Shading::Filtered { .. } | Shading::Glass(..) => return None,
        Shading::Textured(places) => Vertices::Textured(
            (0..scene.positions.len())
                .map(|index| vertex(place(index), uv(places[index][0], places[index][1])))
                .collect(),
        ),
    };
    let triangles = if own_vertices {
        (0..AT_ONCE).map(|t| tri(3 * t, 3 * t + 1, 3 * t + 2)).collect()
    } else {
        scene.triangles.iter().map(|&[a, b, c]| tri(a, b, c)).collect()
    };
    let dims = Dims(size.width.into(), size.height.into());
    let texels = TEXELS.iter().map(|&texel| {
        let [red, green, blue] = scene::rgb(texel);
        rgb(red, green, blue)
    });
    Some(Box::new(Ready {
        scene: scene.clone(),
        size,
        vertices,
        triangles,
        own_vertices,
        texture: Texture::from(Buf2::new_from(Dims(SIDE as u32, SIDE as u32), texels)),
        target: Framebuf { color_buf: Colorbuf::new(Buf2::new(dims)), depth_buf: Buf2::new(dims) },
    }))
}

impl Renderer for Ready {
    fn clear(&mut self) {
        self.target.color_buf.buf.fill(0);
        // Reciprocals of the distance.
        self.target.depth_buf.fill(0.0);
    }

    fn draw(&mut self, frame: usize) {
        let rows = scene::product(&scene::projection(self.size), &self.scene.model_view(frame));
        let matrix: ProjMat3<Model> = rows.into();
        let (width, height) = (f32::from(self.size.width), f32::from(self.size.height));
        let to_screen: Mat4<Ndc, Screen> =
            retrofire_core::math::mat::Matrix::<_, RealToReal<3, Ndc, Screen>>::new([
                [width / 2.0, 0.0, 0.0, width / 2.0],
                [0.0, -height / 2.0, 0.0, height / 2.0],
                [0.0, 0.0, 1.0, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ]);
        let context = Context {
            // On a screen whose y runs down.
            face_cull: self.scene.culled.then_some(FaceCull::Front),
            ..Context::default()
        };
        let to_light = self.scene.to_light(frame);
        let Self { triangles, target, texture, .. } = self;
        match &self.vertices {
            Vertices::Colored(vertices) => {
                let shader = shader::new(
                    |v: Vertex<Point3<Model>, From>, matrix: &ProjMat3<Model>| {
                        let [r, g, b] = match v.attrib {
                            From::Color(color) => color,
                            From::Normal(normal) => lit(light(normal, to_light)),
                        };
                        vertex(matrix.apply(&v.pos), rgb(r, g, b))
                    },
                    |frag: Frag<Color3f>, _: &ProjMat3<Model>| frag.var.to_color4(),
                );
                let at_once = if self.own_vertices { 3 * AT_ONCE } else { vertices.len() };
                for vertices in vertices.chunks(at_once) {
                    let all = if self.own_vertices { vertices.len() / 3 } else { triangles.len() };
                    let triangles = &triangles[..all];
                    if self.scene.depth {
                        render(triangles, vertices, &shader, &matrix, to_screen, target, &context);
                    } else {
                        let target = &mut target.color_buf;
                        render(triangles, vertices, &shader, &matrix, to_screen, target, &context);
                    }
                }
            }
            Vertices::Textured(vertices) => {
                let sampler = SamplerRepeatPot::new(texture);
                let shader = shader::new(
                    |v: Vertex<Point3<Model>, TexCoord>, matrix: &ProjMat3<Model>| {
                        vertex(matrix.apply(&v.pos), v.attrib)
                    },
                    |frag: Frag<TexCoord>, _: &ProjMat3<Model>| {
                        sampler.sample(texture, frag.var).to_rgba()
                    },
                );
                render(&*triangles, vertices, &shader, &matrix, to_screen, target, &context);
            }
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        let buffer = &self.target.color_buf.buf;
        (0..self.size.height)
            .flat_map(|y| (0..self.size.width).map(move |x| buffer[pt2(x.into(), y.into())]))
            .map(scene::rgb)
            .collect()
    }
}
