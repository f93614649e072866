use super::{
    Alpha8, AnyFilter, AnyWrap, Footprint, Indexed4, Indexed8, Luminance8, Rgba4444, Rgba5551,
    Sample, Sampler, Texture, TextureError,
};
use crate::color::{Color, Rgb565, Rgba8888};

macro_rules! formats {
    ($($(#[$doc:meta])* $name:ident($format:ty);)*) => {
        /// A texture of any format, chosen when the program runs: for host tools.
        #[non_exhaustive]
        #[derive(Clone, Copy, Debug)]
        pub enum AnyTexture<'a> {
            $(
                $(#[$doc])*
                $name(Texture<'a, $format>),
            )*
        }

        /// A sampler whose format, filter and wraps are chosen when the program runs: for host
        /// tools, which would otherwise instantiate every combination.
        #[non_exhaustive]
        #[derive(Clone, Copy, Debug)]
        pub enum AnySampler<'a> {
            $(
                $(#[$doc])*
                $name(Sampler<'a, $format, AnyFilter, AnyWrap>),
            )*
        }

        impl<'a> AnySampler<'a> {
            /// Reads `texture` by `filter`, beyond its sides by `across` along u and by `down`
            /// along v.
            ///
            /// # Errors
            /// As [`Sampler::new`].
            pub const fn new(
                texture: AnyTexture<'a>,
                filter: AnyFilter,
                across: AnyWrap,
                down: AnyWrap,
            ) -> Result<Self, TextureError> {
                match texture {
                    $(AnyTexture::$name(texture) => {
                        match Sampler::new(texture, filter, across, down) {
                            Ok(sampler) => Ok(Self::$name(sampler)),
                            Err(error) => Err(error),
                        }
                    })*
                }
            }

            /// One repeat is 2^`bits` units, as [`Sampler::unit_bits`].
            #[must_use]
            pub const fn unit_bits(self, bits: u32) -> Self {
                match self {
                    $(Self::$name(sampler) => Self::$name(sampler.unit_bits(bits)),)*
                }
            }
        }

        impl Sample for AnySampler<'_> {
            type Level = Self;

            fn level(&self, _footprint: impl FnOnce() -> Footprint) -> Self {
                *self
            }

            fn fetch(&self, u: i32, v: i32) -> Option<Color> {
                match self {
                    $(Self::$name(sampler) => sampler.fetch(u, v),)*
                }
            }
        }
    };
}

formats! {
    /// [`Rgb565`].
    Rgb565(Rgb565);
    /// [`Rgba8888`].
    Rgba8888(Rgba8888);
    /// [`Rgba5551`].
    Rgba5551(Rgba5551);
    /// [`Rgba4444`].
    Rgba4444(Rgba4444);
    /// [`Luminance8`].
    Luminance8(Luminance8);
    /// [`Alpha8`].
    Alpha8(Alpha8);
    /// [`Indexed8`] with entries of RGB565.
    Indexed8(Indexed8<Rgb565>);
    /// [`Indexed8`] with entries of RGBA8888.
    Indexed8Rgba8888(Indexed8<Rgba8888>);
    /// [`Indexed8`] with colours.
    Indexed8Color(Indexed8<Color>);
    /// [`Indexed4`] with entries of RGB565.
    Indexed4(Indexed4<Rgb565>);
    /// [`Indexed4`] with entries of RGBA8888.
    Indexed4Rgba8888(Indexed4<Rgba8888>);
    /// [`Indexed4`] with colours.
    Indexed4Color(Indexed4<Color>);
}
