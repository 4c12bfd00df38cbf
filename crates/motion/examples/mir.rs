use motion::body::{self, Role};
use motion::kinematics::Kinematics;
use nalgebra::Vector3;
fn main() {
    for path in std::env::args().skip(1) {
        let clip = motion::bvh::parse(&std::fs::read(&path).unwrap()).unwrap();
        let body = body::find(&clip, 0, &[]);
        let mut k = Kinematics::new(&clip, 0);
        let mut p = vec![0.0; 3 * k.joint_count()];
        for f in (0..clip.frames).step_by(clip.frames / 10 + 1) {
            k.positions(f, &mut p);
            let at = |r: Role| {
                let j = body.joint(r).unwrap();
                Vector3::new(p[3 * j], p[3 * j + 1], p[3 * j + 2])
            };
            let (l, r) = (at(Role::LeftHip), at(Role::RightHip));
            let up = at(Role::Neck) - (l + r) / 2.0;
            let fw = (l - r).cross(&up).normalize();
            let toes = [
                at(Role::LeftToe) - at(Role::LeftAnkle),
                at(Role::RightToe) - at(Role::RightAnkle),
            ];
            let knees = [
                at(Role::LeftKnee) - (l + at(Role::LeftAnkle)) / 2.0,
                at(Role::RightKnee) - (r + at(Role::RightAnkle)) / 2.0,
            ];
            println!(
                "{f} fw {:?} toes {:.2} {:.2} knees {:.2} {:.2}",
                fw.as_slice(),
                toes[0].dot(&fw),
                toes[1].dot(&fw),
                knees[0].dot(&fw),
                knees[1].dot(&fw)
            );
        }
    }
}
