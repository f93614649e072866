//! Draws, compares and counts everything, and writes it down.

use microraster::Camera;
use std::path::Path;

use crate::case::Case;
use crate::costs::{Cost, Costs, BOARDS};
use crate::document::Document;
use crate::drawing::{self, Drawing};
use crate::errors::compare;
use crate::memory::{buffers, Flash};
use crate::row::{is_on_front, Row};
use crate::scenes::gallery::pictures::terrain;
use crate::scenes::standard::camera;
use crate::scenes::Model;
use crate::truth::{Key, Truths};
use crate::{bunny, doc_lines, plot, side_by_side, subpixels, table, texels, tradeoff, traversals};

/// The largest error of each knob so far.
#[derive(Debug)]
struct Worst {
    case: Case,
    error: f64,
    drawn: Vec<[f64; 3]>,
    exact: Vec<[f64; 3]>,
}

/// All rows.
#[derive(Debug)]
pub(crate) struct Report {
    pub(crate) rows: Vec<Row>,
    truths: Truths,
    bunny: Option<Vec<u32>>,
    worst: Vec<Worst>,
}

impl Report {
    /// Draws and compares the cases that are `wanted`. Costs are those of `costs`, 0 where it has
    /// none.
    ///
    /// # Errors
    /// A board drew another picture than the host.
    pub(crate) fn new(
        root: &Path,
        costs: &Costs,
        wanted: impl Fn(&Case) -> bool,
    ) -> Result<Self, String> {
        let bunny = bunny::find(root).and_then(|file| bunny::convert(&file));
        let mut missing = bunny.as_ref().err().cloned();
        let mut report = Self {
            rows: Vec::new(),
            truths: Truths::default(),
            bunny: bunny.ok(),
            worst: Vec::new(),
        };
        let flash = Flash::read(root)?;
        for scene in drawing::all() {
            let Some(case) = Case::parse(scene.name) else {
                return Err(format!("`{}` is no name of a case", scene.name));
            };
            if !wanted(&case) {
                continue;
            }
            if scene.bunny && report.bunny.is_none() {
                if let Some(why) = missing.take() {
                    eprintln!("tradeoff: the bunny is left out: {why}");
                }
                continue;
            }
            let words = report.bunny.take();
            let model = words.as_ref().and_then(|words| Model::view(bytemuck::cast_slice(words)));
            let drawing = drawing::draw(&scene, model);
            let cost = cost(costs, scene.name, &drawing)?;
            report.compare(case, &drawing, cost, &flash, model);
            report.bunny = words;
        }
        Ok(report)
    }

    fn compare(
        &mut self,
        case: Case,
        drawing: &Drawing,
        cost: Cost,
        flash: &Flash,
        model: Option<Model<'_>>,
    ) {
        let truth = self.truths.get(&Key::of(&case), model);
        let ideal = self.truths.get(&Key::ideal(&case), model);
        let coordinates = texels::error(&case);
        let errors = compare(&case, drawing, &truth, &ideal.colors, coordinates, &camera_of(&case));
        let row = Row {
            errors,
            cost,
            memory: buffers(&case),
            flash: flash.of(&case),
            pixels: drawing.pixels,
            triangles: drawing.triangles,
            case,
        };
        self.remember(&row, drawing, &truth.colors);
        self.rows.push(row);
    }

    /// Keeps the pictures of each knob's worst setting.
    fn remember(&mut self, row: &Row, drawing: &Drawing, exact: &[[f64; 3]]) {
        let new = Worst {
            case: row.case.clone(),
            error: row.error(),
            drawn: drawing.colors.clone(),
            exact: exact.to_vec(),
        };
        match self.worst.iter_mut().find(|worst| worst.case.knobs == row.case.knobs) {
            Some(worst) if worst.error < new.error => *worst = new,
            Some(_) => {}
            None => self.worst.push(new),
        }
    }

    /// Writes everything.
    ///
    /// # Errors
    /// A file cannot be written, or docs/TRADEOFF.md lacks a block.
    pub(crate) fn write(&mut self, root: &Path, costs: &Costs) -> Result<(), String> {
        let folder = root.join("docs/tradeoff");
        std::fs::create_dir_all(&folder).map_err(|why| format!("{}: {why}", folder.display()))?;
        let csv = folder.join("cases.csv");
        std::fs::write(&csv, table::csv(&self.rows))
            .map_err(|why| format!("{}: {why}", csv.display()))?;

        let mut document = Document::read(&root.join("docs/TRADEOFF.md"))?;
        document.put("source", &format!("Instructions were {}.", table::source(costs)))?;
        for (knob, tables) in self.tables() {
            document.put(&knob, &tables)?;
        }
        document.put("defaults", &self.defaults())?;
        let words = self.bunny.take();
        let model = words.as_ref().and_then(|words| Model::view(bytemuck::cast_slice(words)));
        document.put("subpixels", &subpixels::table(&mut self.truths, model))?;
        document.put("positions", &subpixels::with_positions(&mut self.truths))?;
        match traversals::table() {
            Ok(table) => document.put("traversals", &table)?,
            Err(why) => eprintln!("tradeoff: traversals are left as they were: {why}"),
        }
        document.put("plots", &self.plots(&folder)?)?;
        document.put("pictures", &self.pictures(&folder)?)?;
        document.write()?;
        doc_lines::renew(&root.join("src"), &self.rows)
    }

