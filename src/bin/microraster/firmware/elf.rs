//! Reads what is needed of an ELF file of 32 bits, little-endian: sections and symbols.

/// A section that the board holds in memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Section {
    /// Its name.
    pub(crate) name: String,
    /// Bytes that it takes.
    pub(crate) size: u32,
    /// Whether it has contents in flash; else it is cleared or left alone at the start.
    pub(crate) stored: bool,
    /// Whether it is written at run time, and so takes RAM.
    pub(crate) writable: bool,
}

/// A symbol that takes flash.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Symbol {
    /// Its name, as the linker sees it.
    pub(crate) name: String,
    /// The section that it lies in.
    pub(crate) section: String,
    /// Bytes that it takes.
    pub(crate) size: u32,
}

/// What an ELF file says of a board's memory.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Elf {
    /// Sections with contents at run time, in the file's order.
    pub(crate) sections: Vec<Section>,
    /// Symbols with a size in sections that are stored, each address once.
    pub(crate) symbols: Vec<Symbol>,
    /// Names of all symbols.
    pub(crate) names: Vec<String>,
}

/// Parts of the names of what only a heap needs.
pub(crate) const ALLOCATORS: [&str; 2] = ["__rust_alloc", "__rdl_alloc"];

// Numbers of the ELF specification.
const SYMBOL_TABLE: u32 = 2;
const NO_BITS: u32 = 8;
/// With addends, and without.
const RELOCATIONS: [u32; 2] = [4, 9];
const WRITE: u32 = 1;
const ALLOCATE: u32 = 2;
const SECTION_HEADER: usize = 40;
const SYMBOL_ENTRY: usize = 16;

/// A section's header.
#[derive(Clone, Copy)]
struct Header {
    name: usize,
    kind: u32,
    flags: u32,
    offset: usize,
    size: u32,
    link: usize,
    info: usize,
    entry: usize,
}

impl Elf {
    /// Reads a file's bytes.
    ///
    /// # Errors
    /// Not such a file, or one that ends before what its tables name.
    pub(crate) fn read(file: &[u8]) -> Result<Self, String> {
        if file.get(..6) != Some(&[0x7f, b'E', b'L', b'F', 1, 1]) {
            return Err("not a little-endian ELF file of 32 bits".into());
        }
        Self::tables(file).ok_or_else(|| "the ELF file ends before what its tables name".into())
    }

    /// The section headers; `None` where the file is cut off.
    fn headers(file: &[u8]) -> Option<Vec<Header>> {
        let start = place(file, 32)?;
        let count = usize::from(half(file, 48)?);
        (0..count).map(|index| header(file, start.checked_add(index * SECTION_HEADER)?)).collect()
    }

    /// The tables; `None` where the file is cut off.
    fn tables(file: &[u8]) -> Option<Self> {
        let headers = Self::headers(file)?;
        let names = headers.get(usize::from(half(file, 50)?))?.offset;

        let mut elf = Self::default();
        for header in headers.iter().filter(|header| header.flags & ALLOCATE != 0) {
            elf.sections.push(Section {
                name: text(file, names, header.name)?,
                size: header.size,
                stored: header.kind != NO_BITS,
                writable: header.flags & WRITE != 0,
            });
        }
        let Some(table) = headers.iter().find(|header| header.kind == SYMBOL_TABLE) else {
            return Some(elf);
        };
        let strings = headers.get(table.link)?.offset;
        // Several names may stand for one place; it takes flash only once.
        let mut seen = std::collections::HashSet::new();
        for index in 0..usize::try_from(table.size).ok()? / SYMBOL_ENTRY {
            let at = table.offset.checked_add(index * SYMBOL_ENTRY)?;
            let name = text(file, strings, place(file, at)?)?;
            let (value, size) = (word(file, at + 4)?, word(file, at + 8)?);
            let home = headers.get(usize::from(half(file, at + 14)?));
            let home = home.filter(|home| home.flags & ALLOCATE != 0 && home.kind != NO_BITS);
            if let (Some(home), true) = (home, size > 0) {
                if seen.insert(value) {
                    elf.symbols.push(Symbol {
                        name: name.clone(),
                        section: text(file, names, home.name)?,
                        size,
                    });
                }
            }
            elf.names.push(name);
        }
        Some(elf)
    }

