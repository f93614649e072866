//! A conformance scene: the text that says what is drawn.

/// A vertex as it stands in the file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertex {
    pub(crate) position: [f32; 4],
    pub(crate) color: [f32; 4],
    pub(crate) uv: [f32; 2],
}

/// A texture as it stands in the file.
#[derive(Clone, Debug)]
pub(crate) struct Texels {
    pub(crate) width: u16,
    pub(crate) height: u16,
    pub(crate) is_rgb565: bool,
    pub(crate) is_linear: bool,
    pub(crate) repeats: bool,
    /// In the file's order: little-endian words, or red, green, blue, alpha.
    pub(crate) bytes: Vec<u8>,
}

/// What the vertices of a draw make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Triangles,
    Lines,
    Points,
}

impl Kind {
    /// Vertices of one primitive.
    pub(crate) fn corners(self) -> usize {
        match self {
            Self::Triangles => 3,
            Self::Lines => 2,
            Self::Points => 1,
        }
    }
}

/// One `draw` line with its vertices.
#[derive(Clone, Debug)]
pub(crate) struct Draw {
    pub(crate) kind: Kind,
    settings: Vec<(String, String)>,
    pub(crate) vertices: Vec<Vertex>,
}

impl Draw {
    /// A setting of the draw.
    pub(crate) fn setting(&self, key: &str) -> &str {
        self.settings.iter().find(|(k, _)| k == key).map_or("", |(_, value)| value)
    }

    /// The primitives, in order.
    pub(crate) fn primitives(&self) -> impl Iterator<Item = &[Vertex]> {
        self.vertices.chunks_exact(self.kind.corners())
    }
}

/// A whole scene.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) width: u16,
    pub(crate) height: u16,
    /// Positions are in clip space instead of on the screen.
    pub(crate) clip: bool,
    /// Red, green, blue, alpha; 0 to 255.
    pub(crate) clear: [u8; 4],
    pub(crate) texture: Option<Texels>,
    pub(crate) draws: Vec<Draw>,
}

impl Scene {
    /// Reads the text form; the message says which line is wrong.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let mut scene = Self {
            width: 0,
            height: 0,
            clip: false,
            clear: [0, 0, 0, 255],
            texture: None,
            draws: Vec::new(),
        };
        for (number, line) in text.lines().enumerate() {
            let words: Vec<&str> = line.split_whitespace().collect();
            scene.take(&words).ok_or_else(|| format!("line {}: {line}", number + 1))?;
        }
        Ok(scene)
    }

    fn take(&mut self, words: &[&str]) -> Option<()> {
        match words {
            ["scene", _, width, height, space] => {
                (self.width, self.height) = (width.parse().ok()?, height.parse().ok()?);
                self.clip = *space == "clip";
            }
            ["clear", r, g, b, a, depth] => {
                let channel = |word: &str| word.parse().ok();
                self.clear = [channel(r)?, channel(g)?, channel(b)?, channel(a)?];
                // All scenes clear to the farthest.
                (depth.parse() == Ok(1.0_f32)).then_some(())?;
            }
            ["draw", kind, settings @ ..] => {
                let kind = match *kind {
                    "triangles" => Kind::Triangles,
                    "lines" => Kind::Lines,
                    "points" => Kind::Points,
                    _ => return None,
                };
                let pair = |word: &&str| {
                    word.split_once('=').map(|(key, value)| (key.to_owned(), value.to_owned()))
                };
                let settings = settings.iter().map(pair).collect::<Option<_>>()?;
                self.draws.push(Draw { kind, settings, vertices: Vec::new() });
            }
            ["v", numbers @ ..] => {
                let numbers: Vec<f32> = numbers.iter().filter_map(|n| n.parse().ok()).collect();
                let [x, y, z, w, r, g, b, a, u, v] = numbers[..] else { return None };
                let vertex = Vertex { position: [x, y, z, w], color: [r, g, b, a], uv: [u, v] };
                self.draws.last_mut()?.vertices.push(vertex);
            }
            ["texture", width, height, format, filter, wrap, hex] => {
                let byte = |at: usize| u8::from_str_radix(hex.get(at..at + 2)?, 16).ok();
                let bytes = (0..hex.len()).step_by(2).map(byte).collect::<Option<_>>()?;
                self.texture = Some(Texels {
                    width: width.parse().ok()?,
                    height: height.parse().ok()?,
                    is_rgb565: *format == "rgb565",
                    is_linear: *filter == "linear",
                    repeats: *wrap == "repeat",
                    bytes,
                });
            }
            ["end"] | [] => {}
            _ => return None,
        }
        Some(())
    }
}
