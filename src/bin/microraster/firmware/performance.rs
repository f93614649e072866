//! `--performance`: every measured scene on five cores and on the host, as the tables of
//! `docs/PERFORMANCE.md` and the README, and as the record that the gate compares with.

use super::board::Board;
use super::build::House;
use super::cycles::{Classes, MODELS};
use super::facts::Line;
use super::figures::Figures;
use super::marks::{self, LIT_VERTEX, LIT_VERTEX_OF, MARKS};
use super::per::Per;
use super::profile::{Profile, Profiler};
use super::record::Record;
use super::{callgrind, loops, sizes};

/// The files that it writes, in the package's folder.
const DOCUMENT: &str = "docs/PERFORMANCE.md";
const README: &str = "README.md";
const RECORD: &str = "docs/performance.csv";
const LOOPS: &str = "docs/LOOPS.md";

/// The boards that it runs: those that cycles are modelled for.
pub(crate) fn boards() -> Vec<String> {
    MODELS.iter().map(|model| model.board.to_owned()).collect()
}

/// Measures the rest and writes the files. `lines` are those of all measured scenes on all
/// `boards`, one board after the other.
///
/// # Errors
/// A run failed, or a file cannot be written or has no marks for a table.
pub(crate) fn write(
    house: &House,
    boards: &[&'static Board],
    lines: &[Line],
    record: &Record,
) -> Result<(), String> {
    let document = house.package.join(DOCUMENT);
    speed(boards, lines)?.write(&document, "speed")?;
    against_marks(lines).write(&document, "marks")?;
    let profiles = profiles(house, boards)?;
    cycles(boards, lines, &profiles).write(&document, "cycles")?;
    let missed = missed(lines, &profiles);
    let place = house.package.join(LOOPS);
    std::fs::write(&place, loops::page(&missed)).map_err(|why| format!("{LOOPS}: {why}"))?;
    models().write(&document, "models")?;
    short(house, boards, lines)?.write(&house.package.join(README), "")?;
    record.save(&house.package.join(RECORD))
}

/// The lines of a board.
fn of<'a>(board: &'a str, lines: &'a [Line]) -> impl Iterator<Item = &'a Line> {
    lines.iter().filter(move |line| line.board() == board)
}

/// A figure of a scene: so much by its own unit.
fn by(per: Per, amount: u64, line: &Line) -> f64 {
    amount as f64 / per.count(line) as f64
}

/// A board's figure of a scene, or of [`LIT_VERTEX`].
fn figure(board: &str, scene: &str, lines: &[Line]) -> Option<f64> {
    if scene == LIT_VERTEX {
        let [place, lit, unlit] = LIT_VERTEX_OF.map(|scene| figure(board, scene, lines));
        return Some(place? + lit? - unlit?);
    }
    let line = of(board, lines).find(|line| line.scene() == scene)?;
    Some(by(Per::of(scene), line.instructions(), line))
}

/// Starts a table with the column that says what its rows are counted by.
fn table<'a>(scenes: impl Iterator<Item = &'a str>) -> Figures {
    let mut figures = Figures::default();
    figures.board("a");
    scenes.for_each(|scene| figures.put(scene, Per::of(scene).to_string()));
    figures
}

/// All scenes on all boards and on the host.
fn speed(boards: &[&'static Board], lines: &[Line]) -> Result<Figures, String> {
    let first: Vec<_> = boards.first().map_or(Vec::new(), |board| of(board.name, lines).collect());
    let mut figures = table(first.iter().map(|line| line.scene()));
    for board in boards {
        figures.board(board.name);
        for line in of(board.name, lines) {
            let per = Per::of(line.scene());
            figures.put(line.scene(), per.text(by(per, line.instructions(), line)));
        }
    }
    if !callgrind::is_installed() {
        eprintln!("the host is left out: valgrind is not installed");
        return Ok(figures);
    }
    figures.board("host");
    for line in first {
        let instructions = callgrind::count(line.scene())?;
        let per = Per::of(line.scene());
        let by = by(per, instructions, line);
        println!("host scene={} instructions={instructions} a_{per}={by:.2}", line.scene());
        figures.put(line.scene(), per.text(by));
    }
    Ok(figures)
}

/// What was asked for, what is measured, and what others take.
fn against_marks(lines: &[Line]) -> Figures {
    let mut figures = table(MARKS.iter().map(|mark| mark.scene));
    for (column, board) in marks::BOARDS.into_iter().enumerate() {
        let cells = |mark: &marks::Mark| {
            let per = Per::of(mark.scene);
            let measured = figure(board, mark.scene, lines);
            let verdict = match (measured, mark.most[column]) {
                (Some(figure), Some(most)) if figure <= most => {
                    format!("{}, met", per.text(most))
                }
                (Some(_), Some(most)) => format!("{}, **missed**", per.text(most)),
                _ => String::new(),
            };
            let measured = measured.map_or(String::new(), |figure| per.text(figure));
            [measured, verdict, mark.peers[column].to_owned()]
        };
        for (part, title) in [board, "at most", "best other"].into_iter().enumerate() {
            figures.board(title);
            MARKS.iter().for_each(|mark| figures.put(mark.scene, cells(mark)[part].clone()));
        }
    }
    figures
}

/// What was executed of a scene on a board.
struct Profiled {
    board: &'static str,
    scene: &'static str,
    profile: Profile,
}

/// The scenes that have marks.
fn marked() -> impl Iterator<Item = &'static str> {
    MARKS.iter().map(|mark| mark.scene).filter(|scene| *scene != LIT_VERTEX)
}

