//! Names of cases: `SCENE/KNOB=SETTING`, with `+` between the parts of a pair.

/// A setting of a knob, or of two, in a scene.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Case {
    pub(crate) scene: String,
    pub(crate) knobs: Vec<String>,
    pub(crate) settings: Vec<String>,
}

impl Case {
    /// From a name.
    pub(crate) fn parse(name: &str) -> Option<Self> {
        let (scene, rest) = name.split_once('/')?;
        let (knobs, settings) = rest.split_once('=')?;
        let words = |text: &str| text.split('+').map(str::to_owned).collect::<Vec<_>>();
        let case = Self { scene: scene.into(), knobs: words(knobs), settings: words(settings) };
        (case.knobs.len() == case.settings.len()).then_some(case)
    }

    pub(crate) fn name(&self) -> String {
        format!("{}/{}={}", self.scene, self.knobs.join("+"), self.settings.join("+"))
    }

    /// The knob, or the pair.
    pub(crate) fn knob(&self) -> String {
        self.knobs.join(" x ")
    }

    /// The setting, or the pair.
    pub(crate) fn setting(&self) -> String {
        self.settings.join(" + ")
    }

    /// Whether every knob stands where the crate leaves it.
    pub(crate) fn is_default(&self) -> bool {
        self.knobs.iter().zip(&self.settings).all(|(knob, setting)| default_of(knob) == setting)
    }
}

/// Where the crate leaves a knob, or what its examples write where they must choose.
pub(crate) fn default_of(knob: &str) -> &'static str {
    match knob {
        "perspective" => "adaptive",
        "filter" => "nearest",
        "colour" => "linear",
        "depth" => "tested",
        "range" => "1e3",
        "dither" => "none",
        "samples" => "1",
        "normals" => "vertex",
        "trigonometry" => "exact",
        "inverse-root" => "table",
        "vertices" => "i16",
        "format" => "rgb565",
        "rows" => "240",
        "cache" => "32",
        "fog" => "vertices",
        "blend" => "replace",
        "line" => "thin",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back() {
        for name in ["plane-4/perspective+filter=affine+mip-nearest", "teapot/rows=240"] {
            let case = Case::parse(name).expect("the name has all parts");
            assert_eq!(case.name(), name);
        }
        for name in ["teapot", "teapot/rows", "teapot/rows=1+2"] {
            assert_eq!(Case::parse(name), None, "{name}");
        }
    }

    #[test]
    fn every_knob_of_the_list_has_a_default_among_its_settings() {
        let cases: Vec<Case> = crate::drawing::all().filter_map(|c| Case::parse(c.name)).collect();
        for case in &cases {
            // Depth of the range is a format of its own, compared in pairs.
            if case.scene != "range" {
                let settings = case.knobs.iter().map(|knob| default_of(knob).to_owned()).collect();
                let base = Case { settings, ..case.clone() };
                assert!(cases.contains(&base), "{} has no base case", case.name());
            }
        }
    }
}
