use super::{
    Consecutive, FanCursor, IndexedList, Indices, List, RestartIndices, StripCursor, Topology,
    TriangleFan, TriangleStrip,
};

macro_rules! any_topology {
    ($($(#[$doc:meta])* $name:ident($type:ty): $cursor:ident;)*) => {
        /// Any topology of triangles, chosen when the program runs: for host tools, and for scenes
        /// that are data.
        #[non_exhaustive]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum AnyTopology<'a> {
            $($(#[$doc])* $name($type),)*
        }

        impl Topology for AnyTopology<'_> {
            type Primitive = [u32; 3];
            type Cursor = AnyCursor;

            fn next<const LAST: bool>(&self, cursor: &mut AnyCursor) -> Option<(u32, [u32; 3])> {
                match self {
                    $(Self::$name(topology) => topology.next::<LAST>(&mut cursor.$cursor),)*
                }
            }

            fn count(&self) -> u32 {
                match self {
                    $(Self::$name(topology) => topology.count(),)*
                }
            }
        }
    };
}

/// How far one is in an [`AnyTopology`].
#[derive(Clone, Copy, Debug, Default)]
pub struct AnyCursor {
    list: u32,
    strip: StripCursor,
    fan: FanCursor,
}

any_topology! {
    /// As [`List`].
    List(List): list;
    /// As [`IndexedList`] of 8 bits.
    Indexed8(IndexedList<'a, u8>): list;
    /// As [`IndexedList`] of 16 bits.
    Indexed16(IndexedList<'a, u16>): list;
    /// As [`IndexedList`] of 32 bits.
    Indexed32(IndexedList<'a, u32>): list;
    /// As [`TriangleStrip`] of [`Consecutive`].
    Strip(TriangleStrip<Consecutive>): strip;
    /// As [`TriangleStrip`] of [`Indices`] of 8 bits.
    Strip8(TriangleStrip<Indices<'a, u8>>): strip;
    /// As [`TriangleStrip`] of [`Indices`] of 16 bits.
    Strip16(TriangleStrip<Indices<'a, u16>>): strip;
    /// As [`TriangleStrip`] of [`RestartIndices`] of 8 bits.
    RestartStrip8(TriangleStrip<RestartIndices<'a, u8>>): strip;
    /// As [`TriangleStrip`] of [`RestartIndices`] of 16 bits.
    RestartStrip16(TriangleStrip<RestartIndices<'a, u16>>): strip;
    /// As [`TriangleFan`] of [`Consecutive`].
    Fan(TriangleFan<Consecutive>): fan;
    /// As [`TriangleFan`] of [`Indices`] of 8 bits.
    Fan8(TriangleFan<Indices<'a, u8>>): fan;
    /// As [`TriangleFan`] of [`Indices`] of 16 bits.
    Fan16(TriangleFan<Indices<'a, u16>>): fan;
    /// As [`TriangleFan`] of [`RestartIndices`] of 8 bits.
    RestartFan8(TriangleFan<RestartIndices<'a, u8>>): fan;
    /// As [`TriangleFan`] of [`RestartIndices`] of 16 bits.
    RestartFan16(TriangleFan<RestartIndices<'a, u16>>): fan;
}