    /// Bytes of flash: all that is stored.
    pub(crate) fn flash(&self) -> u32 {
        self.sections.iter().filter(|section| section.stored).map(|section| section.size).sum()
    }

    /// Bytes of RAM: all that is written at run time. Sections that only set room aside for the
    /// stack or a heap are no use of it.
    pub(crate) fn ram(&self) -> u32 {
        let room = |section: &&Section| [".stack", ".heap"].contains(&section.name.as_str());
        let used = self.sections.iter().filter(|section| section.writable || !section.stored);
        used.filter(|section| !room(section)).map(|section| section.size).sum()
    }

    /// A symbol that only a heap needs, if one is linked.
    pub(crate) fn allocator(&self) -> Option<&str> {
        let heap = |name: &&String| ALLOCATORS.iter().any(|part| name.contains(part));
        self.names.iter().find(heap).map(String::as_str)
    }
}

/// That one function or table refers to a symbol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Reference {
    /// Where it does.
    pub(crate) address: u32,
    /// Who does; empty where no symbol covers the address.
    pub(crate) from: String,
    /// To whom.
    pub(crate) to: String,
}

/// All references between symbols, of a file that was linked with `--emit-relocs`.
///
/// # Errors
/// Not such a file, or one that ends before what its tables name.
pub(crate) fn references(file: &[u8]) -> Result<Vec<Reference>, String> {
    let cut_off = "the ELF file ends before what its tables name";
    let headers = Elf::headers(file).ok_or(cut_off)?;
    if !headers.iter().any(|header| RELOCATIONS.contains(&header.kind)) {
        return Err("the ELF file was linked without `--emit-relocs`".into());
    }
    references_of(file, &headers).ok_or_else(|| cut_off.into())
}

/// The references; `None` where the file is cut off.
fn references_of(file: &[u8], headers: &[Header]) -> Option<Vec<Reference>> {
    let table = headers.iter().find(|header| header.kind == SYMBOL_TABLE)?;
    let strings = headers.get(table.link)?.offset;
    let symbol = |index: usize| {
        let at = table.offset.checked_add(index.checked_mul(SYMBOL_ENTRY)?)?;
        // Functions of Thumb code have an odd address.
        let start = word(file, at + 4)? & !1;
        Some((start, word(file, at + 8)?, text(file, strings, place(file, at)?)?))
    };
    let count = usize::try_from(table.size).ok()? / SYMBOL_ENTRY;
    let mut homes = (0..count).map(symbol).collect::<Option<Vec<_>>>()?;
    homes.retain(|(_, size, _)| *size > 0);
    homes.sort();
    let mut references = Vec::new();
    for header in headers {
        // Those of debug information refer to everything.
        let from = headers.get(header.info);
        let loaded = from.is_some_and(|section| section.flags & ALLOCATE != 0);
        if !loaded || !RELOCATIONS.contains(&header.kind) || header.entry == 0 {
            continue;
        }
        for index in 0..usize::try_from(header.size).ok()? / header.entry {
            let at = header.offset.checked_add(index * header.entry)?;
            let (address, info) = (word(file, at)?, place(file, at + 4)?);
            let before = homes.partition_point(|(start, _, _)| *start <= address);
            let home = before.checked_sub(1).and_then(|last| homes.get(last));
            let home = home.filter(|(start, size, _)| address - start < *size);
            let from = home.map_or_else(String::new, |(_, _, name)| name.clone());
            references.push(Reference { address, from, to: symbol(info >> 8)?.2 });
        }
    }
    Some(references)
}

