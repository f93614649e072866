//! Drawing a view: the only file that knows how triangles become pixels.

use super::options::{Cull, Format, Shade};
use super::picture::Picture;
use super::view::View;
use microraster::host::Corner;

/// Towards the light, and the share of light that comes from everywhere.
const LIGHT: [f64; 3] = [0.408, 0.408, 0.816];
const AMBIENT: f64 = 0.2;

/// Draws `scene` into `picture`, pixel by pixel in `f64`: the plainest picture of it.
pub(crate) fn render(scene: &View, picture: &mut Picture) {
    // Every pixel is tested, which is what all traversals must amount to.
    let _ = scene.traversal;
    let mut depth = vec![0.0; picture.size.pixels()];
    for group in &scene.model.groups {
        for triangle in &group.triangles {
            draw(scene, picture, &mut depth, triangle, group.material.diffuse);
        }
    }
}

fn draw(
    scene: &View,
    picture: &mut Picture,
    depth: &mut [f64],
    triangle: &[Corner; 3],
    diffuse: [f32; 3],
) {
    let (width, height) = (
        f64::from(picture.size.width),
        f64::from(picture.size.height),
    );
    let focus = height / 2.0 / View::HALF_FIELD.tan();
    let face = scene.model.face_normal(triangle).unwrap_or_default();
    let [a, b, c] = triangle.map(|corner| {
        let position = scene.model.positions.get(corner.position as usize);
        let [x, y, z] = scene.place(position.copied().unwrap_or_default());
        let near = 1.0 / (scene.distance - z);
        let normal = match scene.shade {
            Shade::Flat => face,
            Shade::Gouraud => {
                let normal = scene.model.normals.get(corner.normal as usize);
                normal.copied().unwrap_or_default()
            }
        };
        let [i, j, k] = scene.turn(normal.map(f64::from));
        let light = (i * LIGHT[0] + j * LIGHT[1] + k * LIGHT[2]).max(0.0);
        let lit = AMBIENT + (1.0 - AMBIENT) * light;
        (
            [
                width / 2.0 + x * near * focus,
                height / 2.0 - y * near * focus,
            ],
            near,
            lit,
        )
    });
    let turn = |[ax, ay]: [f64; 2], [bx, by]: [f64; 2], [cx, cy]: [f64; 2]| {
        (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    };
    let area = turn(a.0, c.0, b.0);
    let culled = match scene.cull {
        Cull::None => false,
        Cull::Back => area < 0.0,
        Cull::Front => area > 0.0,
    };
    if culled || area.abs() <= 0.0 {
        return;
    }
    picture.drawn += 1;

    let range = |axis: usize, size: f64| {
        let ends = [a.0[axis], b.0[axis], c.0[axis]];
        let first = ends.into_iter().fold(size, f64::min).max(0.0);
        let last = ends.into_iter().fold(0.0, f64::max).min(size);
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "within the picture"
        )]
        (first as usize..last.ceil() as usize)
    };
    for y in range(1, height) {
        for x in range(0, width) {
            let at = [x as f64 + 0.5, y as f64 + 0.5];
            let weights = [
                turn(at, c.0, b.0) / area,
                turn(a.0, c.0, at) / area,
                turn(a.0, at, b.0) / area,
            ];
            let [u, v, w] = weights;
            let index = y * usize::from(picture.size.width) + x;
            let near = u * a.1 + v * b.1 + w * c.1;
            let hidden = scene.depth && depth.get(index).is_some_and(|&depth| near <= depth);
            if u < 0.0 || v < 0.0 || w < 0.0 || hidden {
                continue;
            }
            if let Some(depth) = depth.get_mut(index) {
                *depth = near;
            }
            let light = u * a.2 + v * b.2 + w * c.2;
            put(
                picture,
                index,
                diffuse.map(|channel| f64::from(channel) * light),
            );
        }
    }
}

fn put(picture: &mut Picture, index: usize, color: [f64; 3]) {
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a colour within 0..=1; a float cast saturates"
    )]
    let [red, green, blue] = color.map(|channel| (channel * 255.0 + 0.5) as u8);
    let five = |channel: u8| u16::from(channel >> 3);
    let pixel = (five(red) << 11) | (u16::from(green >> 2) << 5) | five(blue);
    let bytes: &[u8] = match picture.format {
        Format::Rgb565 => &pixel.to_ne_bytes(),
        Format::Rgb565be => &pixel.to_be_bytes(),
        Format::Rgba8888 => &[red, green, blue, 255],
    };
    let start = index * bytes.len();
    if let Some(place) = picture.bytes.get_mut(start..start + bytes.len()) {
        place.copy_from_slice(bytes);
        picture.pixels += 1;
    }
}
