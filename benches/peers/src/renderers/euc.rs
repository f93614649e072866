//! euc: floats, bounding boxes, attributes by barycentric weights. Nothing is clipped at the near
//! plane. It has no flat varyings, so that colours of triangles are those of their three vertices.

use alloc::boxed::Box;
use alloc::vec::Vec;

use euc::buffer::Buffer2d;
use euc::rasterizer::{BackfaceCullingDisabled, BackfaceCullingEnabled, Triangles};
use euc::{DepthStrategy, Pipeline, Target};
use vek::{Mat4, Rgb as Channels, Vec2, Vec3, Vec4};

use super::{light, lit, Renderer};
use crate::scene::{self, rgb565, Rgb, Scene, Shading, Size, SIDE, TEXELS};

/// A colour that is interpolated.
struct Colored {
    matrix: Mat4<f32>,
    to_light: [f32; 3],
    depth: DepthStrategy,
}

/// What a vertex has its colour from.
#[derive(Clone, Copy)]
enum From {
    Color([f32; 3]),
    Normal([f32; 3]),
}

fn pixel(color: Channels<f32>) -> u16 {
    rgb565(color.into_array().map(|c| (c * 255.0) as u8))
}

impl Pipeline for Colored {
    type Vertex = ([f32; 3], From);
    type VsOut = Channels<f32>;
    type Pixel = u16;

    #[inline(always)]
    fn vert(&self, (position, from): &Self::Vertex) -> ([f32; 4], Self::VsOut) {
        let color = match from {
            From::Color(color) => *color,
            From::Normal(normal) => lit(light(*normal, self.to_light)),
        };
        let place = self.matrix * Vec4::from_point(Vec3::from(*position));
        (place.into_array(), Channels::from(color))
    }

    #[inline(always)]
    fn frag(&self, color: &Self::VsOut) -> u16 {
        pixel(*color)
    }

    fn get_depth_strategy(&self) -> DepthStrategy {
        self.depth
    }
}

/// The nearest texel.
struct Textured {
    matrix: Mat4<f32>,
}

impl Pipeline for Textured {
    type Vertex = ([f32; 3], [f32; 2]);
    type VsOut = Vec2<f32>;
    type Pixel = u16;

    #[inline(always)]
    fn vert(&self, (position, place): &Self::Vertex) -> ([f32; 4], Self::VsOut) {
        let position = self.matrix * Vec4::from_point(Vec3::from(*position));
        (position.into_array(), Vec2::from(*place))
    }

    #[inline(always)]
    fn frag(&self, place: &Self::VsOut) -> u16 {
        let [u, v] = place.into_array().map(|c| (c * SIDE as f32) as usize & (SIDE - 1));
        TEXELS[v * SIDE + u]
    }
}

enum Vertices {
    Colored(Vec<([f32; 3], From)>),
    Textured(Vec<([f32; 3], [f32; 2])>),
}

struct Ready {
    scene: Scene,
    size: Size,
    vertices: Vertices,
    color: Buffer2d<u16>,
    depth: Buffer2d<f32>,
}

/// All scenes but those that filter or blend.
pub(super) fn make(scene: &Scene, size: Size) -> Option<Box<dyn Renderer>> {
    let level = |color: &Rgb| From::Color(color.map(|c| f32::from(c) / 255.0));
    let corners = |from: &dyn Fn(usize, usize) -> From| {
        let numbered = scene.triangles.iter().enumerate();
        let corners = numbered.flat_map(|(number, triangle)| {
            triangle.map(|index| (scene.positions[index], number, index, triangle[0]))
        });
        Vertices::Colored(
            corners
                .map(|(position, number, index, first)| {
                    let from = match &scene.shading {
                        Shading::Lit { smooth: false, .. } => from(number, first),
                        _ => from(number, index),
                    };
                    (position, from)
                })
                .collect(),
        )
    };
    let vertices = match &scene.shading {
        Shading::Solid(color) => corners(&|_, _| level(color)),
        Shading::Smooth(colors) => corners(&|_, index| level(&colors[index])),
        Shading::Faces(colors) => corners(&|number, _| level(&colors[number])),
        Shading::Lit { normals, .. } => corners(&|_, index| From::Normal(normals[index])),
        // Neither filters nor blending are its own.
        Shading::Filtered { .. } | Shading::Glass(..) => return None,
        Shading::Textured(places) => Vertices::Textured(
            scene
                .triangles
                .iter()
                .flatten()
                .map(|&index| (scene.positions[index], places[index]))
                .collect(),
        ),
    };
    let sides = [size.width.into(), size.height.into()];
    Some(Box::new(Ready {
        scene: scene.clone(),
        size,
        vertices,
        color: Buffer2d::new(sides, 0),
        depth: Buffer2d::new(sides, f32::INFINITY),
    }))
}

impl Renderer for Ready {
    fn clear(&mut self) {
        self.color.clear(0);
        self.depth.clear(f32::INFINITY);
    }

    fn draw(&mut self, frame: usize) {
        let rows = scene::product(&scene::projection(self.size), &self.scene.model_view(frame));
        let matrix = Mat4::from_row_arrays(rows);
        let Self { color, depth, .. } = self;
        match &self.vertices {
            Vertices::Colored(vertices) => {
                let strategy =
                    if self.scene.depth { DepthStrategy::IfLessWrite } else { DepthStrategy::None };
                let to_light = self.scene.to_light(frame);
                let pipeline = Colored { matrix, to_light, depth: strategy };
                if self.scene.culled {
                    pipeline.draw::<Triangles<_, BackfaceCullingEnabled>, _>(
                        vertices,
                        color,
                        Some(depth),
                    );
                } else {
                    pipeline.draw::<Triangles<_, BackfaceCullingDisabled>, _>(
                        vertices,
                        color,
                        Some(depth),
                    );
                }
            }
            Vertices::Textured(vertices) => Textured { matrix }.draw::<Triangles<
                _,
                BackfaceCullingDisabled,
            >, _>(
                vertices, color, Some(depth)
            ),
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.color.as_ref().iter().map(|&texel| scene::rgb(texel)).collect()
    }
}
