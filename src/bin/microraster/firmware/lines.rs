//! The lines that the firmware prints: words of the form `name=value`.

/// One frame, as a board drew it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Drawn {
    /// The scene's name.
    pub(crate) scene: String,
    /// The frame's number.
    pub(crate) frame: u32,
    /// Instructions of the measured part.
    pub(crate) instructions: u64,
    /// Hash of the picture.
    pub(crate) hash: u64,
    /// Bytes of the picture.
    pub(crate) bytes: usize,
}

/// All that one run printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Report {
    /// Its frames, in order.
    pub(crate) frames: Vec<Drawn>,
    /// Deepest stack of the measured parts, in bytes.
    pub(crate) stack: usize,
}

impl Report {
    /// Reads what the firmware printed.
    ///
    /// # Errors
    /// A line that is none of the two kinds, or no last line: the firmware stopped early.
    pub(crate) fn read(printed: &str) -> Result<Self, String> {
        let mut frames = Vec::new();
        let mut stack = None;
        for line in printed.lines().filter(|line| !line.trim().is_empty()) {
            let known = if line.starts_with("scene=") {
                drawn(line).map(|frame| frames.push(frame))
            } else {
                value(line, "stack").and_then(|text| text.parse().ok()).map(|depth| {
                    stack = Some(depth);
                })
            };
            known
                .ok_or_else(|| format!("the firmware printed a line of no known form: `{line}`"))?;
        }
        let stack = stack.ok_or("the firmware stopped before its last line, `stack=…`")?;
        Ok(Self { frames, stack })
    }
}

/// A line of a frame.
fn drawn(line: &str) -> Option<Drawn> {
    let hash = value(line, "hash").filter(|text| text.len() == 16)?;
    Some(Drawn {
        scene: value(line, "scene")?.to_string(),
        frame: value(line, "frame")?.parse().ok()?,
        instructions: value(line, "instructions")?.parse().ok()?,
        hash: u64::from_str_radix(hash, 16).ok()?,
        bytes: value(line, "bytes")?.parse().ok()?,
    })
}

/// The value of the word `name=value` of a line.
pub(crate) fn value<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    line.split_whitespace().find_map(|word| word.strip_prefix(name)?.strip_prefix('='))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: &str = "scene=F3 frame=2 instructions=1790000 hash=00ff00ff00ff00ff bytes=153600";

    #[test]
    fn a_run_is_read_back() {
        let report = Report::read(&format!("{FRAME}\n\nstack=412\n"));
        let frame = Drawn {
            scene: "F3".into(),
            frame: 2,
            instructions: 1_790_000,
            hash: 0x00ff_00ff_00ff_00ff,
            bytes: 153_600,
        };
        assert_eq!(report, Ok(Report { frames: vec![frame], stack: 412 }));
    }

    #[test]
    fn a_run_that_stopped_early_is_an_error() {
        let message = Report::read(FRAME).expect_err("there is no last line");
        assert!(message.contains("stopped before"), "the message is: {message}");
    }

    #[test]
    fn a_foreign_line_is_an_error_that_shows_it() {
        for line in [
            "panicked at src/lib.rs",
            "scene=F3 frame=2",
            "scene=F3 frame=-1 instructions=1 hash=00ff00ff00ff00ff bytes=1",
            "scene=F3 frame=1 instructions=1 hash=ff bytes=1",
            "stack=deep",
        ] {
            let message = Report::read(line).expect_err("the line has no known form");
            assert!(message.contains(line), "the message is: {message}");
        }
    }
}
