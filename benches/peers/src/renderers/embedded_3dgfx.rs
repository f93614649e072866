//! embedded-3dgfx: floats to whole pixels, depth of 16 bits.
//!
//! Meshes that are lit go through its engine (record, then execute), with its own ambient light.
//! Coloured and textured triangles, for which the engine has no mode, are drawn as primitives, as
//! its own examples do; they are transformed here, since its engine drops a triangle with a corner
//! beside the picture.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;

use embedded_3dgfx::engine::K3dengine;
use embedded_3dgfx::pipeline::assemble::primitive::DrawPrimitive;
use embedded_3dgfx::pipeline::command_buffer::CommandBuffer;
use embedded_3dgfx::pipeline::rasterize::draw::state::RasterState;
use embedded_3dgfx::pipeline::rasterize::draw::textured::draw_zbuffered_with_textures_state;
use embedded_3dgfx::pipeline::rasterize::draw::zbuffered::draw_zbuffered_with_state;
use embedded_3dgfx::pipeline::rasterize::texture::{Texture, TextureManager};
use embedded_3dgfx::pipeline::renderer::FrameCtx;
use embedded_3dgfx::pipeline::vertex::mesh::{Geometry, K3dMesh, RenderMode};
use embedded_3dgfx::{ZDepth, Z_MAX_VALUE};
use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::Rgb565;
use nalgebra::{Matrix4, Point2, Point3, Vector3};

use super::embedded_graphics::Buffer;
use super::Renderer;
use crate::scene::{self, rgb565, Rgb, Scene, Shading, Size, FAR, NEAR, SIDE, TEXELS};

/// Commands of the largest mesh.
const COMMANDS: usize = 4096;

struct Ready {
    scene: Scene,
    size: Size,
    engine: K3dengine,
    colors: Vec<Rgb565>,
    /// Of triangles, by which it culls.
    normals: Vec<[f32; 3]>,
    texture: &'static [Rgb565],
    commands: Box<CommandBuffer<COMMANDS>>,
    buffer: Buffer,
    depth: Vec<ZDepth>,
}

fn color(rgb: &Rgb) -> Rgb565 {
    Rgb565::from(RawU16::new(rgb565(*rgb)))
}

fn normal([a, b, c]: [[f32; 3]; 3]) -> [f32; 3] {
    let [a, b, c] = [a, b, c].map(Vector3::from);
    (b - a).cross(&(c - a)).normalize().into()
}

/// All scenes but those that filter or blend.
pub(super) fn make(scene: &Scene, size: Size) -> Option<Box<dyn Renderer>> {
    let mut engine = K3dengine::new(size.width, size.height);
    engine.camera.set_fovy(scene::FIELD_OF_VIEW.to_radians());
    engine.camera.set_near_far(NEAR, FAR);
    engine.camera.set_position(Point3::origin());
    engine.camera.set_target(Point3::new(0.0, 0.0, -1.0));
    let colors = match &scene.shading {
        Shading::Solid(solid) => vec![color(solid)],
        Shading::Smooth(colors) | Shading::Faces(colors) => colors.iter().map(color).collect(),
        Shading::Lit { .. } | Shading::Textured(_) => Vec::new(),
        // It has no filter, and blends with black alone.
        Shading::Filtered { .. } | Shading::Glass(..) => return None,
    };
    let texels: Vec<_> = TEXELS.iter().map(|&texel| Rgb565::from(RawU16::new(texel))).collect();
    Some(Box::new(Ready {
        scene: scene.clone(),
        size,
        engine,
        colors,
        normals: scene
            .triangles
            .iter()
            .map(|t| normal(t.map(|index| scene.positions[index])))
            .collect(),
        // Its textures borrow for ever.
        texture: Vec::leak(texels),
        commands: Box::new(CommandBuffer::new()),
        buffer: Buffer::new(size),
        depth: vec![Z_MAX_VALUE; size.pixels()],
    }))
}

