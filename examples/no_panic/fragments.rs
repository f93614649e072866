//! What happens to a fragment: depth, stencil, blending, dither, mask.

use crate::inputs::{self, hidden, Buffers};
use fixed::types::I8F8;
use microraster::{
    Add, Alpha, Always, AnyBlend, AnyCompare, AnyDepth, AnyDepthState, AnyDither, AnyMask,
    AnyOperation, Average, Blend, Channels, ConstantAlpha, ConstantDepth, DepthBuffer, DepthRange,
    DepthTest, Dither4, Dither8, Equal, Format, Frame, Gouraud, IncrementWrap, LessEqual, Multiply,
    NotEqual, Pass, PolygonOffset, Premultiplied, ReadOnly, Replace, Rgb565, Rgba8888, Stencil,
    StencilBuffer, Stenciled, Subtract,
};

type Full<'a, F> = Frame<'a, F, StencilBuffer<'a, DepthBuffer<'a>>>;

/// Draws them all.
pub(crate) fn draw(buffers: &mut Buffers) -> Option<()> {
    let frame = &mut buffers.deep::<Rgb565>()?;
    let (slope, units) = hidden((I8F8::ONE, 3));
    let (farthest, nearest) = hidden((100, 9000));
    depth(frame, Always);
    depth(frame, NotEqual);
    depth(frame, ReadOnly::new(Equal));
    depth(frame, ConstantDepth::new(LessEqual));
    depth(frame, PolygonOffset::new(LessEqual, slope, units));
    depth(frame, DepthRange::new(LessEqual, farthest, nearest));
    let mut any = AnyDepthState::new(hidden(AnyDepth::Greater));
    any.read_only = hidden(false);
    any.constant = hidden(false);
    any.offset = (slope, units);
    any.range = (farthest, nearest);
    depth(frame, any);

    let frame = &mut buffers.plain::<Rgb565>()?;
    blend(frame, Alpha);
    blend(frame, ConstantAlpha(hidden(77)));
    blend(frame, Premultiplied);
    blend(frame, Add);
    blend(frame, Multiply);
    blend(frame, Subtract);
    blend(frame, Average);

    everything(&mut buffers.frame::<Rgb565>()?);
    everything(&mut buffers.frame::<Rgba8888>()?);
    Some(())
}

fn depth<D: DepthTest>(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, test: D)
where
    for<'a> DepthBuffer<'a>: microraster::frame::Supplies<D::Access>,
{
    let (camera, model) = (inputs::camera(), inputs::model());
    let mesh = inputs::colored();
    Pass::new(&camera).depth(test).draw(frame, &model, &mesh, &Gouraud::colored());
}

fn blend<B: Blend>(frame: &mut Frame<'_, Rgb565>, blend: B) {
    let (camera, model) = (inputs::camera(), inputs::model());
    let mesh = inputs::colored();
    Pass::new(&camera).blend(blend).draw(frame, &model, &mesh, &Gouraud::colored());
}

/// Several states at once, of known and of chosen kinds, in a band with a scissor.
fn everything<F: Format>(frame: &mut Full<'_, F>) {
    let (camera, model) = (inputs::camera(), inputs::model());
    let mesh = inputs::colored();
    let shader = Gouraud::colored();
    let plain = Stencil::new(Equal, hidden(3)).on_pass(IncrementWrap);
    Pass::new(&camera)
        .depth(Stenciled::new(LessEqual, plain))
        .dither(Dither4)
        .color_mask(Channels::<true, false, true>)
        .draw(frame, &model, &mesh, &shader);
    Pass::new(&camera).blend(Replace).dither(Dither8).draw(frame, &model, &mesh, &shader);
    let stencil = Stencil::new(hidden(AnyCompare::Less), hidden(3))
        .on_fail(hidden(AnyOperation::Invert))
        .on_depth_fail(hidden(AnyOperation::DecrementClamp))
        .on_pass(hidden(AnyOperation::Replace))
        .read_mask(hidden(0xF0))
        .write_mask(hidden(0x0F));
    let depth = AnyDepthState::new(hidden(AnyDepth::Less));
    let mask = AnyMask { red: hidden(true), green: hidden(false), blue: hidden(true) };
    Pass::new(&camera)
        .depth(Stenciled::new(depth, stencil))
        .blend(hidden(AnyBlend::Alpha))
        .dither(hidden(AnyDither::Four))
        .color_mask(mask)
        .draw(frame, &model, &mesh, &shader);
}
