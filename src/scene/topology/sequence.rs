use super::saturated;

/// Consecutive in the order in which strips, fans, lines and points take them: [`Consecutive`] as the
/// mesh has them, [`Indices`], or [`RestartIndices`].
pub trait Sequence: Copy {
    /// What comes at a place; `None` behind the last.
    fn step(&self, at: u32) -> Option<Step>;

    /// How many places there are, as far as 32 bits count.
    fn places(&self) -> u32;

    /// Whether there may be a [`Step::Restart`].
    const RESTARTS: bool;
}

/// What a [`Sequence`] says at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// The next vertex.
    Vertex(u32),
    /// The strip, fan, loop or list ends, and another begins.
    Restart,
}

/// The vertices of the mesh, one after the other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Consecutive {
    vertices: u32,
}

impl Consecutive {
    /// So many vertices, from the first on.
    pub const fn new(vertices: usize) -> Self {
        Self { vertices: saturated(vertices) }
    }
}

impl Sequence for Consecutive {
    const RESTARTS: bool = false;

    #[inline(always)]
    fn step(&self, at: u32) -> Option<Step> {
        (at < self.vertices).then_some(Step::Vertex(at))
    }

    #[inline(always)]
    fn places(&self) -> u32 {
        self.vertices
    }
}

/// A type of indices: `u8`, `u16` or `u32`.
pub trait Index: Copy + PartialEq + Into<u32> {
    /// All ones.
    const RESTART: Self;
}

impl Index for u8 {
    const RESTART: Self = Self::MAX;
}

impl Index for u16 {
    const RESTART: Self = Self::MAX;
}

impl Index for u32 {
    const RESTART: Self = Self::MAX;
}

/// Consecutive by indices of 8, 16 or 32 bits, all of which are vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Indices<'a, I> {
    indices: &'a [I],
}

impl<'a, I> Indices<'a, I> {
    /// The vertices with these indices.
    pub const fn new(indices: &'a [I]) -> Self {
        Self { indices }
    }
}

impl<I: Index> Sequence for Indices<'_, I> {
    const RESTARTS: bool = false;

    #[inline(always)]
    fn step(&self, at: u32) -> Option<Step> {
        self.indices.get(at as usize).map(|index| Step::Vertex((*index).into()))
    }

    #[inline(always)]
    fn places(&self) -> u32 {
        saturated(self.indices.len())
    }
}

/// Consecutive by indices, where one of all ones (255, 65535 or 2^32 - 1) is no vertex but begins anew.
///
/// Source: primitive restart with a fixed index, OpenGL 4.6, section 10.3.6.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RestartIndices<'a, I> {
    indices: &'a [I],
}

impl<'a, I> RestartIndices<'a, I> {
    /// The vertices with these indices, and what is between them.
    pub const fn new(indices: &'a [I]) -> Self {
        Self { indices }
    }
}

impl<I: Index> Sequence for RestartIndices<'_, I> {
    const RESTARTS: bool = true;

    #[inline(always)]
    fn step(&self, at: u32) -> Option<Step> {
        let index = *self.indices.get(at as usize)?;
        Some(if index == I::RESTART { Step::Restart } else { Step::Vertex(index.into()) })
    }

    #[inline(always)]
    fn places(&self) -> u32 {
        saturated(self.indices.len())
    }
}

/// How far one is in a sequence, and in the primitives that it makes.
#[derive(Clone, Copy, Debug, Default)]
pub struct NumberCursor {
    at: u32,
    number: u32,
}

impl NumberCursor {
    /// What comes next.
    #[inline(always)]
    pub(super) fn step(&mut self, sequence: &impl Sequence) -> Option<Step> {
        let step = sequence.step(self.at)?;
        self.at = self.at.wrapping_add(1);
        Some(step)
    }

    /// The number of the next primitive.
    #[inline(always)]
    pub(super) fn number(&mut self) -> u32 {
        let number = self.number;
        self.number = number.wrapping_add(1);
        number
    }
}
