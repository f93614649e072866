//! Which settings fit into the memory there is, which of them is best, and what to give up first.

use super::settings::{cache_bytes, BAND_ROOM, CACHES};
use microraster::Size;

/// Bytes of a pixel's colour and depth.
const PIXEL: u64 = 4;

/// Where the light is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shading {
    Gouraud,
    Flat,
}

impl Shading {
    /// As the firmware names it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Gouraud => "gouraud",
            Self::Flat => "flat",
        }
    }
}

/// One way to draw the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Setting {
    pub(crate) shading: Shading,
    /// Vertices of the caller's cache; 0 for that of 32 on the stack.
    pub(crate) cache: u16,
    /// Rows of a band.
    pub(crate) rows: u16,
}

impl Setting {
    /// The firmware's word for it.
    pub(crate) fn word(&self, display: Size) -> String {
        let Self { shading, cache, rows } = self;
        format!("{}:{cache}:{}:{}:{rows}", shading.name(), display.width, display.height)
    }

    /// The variant of the firmware that has only its code.
    pub(crate) fn variant(&self) -> String {
        format!("{} {}", self.shading.name(), self.cache)
    }

    /// Bytes of the bands of colour and depth.
    pub(crate) fn bands(&self, display: Size) -> u64 {
        u64::from(display.width) * u64::from(self.rows) * PIXEL
    }

    /// Bytes of bands and cache.
    pub(crate) fn buffers(&self, display: Size) -> u64 {
        self.bands(display) + cache_bytes(self.cache) as u64
    }
}

/// What a setting costs, as measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cost {
    pub(crate) setting: Setting,
    /// Instructions of a frame.
    pub(crate) instructions: u64,
    /// Deepest stack, in bytes.
    pub(crate) stack: u64,
}

/// Rows of as many bands as rows of this number make, evened out.
fn evened(rows: u16, height: u16) -> u16 {
    height.div_ceil(height.div_ceil(rows.max(1)).max(1))
}

/// The settings worth a measurement in so many bytes for bands and cache: for each cache that has
/// a use for a mesh of so many vertices, the highest bands that fit, and half of them. None where
/// not even one row fits.
pub(crate) fn candidates(display: Size, room: u64, vertices: usize) -> Vec<Setting> {
    let row = u64::from(display.width) * PIXEL;
    let most = (BAND_ROOM / usize::from(display.width).max(1)).min(display.height.into());
    let mut settings = Vec::new();
    for (number, &cache) in CACHES.iter().enumerate() {
        // A cache is of use as long as the one before it does not hold every vertex.
        let before = number.checked_sub(1).map_or(0, |before| CACHES[before]);
        let Some(left) = room.checked_sub(cache_bytes(cache) as u64) else { continue };
        if usize::from(before.max(32)) >= vertices && cache > 0 {
            continue;
        }
        let rows = u16::try_from((left / row.max(1)).min(most as u64)).unwrap_or(display.height);
        if rows == 0 {
            continue;
        }
        let rows = evened(rows, display.height);
        for rows in [rows, evened(rows.div_ceil(2), display.height)] {
            let setting = Setting { shading: Shading::Gouraud, cache, rows };
            if !settings.contains(&setting) {
                settings.push(setting);
            }
        }
    }
    settings
}

/// The best of what was measured: of all within 2 % of the fewest instructions, the one with the
/// smallest buffers.
pub(crate) fn best(costs: &[Cost], display: Size) -> Option<Cost> {
    let fewest = costs.iter().map(|cost| cost.instructions).min()?;
    let near = costs.iter().filter(|cost| cost.instructions <= fewest + fewest / 50);
    near.min_by_key(|cost| (cost.setting.buffers(display), cost.instructions)).copied()
}

/// Settings that take less than the one that was chosen, each in one respect.
pub(crate) fn smaller(chosen: Setting, display: Size) -> Vec<Setting> {
    let mut settings = Vec::new();
    if let Some(&cache) = CACHES.iter().rev().find(|&&cache| cache < chosen.cache) {
        settings.push(Setting { cache, ..chosen });
    }
    if chosen.rows > 1 {
        let rows = evened(chosen.rows.div_ceil(2), display.height);
        settings.push(Setting { rows, ..chosen });
    }
    if chosen.shading == Shading::Gouraud {
        settings.push(Setting { shading: Shading::Flat, ..chosen });
    }
    settings
}

