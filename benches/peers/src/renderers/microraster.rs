//! This crate: meshes quantised to 16 bits an axis.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;

use microraster::math::{Angle, Mat4, Vec3};
use microraster::texture::{Sampler, Texture, TextureError};
use microraster::{
    normal, Camera, Color, ConstantAlpha, Cull, DepthBuffer, FacePlane, FacePlanes, Flat, Frame,
    Gouraud, IndexedList, Lambert, Less, Light, Mesh, Normal, Pass, PlaneScale, Rgb as Channels,
    Rgb565, Textured, VertexCache, WithPlanes,
};

use super::Renderer;
use crate::scene::{self, Rgb, Scene, Shading, Size};

/// What a mesh's vertices or triangles hold.
enum Attributes {
    Solid(Channels),
    Smooth(Vec<Channels>),
    Faces(Vec<Channels>),
    Lit { normals: Vec<Normal>, smooth: bool },
    Textured(Vec<((), [i16; 2])>),
    Filtered(Vec<((), [i16; 2])>),
    Tinted(Vec<(Channels, [i16; 2])>),
    Glass(Channels, u8),
}

/// A lit mesh, culled by the planes of its triangles.
pub(crate) type Lit<'a> = Mesh<'a, Normal, WithPlanes<'a, IndexedList<'a, u16>>>;

/// A scene in this crate's form.
pub(crate) struct Drawing {
    scene: Scene,
    positions: Vec<[i16; 3]>,
    indices: Vec<u16>,
    scale: Vec3,
    offset: Vec3,
    attributes: Attributes,
    planes: Vec<FacePlane>,
    plane_scale: PlaneScale,
    /// Nothing for the mesh without attributes.
    nothing: Vec<()>,
}

/// Enough for every vertex of the largest mesh.
pub(crate) type Cache = VertexCache<Color, 2048>;

/// A scene in this crate's form, and what it is drawn into.
pub(crate) struct Ready {
    pub(crate) drawing: Drawing,
    pub(crate) size: microraster::Size,
    pub(crate) pixels: Vec<u16>,
    pub(crate) depth: Vec<u16>,
    cache: Box<Cache>,
}

fn channels([red, green, blue]: Rgb) -> Channels {
    Channels::new(red, green, blue)
}

/// A place in a texture of which 4096 steps are the whole.
fn texels(place: &[f32; 2]) -> [i16; 2] {
    place.map(|c| (c * 4096.0) as i16)
}

/// Always ready.
pub(super) fn make(scene: &Scene, size: Size) -> Option<Box<dyn Renderer>> {
    Some(Box::new(ready(scene, size)))
}

