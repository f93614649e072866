//! Mesa's llvmpipe through OpenGL without a window: machine code made for each scene's state, on
//! one thread. `None` where the machine has no such driver.
#![allow(unsafe_code, reason = "OpenGL has no safe form")]

use glow::HasContext;
use khronos_egl as egl;

use crate::renderers::Renderer;
use crate::scene::{self, Rgb, Scene, Shading, Size, SIDE, TEXELS};

/// A platform without displays (`EGL_MESA_platform_surfaceless`).
const SURFACELESS: egl::Enum = 0x31DD;

const VERTEX: &str = "#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 given;
#ifdef TINTED
layout(location = 2) in vec3 given_tint;
noperspective out vec3 tint;
#endif
uniform mat4 matrix;
uniform vec3 to_light;
uniform vec3 material;
uniform vec2 light;
#ifdef FLAT
flat out vec3 color;
#else
out vec3 color;
#endif
void main() {
    gl_Position = matrix * vec4(position, 1.0);
#ifdef LIT
    color = material * (light.x + light.y * max(dot(given, to_light), 0.0));
#else
    color = given;
#endif
#ifdef TINTED
    tint = given_tint;
#endif
}";

const FRAGMENT: &str = "#version 330 core
#ifdef FLAT
flat in vec3 color;
#else
in vec3 color;
#endif
#ifdef TINTED
noperspective in vec3 tint;
#endif
uniform sampler2D image;
uniform float opacity;
out vec4 result;
void main() {
#ifdef TEXTURED
    result = texture(image, color.xy);
#ifdef TINTED
    result *= vec4(tint, 1.0);
#endif
#elif defined(GLASS)
    result = vec4(color, opacity);
#else
    result = vec4(color, 1.0);
#endif
}";

struct Ready {
    scene: Scene,
    size: Size,
    context: egl::Context,
    display: egl::Display,
    instance: egl::DynamicInstance<egl::EGL1_5>,
    gl: glow::Context,
    program: glow::Program,
    indices: i32,
}

/// All scenes, where there is a driver.
pub(crate) fn make(scene: &Scene, size: Size) -> Option<Box<dyn Renderer>> {
    // SAFETY: the library is EGL's own, and the context is current while it is used.
    unsafe { ready(scene, size) }.map(|ready| Box::new(ready) as Box<dyn Renderer>)
}

/// # Safety
/// As of every call of OpenGL: with the context current, which the first lines make it.
unsafe fn ready(scene: &Scene, size: Size) -> Option<Ready> {
    let instance = egl::DynamicInstance::<egl::EGL1_5>::load_required().ok()?;
    let display = instance
        .get_platform_display(SURFACELESS, egl::DEFAULT_DISPLAY, &[egl::ATTRIB_NONE])
        .ok()?;
    instance.initialize(display).ok()?;
    instance.bind_api(egl::OPENGL_API).ok()?;
    // Windows are what is asked for otherwise.
    let wanted =
        [egl::SURFACE_TYPE, egl::PBUFFER_BIT, egl::RENDERABLE_TYPE, egl::OPENGL_BIT, egl::NONE];
    let config = instance.choose_first_config(display, &wanted).ok()??;
    let version = [
        egl::CONTEXT_MAJOR_VERSION,
        3,
        egl::CONTEXT_MINOR_VERSION,
        3,
        egl::CONTEXT_OPENGL_PROFILE_MASK,
        egl::CONTEXT_OPENGL_CORE_PROFILE_BIT,
        egl::NONE,
    ];
    let context = instance.create_context(display, config, None, &version).ok()?;
    instance.make_current(display, None, None, Some(context)).ok()?;
    let gl = glow::Context::from_loader_function(|name| {
        instance.get_proc_address(name).map_or(core::ptr::null(), |f| f as *const _)
    });
    if !gl.get_parameter_string(glow::RENDERER).contains("llvmpipe") {
        return None;
    }
    target(&gl, size)?;
    let program = program(&gl, scene)?;
    let indices = upload(&gl, scene)?;
    gl.viewport(0, 0, size.width.into(), size.height.into());
    if scene.depth {
        gl.enable(glow::DEPTH_TEST);
        gl.depth_func(glow::LESS);
    }
    if scene.culled {
        gl.enable(glow::CULL_FACE);
    }
    gl.disable(glow::DITHER);
    if let Shading::Glass(_, opacity) = scene.shading {
        gl.enable(glow::BLEND);
        gl.blend_func(glow::SRC_ALPHA, glow::ONE_MINUS_SRC_ALPHA);
        let place = gl.get_uniform_location(program, "opacity");
        gl.uniform_1_f32(place.as_ref(), f32::from(opacity) / 255.0);
    }
    Some(Ready { scene: scene.clone(), size, context, display, instance, gl, program, indices })
}

