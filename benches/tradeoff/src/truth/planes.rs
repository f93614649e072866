//! Textured and coloured planes.

use microraster::host::reference::compare::rgb565;
use microraster::host::reference::{
    Draw, Fog, Fragment, Interpolation, Kind, Reference, State, TexelGrid, Texture,
};
use microraster::texture::AnyWrap;

use super::flat::{channels, opaque, tested};
use super::geometry::{distance, in_model, space, vertices};
use super::Shading;
use crate::scenes::standard::camera;
use crate::tradeoff::planes::{Plane, COLORS, DENSITY, GROUND, HAZE, PLANES};
use crate::tradeoff::texture::{SIDE, WORDS_OF_LEVELS};

/// The plane of a scene.
pub(crate) fn plane_of(scene: &str) -> Option<(usize, &'static Plane)> {
    let names = ["plane-1", "plane-2", "plane-4", "plane-10", "plane-50", "floor"];
    let number = names.iter().position(|name| *name == scene)?;
    PLANES.get(number).map(|plane| (number, plane))
}

/// The largest picture of the texture.
fn texture() -> Option<Texture> {
    let side = usize::from(SIDE);
    let grid = TexelGrid { width: side, height: side, wraps: [AnyWrap::Repeat; 2] };
    let texels: Vec<_> =
        WORDS_OF_LEVELS.iter().take(side * side).map(|word| opaque(rgb565(*word))).collect();
    Texture::new(grid, &texels)
}

pub(super) fn plane(scene: &str, shading: &Shading, picture: &mut Reference) {
    let (Some((_, plane)), Some(texture)) = (plane_of(scene), texture()) else { return };
    let (shape, camera) = (plane.shape(), camera());
    let unit = f64::from(1_u32 << plane.unit_bits);
    let places = plane.places().map(|place| place.map(|c| f64::from(c) / unit));
    let vertices = vertices(&in_model(&shape), &shape.model, &camera, |i, point| match shading {
        Shading::Colors => channels(COLORS[i]).to_vec(),
        Shading::AtPoints => vec![distance(&camera, point)],
        _ => places[i].to_vec(),
    });
    let fog = Fog::ExponentialSquared { density: f64::from(DENSITY) };
    let shade = |fragment: &Fragment<'_>| match (shading, fragment.varyings) {
        (Shading::Nearest, &[u, v]) => Some(texture.nearest([u, v])),
        (Shading::Continuous, &[u, v]) => Some(texture.bilinear([u, v])),
        (_, &[away]) => Some(opaque(fog.over(channels(GROUND), channels(HAZE), away))),
        (_, &[r, g, b]) => Some(opaque([r, g, b])),
        _ => None,
    };
    let corners: Vec<u32> = shape.indices.iter().map(|index| u32::from(*index)).collect();
    picture.draw(&Draw {
        space: space(false),
        kind: Kind::Triangles,
        vertices: &vertices,
        corners: &corners,
        interpolation: Interpolation::Perspective,
        state: State { depth: tested(), ..State::PLAIN },
        shade: &shade,
    });
}

/// Exact texture coordinates of every pixel, in texels; `None` where the plane is not seen.
pub(crate) fn texels(scene: &str) -> Vec<Option<[f64; 2]>> {
    use std::cell::RefCell;
    let size = crate::scenes::standard::SIZE;
    let mut picture = Reference::new(size, [0.0; 3]);
    let width = usize::from(size.width);
    let found = RefCell::new(vec![None; width * usize::from(size.height)]);
    let Some((_, plane)) = plane_of(scene) else { return found.into_inner() };
    let (shape, camera) = (plane.shape(), camera());
    let scale = f64::from(SIDE) / f64::from(1_u32 << plane.unit_bits);
    let places = plane.places().map(|place| place.map(|c| f64::from(c) * scale));
    let vertices = vertices(&in_model(&shape), &shape.model, &camera, |i, _| places[i].to_vec());
    let corners: Vec<u32> = shape.indices.iter().map(|index| u32::from(*index)).collect();
    let shade = |fragment: &Fragment<'_>| {
        if let &[u, v] = fragment.varyings {
            let at = usize::from(fragment.y) * width + usize::from(fragment.x);
            if let Some(place) = found.borrow_mut().get_mut(at) {
                *place = Some([u, v]);
            }
        }
        Some([0.0; 4])
    };
    picture.draw(&Draw {
        space: space(false),
        kind: Kind::Triangles,
        vertices: &vertices,
        corners: &corners,
        interpolation: Interpolation::Perspective,
        state: State::PLAIN,
        shade: &shade,
    });
    found.into_inner()
}
