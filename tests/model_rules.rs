//! Model files in: every rule on a few lines of text.
#![cfg(feature = "tools")]

use microraster::host::{Corner, Model, ModelError};
use std::fs;

mod sound;
use sound::assert_sound;

fn obj(text: &str) -> Result<Model, ModelError> {
    Model::read_obj(text.as_bytes(), "no-folder/a.obj")
}

fn asc(text: &str) -> Result<Model, ModelError> {
    Model::read_asc(text.as_bytes(), "a.asc")
}

#[track_caller]
fn loads(text: &str) -> Model {
    let model = obj(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert_sound(&model);
    model
}

#[track_caller]
fn fails(text: &str, message: &str) {
    match obj(text) {
        Ok(_) => panic!("loads, but should fail: {text}"),
        Err(error) => assert_eq!(error.to_string(), format!("no-folder/a.obj:{message}"), "{text}"),
    }
}

/// The normal of a corner, as Rust writes it.
fn normal(model: &Model, corner: Corner) -> String {
    format!("{:?}", model.normals[corner.normal as usize])
}

fn warnings(model: &Model) -> Vec<String> {
    model.warnings.iter().map(ToString::to_string).collect()
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn lines_may_continue_and_end_in_any_way() {
    let plain = loads(&format!("{TRIANGLE}f 1 2 3\n"));
    for text in [
        format!("\u{feff}{TRIANGLE}f 1 2 3"),
        format!("{TRIANGLE}f 1 2 3\n").replace('\n', "\r\n"),
        format!("{TRIANGLE}f 1 2 3\n").replace(' ', "\t  "),
        format!("  {TRIANGLE}f 1 \\\n2 \\  \r\n3"),
        format!("{TRIANGLE}f 1 2 3 # a comment\n"),
        format!("# nothing\n\n{TRIANGLE}s off\no x\ng y z\nf 1 2 3\n"),
        format!("{TRIANGLE}f -3 -2 -1\n"),
        format!("{TRIANGLE}f 1// 2// 3//\n"),
        "v -0 0 0 1\nv 1. +0 0 9 9 9\nv .0 1e0 -0 nan nan nan\nf 1 2 3".to_owned(),
    ] {
        assert_eq!(loads(&text), plain, "{text:?}");
    }
    let padded = loads(&format!("\0\0{TRIANGLE}f 1 2\0 3\0"));
    assert_eq!(padded.groups, plain.groups, "NUL bytes");
    assert_eq!(warnings(&padded), ["no-folder/a.obj:1: NUL bytes are left out"]);
}

#[test]
fn errors_name_the_line_and_what_to_do() {
    fails(
        "v 1 2",
        "1: a position needs 3 numbers and has 2; complete the line; the file may be cut off",
    );
    fails("v 1 \\\n x 3", "1: \"x\" is no number; write it like -1.5 or 2e-3");
    fails("\nvt", "2: a texture coordinate needs 1 numbers and has 0; complete the line; the file may be cut off");
    let missing = "correct the index, or move the face behind what it uses";
    fails(
        &format!("{TRIANGLE}f 1 2 4"),
        &format!("4: position 4 does not exist, 3 have been read so far; {missing}"),
    );
    fails(
        &format!("{TRIANGLE}f 1 2 -4"),
        &format!("4: position -4 does not exist, 3 have been read so far; {missing}"),
    );
    fails(
        &format!("{TRIANGLE}f 1 2 -9223372036854775808"),
        &format!(
            "4: position -9223372036854775808 does not exist, 3 have been read so far; {missing}"
        ),
    );
    fails(
        &format!("{TRIANGLE}f 1 2 99999999999999999999"),
        "4: \"99999999999999999999\" is no index of a position; write a whole number",
    );
    fails(
        &format!("{TRIANGLE}f 1 0 2"),
        "4: a position has the index 0; count from 1, or from -1 backwards",
    );
    fails(
        &format!("{TRIANGLE}f 1 2/1/1/1 3"),
        "4: \"2/1/1/1\" is no corner of a face; write v, v/vt, v//vn or v/vt/vn",
    );
    let nothing = "the file ends without a face that can be drawn; check that this is the file you meant, and that it holds faces (f)";
    fails("", &format!("1: {nothing}"));
    fails(&format!("{TRIANGLE}l 1 2 3"), &format!("4: {nothing}"));
    let wide = Model::read_obj(&b"\xff\xfev\0"[..], "a.obj").unwrap_err();
    assert_eq!(wide.to_string(), "a.obj:1: the text is UTF-16; save the file as UTF-8");
    let endless = Model::read_obj(std::io::BufReader::new(std::io::repeat(b'1')), "a.obj");
    assert_eq!(endless.unwrap_err().line, Some(1), "a line without end");
    let zeros = Model::read_obj(std::io::BufReader::new(std::io::repeat(0)), "a.obj");
    assert_eq!(zeros.unwrap_err().line, Some(1), "a line without end");
}

#[test]
fn what_is_not_drawn_is_left_out_with_a_warning() {
    let model = loads(&format!(
        "{TRIANGLE}f 1\nf 1 2\nl 1 2\np 1\nl 2 3\ncall x\nusemtl steel\nf 1/7/0 2//9 3"
    ));
    assert_eq!(model.triangle_count(), 1, "one face of three corners");
    assert_eq!(
        warnings(&model),
        [
            "no-folder/a.obj:4: a face of 1 corners is left out",
            "no-folder/a.obj:5: a face of 2 corners is left out",
            "no-folder/a.obj:6: lines and points are left out",
            "no-folder/a.obj:7: lines and points are left out",
            "no-folder/a.obj:9: the keyword \"call\" is not used",
            "no-folder/a.obj:11: texture coordinate 7 does not exist, 0 have been read so far; it is left out",
            "no-folder/a.obj:11: a normal has the index 0; it is left out",
            "no-folder/a.obj: no library describes \"steel\"; it is grey",
        ]
    );
    let many = loads(&format!("{TRIANGLE}f 1 2 3\n{}", "f 1\n".repeat(1000)));
    assert_eq!(many.warnings.len(), 65, "warnings are bounded");
    assert_eq!(many.warnings[64].to_string(), "no-folder/a.obj: 936 more warnings");
}

#[test]
fn faces_with_infinite_positions_are_left_out() {
    for bad in ["nan", "-inf", "1e39", "1.#IND", "-1.#INF"] {
        let model = loads(&format!("{TRIANGLE}v 0 {bad} 0\nf 1 2 4\nf 1 2 3\nf 4 3 2 1"));
        assert_eq!((model.triangle_count(), model.positions.len()), (1, 3), "{bad}");
        assert_eq!(
            warnings(&model),
            ["no-folder/a.obj:4: a position is infinite or no number; its faces are left out"]
        );
    }
}

#[test]
fn missing_and_broken_normals_are_made() {
    // A square pyramid's apex: four equal faces, so straight up.
    let model = loads(
        "v 1 1 0\nv -1 1 0\nv -1 -1 0\nv 1 -1 0\nv 0 0 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5",
    );
    let apex = model.groups[0].triangles[0][2];
    assert_eq!(normal(&model, apex), "[0.0, 0.0, 1.0]", "the apex");
    assert_eq!(model.normals.len(), 5, "one for each vertex");

    // The larger face weighs more: sides of 1 and 3 make slopes of 1 : 3.
    let model = loads("v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 3\nf 1 3 2\nf 1 2 4");
    let shared = model.groups[0].triangles[0][0];
    let [x, y, z] = model.normals[shared.normal as usize];
    assert!((x.abs() - 3.0 * z.abs()).abs() < 1e-6 && y.abs() < 1e-6, "{x} {y} {z}");

    // Coincident positions are one vertex: the seam is smooth.
    let seam = loads("v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 3\nv 0 0 0\nv 0 1 0\nf 1 3 2\nf 5 6 4");
    assert_eq!(seam.positions, model.positions, "welded");
    assert_eq!(seam.normals, model.normals, "welded");

    // A normal without direction is replaced, one of another length brought to 1.
    for bad in ["0 0 0", "nan 0 1", "0 inf 0"] {
        let model = loads(&format!("{TRIANGLE}vn {bad}\nvn 9 0 0\nf 1//1 2//2 3//2"));
        let [a, b, _] = model.groups[0].triangles[0];
        assert_eq!(normal(&model, a), "[0.0, 0.0, 1.0]", "{bad}");
        assert_eq!(normal(&model, b), "[1.0, 0.0, 0.0]", "{bad}");
    }
    // Normals and texture coordinates never leak from one corner to the next.
    let mixed = loads(&format!("{TRIANGLE}vn 1 0 0\nvt .5 .5\nf 1/1/1 2 3"));
    let [a, b, _] = mixed.groups[0].triangles[0];
    assert_eq!((a.texture, b.texture), (Some(0), None), "only the first has one");
    assert_ne!(a.normal, b.normal, "only the first has one");
    // No area at all, and nothing but opposite faces: still a normal.
    loads("v 5 5 5\nv 5 5 5\nv 5 5 5\nf 1 2 3");
    let flat = loads(&format!("{TRIANGLE}f 1 2 3\nf 3 2 1"));
    let [front, back] = [0, 1].map(|i| flat.groups[0].triangles[i]);
    assert_eq!(normal(&flat, front[0]), "[0.0, 0.0, 1.0]", "its own");
    assert_eq!(normal(&flat, back[0]), "[0.0, 0.0, -1.0]", "its own");
    assert_eq!(flat.face_normal(&back), Some([0.0, 0.0, -1.0]), "clockwise");
}

#[test]
fn huge_and_tiny_models_keep_their_normals() {
    for scale in ["1e38", "1e-30", "1e-44"] {
        let model = loads(&format!("v 0 0 0\nv {scale} 0 0\nv 0 {scale} 0\nf 1 2 3"));
        assert_eq!(model.normals, [[0.0, 0.0, 1.0]], "{scale}");
        assert!(model.bounds().largest_side() > 0.0, "{scale}");
    }
}

#[test]
fn a_concave_face_stays_inside_its_outline() {
    // An arrow head whose fan from the first corner would leave it.
    let model = loads("v 2 0 0\nv 0 2 0\nv 1 0 0\nv 0 -2 0\nf 4 1 2 3");
    let area: f32 = model.groups[0]
        .triangles
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|corner| model.positions[corner.position as usize]);
            let turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            assert!(turn > 0.0, "no triangle is turned over");
            turn / 2.0
        })
        .sum();
    assert_eq!(area.to_bits(), 2.0_f32.to_bits(), "the area of the arrow head");
}