/// A scene in this crate's form, and what it is drawn into.
pub(crate) fn ready(scene: &Scene, size: Size) -> Ready {
    let bound = |axis: usize, choose: fn(f32, f32) -> f32| {
        scene.positions.iter().map(|p| p[axis]).reduce(choose).unwrap_or(0.0)
    };
    let low: [f32; 3] = core::array::from_fn(|axis| bound(axis, f32::min));
    let high: [f32; 3] = core::array::from_fn(|axis| bound(axis, f32::max));
    // Steps that 16 bits hold, and no fewer than a grid of halves needs to be exact.
    let step = |axis: usize| ((high[axis] - low[axis]) / 2.0 / 19_200.0).max(f32::MIN_POSITIVE);
    let middle = |axis: usize| (low[axis] + high[axis]) / 2.0;
    let quantised = |p: &[f32; 3]| {
        [0, 1, 2].map(|axis| libm::roundf((p[axis] - middle(axis)) / step(axis)) as i16)
    };
    let attributes = match &scene.shading {
        Shading::Solid(color) => Attributes::Solid(channels(*color)),
        Shading::Smooth(colors) => {
            Attributes::Smooth(colors.iter().copied().map(channels).collect())
        }
        Shading::Faces(colors) => Attributes::Faces(colors.iter().copied().map(channels).collect()),
        Shading::Lit { normals, smooth } => Attributes::Lit {
            normals: normals.iter().map(|[x, y, z]| normal(Vec3::new(*x, *y, *z))).collect(),
            smooth: *smooth,
        },
        Shading::Textured(places) => {
            Attributes::Textured(places.iter().map(|place| ((), texels(place))).collect())
        }
        Shading::Filtered { places, colors: None } => {
            Attributes::Filtered(places.iter().map(|place| ((), texels(place))).collect())
        }
        Shading::Filtered { places, colors: Some(colors) } => {
            let pairs = colors.iter().zip(places);
            Attributes::Tinted(pairs.map(|(&c, place)| (channels(c), texels(place))).collect())
        }
        Shading::Glass(color, opacity) => Attributes::Glass(channels(*color), *opacity),
    };
    let positions: Vec<_> = scene.positions.iter().map(quantised).collect();
    let indices: Vec<_> = scene.triangles.iter().flatten().map(|&index| index as u16).collect();
    let plane_scale = PlaneScale::of(&positions, &indices);
    let corners = |triangle: &[u16; 3]| triangle.map(|index| positions[usize::from(index)]);
    let planes = indices.as_chunks().0.iter();
    let planes = planes.map(|triangle| plane_scale.plane(corners(triangle))).collect();
    let drawing = Drawing {
        positions,
        indices,
        planes,
        plane_scale,
        scale: Vec3::new(step(0), step(1), step(2)),
        offset: Vec3::new(middle(0), middle(1), middle(2)),
        attributes,
        nothing: vec![(); scene.positions.len()],
        scene: scene.clone(),
    };
    Ready {
        drawing,
        size: microraster::Size::new(size.width, size.height),
        pixels: vec![0; size.pixels()],
        depth: vec![0; size.pixels()],
        cache: Box::new(VertexCache::new()),
    }
}

/// The texture of all scenes.
fn texture() -> Result<Texture<'static, Rgb565>, TextureError> {
    let side = scene::SIDE as u16;
    Texture::new(&scene::TEXELS, side, side)
}

/// Columns of a matrix that is given by rows.
fn transposed(rows: &scene::Matrix) -> [[f32; 4]; 4] {
    core::array::from_fn(|column| core::array::from_fn(|row| rows[row][column]))
}

impl Drawing {
    /// The camera of all scenes.
    pub(crate) fn camera() -> Camera {
        Camera::perspective(Angle::from_degrees(scene::FIELD_OF_VIEW), scene::NEAR)
    }

    /// The mesh's place in a frame.
    pub(crate) fn model(&self, number: usize) -> Mat4 {
        let [x, y, z, w] = transposed(&self.scene.model_view(number))
            .map(|[x, y, z, w]| microraster::math::Vec4::new(x, y, z, w));
        Mat4 { x, y, z, w }
    }