/// RGB565 and 16 bits of depth.
unsafe fn target(gl: &glow::Context, size: Size) -> Option<()> {
    let (width, height) = (size.width.into(), size.height.into());
    let framebuffer = gl.create_framebuffer().ok()?;
    gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
    for (format, point) in
        [(glow::RGB565, glow::COLOR_ATTACHMENT0), (glow::DEPTH_COMPONENT16, glow::DEPTH_ATTACHMENT)]
    {
        let buffer = gl.create_renderbuffer().ok()?;
        gl.bind_renderbuffer(glow::RENDERBUFFER, Some(buffer));
        gl.renderbuffer_storage(glow::RENDERBUFFER, format, width, height);
        gl.framebuffer_renderbuffer(glow::FRAMEBUFFER, point, glow::RENDERBUFFER, Some(buffer));
    }
    let status = gl.check_framebuffer_status(glow::FRAMEBUFFER);
    (status == glow::FRAMEBUFFER_COMPLETE).then_some(())
}

/// The shaders that a scene needs.
unsafe fn program(gl: &glow::Context, scene: &Scene) -> Option<glow::Program> {
    let defines = match &scene.shading {
        Shading::Solid(_) | Shading::Faces(_) => "#define FLAT\n",
        Shading::Smooth(_) => "",
        Shading::Lit { smooth: true, .. } => "#define LIT\n",
        Shading::Lit { smooth: false, .. } => "#define LIT\n#define FLAT\n",
        Shading::Textured(_) | Shading::Filtered { colors: None, .. } => "#define TEXTURED\n",
        Shading::Filtered { colors: Some(_), .. } => "#define TEXTURED\n#define TINTED\n",
        Shading::Glass(..) => "#define FLAT\n#define GLASS\n",
    };
    let program = gl.create_program().ok()?;
    for (kind, source) in [(glow::VERTEX_SHADER, VERTEX), (glow::FRAGMENT_SHADER, FRAGMENT)] {
        let shader = gl.create_shader(kind).ok()?;
        // Defines come behind the version.
        let (version, rest) = source.split_once('\n')?;
        gl.shader_source(shader, &format!("{version}\n{defines}{rest}"));
        gl.compile_shader(shader);
        if !gl.get_shader_compile_status(shader) {
            eprintln!("llvmpipe: {}", gl.get_shader_info_log(shader));
            return None;
        }
        gl.attach_shader(program, shader);
    }
    gl.link_program(program);
    if !gl.get_program_link_status(program) {
        eprintln!("llvmpipe: {}", gl.get_program_info_log(program));
        return None;
    }
    gl.use_program(Some(program));
    Some(program)
}

