//! Lines, points, triangles on the screen, samples.

use crate::inputs::{self, hidden, Buffers};
use microraster::raster::ScreenVertex;
use microraster::texture::Sampler;
use microraster::{
    Alpha, Attenuated, Consecutive, Cull, Cutout, DepthBuffer, Dither4, Frame, Gouraud, Indices,
    Less, LineList, LineLoop, LineStrip, LineStyle, Midpoint, Pass, Points, Rectangle, Rgb, Rgb565,
    Rgba8888, ScreenPass, SizeOf, Smooth, Sprite, Stippled, Supersampling, Thin, Undithered,
    VertexInput, Wide, Winding,
};

type Deep<'a> = Frame<'a, Rgb565, DepthBuffer<'a>>;

/// Draws them all.
pub(crate) fn draw(buffers: &mut Buffers) -> Option<()> {
    let frame = &mut buffers.deep::<Rgb565>()?;
    lines(frame);
    points(frame)?;
    screen(frame);
    samples()
}

/// Lines of each style, of each topology, and wireframes.
fn lines(frame: &mut Deep<'_>) {
    fn styled(frame: &mut Deep<'_>, style: impl LineStyle) {
        let (camera, model) = (inputs::camera(), inputs::model());
        let mesh = inputs::colored().with_topology(LineStrip::new(Consecutive::new(hidden(6))));
        let mut pass = Pass::new(&camera).depth(Less).blend(Alpha);
        pass.draw_lines(frame, &model, &mesh, &Gouraud::colored(), style);
        ScreenPass::new().depth(Less).lines(frame, &Gouraud::colored(), style, &[ends()]);
    }
    static PAIRS: [u16; 6] = [0, 1, 2, 3, 4, 9];
    styled(frame, Thin);
    styled(frame, Midpoint);
    styled(frame, Wide(hidden(3)));
    styled(frame, Rectangle(hidden(5)));
    styled(frame, Smooth(hidden(5)));
    styled(frame, Stippled::new(hidden(0x5555), hidden(2), Thin));
    styled(frame, Stippled::new(hidden(0x5555), hidden(2), Wide(hidden(3))));
    let (camera, model) = (inputs::camera(), inputs::model());
    let pass = || Pass::new(&camera).depth(Less);
    let (mesh, shader) = (inputs::colored(), Gouraud::colored());
    let list = mesh.with_topology(LineList::new(Indices::new(hidden(&PAIRS[..]))));
    pass().draw_lines(frame, &model, &list, &shader, Thin);
    let round = mesh.with_topology(LineLoop::new(Consecutive::new(hidden(6))));
    pass().draw_lines(frame, &model, &round, &shader, Thin);
    pass().draw_wireframe(frame, &model, &mesh, &shader, Thin);
}

/// Points of each size, and sprites.
fn points(frame: &mut Deep<'_>) -> Option<()> {
    let (camera, model) = (inputs::camera(), inputs::model());
    let mesh = inputs::colored().with_topology(Points::new(Consecutive::new(hidden(6))));
    let (mut pass, shader) = (Pass::new(&camera).depth(Less), Gouraud::colored());
    pass.draw_points(frame, &model, &mesh, &shader, &hidden(7_u16));
    let far =
        Attenuated::new(hidden(9.0), hidden(0.5), hidden([1.0, 0.3, 0.1])).at_least(hidden(2));
    pass.draw_points(frame, &model, &mesh, &shader, &far);
    let by_color = SizeOf(|vertex: VertexInput<'_, Rgb>, depth| {
        u32::from(vertex.attributes.r) * u32::from(depth)
    });
    pass.draw_points(frame, &model, &mesh, &shader, &by_color);
    pass.draw_corners(frame, &model, &inputs::colored(), &shader, &hidden(3_u16));
    let sprite = Sprite::new(Sampler::bilinear(inputs::texture()?).ok()?);
    pass.draw_points(frame, &model, &mesh, &Cutout::new(sprite, hidden(9)), &hidden(20_u16));
    Some(())
}

fn corner(x: i32, y: i32) -> (ScreenVertex, microraster::Color) {
    (ScreenVertex::from_bits(hidden(x), hidden(y), hidden(30_000)), hidden(Rgb::RED).into())
}

fn ends() -> [(ScreenVertex, microraster::Color); 2] {
    [corner(5, 9), corner(300, 200)]
}

/// What is on the screen already.
fn screen(frame: &mut Deep<'_>) {
    let [a, b] = ends();
    let shader = Gouraud::colored();
    let mut pass = ScreenPass::new()
        .depth(Less)
        .dither(Dither4)
        .cull(hidden(Cull::Front))
        .front_face(hidden(Winding::Clockwise));
    pass.triangle(frame, &shader, &[a, b, corner(9, 400)]);
    pass.triangles(frame, &shader, hidden(&[[a, b, corner(0, 0)]][..]));
    pass.line_strip(frame, &shader, Thin, hidden(&[a, b][..]));
    pass.points(frame, &shader, hidden(3), hidden(&[a, b][..]));
}

/// Two and four samples a side.
fn samples() -> Option<()> {
    let mut fine = hidden([0_u16; 16 * 16]);
    let mut coarse = hidden([0_u32; 8 * 8]);
    let fine = Frame::<Rgb565>::new(&mut fine, hidden(microraster::Size::new(16, 16))).ok()?;
    let size = hidden(microraster::Size::new(4, 4));
    let mut frame = Frame::<Rgba8888>::new(&mut coarse, size).ok()?;
    hidden(Supersampling::Four).resolve(&fine, &mut frame, &Undithered);
    let mut coarse = hidden([0_u16; 8 * 8]);
    let mut frame = Frame::<Rgb565>::new(&mut coarse, size).ok()?;
    hidden(Supersampling::Two).resolve(&fine, &mut frame, &Dither4);
    hidden(coarse);
    Some(())
}
