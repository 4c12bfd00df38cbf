//! The 16 bytes before the end of a word go in, its digits come out, zeros before them and no point
//! between them: by one instruction where there is one for it, else by two masks.

use wide::bytemuck::cast;
use wide::u8x16;

/// Bytes that are put in order.
const LENGTH: usize = 16;

#[cfg(target_feature = "simd128")]
pub use shuffled::Order;

#[cfg(not(target_feature = "simd128"))]
pub use masked::Order;

#[cfg(target_feature = "simd128")]
mod shuffled {
    use super::{LENGTH, cast, u8x16};

    /// Where each digit is from.
    #[derive(Clone, Copy)]
    pub struct Order([u8; LENGTH]);

    impl Order {
        /// For a word of so many bytes with its point at a place; at its end where there is none.
        pub const fn of(length: usize, point: usize) -> Self {
            let mut from = [LENGTH as u8; LENGTH];
            let mut place = 0;
            while place < length {
                let moved = (point < length && place < point) as usize;
                if place != point {
                    from[LENGTH - length + place + moved] = (LENGTH - length + place) as u8;
                }
                place += 1;
            }
            Self(from)
        }

        /// The digits, each as its value.
        #[inline]
        pub fn of_digits(self, bytes: [u8; LENGTH]) -> u8x16 {
            let digits = cast::<_, u8x16>(bytes) - u8x16::splat(b'0');
            digits.shuffle_zeroing(cast(self.0))
        }
    }
}

#[cfg(not(target_feature = "simd128"))]
mod masked {
    use super::{LENGTH, cast, u8x16};

    /// The digits that stay and those that move over the point, once moved.
    #[derive(Clone, Copy)]
    pub struct Order {
        staying: u128,
        moved: u128,
    }

    impl Order {
        /// For a word of so many bytes with its point at a place; at its end where there is none.
        pub const fn of(length: usize, point: usize) -> Self {
            if point >= length {
                return Self {
                    staying: last(length),
                    moved: 0,
                };
            }
            let staying = last(length - point - 1);
            Self {
                staying,
                moved: last(length - 1) & !staying,
            }
        }

        /// The digits, each as its value.
        #[inline]
        pub fn of_digits(self, bytes: [u8; LENGTH]) -> u8x16 {
            const ZEROS: u128 = u128::from_le_bytes([b'0'; LENGTH]);
            let digits = u128::from_le_bytes(bytes) ^ ZEROS;
            cast(((digits & self.staying) | (digits << 8 & self.moved)).to_le_bytes())
        }
    }

    /// The last bytes.
    const fn last(count: usize) -> u128 {
        match count {
            0 => 0,
            _ => u128::MAX << (8 * (LENGTH - count)),
        }
    }
}
