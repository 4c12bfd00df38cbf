//! The rigs that the samples are written in: a name in, its skeleton out.

use crate::skeleton::Skeleton;
use crate::{rig_hik, rig_poser, rig_vrm};

/// A naming and structure of skeletons found in real files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rig {
    /// MotionBuilder and Mixamo: `LeftArm`; centimetres, y up, order ZXY, T pose, no fingers.
    Hik,
    /// Poser and DAZ: `lShldr`; inches, y up, an order of its own for each limb, arms hanging at rest.
    Poser,
    /// VRoid: `J_Bip_L_UpperArm`; metres, z up, order ZYX, fingers, a twist helper, A pose.
    Vrm,
}

impl Rig {
    /// Every rig.
    pub const ALL: [Self; 3] = [Self::Hik, Self::Poser, Self::Vrm];

    /// Short name in lower case, used in ids and file names.
    pub fn id(self) -> &'static str {
        match self {
            Self::Hik => "hik",
            Self::Poser => "poser",
            Self::Vrm => "vrm",
        }
    }

    pub(crate) fn skeleton(self) -> Skeleton {
        match self {
            Self::Hik => rig_hik::skeleton(),
            Self::Poser => rig_poser::skeleton(),
            Self::Vrm => rig_vrm::skeleton(),
        }
    }
}
