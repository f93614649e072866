//! Bytes that settings take: buffers by their size, flash as docs/SIZES.md has it.

use std::path::Path;

use crate::case::Case;
use crate::scenes::standard::SIZE;

/// A vertex in the cache: what is projected, a key, a packed colour.
const CACHED: usize = 20;

/// Bytes of the buffers that a case draws with: colour, depth, samples, the vertex cache.
pub(crate) fn buffers(case: &Case) -> usize {
    let setting = |knob: &str| {
        let found = case.knobs.iter().position(|name| name == knob);
        found.and_then(|at| case.settings.get(at)).map(String::as_str)
    };
    let width = usize::from(SIZE.width);
    let pixels = width * usize::from(SIZE.height);
    let rows = setting("rows").and_then(|rows| rows.parse().ok());
    let color = if setting("format") == Some("rgba8888") { 4 } else { 2 };
    let depth =
        if matches!(setting("depth"), Some("off")) || case.scene == "heads-up" { 0 } else { 2 };
    let frame = rows.map_or(pixels, |rows: usize| rows * width) * (color + depth);
    // Samples of four bytes with depth; the frame that they go to has none.
    let frame = match setting("samples") {
        Some("2x2") => 2 * pixels + 2 * width * 60 * 6,
        Some("4x4") => 2 * pixels + 4 * width * 24 * 6,
        _ => frame,
    };
    let cache = setting("cache").and_then(|entries| entries.parse().ok()).unwrap_or(32);
    let has_cache = case.scene != "heads-up";
    frame + if has_cache { cache * CACHED } else { 0 }
}

/// The row of docs/SIZES.md that weighs a case's setting, alone beside flat triangles.
fn feature(case: &Case) -> Option<&'static str> {
    let ([knob], [setting]) = (case.knobs.as_slice(), case.settings.as_slice()) else {
        return None;
    };
    Some(match (knob.as_str(), setting.as_str()) {
        ("perspective", "affine") => "affine texture",
        ("perspective", "every-16") => "texture every 16",
        ("perspective", "adaptive") => "nearest texture",
        ("perspective", "exact") => "exact texture",
        ("depth", "tested") => "depth",
        ("depth", "constant") => "constant depth",
        ("depth", "read-only") => "read-only depth",
        ("dither", "4x4") => "dither 4x4",
        ("dither", "8x8") => "dither 8x8",
        ("normals", "face") if case.scene != "sphere" => "lambert",
        ("normals", "pixel") if case.scene != "sphere" => "phong",
        ("fog", "vertices") => "fog at vertices",
        ("fog", "fragments") => "fog at fragments",
        ("samples", "2x2" | "4x4") => "supersampling",
        ("blend", "alpha") => "alpha blending",
        ("blend", "multiply") => "multiply blending",
        ("line", "thin") => "lines",
        ("line", "midpoint") => "midpoint lines",
        ("line", "wide") => "wide lines",
        ("line", "rectangle") => "rectangular lines",
        ("line", "smooth") => "smooth lines",
        _ => return None,
    })
}

/// Flash by feature on Cortex-M4, from the table of docs/SIZES.md.
#[derive(Debug)]
pub(crate) struct Flash(String);

impl Flash {
    /// Reads the table.
    ///
    /// # Errors
    /// The file is not there.
    pub(crate) fn read(root: &Path) -> Result<Self, String> {
        let file = root.join("docs/SIZES.md");
        std::fs::read_to_string(&file).map(Self).map_err(|why| format!("{}: {why}", file.display()))
    }

    /// Bytes more than flat triangles; `None` for a setting that is not weighed.
    pub(crate) fn of(&self, case: &Case) -> Option<i64> {
        let name = feature(case)?;
        self.0.lines().find_map(|line| {
            let mut cells = line.strip_prefix("| ")?.split(" | ");
            (cells.next()? == name).then(|| cells.next()?.parse().ok())?
        })
    }
}
