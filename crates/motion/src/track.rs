//! A performer's principal joints over the analysed frames, in pelvis coordinates.

/// Positions of the principal joints in pelvis coordinates, in body heights (16
/// joints in the fixed order of `body::Role::PRINCIPAL`), or of all joints in root
/// coordinates where the body is not human.
#[derive(Clone, Debug, PartialEq)]
pub struct PelvisTrack {
    /// Frames × joints × (x, y, z), row-major.
    pub coordinates: Vec<f64>,
    /// Joints of each frame.
    pub joint_count: usize,
    /// The frame of the file that row 0 is (the leading rest frames left out).
    pub first_frame: usize,
}

impl PelvisTrack {
    /// Frames in the track.
    pub fn frames(&self) -> usize {
        match self.joint_count {
            0 => 0,
            joints => self.coordinates.len() / (3 * joints),
        }
    }

    /// The coordinates of one frame of the track (from 0), joint by joint.
    pub fn frame(&self, frame: usize) -> &[f64] {
        let width = 3 * self.joint_count;
        &self.coordinates[frame * width..(frame + 1) * width]
    }
}
