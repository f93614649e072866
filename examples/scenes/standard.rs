//! The measured scenes: 320x240, RGB565, clears excluded.

use super::{Facts, Group, Probe, Scene, Stage, ROOM};

/// Half as many words as pixels: two RGB565 pixels a word.
const WORDS: usize = ROOM / 2;

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 2] {
    let scene = |name, bunny, draw| Scene {
        name,
        group: Group::Standard,
        frames: 1,
        bunny,
        draw,
    };
    [
        scene("clear", false, clear::<P>),
        Scene {
            frames: 16,
            ..scene("bunny-dots", true, bunny_dots::<P>)
        },
    ]
}

/// Clearing colour and depth, measured.
fn clear<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    let color = stage.color.get_mut(..WORDS).unwrap_or_default();
    let depth = &mut *stage.depth;
    probe.measure(|| {
        color.fill(0x1234_5678);
        depth.fill(0);
    });
    if P::COUNTING {
        probe.pixels(ROOM as u64);
    }
    Facts {
        bytes: WORDS * 4,
        triangles: 0,
    }
}

/// One word for each vertex of the bunny.
fn bunny_dots<P: Probe>(stage: &mut Stage<'_>, frame: u32, probe: &mut P) -> Facts {
    stage.color.fill(0);
    let Some(model) = stage.bunny else {
        return Facts {
            bytes: 0,
            triangles: 0,
        };
    };
    let color = stage.color.get_mut(..WORDS).unwrap_or_default();
    let mut written = 0;
    probe.measure(|| {
        for (position, normal) in model.positions.iter().zip(model.normals) {
            let row = usize::from(position[1].cast_unsigned() >> 8) * 150;
            let column = usize::from(position[0].cast_unsigned() >> 9) + frame as usize;
            if let Some(word) = color.get_mut(row + column) {
                *word = u32::from(normal[2].cast_unsigned());
                written += 1;
            }
        }
    });
    if P::COUNTING {
        probe.pixels(written);
    }
    Facts {
        bytes: WORDS * 4,
        triangles: u32::try_from(model.indices.len() / 3).unwrap_or(u32::MAX),
    }
}
