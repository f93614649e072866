//! How colours meet, as the definitions say.

use crate::shade::AnyBlend;

/// One channel of a source, whose alpha is 0 to 1, over a stored one.
fn channel(mode: AnyBlend, source: f64, alpha: f64, stored: f64) -> f64 {
    let over = |alpha: f64| source * alpha + stored * (1.0 - alpha);
    match mode {
        AnyBlend::Replace => source,
        AnyBlend::Alpha => over(alpha),
        AnyBlend::ConstantAlpha(alpha) => over(f64::from(alpha) / 255.0),
        AnyBlend::Premultiplied => source + stored * (1.0 - alpha),
        AnyBlend::Add => source + stored,
        AnyBlend::Multiply => source * stored / 255.0,
        AnyBlend::Subtract => stored - source,
        AnyBlend::Average => (source + stored) / 2.0,
    }
}

/// A source colour (red, green, blue, alpha) blended with a stored one, all 0 to 255, not rounded.
///
/// | mode | result, limited to 0..=255 |
/// | --- | --- |
/// | `Replace` | source |
/// | `Alpha`, `ConstantAlpha` | source a + stored (1 - a) |
/// | `Premultiplied` | source + stored (1 - a) |
/// | `Add`, `Subtract` | stored + source, stored - source |
/// | `Multiply` | source stored / 255 |
/// | `Average` | (source + stored) / 2 |
///
/// # Range
/// The source's channels are limited to 0..=255 first, as a shader's are.
///
/// ```
/// use microraster::host::reference::blended;
/// use microraster::AnyBlend;
///
/// let glass = [255.0, 0.0, 50.0, 127.5];
/// assert_eq!(blended(AnyBlend::Alpha, glass, [0.0, 100.0, 50.0]), [127.5, 50.0, 50.0]);
/// ```
#[must_use]
pub fn blended(mode: AnyBlend, source: [f64; 4], stored: [f64; 3]) -> [f64; 3] {
    let [r, g, b, alpha] = source.map(|channel| channel.clamp(0.0, 255.0));
    let source = [r, g, b];
    [0, 1, 2].map(|i| channel(mode, source[i], alpha / 255.0, stored[i]).clamp(0.0, 255.0))
}