/// The section header at a place.
fn header(file: &[u8], at: usize) -> Option<Header> {
    Some(Header {
        name: place(file, at)?,
        kind: word(file, at + 4)?,
        flags: word(file, at + 8)?,
        offset: place(file, at + 16)?,
        size: word(file, at + 20)?,
        link: place(file, at + 24)?,
        info: place(file, at + 28)?,
        entry: place(file, at + 36)?,
    })
}

/// Two bytes.
fn half(file: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_le_bytes(*file.get(at..)?.first_chunk()?))
}

/// Four bytes.
fn word(file: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(*file.get(at..)?.first_chunk()?))
}

/// Four bytes that say where something is.
fn place(file: &[u8], at: usize) -> Option<usize> {
    usize::try_from(word(file, at)?).ok()
}

/// The zero-terminated text at an offset of a string table.
fn text(file: &[u8], table: usize, offset: usize) -> Option<String> {
    let bytes = file.get(table.checked_add(offset)?..)?;
    let end = bytes.iter().position(|&byte| byte == 0)?;
    Some(String::from_utf8_lossy(bytes.get(..end)?).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of six sections (none, names, text, bss, symbols, their names) and two symbols,
    /// both at the same address.
    fn file() -> Vec<u8> {
        let names = b"\0.text\0.bss\0.tab\0";
        let strings = b"\0draw\0alias\0";
        let mut symbols = vec![0; SYMBOL_ENTRY];
        for name in [1u32, 6] {
            for word in [name, 0x101, 24] {
                symbols.extend(word.to_le_bytes());
            }
            symbols.extend([2, 0, 2, 0]);
        }
        let mut file = vec![0x7f, b'E', b'L', b'F', 1, 1];
        file.resize(52, 0);
        let mut offset = |bytes: &[u8]| {
            let at = u32::try_from(file.len()).expect("a small file");
            file.extend(bytes);
            at
        };
        let (at_names, at_strings) = (offset(names), offset(strings));
        let (at_text, at_symbols) = (offset(&[0; 100]), offset(&symbols));
        let start = offset(&[]);
        // name, kind, flags, address, offset, size, link
        for header in [
            [0; 7],
            [12, 3, 0, 0, at_names, 17, 0],
            [1, 1, ALLOCATE | 4, 0x100, at_text, 100, 0],
            [7, NO_BITS, ALLOCATE | WRITE, 0x2000, 0, 4000, 0],
            [12, SYMBOL_TABLE, 0, 0, at_symbols, 48, 5],
            [12, 3, 0, 0, at_strings, 12, 0],
        ] {
            file.extend(header.iter().flat_map(|word| word.to_le_bytes()));
            file.extend([0; SECTION_HEADER - 28]);
        }
        file[32..36].copy_from_slice(&start.to_le_bytes());
        file[48] = 6;
        file[50] = 1;
        file
    }

    #[test]
    fn flash_and_ram_are_told_apart() {
        let elf = Elf::read(&file()).expect("the file is whole");
        assert_eq!((elf.flash(), elf.ram()), (100, 4000));
        assert_eq!(elf.sections[0].name, ".text");
    }

    #[test]
    fn two_names_of_one_place_weigh_once() {
        let elf = Elf::read(&file()).expect("the file is whole");
        let draw = Symbol { name: "draw".into(), section: ".text".into(), size: 24 };
        assert_eq!(elf.symbols, [draw]);
        assert_eq!(elf.names, ["", "draw", "alias"]);
        assert_eq!(elf.allocator(), None);
    }

    #[test]
    fn a_file_cut_anywhere_is_an_error_and_never_a_panic() {
        let whole = file();
        for length in 0..whole.len() - (SECTION_HEADER - 28) {
            assert!(Elf::read(&whole[..length]).is_err(), "{length} bytes were accepted");
        }
    }
}