/// Vertices, indices and the texture; how many indices there are.
unsafe fn upload(gl: &glow::Context, scene: &Scene) -> Option<i32> {
    let level = |color: &Rgb| color.map(|c| f32::from(c) / 255.0);
    let attribute = |number: usize, index: usize| match &scene.shading {
        Shading::Solid(color) | Shading::Glass(color, _) => level(color),
        Shading::Smooth(colors) => level(&colors[index]),
        Shading::Faces(colors) => level(&colors[number]),
        Shading::Lit { normals, .. } => normals[index],
        Shading::Textured(places) | Shading::Filtered { places, .. } => {
            [places[index][0], places[index][1], 0.0]
        }
    };
    let tints = match &scene.shading {
        Shading::Filtered { colors, .. } => colors.as_ref(),
        _ => None,
    };
    let mut words: Vec<f32> = Vec::new();
    let mut vertex = |number, index: usize| {
        words.extend(scene.positions[index]);
        words.extend(attribute(number, index));
        words.extend(tints.into_iter().flat_map(|colors| level(&colors[index])));
    };
    let indices: Vec<u32> = if matches!(scene.shading, Shading::Faces(_)) {
        for (number, triangle) in scene.triangles.iter().enumerate() {
            triangle.iter().for_each(|&index| vertex(number, index));
        }
        (0..3 * scene.triangles.len() as u32).collect()
    } else {
        (0..scene.positions.len()).for_each(|index| vertex(0, index));
        // OpenGL takes a triangle's colour from its last vertex, the scenes from the first.
        let turned = scene.triangles.iter().flat_map(|[a, b, c]| [*b, *c, *a]);
        turned.map(|index| index as u32).collect()
    };
    let bytes = |words: &[[u8; 4]]| words.as_flattened().to_vec();
    let array = gl.create_vertex_array().ok()?;
    gl.bind_vertex_array(Some(array));
    let buffer = gl.create_buffer().ok()?;
    gl.bind_buffer(glow::ARRAY_BUFFER, Some(buffer));
    let vertices: Vec<_> = words.iter().map(|word| word.to_ne_bytes()).collect();
    gl.buffer_data_u8_slice(glow::ARRAY_BUFFER, &bytes(&vertices), glow::STATIC_DRAW);
    let attributes = if tints.is_some() { 3 } else { 2 };
    for at in 0..attributes {
        gl.enable_vertex_attrib_array(at as u32);
        gl.vertex_attrib_pointer_f32(at as u32, 3, glow::FLOAT, false, 12 * attributes, 12 * at);
    }
    let elements = gl.create_buffer().ok()?;
    gl.bind_buffer(glow::ELEMENT_ARRAY_BUFFER, Some(elements));
    let numbers: Vec<_> = indices.iter().map(|index| index.to_ne_bytes()).collect();
    gl.buffer_data_u8_slice(glow::ELEMENT_ARRAY_BUFFER, &bytes(&numbers), glow::STATIC_DRAW);
    if matches!(scene.shading, Shading::Textured(_) | Shading::Filtered { .. }) {
        let texels: Vec<u8> = TEXELS.iter().flat_map(|&texel| scene::rgb(texel)).collect();
        let texture = gl.create_texture().ok()?;
        gl.bind_texture(glow::TEXTURE_2D, Some(texture));
        let (side, format) = (SIDE as i32, glow::RGB8 as i32);
        gl.pixel_store_i32(glow::UNPACK_ALIGNMENT, 1);
        gl.tex_image_2d(
            glow::TEXTURE_2D,
            0,
            format,
            side,
            side,
            0,
            glow::RGB,
            glow::UNSIGNED_BYTE,
            glow::PixelUnpackData::Slice(Some(&texels)),
        );
        let is_filtered = matches!(scene.shading, Shading::Filtered { .. });
        let filter = if is_filtered { glow::LINEAR } else { glow::NEAREST };
        for parameter in [glow::TEXTURE_MIN_FILTER, glow::TEXTURE_MAG_FILTER] {
            gl.tex_parameter_i32(glow::TEXTURE_2D, parameter, filter as i32);
        }
    }
    i32::try_from(indices.len()).ok()
}

impl Ready {
    /// SAFETY for all that follows: this thread's current context is this one.
    fn make_current(&self) {
        let _ = self.instance.make_current(self.display, None, None, Some(self.context));
    }
}

impl Renderer for Ready {
    fn clear(&mut self) {
        self.make_current();
        // SAFETY: the context is current.
        unsafe {
            self.gl.clear(glow::COLOR_BUFFER_BIT | glow::DEPTH_BUFFER_BIT);
            self.gl.finish();
        }
    }

    fn draw(&mut self, frame: usize) {
        let gl = &self.gl;
        let rows = scene::product(&scene::projection(self.size), &self.scene.model_view(frame));
        let to_light = self.scene.to_light(frame);
        let material = scene::MATERIAL.map(|c| f32::from(c) / 255.0);
        // SAFETY: `clear` made the context current.
        unsafe {
            let place = |name| gl.get_uniform_location(self.program, name);
            let rows = rows.as_flattened();
            gl.uniform_matrix_4_f32_slice(place("matrix").as_ref(), true, rows);
            gl.uniform_3_f32_slice(place("to_light").as_ref(), &to_light);
            gl.uniform_3_f32_slice(place("material").as_ref(), &material);
            gl.uniform_2_f32(place("light").as_ref(), scene::AMBIENT, scene::DIFFUSE);
            gl.draw_elements(glow::TRIANGLES, self.indices, glow::UNSIGNED_INT, 0);
            gl.finish();
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.make_current();
        let (width, height) = (usize::from(self.size.width), usize::from(self.size.height));
        let mut bytes = vec![0; 3 * width * height];
        // SAFETY: the context is current, and the buffer as large as the picture.
        unsafe {
            self.gl.pixel_store_i32(glow::PACK_ALIGNMENT, 1);
            self.gl.read_pixels(
                0,
                0,
                width as i32,
                height as i32,
                glow::RGB,
                glow::UNSIGNED_BYTE,
                glow::PixelPackData::Slice(Some(&mut bytes)),
            );
        }
        // Rows come from the bottom.
        let rows: Vec<Vec<Rgb>> =
            bytes.chunks_exact(3 * width).map(|row| row.as_chunks::<3>().0.to_vec()).collect();
        rows.into_iter().rev().flatten().collect()
    }
}

impl Drop for Ready {
    fn drop(&mut self) {
        let _ = self.instance.make_current(self.display, None, None, None);
        let _ = self.instance.destroy_context(self.display, self.context);
    }
}