/// Something that can be given up.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Offer {
    /// What it is.
    pub(crate) what: String,
    /// Bytes of RAM and of flash that it frees.
    pub(crate) ram: i64,
    pub(crate) flash: i64,
    /// How many per cent more instructions a frame has; less than zero where it is faster. `None`
    /// where nobody measured it.
    pub(crate) slower: Option<f64>,
    /// What is seen of it, if anything is.
    pub(crate) seen: Option<&'static str>,
}

/// Puts what to give up first in front: what is not seen before what is, and of either what frees
/// the most for a per cent of speed.
pub(crate) fn order(offers: &mut Vec<Offer>) {
    offers.retain(|offer| offer.ram > 0 || offer.flash > 0);
    // A per cent more, so that what costs nothing is no division by zero.
    let worth = |offer: &Offer| {
        (offer.ram + offer.flash) as f64 / (offer.slower.unwrap_or(0.0).max(0.0) + 1.0)
    };
    offers.sort_by(|a, b| {
        let seen = a.seen.is_some().cmp(&b.seen.is_some());
        seen.then_with(|| worth(b).total_cmp(&worth(a)))
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    const DISPLAY: Size = Size::new(240, 240);

    fn setting(cache: u16, rows: u16) -> Setting {
        Setting { shading: Shading::Gouraud, cache, rows }
    }

    #[test]
    fn bands_are_as_high_as_they_fit_and_of_one_height() {
        // 64 rows of 240 pixels: four bands would be one of 48 at the end.
        let settings = candidates(DISPLAY, 64 * 960, 30);
        assert_eq!(settings, [setting(0, 60), setting(0, 30)]);
        let settings = candidates(DISPLAY, 1 << 20, 30);
        assert_eq!(settings.first(), Some(&setting(0, 240)), "the whole picture");
        assert_eq!(candidates(DISPLAY, 960, 30), [setting(0, 1)], "one row");
        assert_eq!(candidates(DISPLAY, 959, 5000), [], "not even that");
    }

    #[test]
    fn what_is_proposed_fits_and_draws_all_rows() {
        for width in [1, 7, 240, 800, 8192] {
            for height in [1, 13, 240, 241, 4096] {
                for room in [0, 100, 5000, 40_000, 65_536, 1 << 22] {
                    let display = Size::new(width, height);
                    for setting in candidates(display, room, 5000) {
                        assert!(setting.buffers(display) <= room, "{display:?} {setting:?}");
                        assert!((1..=height).contains(&setting.rows), "{display:?} {setting:?}");
                        let pixels = usize::from(width) * usize::from(setting.rows);
                        assert!(pixels <= BAND_ROOM, "{display:?} {setting:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn caches_are_no_larger_than_the_mesh() {
        let largest = |vertices| {
            candidates(DISPLAY, 1 << 20, vertices).iter().map(|setting| setting.cache).max()
        };
        assert_eq!(largest(32), Some(0));
        assert_eq!(largest(33), Some(64));
        assert_eq!(largest(64), Some(64));
        assert_eq!(largest(65), Some(256));
        assert_eq!(largest(9999), Some(1024));
    }

    #[test]
    fn the_best_is_the_smallest_of_the_fastest() {
        let cost = |cache, rows, instructions| Cost {
            setting: setting(cache, rows),
            instructions,
            stack: 900,
        };
        let costs = [cost(1024, 240, 1000), cost(256, 240, 1010), cost(0, 60, 1400)];
        assert_eq!(best(&costs, DISPLAY), Some(costs[1]));
        assert_eq!(best(&[], DISPLAY), None);
    }

    #[test]
    fn each_smaller_setting_gives_up_one_thing() {
        let flat = Setting { shading: Shading::Flat, ..setting(256, 60) };
        assert_eq!(smaller(setting(256, 60), DISPLAY), [setting(64, 60), setting(256, 30), flat]);
        let least = Setting { shading: Shading::Flat, ..setting(0, 1) };
        assert_eq!(smaller(least, DISPLAY), [], "nothing is left");
    }

    #[test]
    fn first_comes_what_is_not_seen_and_frees_the_most_for_its_price() {
        let offer = |what: &str, ram, slower, seen| Offer {
            what: what.into(),
            ram,
            flash: 0,
            slower: Some(slower),
            seen,
        };
        let mut offers = vec![
            offer("flat", 2000, -5.0, Some("facets")),
            offer("dear", 9000, 90.0, None),
            offer("cheap", 4000, 1.0, None),
            offer("useless", 0, 0.0, None),
        ];
        order(&mut offers);
        let names: Vec<_> = offers.iter().map(|offer| offer.what.as_str()).collect();
        assert_eq!(names, ["cheap", "dear", "flat"]);
    }
}
