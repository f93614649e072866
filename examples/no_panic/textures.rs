//! Textures: formats, filters, wraps, mip-maps, environments, and the shaders that show them.

use crate::inputs::{self, hidden, Buffers};
use microraster::math::Vec3;
use microraster::texture::{
    Add, Alpha8, AnyEnvironment, AnyFilter, AnySampler, AnyTexture, AnyWrap, Bilinear, Clamp,
    ClampAny, Decal, FineBilinear, Indexed4, Indexed8, Luminance8, MipMap, MipSampler, Mirror,
    Modulate, Nearest, Repeat, Replace, Rgba4444, Rgba5551, Sample, Sampler, Texture,
};
use microraster::{
    Affine, Cutout, DepthBuffer, Every, Exact, Fog, Fogged, Frame, Gouraud, Lambert, Less, Light,
    Matcap, Pass, Rgb, Rgb565, Rgba8888, Textured,
};

type Deep<'a> = Frame<'a, Rgb565, DepthBuffer<'a>>;

/// Draws them all.
pub(crate) fn draw(buffers: &mut Buffers) -> Option<()> {
    let frame = &mut buffers.deep::<Rgb565>()?;
    samplers(frame)?;
    formats(frame)?;
    mip_maps(frame)?;
    modes(frame)?;
    surfaces(frame)
}

/// Draws what a sampler gives.
fn show<S: Sample + Copy>(frame: &mut Deep<'_>, sampler: S) {
    let (camera, model) = (inputs::camera(), inputs::model());
    let mesh = inputs::on_texture();
    Pass::new(&camera).depth(Less).draw(frame, &model, &mesh, &Textured::new(sampler));
}

/// Filters and wraps.
fn samplers(frame: &mut Deep<'_>) -> Option<()> {
    let texture = inputs::texture()?;
    show(frame, Sampler::nearest(texture).ok()?.unit_bits(hidden(10)));
    show(frame, Sampler::bilinear(texture).ok()?);
    show(frame, Sampler::new(texture, FineBilinear, Mirror, Clamp).ok()?);
    show(frame, Sampler::new(texture, Nearest, Clamp, Mirror).ok()?);
    show(frame, Sampler::new(texture, Bilinear, ClampAny, ClampAny).ok()?);
    let filter = hidden(AnyFilter::FineBilinear);
    let (across, down) = hidden((AnyWrap::Mirror, AnyWrap::Repeat));
    let any = AnySampler::new(hidden(AnyTexture::Rgb565(texture)), filter, across, down).ok()?;
    show(frame, any.unit_bits(hidden(9)));
    Some(())
}

/// Formats of texels, near and far.
fn formats(frame: &mut Deep<'_>) -> Option<()> {
    static COLORS: [u16; 256] = [0x1234; 256];
    let side = || hidden(8);
    let texture = Texture::<Rgba8888>::new(inputs::words()?, side(), side()).ok()?;
    show(frame, Sampler::bilinear(texture).ok()?);
    let texture = Texture::<Rgba5551>::new(inputs::words()?, side(), side()).ok()?;
    show(frame, Sampler::bilinear(texture).ok()?);
    let texture = Texture::<Rgba4444>::new(inputs::words()?, side(), side()).ok()?;
    show(frame, Sampler::bilinear(texture).ok()?);
    let texture = Texture::<Luminance8>::new(inputs::words()?, side(), side()).ok()?;
    show(frame, Sampler::bilinear(texture).ok()?);
    let texture = Texture::<Alpha8>::new(inputs::words()?, side(), side()).ok()?;
    show(frame, Sampler::bilinear(texture).ok()?);
    let (words, palette) = (inputs::words()?, hidden(&COLORS));
    let texture = Texture::<Indexed8>::with_palette(words, palette, side(), side()).ok()?;
    show(frame, Sampler::bilinear(texture).ok()?);
    let palette = hidden(&COLORS).first_chunk()?;
    let texture = Texture::<Indexed4>::with_palette(words, palette, side(), side()).ok()?;
    show(frame, Sampler::bilinear(texture).ok()?);
    show(frame, Sampler::nearest(texture).ok()?);
    Some(())
}

/// Mip-maps, made here.
fn mip_maps(frame: &mut Deep<'_>) -> Option<()> {
    let mut words = hidden([0x1234_u16; 85]);
    MipMap::<Rgb565>::reduce(&mut words, hidden(8), hidden(8)).ok()?;
    let levels = MipMap::<Rgb565>::new(&words, hidden(8), hidden(8)).ok()?;
    hidden((levels.levels(), levels.level(hidden(1)).width()));
    show(frame, MipSampler::new(levels, Nearest, Repeat, Repeat).unit_bits(hidden(9)));
    show(frame, MipSampler::new(levels, Bilinear, Repeat, Mirror));
    Some(())
}

/// Modes of perspective.
fn modes(frame: &mut Deep<'_>) -> Option<()> {
    let sampler = Sampler::nearest(inputs::texture()?).ok()?;
    let (camera, model) = (inputs::camera(), inputs::model());
    let pass = || Pass::new(&camera).depth(Less);
    let mesh = inputs::on_texture();
    pass().draw(frame, &model, &mesh, &Textured::new(sampler).perspective(Affine));
    pass().draw(frame, &model, &mesh, &Textured::new(sampler).perspective(Every::<8>));
    pass().draw(frame, &model, &mesh, &Textured::new(sampler).perspective(Every::<16>));
    pass().draw(frame, &model, &mesh, &Textured::new(sampler).perspective(Exact));
    Some(())
}

/// Textures on lit surfaces, matcaps, holes, fog.
fn surfaces(frame: &mut Deep<'_>) -> Option<()> {
    let sampler = Sampler::bilinear(inputs::texture()?).ok()?;
    let (camera, model) = (inputs::camera(), inputs::model());
    let pass = || Pass::new(&camera).depth(Less);
    let mesh = inputs::lit_and_placed();
    let sun = Light::directional(hidden(Vec3::Z), Rgb::WHITE);
    let lit = Gouraud::new(Lambert::new(&[sun]));
    let modulated = Textured::on(lit, sampler);
    pass().draw(frame, &model, &mesh, &modulated.environment(Modulate));
    pass().draw(frame, &model, &mesh, &modulated.environment(Replace));
    pass().draw(frame, &model, &mesh, &modulated.environment(Decal));
    pass().draw(frame, &model, &mesh, &modulated.environment(Add));
    pass().draw(frame, &model, &mesh, &modulated.environment(hidden(AnyEnvironment::Add)));
    pass().draw(frame, &model, &mesh, &Cutout::new(modulated, hidden(100)));
    let fog = Fog::exponential(Rgb::WHITE, hidden(0.3));
    pass().draw(frame, &model, &mesh, &Fogged::new(modulated, fog));
    pass().draw(frame, &model, &inputs::lit(), &Matcap::new(sampler));
    Some(())
}