    /// For each knob, its tables by scene.
    fn tables(&self) -> Vec<(String, String)> {
        let mut knobs: Vec<(String, String)> = Vec::new();
        let mut groups: Vec<(String, String)> = self.rows.iter().map(Row::group).collect();
        groups.dedup();
        for (scene, knob) in groups {
            let rows: Vec<&Row> = self
                .rows
                .iter()
                .filter(|row| row.group() == (scene.clone(), knob.clone()))
                .collect();
            let text = format!("\n`{scene}`:\n\n{}\n", table::table(&rows));
            match knobs.iter_mut().find(|(name, _)| *name == knob) {
                Some((_, tables)) => tables.push_str(&text),
                None => knobs.push((knob, text)),
            }
        }
        knobs
    }

    /// Which defaults are beaten, and by what.
    fn defaults(&self) -> String {
        let mut lines = Vec::new();
        let traded = |row: &&Row| row.case.is_default() && is_traded(&row.case);
        for row in self.rows.iter().filter(traded) {
            let group: Vec<&Row> =
                self.rows.iter().filter(|other| other.group() == row.group()).collect();
            if !is_on_front(row, &group, Row::error) {
                let better: Vec<String> = group
                    .iter()
                    .filter(|other| !is_on_front(row, &[row, other], Row::error))
                    .map(|other| format!("`{}`", other.case.setting()))
                    .collect();
                lines.push(format!(
                    "- `{}`: {} of `{}` is beaten by {}",
                    row.case.scene,
                    row.case.setting(),
                    row.case.knob(),
                    better.join(", ")
                ));
            }
        }
        if lines.is_empty() {
            "Every default lies on the front of its knob, in every scene.".into()
        } else {
            lines.join("\n")
        }
    }

    /// A plot for each picture that settings are to come near to, and each board.
    fn plots(&self, folder: &Path) -> Result<String, String> {
        // Blending makes other pictures, not better ones; ranges are compared in their table.
        let plotted = |row: &&Row| row.case.scene != "range" && row.case.knob() != "blend";
        let mut keys: Vec<Key> = Vec::new();
        for row in self.rows.iter().filter(plotted) {
            let key = Key::ideal(&row.case);
            if !keys.contains(&key) {
                keys.push(key);
            }
        }
        let mut links = Vec::new();
        for key in keys {
            let of_key = |row: &&Row| Key::ideal(&row.case) == key;
            let rows: Vec<&Row> = self.rows.iter().filter(plotted).filter(of_key).collect();
            // A scene that is shown in several ways, such as in colours instead of a texture.
            let knob = rows.first().map(|row| row.case.knob()).unwrap_or_default();
            let others = self.rows.iter().filter(plotted).find(|row| row.case.scene == key.scene);
            let is_first = others.is_some_and(|row| Key::ideal(&row.case) == key);
            let title = if is_first { key.scene.clone() } else { format!("{}-{knob}", key.scene) };
            for (board, (short, name)) in BOARDS.iter().enumerate() {
                let file = format!("{title}-{short}.svg");
                plot::draw(&title, board, &rows, &folder.join(&file))?;
                if board < 2 {
                    links.push(format!("![{title} on {name}](tradeoff/{file})"));
                }
            }
        }
        Ok(links.join("\n"))
    }

    fn pictures(&self, folder: &Path) -> Result<String, String> {
        let mut links = Vec::new();
        for worst in &self.worst {
            let file = format!("worst-{}.png", worst.case.knobs.join("-"));
            side_by_side::write(&worst.drawn, &worst.exact, &folder.join(&file))?;
            links.push(format!(
                "`{}`: {} off, root mean square of 255\n\n![{}](tradeoff/{file})",
                worst.case.name(),
                table::number(worst.error),
                worst.case.name()
            ));
        }
        Ok(links.join("\n\n"))
    }
}

/// Whether the settings of a knob are the same picture, more or less exactly. Without depth, and in
/// other ways of blending, they are others as soon as surfaces overlap.
pub(crate) fn is_traded(case: &Case) -> bool {
    case.knobs.iter().all(|knob| knob != "depth" && knob != "blend") || case.knobs.len() > 1
}

/// The cost of a case; its picture must be the host's.
fn cost(costs: &Costs, name: &str, drawing: &Drawing) -> Result<Cost, String> {
    match costs.cases.get(name) {
        Some(cost) if cost.hash == drawing.hash => Ok(*cost),
        Some(cost) => {
            Err(format!("{name}: boards drew {:016x}, the host {:016x}", cost.hash, drawing.hash))
        }
        None => Ok(Cost::default()),
    }
}

/// The camera of a case.
fn camera_of(case: &Case) -> Camera {
    match case.scene.as_str() {
        "terrain" => terrain::camera(tradeoff::terrain::TURN),
        "sphere-close" => tradeoff::sphere::CLOSE,
        _ => camera(),
    }
}
