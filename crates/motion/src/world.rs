//! The world around the body: the up axis, the ground and the unit of length, from the motion.

use nalgebra::Vector3;

use crate::body::Footing;
use crate::skeleton::Axis;

/// The smallest share of the mean trunk along one axis that makes it the up axis.
const UPRIGHT: f64 = 0.7;

/// The share of the frames whose lowest foot lies below the ground.
const BELOW_GROUND: f64 = 0.05;

/// The body height to which the unit is fitted, in metres.
const USUAL_HEIGHT_M: f64 = 1.5;

/// How far the height may be from it.
const HEIGHT_FACTOR: f64 = 1.5;

/// A signed axis of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Up {
    /// The axis.
    pub axis: Axis,
    /// Whether up is towards smaller values.
    pub is_negative: bool,
}

impl Up {
    /// +Y, as in nine files of ten.
    pub const PLUS_Y: Up = Up {
        axis: Axis::Y,
        is_negative: false,
    };

    /// 1 or −1.
    pub fn sign(self) -> f64 {
        if self.is_negative { -1.0 } else { 1.0 }
    }

    /// Every up axis.
    pub const ALL: [Up; 6] = [
        Up {
            axis: Axis::X,
            is_negative: false,
        },
        Up {
            axis: Axis::X,
            is_negative: true,
        },
        Up {
            axis: Axis::Y,
            is_negative: false,
        },
        Up {
            axis: Axis::Y,
            is_negative: true,
        },
        Up {
            axis: Axis::Z,
            is_negative: false,
        },
        Up {
            axis: Axis::Z,
            is_negative: true,
        },
    ];

    /// The up axis of that name.
    pub fn from_name(name: &str) -> Option<Up> {
        Self::ALL.into_iter().find(|up| up.name() == name)
    }

    /// The direction towards the sky, of length 1.
    pub fn direction(self) -> Vector3<f64> {
        let mut direction = Vector3::zeros();
        direction[self.axis.index()] = self.sign();
        direction
    }

    /// Two level axes, the second a quarter turn counter-clockwise about up from the first. A viewer
    /// at yaw ψ has first · cos ψ + second · sin ψ to the right and stands on the side
    /// first · sin ψ − second · cos ψ. The first is +X for ±Y and ±Z up, ∓Y for ±X.
    pub fn level_axes(self) -> [Vector3<f64>; 2] {
        let first = match self.axis {
            Axis::X => -self.sign() * Vector3::y(),
            Axis::Y | Axis::Z => Vector3::x(),
        };
        [first, self.direction().cross(&first)]
    }

    /// Its name, e.g. `+Y`.
    pub fn name(self) -> &'static str {
        match (self.axis, self.is_negative) {
            (Axis::X, false) => "+X",
            (Axis::X, true) => "-X",
            (Axis::Y, false) => "+Y",
            (Axis::Y, true) => "-Y",
            (Axis::Z, false) => "+Z",
            (Axis::Z, true) => "-Z",
        }
    }
}

/// The up axis: that of the largest component of the mean of neck − middle of the ankles.
///
/// None where it is below 0.7 of the mean's length, or the body not human: then
/// [`Up::PLUS_Y`] is assumed, with a note.
pub fn up_axis(footing: &Footing) -> Option<Up> {
    let mean = footing.trunk;
    let mut best = (Axis::Y, 0.0_f64);
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        let value = mean[axis.index()];
        if value.abs() > best.1.abs() {
            best = (axis, value);
        }
    }
    let (axis, value) = best;
    let is_clear = value != 0.0 && value.abs() >= UPRIGHT * mean.norm();
    is_clear.then_some(Up {
        axis,
        is_negative: value < 0.0,
    })
}

/// The height of the ground along `up`, in file units: the 5th percentile over the frames of the
/// lowest ankle or toe (of any joint if the body is not human). 0 without frames.
pub fn ground_height(footing: &Footing, up: Up) -> f64 {
    let axis = up.axis.index();
    let lowest = |extent: &[f64; 6]| match up.is_negative {
        true => -extent[axis + 3],
        false => extent[axis],
    };
    let mut heights: Vec<f64> = footing.feet.iter().map(lowest).collect();
    percentile(&mut heights, BELOW_GROUND)
}