    /// The triangles of a lit mesh in so many parts.
    pub(crate) fn parts<'a>(
        &'a self,
        mesh: &Lit<'a>,
        parts: usize,
    ) -> impl Iterator<Item = Lit<'a>> {
        let (mesh, scale) = (*mesh, self.plane_scale);
        let triangles = self.planes.len().div_ceil(parts).max(1);
        let parts = self.indices.chunks(3 * triangles).zip(self.planes.chunks(triangles));
        parts.map(move |(indices, planes)| {
            mesh.indexed(indices).with_planes(FacePlanes::new(planes, scale))
        })
    }

    /// A lit mesh, its light, and whether it is smooth.
    pub(crate) fn lit(&self) -> Option<(Lit<'_>, Lambert<1>, bool)> {
        let Attributes::Lit { normals, smooth } = &self.attributes else { return None };
        let grey = |part: f32| {
            let level = (part * 255.0) as u8;
            Channels::new(level, level, level)
        };
        let [x, y, z] = scene::SUN;
        let sun = Light::directional(Vec3::new(x, y, z), grey(scene::DIFFUSE));
        let light =
            Lambert::new(&[sun]).ambient(grey(scene::AMBIENT)).material(channels(scene::MATERIAL));
        let mesh = Mesh::new(&self.positions, normals)
            .indexed(&self.indices)
            .placed(self.scale, self.offset)
            .with_planes(FacePlanes::new(&self.planes, self.plane_scale));
        Some((mesh, light, *smooth))
    }

    /// Draws a frame.
    pub(crate) fn draw(
        &self,
        frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>,
        number: usize,
        cache: &mut Cache,
    ) {
        let (camera, model) = (Self::camera(), self.model(number));
        let Self { positions, indices, .. } = self;
        let placed = (self.scale, self.offset);
        let pass = Pass::new(&camera);
        match &self.attributes {
            Attributes::Solid(color) => {
                let mesh = Mesh::new(positions, &self.nothing).indexed(indices);
                let mesh = mesh.placed(placed.0, placed.1);
                if self.scene.depth {
                    pass.depth(Less).draw(frame, &model, &mesh, &Flat::solid(*color));
                } else {
                    let mut pass = pass;
                    pass.draw(frame, &model, &mesh, &Flat::solid(*color));
                }
            }
            Attributes::Smooth(colors) => {
                let mesh = Mesh::new(positions, colors).indexed(indices).placed(placed.0, placed.1);
                pass.depth(Less).draw(frame, &model, &mesh, &Gouraud::colored());
            }
            Attributes::Faces(colors) => {
                let mesh = Mesh::new(positions, colors).by_face().indexed(indices);
                let mesh = mesh.placed(placed.0, placed.1);
                let shader = Flat::colored();
                pass.depth(Less).draw_cached(frame, &model, &mesh, &shader, cache);
            }
            Attributes::Lit { .. } => {
                let Some((mesh, light, smooth)) = self.lit() else { return };
                let mut pass = pass.depth(Less).cull(Cull::Back);
                if smooth {
                    pass.draw_cached(frame, &model, &mesh, &Gouraud::new(light), cache);
                } else {
                    pass.draw_cached(frame, &model, &mesh, &Flat::new(light), cache);
                }
            }
            Attributes::Textured(places) => {
                let Ok(sampler) = texture().and_then(Sampler::nearest) else { return };
                let mesh = Mesh::new(positions, places).indexed(indices).placed(placed.0, placed.1);
                pass.depth(Less).draw(frame, &model, &mesh, &Textured::new(sampler));
            }
            Attributes::Filtered(places) => {
                let Ok(sampler) = texture().and_then(Sampler::bilinear) else { return };
                let mesh = Mesh::new(positions, places).indexed(indices).placed(placed.0, placed.1);
                pass.depth(Less).draw(frame, &model, &mesh, &Textured::new(sampler));
            }
            Attributes::Tinted(places) => {
                let Ok(sampler) = texture().and_then(Sampler::bilinear) else { return };
                let mesh = Mesh::new(positions, places).indexed(indices).placed(placed.0, placed.1);
                let shader = Textured::on(Gouraud::colored(), sampler);
                pass.depth(Less).draw(frame, &model, &mesh, &shader);
            }
            Attributes::Glass(color, opacity) => {
                let mesh = Mesh::new(positions, &self.nothing).indexed(indices);
                let mesh = mesh.placed(placed.0, placed.1);
                let mut pass = pass.blend(ConstantAlpha(*opacity));
                pass.draw(frame, &model, &mesh, &Flat::solid(*color));
            }
        }
    }
}

impl Renderer for Ready {
    fn clear(&mut self) {
        if let Ok(frame) = Frame::<Rgb565>::new(&mut self.pixels, self.size) {
            if let Ok(mut frame) = frame.with_depth(&mut self.depth) {
                frame.clear(Channels::BLACK);
            }
        }
    }

    fn draw(&mut self, number: usize) {
        let Self { drawing, size, pixels, depth, cache } = self;
        if let Ok(frame) = Frame::<Rgb565>::new(pixels, *size) {
            if let Ok(mut frame) = frame.with_depth(depth) {
                drawing.draw(&mut frame, number, cache);
            }
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.pixels.iter().map(|&texel| scene::rgb(texel)).collect()
    }
}
