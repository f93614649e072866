//! Model files in: every file of the shared collection, and noise.
#![cfg(feature = "tools")]

use microraster::host::Model;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

mod sound;
use sound::assert_sound;

#[test]
fn noise_ends_in_a_value_or_an_error() {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut random = move |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 33) as usize % below
    };
    const WORDS: [&str; 32] = [
        "v ",
        "v 1 2 3\n",
        "vt ",
        "vt 0 1\n",
        "vn 0 0 1\n",
        "f ",
        "f 1 2 3\n",
        "f -1 -2 -3 -4\n",
        "/",
        "//",
        "\\\n",
        "\n",
        " ",
        "-",
        "0",
        "1",
        "2",
        "9",
        "1e38",
        "nan",
        "usemtl a\n",
        "mtllib x\n",
        "o\n",
        "#",
        "\0",
        "\u{feff}",
        "é",
        "triangle ",
        "-1",
        ".",
        "f 1/1/1 2/2/2 1//1 2\n",
        "v 0 9 -4\n",
    ];
    for _ in 0..3000 {
        let words: String = (0..random(60)).map(|_| WORDS[random(WORDS.len())]).collect();
        let read = [
            Model::read_obj(words.as_bytes(), "no-folder/a.obj"),
            Model::read_asc(words.as_bytes(), "a.asc"),
        ];
        read.into_iter().flatten().for_each(|model| assert_sound(&model));
        let bytes: Vec<u8> = (0..random(200)).map(|_| random(256).to_le_bytes()[0]).collect();
        let _ = Model::read_obj(&bytes[..], "a.obj");
        let _ = Model::read_asc(&bytes[..], "a.asc");
    }
}

/// The collection: the folder named by `MICRORASTER_MODELS`, or the one beside the crate.
fn collection() -> Option<PathBuf> {
    let folder = std::env::var_os("MICRORASTER_MODELS").map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/models"),
        PathBuf::from,
    );
    if folder.is_dir() {
        return Some(folder);
    }
    let message = format!("SKIPPED: no model collection at {}", folder.display());
    assert!(std::env::var_os("MICRORASTER_REQUIRE_SHARED").is_none(), "{message}");
    eprintln!("{message}");
    None
}

fn obj_files(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            obj_files(&path, into);
        } else if path.extension().is_some_and(|extension| extension == "obj") {
            into.push(path);
        }
    }
}

/// Triangle counts by path, counted by another program that drops nothing.
fn oracle(folder: &Path) -> HashMap<PathBuf, usize> {
    let text = fs::read_to_string(folder.join("ORACLE.tsv")).unwrap();
    text.lines()
        .skip(1)
        .filter_map(|line| {
            let columns: Vec<&str> = line.split('\t').collect();
            Some((folder.join(columns[0]), columns[3].parse().ok()?))
        })
        .collect()
}

/// The tricky files that end in an error, and in which line.
const REFUSED: [(&str, usize); 15] = [
    ("index_out_of_range.obj", 4),
    ("index_zero.obj", 4),
    ("only_comments.obj", 4),
    ("only_vertices.obj", 8),
    ("random_bytes.obj", 15),
    ("truncated_number.obj", 7),
    ("box_UTF16BE.obj", 1),
    ("empty.obj", 1),
    ("malformed.obj", 23),
    ("number_formats.obj", 11),
    ("invalid-face-definition.obj", 18),
    ("invalid-relative-texture-index.obj", 2),
    ("issue-140-zero-face-idx.obj", 16),
    ("line-prim.obj", 16),
    ("issue-356-leading-spaces-newmtl.obj", 2),
];

/// Tricky files that load with fewer triangles than a reader that drops nothing would make.
const FEWER: [&str; 2] = ["nan_inf.obj", "test-nan.obj"];

#[test]
fn every_file_of_the_collection_ends_in_a_model_or_a_line() {
    let Some(folder) = collection() else { return };
    let oracle = oracle(&folder);
    let mut files = Vec::new();
    obj_files(&folder.join("obj"), &mut files);
    let ordinary = files.len();
    obj_files(&folder.join("obj-tricky"), &mut files);
    assert!(ordinary >= 14 && files.len() >= 70, "{} files", files.len());

    for (index, path) in files.iter().enumerate() {
        let name = path.file_name().unwrap().to_str().unwrap();
        let start = Instant::now();
        let result = Model::load(path);
        assert!(start.elapsed() < Duration::from_secs(10), "{name}: too slow");
        let refused = REFUSED.iter().find(|(refused, _)| *refused == name);
        match (result, refused) {
            (Ok(model), None) => {
                assert_sound(&model);
                let triangles = oracle[path];
                if FEWER.contains(&name) {
                    assert!(model.triangle_count() < triangles, "{name}");
                } else {
                    assert_eq!(model.triangle_count(), triangles, "{name}: triangles");
                }
                if index < ordinary {
                    assert_eq!(model.positions.len(), distinct_used(path), "{name}: positions");
                }
            }
            (Err(error), Some(&(_, line))) => {
                assert_eq!(
                    (error.path.as_path(), error.line),
                    (path.as_path(), Some(line)),
                    "{error}"
                );
            }
            (Err(error), None) => panic!("{error}"),
            (Ok(_), Some(_)) => panic!("{name} loads"),
        }
    }
}

/// How many distinct positions the faces of a well-formed file use: counted in the plainest way.
fn distinct_used(path: &Path) -> usize {
    let text = fs::read_to_string(path).unwrap();
    let mut positions: Vec<Vec<u32>> = Vec::new();
    let mut used = std::collections::HashSet::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => positions
                .push(words.take(3).map(|w| (w.parse::<f32>().unwrap() + 0.0).to_bits()).collect()),
            Some("f") => used.extend(words.map(|word| {
                let index: isize = word.split('/').next().unwrap().parse().unwrap();
                let at = match usize::try_from(index) {
                    Ok(index) => index - 1,
                    Err(_) => positions.len() - index.unsigned_abs(),
                };
                positions[at].clone()
            })),
            _ => {}
        }
    }
    used.len()
}