/// The value at `share` of the way through the sorted values, between the two nearest in
/// proportion; reorders them.
fn percentile(values: &mut [f64], share: f64) -> f64 {
    let Some(last) = values.len().checked_sub(1) else {
        return 0.0;
    };
    let place = share * last as f64;
    let (_, below, above) = values.select_nth_unstable_by(place as usize, f64::total_cmp);
    let below = *below;
    let above = above.iter().copied().fold(f64::INFINITY, f64::min);
    match place.fract() {
        0.0 => below,
        part => below + (above - below) * part,
    }
}

/// A unit of length that motion files use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Metre.
    Metre,
    /// Decimetre.
    Decimetre,
    /// 1/17.72 m, the unit of the CMU database.
    Cmu,
    /// Inch.
    Inch,
    /// Centimetre.
    Centimetre,
    /// Millimetre.
    Millimetre,
}

impl Unit {
    /// Every unit, the longest first.
    pub const ALL: [Unit; 6] = [
        Unit::Metre,
        Unit::Decimetre,
        Unit::Cmu,
        Unit::Inch,
        Unit::Centimetre,
        Unit::Millimetre,
    ];

    /// Metres in one unit.
    pub fn metres(self) -> f64 {
        match self {
            Unit::Metre => 1.0,
            Unit::Decimetre => 0.1,
            Unit::Cmu => 1.0 / 17.72,
            Unit::Inch => 0.0254,
            Unit::Centimetre => 0.01,
            Unit::Millimetre => 0.001,
        }
    }

    /// Its name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Unit::Metre => "m",
            Unit::Decimetre => "dm",
            Unit::Cmu => "1/17.72 m",
            Unit::Inch => "in",
            Unit::Centimetre => "cm",
            Unit::Millimetre => "mm",
        }
    }
}

/// The unit that brings a body height (file units) nearest to 1.5 m in the logarithm; none if that
/// is more than a factor 1.5 away, or the height no positive number.
pub fn unit(height: f64) -> Option<Unit> {
    let factor = |unit: Unit| {
        let ratio = height * unit.metres() / USUAL_HEIGHT_M;
        if ratio < 1.0 { 1.0 / ratio } else { ratio }
    };
    let nearest = |best: Unit, unit: Unit| {
        if factor(unit) < factor(best) {
            unit
        } else {
            best
        }
    };
    let best = Unit::ALL.into_iter().reduce(nearest)?;
    (factor(best) <= HEIGHT_FACTOR).then_some(best)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn up_is_the_axis_of_the_trunk() {
        let leaning = |x, y, z| Footing {
            trunk: Vector3::new(x, y, z),
            ..Footing::default()
        };
        assert_eq!(up_axis(&leaning(0.1, 3.0, 0.0)), Some(Up::PLUS_Y));
        assert_eq!(up_axis(&leaning(0.1, 0.0, -2.0)).map(Up::name), Some("-Z"));
        assert_eq!(up_axis(&leaning(1.0, 1.0, 1.0)), None);
        assert_eq!(up_axis(&leaning(0.0, 0.0, 0.0)), None);
    }

    #[test]
    fn the_ground_is_the_fifth_percentile_of_the_lowest_foot() {
        let feet = (0..=100)
            .rev()
            .map(|n| [0.0, f64::from(n), 0.0, 0.0, f64::from(n) + 7.0, 0.0]);
        let footing = Footing {
            feet: feet.collect(),
            ..Footing::default()
        };
        assert_eq!(ground_height(&footing, Up::PLUS_Y), 5.0);
        let down = Up {
            axis: Axis::Y,
            is_negative: true,
        };
        assert_eq!(ground_height(&footing, down), -102.0);
        assert_eq!(ground_height(&Footing::default(), down), 0.0);
    }

    #[test]
    fn units_are_told_by_the_body_height() {
        assert_eq!(unit(1.5), Some(Unit::Metre));
        assert_eq!(unit(26.5), Some(Unit::Cmu));
        assert_eq!(unit(65.0), Some(Unit::Inch));
        assert_eq!(unit(160.0), Some(Unit::Centimetre));
        assert_eq!(unit(1607.0), Some(Unit::Millimetre));
        assert_eq!(unit(15.2), Some(Unit::Decimetre));
        assert_eq!(unit(400.0), None);
        assert_eq!(unit(f64::NAN), None);
    }
}
