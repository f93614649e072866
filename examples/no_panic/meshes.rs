//! Triangles of meshes: topologies, cameras, shaders, lights, formats.

use crate::inputs::{self, hidden, Buffers};
use microraster::math::{Angle, Mat4, Vec3};
use microraster::{
    Affine, AnyTopology, AtFragments, Attenuation, BlinnPhong, Camera, Consecutive, Corner, Cull,
    DepthBuffer, Every, Exact, Flat, Fog, Fogged, Format, Frame, Gouraud, IndexedList, Indices,
    Lambert, LastProvoking, Less, Light, List, Mesh, Off, Pass, Phong, Points, RestartIndices, Rgb,
    Rgb565, Rgb565Be, Rgba8888, SmoothColor, Solid, Stats, Topology, TriangleFan, TriangleStrip,
    VertexCache, Winding,
};

static SMALL: [u8; 6] = [0, 1, 2, 255, 4, 5];
static MIDDLE: [u16; 6] = [0, 1, 2, 65_535, 4, 5];
static LARGE: [u32; 6] = [0, 1, 2, u32::MAX, 4, 5];

fn indices<I>(indices: &'static [I]) -> Indices<'static, I> {
    Indices::new(hidden(indices))
}

fn restarting<I>(indices: &'static [I]) -> RestartIndices<'static, I> {
    RestartIndices::new(hidden(indices))
}

/// Draws them all.
pub(crate) fn draw(buffers: &mut Buffers) -> Option<()> {
    topologies(&mut buffers.deep::<Rgb565>()?);
    passes(&mut buffers.plain::<Rgb565>()?);
    shaders(&mut buffers.deep::<Rgb565>()?);
    lights(&mut buffers.deep::<Rgb565>()?);
    fogs(&mut buffers.deep::<Rgb565>()?);
    format::<Rgb565Be>(buffers)?;
    format::<Rgba8888>(buffers)
}

/// Each kind of list, strip and fan.
fn topologies(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>) {
    fn one<T: Topology<Primitive = [u32; 3]>>(
        frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>,
        topology: T,
    ) {
        let mesh = inputs::colored().with_topology(topology);
        hidden(mesh.triangles());
        let (camera, model) = (inputs::camera(), inputs::model());
        Pass::new(&camera).depth(Less).draw(frame, &model, &mesh, &Gouraud::colored());
    }
    let consecutive = Consecutive::new(hidden(6));
    one(frame, List::new(hidden(6)));
    one(frame, IndexedList::new(hidden(&SMALL[..])));
    one(frame, IndexedList::new(hidden(&MIDDLE[..])));
    one(frame, IndexedList::new(hidden(&LARGE[..])));
    one(frame, TriangleStrip::new(consecutive));
    one(frame, TriangleFan::new(consecutive));
    one(frame, LastProvoking(TriangleStrip::new(indices(&SMALL))));
    one(frame, TriangleFan::new(restarting(&MIDDLE)));
    one(frame, hidden(AnyTopology::Strip16(TriangleStrip::new(indices(&MIDDLE)))));
}

/// What a pass can be told, cameras of each kind, a cache of the caller's, faces' attributes.
fn passes(frame: &mut Frame<'_, Rgb565>) {
    let shader = Flat::<Solid<()>>::solid(hidden(Rgb::RED));
    let model = inputs::model();
    let row = || hidden(Vec3::ONE).extend(hidden(1.0));
    let cameras = [
        inputs::camera(),
        Camera::orthographic(hidden(2.0), hidden(-1.0), hidden(9.0)),
        Camera::custom(Mat4::from_rows(row(), row(), row(), row())),
    ];
    for camera in &hidden(cameras) {
        Pass::new(camera)
            .cull(hidden(Cull::Back))
            .front_face(hidden(Winding::Clockwise))
            .viewport(hidden(microraster::Rect::new(-5, 3, 40, 90)))
            .draw(frame, &model, &inputs::bare(), &shader);
    }
    let mut cache = VertexCache::<Corner<SmoothColor>, 64>::new();
    let mut stats = Stats::default();
    let mesh = inputs::colored().by_face().indexed(hidden(&MIDDLE[..]));
    let camera = inputs::camera();
    let mut pass = Pass::new(&camera).depth(Off).count(&mut stats);
    pass.draw_cached(frame, &model, &mesh, &Gouraud::colored(), &mut cache);
    hidden(stats);
    hidden(model.inverse());
    hidden(model.orthonormalize());
}

/// Shaders with normals.
fn shaders(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>) {
    let sun = || Light::directional(hidden(Vec3::Z), Rgb::WHITE);
    let (camera, model) = (inputs::camera(), inputs::model());
    let pass = || Pass::new(&camera).depth(Less);
    let lit = inputs::lit();
    let lambert = Lambert::new(&[sun()]);
    pass().draw(frame, &model, &inputs::colored(), &Flat::colored());
    pass().draw(frame, &model, &lit, &Phong::new(lambert));
    pass().draw(frame, &model, &lit, &Phong::new(lambert).perspective(Affine));
    pass().draw(frame, &model, &lit, &Phong::new(lambert).perspective(Every::<16>));
    pass().draw(frame, &model, &lit, &Phong::new(lambert).perspective(Exact));
    let shiny = BlinnPhong::new(&[sun(), sun()])
        .ambient(hidden(Rgb::RED))
        .material(hidden(Rgb::RED))
        .specular(hidden(Rgb::WHITE), hidden(20))
        .emissive(hidden(Rgb::RED))
        .two_sided();
    pass().draw(frame, &model, &lit, &Phong::new(shiny));
    pass().draw(frame, &model, &lit, &Gouraud::new(shiny));
}

/// Lights of each kind.
fn lights(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>) {
    let place = || hidden(Vec3::ONE);
    let fading = || Attenuation::new(hidden(1.0), hidden(0.5), hidden(0.1));
    let sun = Light::directional(place(), Rgb::WHITE);
    let lamp = Light::point(place(), Rgb::WHITE).attenuation(fading());
    let [inner, outer] = hidden([10.0, 20.0]).map(Angle::from_degrees);
    let spot = Light::spot(place(), place(), inner, outer, Rgb::WHITE).attenuation(fading());
    let (camera, model) = (inputs::camera(), inputs::model());
    let lit = inputs::lit();
    let pass = || Pass::new(&camera).depth(Less);
    pass().draw(frame, &model, &lit, &Flat::lit(&[sun]));
    pass().draw(frame, &model, &lit, &Flat::lit(&[lamp]));
    pass().draw(frame, &model, &lit, &Flat::lit(&[spot]));
    let any = hidden([sun.any(), lamp.any(), spot.any()]);
    pass().draw(frame, &model, &lit, &Gouraud::new(BlinnPhong::new(&any)));
}

/// Fog of each kind, at vertices and at fragments.
fn fogs(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>) {
    let density = || hidden(0.3);
    let (camera, model) = (inputs::camera(), inputs::model());
    let pass = || Pass::new(&camera).depth(Less);
    let mesh = inputs::colored();
    let linear = Fog::linear(Rgb::WHITE, hidden(1.0), hidden(9.0));
    pass().draw(frame, &model, &mesh, &Fogged::new(Gouraud::colored(), linear));
    let exponential = Fog::exponential(Rgb::WHITE, density());
    let shader = Fogged::new(Flat::colored(), exponential).at(AtFragments).perspective(Exact);
    pass().draw(frame, &model, &mesh, &shader);
    let squared = Fog::exponential_squared(Rgb::WHITE, density());
    let shader = Fogged::new(Flat::colored(), squared).perspective(Affine);
    pass().draw(frame, &model, &mesh, &shader);
}

/// Fills and gradients of another format, with depth and without.
fn format<F: Format>(buffers: &mut Buffers) -> Option<()> {
    let (camera, model) = (inputs::camera(), inputs::model());
    let mut frame = buffers.plain::<F>()?;
    let shader = Flat::<Solid<()>>::solid(hidden(Rgb::RED));
    Pass::new(&camera).draw(&mut frame, &model, &inputs::bare(), &shader);
    let mut frame = buffers.deep::<F>()?;
    let mesh: Mesh<'_, Rgb> = inputs::colored();
    let mut pass = Pass::new(&camera).depth(Less);
    pass.draw(&mut frame, &model, &mesh, &Gouraud::colored());
    let points = mesh.with_topology(Points::new(Consecutive::new(hidden(6))));
    pass.draw_points(&mut frame, &model, &points, &Gouraud::colored(), &hidden(1_u16));
    Some(())
}
