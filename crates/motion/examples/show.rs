use motion::body::{self, Role, TableBuilder};
fn main() {
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path).unwrap();
        let Ok(clip) = motion::bvh::parse(&bytes) else {
            println!("{path}: unreadable");
            continue;
        };
        for p in 0..clip.performers.len() {
            let t = std::time::Instant::now();
            let body = body::find(&clip, p, &[]);
            let t1 = t.elapsed();
            let mut b = TableBuilder::new(&clip, p, &body);
            b.step(clip.frames);
            let table = b.finish();
            let t2 = t.elapsed();
            let up = motion::world::up_axis(&table);
            let ground =
                motion::world::ground_height(&table, up.unwrap_or(motion::world::Up::PLUS_Y));
            let a = motion::rest::analysed(&clip, p, &body, table, None);
            println!(
                "{path} #{p} {:?} frames {} H {:.3} up {:?} ground {:.3} unit {:?} lead {:?} find {:?} table {:?} all {:?}",
                body.kind,
                clip.frames,
                a.frame.height,
                up.map(|u| u.name()),
                ground / a.frame.height,
                motion::world::unit(a.frame.height).map(|u| u.name()),
                a.leading,
                t1,
                t2,
                t.elapsed()
            );
            for n in body
                .notes
                .iter()
                .chain(&a.frame.notes)
                .chain(&motion::discontinuity::find(&a.track))
            {
                println!("   {:?} {}", n.frame, n.message());
            }
            if std::env::var("J").is_ok() {
                let l = clip.performers[p].skeleton.labels();
                for j in &body.joints {
                    println!("     {} {} {:?}", j.role.name(), l[j.joint], j.source);
                }
            }
        }
    }
    let _ = Role::ALL;
}
