//! What light falls on: meshes, the ball, the hills.

use microraster::host::reference::lighting::{blinn_phong, lambert, Material, Surface};
use microraster::host::reference::{Draw, Fog, Fragment, Interpolation, Kind, Reference, State};
use microraster::math::{Mat4, Vec3};
use microraster::{AnyLightKind, Camera, Cull, Light, Normal, Rgb, Topology};

use super::flat::{channels, opaque, tested};
use super::geometry::{distance, in_model, normal_in_world, space, unit, vertices, Vector};
use super::{Key, Shading};
use crate::scenes::gallery::pictures::terrain as hills;
use crate::scenes::standard::{self, camera};
use crate::scenes::Model;
use crate::tradeoff::meshes::{Bunny, Distant, Subject, Teapot};
use crate::tradeoff::{sphere as ball, terrain as view, Shape};

fn sun(direction: Vec3, color: Rgb) -> [Light<AnyLightKind>; 1] {
    [Light::directional(direction, color).any()]
}

/// What becomes of a point of a surface: its place in the world and its normal there.
type Lit<'a> = dyn Fn(Vector, Vector) -> [f64; 3] + 'a;

/// A mesh in the world, with a normal for each of its vertices.
struct Body<'a> {
    places: &'a [Vector],
    normals: &'a [Normal],
    corners: &'a [u32],
    model: &'a Mat4,
    camera: &'a Camera,
}

impl Body<'_> {
    /// With light at vertices, linear on the screen, or at each point.
    fn draw(&self, at_points: bool, lit: &Lit<'_>, picture: &mut Reference) {
        let vertices = vertices(self.places, self.model, self.camera, |i, world| {
            let normal = normal_in_world(self.model, self.normals[i]);
            if at_points {
                normal.into_iter().chain(world).collect()
            } else {
                lit(world, normal).to_vec()
            }
        });
        let shade = |fragment: &Fragment<'_>| match *fragment.varyings {
            [r, g, b] => Some(opaque([r, g, b])),
            [x, y, z, u, v, w] => Some(opaque(lit([u, v, w], unit([x, y, z])))),
            _ => None,
        };
        let interpolation =
            if at_points { Interpolation::Perspective } else { Interpolation::Linear };
        picture.draw(&Draw {
            space: space(false),
            kind: Kind::Triangles,
            vertices: &vertices,
            corners: self.corners,
            interpolation,
            state: State { depth: tested(), cull: Cull::Back, ..State::PLAIN },
            shade: &shade,
        });
    }
}

fn numbers(shape: &Shape<'_>) -> Vec<u32> {
    shape.indices.iter().map(|index| u32::from(*index)).collect()
}

pub(super) fn mesh(
    scene: &str,
    shading: &Shading,
    bunny: Option<Model<'_>>,
    picture: &mut Reference,
) {
    let (shape, normals) = match scene {
        "bunny" => Bunny::shape(bunny),
        "distant" => Distant::shape(bunny),
        _ => Teapot::shape(bunny),
    };
    let lights = sun(standard::SUN, standard::SUN_COLOR);
    let material = Material {
        ambient: channels(standard::AMBIENT),
        color: channels(standard::MATERIAL),
        ..Material::WHITE
    };
    let body = Body {
        places: &in_model(&shape),
        normals,
        corners: &numbers(&shape),
        model: &shape.model,
        camera: &camera(),
    };
    let lit = |point, normal| lambert(&lights, &material, &Surface { point, normal });
    body.draw(*shading == Shading::AtPoints, &lit, picture);
}

pub(super) fn sphere(key: &Key, picture: &mut Reference) {
    let is_close = key.scene == "sphere-close";
    let shape = ball::shape(is_close);
    // Where vertices are before they are rounded to any format, or rounded to one.
    let rounded = |v: f32| match key.steps {
        Some(steps) => (f64::from(v) * f64::from(steps)).round() / f64::from(steps),
        None => f64::from(v),
    };
    let places: Vec<Vector> =
        (0..ball::NORMALS.len()).map(|i| ball::place(i).map(rounded)).collect();
    let lights = sun(ball::SUN, ball::SUN_COLOR);
    let material = Material {
        ambient: channels(ball::AMBIENT),
        color: channels(ball::MATERIAL),
        specular: [255.0; 3],
        shininess: f64::from(ball::SHININESS),
        ..Material::WHITE
    };
    let body = Body {
        places: &places,
        normals: &ball::NORMALS,
        corners: &numbers(&shape),
        model: &shape.model,
        camera: if is_close { &ball::CLOSE } else { &camera() },
    };
    let lit = |point: Vector, normal| {
        let surface = Surface { point, normal };
        blinn_phong(&lights, &material, &surface, point.map(|c| -c))
    };
    let to_sun = unit([ball::SUN.x, ball::SUN.y, ball::SUN.z].map(|c| -f64::from(c)));
    // The shader that brings its own way to the inverse root sees all from the front.
    let own = |_: Vector, normal: Vector| {
        let cosine = |way: Vector| (0..3).map(|i| normal[i] * way[i]).sum::<f64>();
        let diffuse = 51.0 + 204.0 * cosine(to_sun).max(0.0);
        let halfway = unit([to_sun[0], to_sun[1], to_sun[2] + 1.0]);
        let highlight = cosine(halfway).clamp(0.0, 1.0).powi(32);
        channels(ball::MATERIAL)
            .map(|channel| (diffuse * channel / 255.0 + 204.0 * highlight).min(255.0))
    };
    match &key.shading {
        Shading::Own => body.draw(true, &own, picture),
        shading => body.draw(*shading == Shading::AtPoints, &lit, picture),
    }
}

pub(super) fn terrain(shading: &Shading, picture: &mut Reference) {
    let camera = hills::camera(view::TURN);
    let ground = &hills::GROUND;
    let shape = Shape {
        positions: &ground.positions,
        indices: &[],
        scale: hills::SCALE,
        offset: Vec3::ZERO,
        model: Mat4::IDENTITY,
    };
    let lights = sun(hills::SUN, hills::SUN_COLOR);
    let fog = Fog::ExponentialSquared { density: f64::from(hills::DENSITY) };
    let haze = channels(hills::HAZE);
    let at_points = *shading == Shading::AtPoints;
    // Light is made at vertices; fog there too, or at each point.
    let vertices = vertices(&in_model(&shape), &shape.model, &camera, |i, point| {
        let (normal, color) = ground.attributes[i];
        let surface = Surface { point, normal: normal_in_world(&shape.model, normal) };
        let material = Material {
            ambient: channels(hills::AMBIENT),
            color: channels(color),
            ..Material::WHITE
        };
        let lit = lambert(&lights, &material, &surface);
        let away = distance(&camera, point);
        let fogged = if at_points { lit } else { fog.over(lit, haze, away) };
        fogged.into_iter().chain(at_points.then_some(away)).collect()
    });
    let shade = |fragment: &Fragment<'_>| match *fragment.varyings {
        [r, g, b] => Some(opaque([r, g, b])),
        [r, g, b, away] => Some(opaque(fog.over([r, g, b], haze, away))),
        _ => None,
    };
    let corners: Vec<u32> = hills::strips().iter().flatten().collect();
    picture.draw(&Draw {
        space: space(false),
        kind: Kind::Triangles,
        vertices: &vertices,
        corners: &corners,
        interpolation: Interpolation::Perspective,
        state: State { depth: tested(), cull: Cull::Back, ..State::PLAIN },
        shade: &shade,
    });
}