#[test]
fn the_soup_reads_and_complains_by_line() {
    let model =
        asc("# two\ntriangle\n0 0 0 0 0 2 0 0\n1 0 0 0 0 0 1 0\n0 1 0 0 0 1 0 1 triangle\n\
         1 0 0 0 0 1 1 0 1 1 0 0 0 1 1 1 0 1 0 0 0 1 0 1")
        .unwrap();
    assert_sound(&model);
    assert_eq!(model.triangle_count(), 2, "two triangles");
    assert_eq!((model.positions.len(), model.normals.len()), (4, 1), "shared corners are one");
    for (text, message) in [
        ("", "1: the file ends without a triangle; check that this is the file you meant"),
        ("\nquad", "2: \"quad\" stands where `triangle` should; begin each triangle with that word; 24 numbers follow it"),
        ("triangle\n1 2", "2: the file ends after 2 of the 24 numbers of a triangle; complete the triangle or remove it"),
        ("triangle\n1 2 3 4 5 6 7 8\n1 nan", "3: y of corner 2 is \"nan\", no finite number; write 8 numbers for each corner: x y z nx ny nz u v"),
    ] {
        assert_eq!(asc(text).unwrap_err().to_string(), format!("a.asc:{message}"), "{text}");
    }
}

#[test]
fn materials_come_from_the_folder_and_from_nowhere_else() {
    let root = std::env::temp_dir().join(format!("microraster-mtl-{}", std::process::id()));
    let folder = root.join("model");
    fs::create_dir_all(folder.join("sub")).unwrap();
    fs::write(root.join("secret.mtl"), "newmtl red\nKd 0 1 0").unwrap();
    fs::write(folder.join("sub/my texture.png"), "").unwrap();
    fs::write(
        folder.join("my colours.mtl"),
        "newmtl red\nKd 1 0 0\nKd 1 2\nmap_Kd -s 1 1 1 ..\\secret.mtl\nmap_Kd sub\\my texture.png\nnewmtl\n\
         newmtl grey # 5\nKd 0.5\nnewmtl hot\nKd 9 -1 .2 # clamped\nKd red",
    )
    .unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("../secret.mtl", folder.join("link.mtl")).unwrap();

    let body = format!("{TRIANGLE}usemtl red\nf 1 2 3\nusemtl grey # 5\nf 1 2 3\nusemtl hot\nf 1 2 3\nusemtl red\nf 3 2 1\n");
    let load = |libraries: &str| {
        let path = folder.join("a.obj");
        fs::write(&path, format!("{libraries}\n{body}")).unwrap();
        Model::load(&path).unwrap()
    };
    let model = load("mtllib my colours.mtl");
    let seen: Vec<_> = model
        .groups
        .iter()
        .map(|g| (g.material.name.as_str(), g.material.diffuse_rgb8(), g.triangles.len()))
        .collect();
    assert_eq!(
        seen,
        [("red", [255, 0, 0], 2), ("grey # 5", [128; 3], 1), ("hot", [255, 0, 51], 1)]
    );
    let texture = model.groups[0].material.texture.as_ref().unwrap();
    assert!(texture.ends_with("model/sub/my texture.png"), "{texture:?}");
    assert_eq!(model.warnings.len(), 4, "{:#?}", warnings(&model));

    for library in [
        "../secret.mtl",
        "sub/../../secret.mtl",
        "/dev/zero",
        "link.mtl",
        "sub",
        ".",
        "",
        "none.mtl",
    ] {
        let model = load(&format!("mtllib {library}"));
        assert_eq!(model.groups[0].material.diffuse_rgb8(), [204; 3], "{library}");
        let first = model.warnings[0].to_string();
        assert!(first.contains("a.obj:1: "), "{library}: {first}");
    }
    assert!(Model::load(&folder).unwrap_err().reason.contains("no regular file"), "a folder");
    fs::remove_dir_all(&root).unwrap();
}