impl Ready {
    /// Triangles that the engine only transforms.
    fn primitives(&mut self, matrix: Matrix4<f32>) {
        let Self { scene, size, colors, buffer, depth, texture, .. } = self;
        let state = RasterState::from_zbuffer(size.width.into(), depth.len());
        let mut textures = TextureManager::<1>::new();
        let side = SIDE as u32;
        let texture_id = textures.add_texture(Texture::new(texture, side, side)).unwrap_or(0);
        for (number, triangle) in scene.triangles.iter().enumerate() {
            let clip = triangle
                .map(|index| matrix * Point3::from(scene.positions[index]).to_homogeneous());
            let ws = clip.map(|clip| clip.w);
            let points = clip.map(|clip| {
                let (x, y) = (1.0 + clip.x / clip.w, 1.0 - clip.y / clip.w);
                let (width, height) = (f32::from(size.width), f32::from(size.height));
                Point2::new((x * 0.5 * width) as i32, (y * 0.5 * height) as i32)
            });
            // As its engine makes them: in units of the world, whole ones there.
            let depths = clip.map(|clip| clip.z / clip.w * (FAR - NEAR) + NEAR);
            let primitive = match &scene.shading {
                Shading::Solid(_) if !scene.depth => {
                    DrawPrimitive::ColoredTriangle(points, colors[0])
                }
                Shading::Solid(_) => {
                    DrawPrimitive::ColoredTriangleWithDepth { points, depths, color: colors[0] }
                }
                Shading::Faces(_) => {
                    let color = colors[number];
                    DrawPrimitive::ColoredTriangleWithDepth { points, depths, color }
                }
                Shading::Smooth(_) => DrawPrimitive::GouraudTriangleWithDepth {
                    points,
                    depths,
                    colors: triangle.map(|index| colors[index]),
                },
                Shading::Textured(places) => {
                    let uvs = triangle.map(|index| places[index]);
                    let primitive = DrawPrimitive::TexturedTriangleWithDepth {
                        points,
                        depths,
                        ws,
                        uvs,
                        texture_id,
                    };
                    draw_zbuffered_with_textures_state(primitive, buffer, depth, &textures, &state);
                    continue;
                }
                _ => continue,
            };
            draw_zbuffered_with_state(primitive, buffer, depth, &state);
        }
    }
}

impl Renderer for Ready {
    fn clear(&mut self) {
        self.buffer.clear();
        self.depth.fill(Z_MAX_VALUE);
    }

    fn draw(&mut self, frame: usize) {
        let rows = self.scene.model_view(frame);
        let model = Matrix4::from_fn(|row, column| rows[row][column]);
        let Shading::Lit { normals, smooth } = &self.scene.shading else {
            let matrix = self.engine.camera.vp_matrix * model;
            return self.primitives(matrix);
        };
        // It turns z over before it uses the direction.
        let [x, y, z] = scene::SUN;
        let to_light = Vector3::new(-x, -y, z).normalize();
        let geometry = Geometry {
            vertices: &self.scene.positions,
            faces: &self.scene.triangles,
            normals: &self.normals,
            vertex_normals: normals,
            ..Geometry::default()
        };
        let mut mesh = K3dMesh::new(geometry);
        mesh.set_color(color(&scene::MATERIAL));
        mesh.set_render_mode(if *smooth {
            RenderMode::GouraudLightDir(to_light)
        } else {
            RenderMode::SolidLightDir(to_light)
        });
        mesh.set_position(0.0, 0.0, rows[2][3]);
        mesh.set_attitude(0.0, 22.5_f32.to_radians() * frame as f32, 0.0);
        self.commands.clear();
        let meshes = core::iter::once(&mesh);
        if self.engine.record(meshes, &mut self.commands, None).is_ok() {
            let (width, height) = (self.size.width.into(), self.size.height.into());
            let mut frame = FrameCtx { zbuffer: &mut self.depth, width, height };
            let done = self.engine.execute(&mut self.buffer, &mut frame, &self.commands, None);
            debug_assert!(done.is_ok(), "the depth buffer is as large as the picture");
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.buffer.picture()
    }
}
