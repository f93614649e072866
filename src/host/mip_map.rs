use std::vec::Vec;

use crate::texture::{MipMap, Reduce, Texture, TextureError};

/// A picture followed by its smaller copies, as [`MipMap`] reads them.
///
/// ```
/// use microraster::texture::{Luminance8, TextureError};
///
/// # fn main() -> Result<(), TextureError> {
/// let words = microraster::host::mip_map::<Luminance8>(&[10, 20, 30, 40], 2, 2)?;
/// assert_eq!(words, [10, 20, 30, 40, 25]);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`TextureError`], if `words` are not one picture of that size with sides of powers of two.
pub fn mip_map<T: Reduce>(
    words: &[T::Word],
    width: u16,
    height: u16,
) -> Result<Vec<T::Word>, TextureError>
where
    T::Word: Default,
{
    let base = Texture::<T>::new(words, width, height)?;
    let texels = usize::from(base.width()) * usize::from(base.height());
    let mut all: Vec<T::Word> = words.iter().take(texels).copied().collect();
    all.resize(MipMap::<T>::words_needed(width, height), T::Word::default());
    T::reduce(&mut all, width, height)?;
    Ok(all)
}