/// Profiles of all marked scenes, and of those that the lit vertex is made of.
fn profiles(house: &House, boards: &[&'static Board]) -> Result<Vec<Profiled>, String> {
    let mut profiles = Vec::new();
    for board in boards.iter().filter(|board| MODELS.iter().any(|m| m.board == board.name)) {
        let profiler = Profiler::new(house, board)?;
        for scene in marked().chain(LIT_VERTEX_OF) {
            let profile = profiler.run(&[scene.to_owned()])?;
            profiles.push(Profiled { board: board.name, scene, profile });
        }
    }
    Ok(profiles)
}

/// Cycles by the models, of the scenes that have marks.
fn cycles(boards: &[&'static Board], lines: &[Line], profiles: &[Profiled]) -> Figures {
    let mut figures = table(marked());
    for board in boards {
        let Some(model) = MODELS.iter().find(|model| model.board == board.name) else { continue };
        figures.board(board.name);
        for scene in marked() {
            let of_scene = |p: &&Profiled| p.board == board.name && p.scene == scene;
            let line = of(board.name, lines).find(|line| line.scene() == scene);
            let (Some(line), Some(profiled)) = (line, profiles.iter().find(of_scene)) else {
                continue;
            };
            let classes = Classes::of(&profiled.profile);
            let per = Per::of(scene);
            let cycles = model.cycles(&classes);
            println!("board={} scene={scene} {classes} cycles={cycles:.0}", board.name);
            figures.put(scene, per.text(cycles / per.count(line) as f64));
        }
    }
    figures
}

/// What was executed where a mark is missed.
fn missed<'a>(lines: &'a [Line], profiles: &'a [Profiled]) -> Vec<loops::Missed<'a>> {
    let mut missed = Vec::new();
    for (column, board) in marks::BOARDS.into_iter().enumerate() {
        for mark in &MARKS {
            let (figure, most) = (figure(board, mark.scene, lines), mark.most[column]);
            let (Some(figure), Some(most)) = (figure, most) else { continue };
            // Of the lit vertex, both that it is made of.
            let scenes = match mark.scene {
                LIT_VERTEX => LIT_VERTEX_OF.to_vec(),
                scene => vec![scene],
            };
            for scene in scenes.into_iter().filter(|_| figure > most) {
                let of_scene = |p: &&Profiled| p.board == board && p.scene == scene;
                let line = of(board, lines).find(|line| line.scene() == scene);
                if let (Some(line), Some(Profiled { profile, .. })) =
                    (line, profiles.iter().find(of_scene))
                {
                    let per = Per::of(scene);
                    let units = profile.instructions as f64 / by(per, line.instructions(), line);
                    missed.push(loops::Missed {
                        board,
                        scene,
                        mark: mark.scene,
                        figure: per.text(figure),
                        most: per.text(most),
                        per,
                        units,
                        profile,
                    });
                }
            }
        }
    }
    missed
}

/// The models themselves.
fn models() -> Figures {
    let mut figures = Figures::default();
    for model in &MODELS {
        figures.board(model.board);
        model.cells().into_iter().for_each(|(what, cell)| figures.put(what, cell));
    }
    figures
}

/// The README's table: the scenes that have marks, and flash.
fn short(house: &House, boards: &[&'static Board], lines: &[Line]) -> Result<Figures, String> {
    let mut figures = Figures::default();
    for board in boards.iter().filter(|board| marks::BOARDS.contains(&board.name)) {
        figures.board(board.name);
        for line in of(board.name, lines).filter(|line| marks::is_in_short(line.scene())) {
            let per = Per::of(line.scene());
            let what = format!("{}, instructions a {per}", line.scene());
            figures.put(&what, per.text(by(per, line.instructions(), line)));
        }
        for (what, bytes) in sizes::figures(house, board)? {
            figures.put(&what, bytes.to_string());
        }
    }
    Ok(figures)
}

#[cfg(test)]
mod tests {
    use super::super::facts::Frame;
    use super::super::lines::Drawn;
    use super::*;

    fn line(board: &'static str, scene: &str, instructions: u64) -> Line {
        let drawn = Drawn { scene: scene.into(), frame: 0, instructions, hash: 7, bytes: 8 };
        let expected = Frame { hash: 7, bytes: 8, triangles: 10, pixels: 1000 };
        Line::compare(board, scene, &[drawn], &[expected])
    }

    #[test]
    fn a_figure_is_by_the_unit_of_its_scene() {
        let lines = [
            line("m0", "F1", 5000),
            line("m4", "F1", 1000),
            line("m4", "S1", 6000),
            line("m4", "vertex", 400),
            line("m4", "vertex-sun", 1500),
            line("m4", "vertex-unlit", 1100),
        ];
        for (board, scene, expected) in [
            ("m0", "F1", Some(5.0)),
            ("m4", "F1", Some(1.0)),
            ("m4", "S1", Some(600.0)),
            ("m4", LIT_VERTEX, Some(80.0)),
            ("m0", LIT_VERTEX, None),
            ("m4", "F2", None),
        ] {
            let figure = figure(board, scene, &lines);
            assert_eq!(
                figure.map(|figure| (figure * 100.0).round()),
                expected.map(|figure| figure * 100.0),
                "{board} {scene}"
            );
        }
    }

    #[test]
    fn marks_are_met_up_to_their_figure() {
        let lines = [line("m4", "F3", 20_000), line("m0", "F3", 28_010)];
        let text = against_marks(&lines).to_string();
        let row = text.lines().find(|line| line.starts_with("| F3 ")).unwrap_or_default();
        assert_eq!(
            row,
            "| F3 | pixel | 20.00 | 20.00, met | 27.5, TinyGL | 28.01 | 28.00, **missed** | 115, \
             small3dlib |"
        );
    }
}
