use motion::body::{self, TableBuilder};
use std::time::Instant;
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let mut clip = motion::bvh::parse(&std::fs::read(&path).unwrap()).unwrap();
    let rows = clip.frames;
    let base = clip.values.clone();
    let n = 432_000;
    clip.values = base
        .iter()
        .cycle()
        .take(n * clip.row_width)
        .copied()
        .collect();
    clip.frames = n;
    println!("{rows} -> {n} rows of {}", clip.row_width);
    let t = Instant::now();
    let body = body::find(&clip, 0, &[]);
    println!("find {:?}", t.elapsed());
    let t = Instant::now();
    let mut b = TableBuilder::new(&clip, 0, &body);
    let mut worst = std::time::Duration::ZERO;
    loop {
        let s = Instant::now();
        let d = b.step(10_000);
        worst = worst.max(s.elapsed());
        if d {
            break;
        }
    }
    let table = b.finish();
    println!("table {:?} worst step of 10000: {worst:?}", t.elapsed());
    let t = Instant::now();
    let up = motion::world::up_axis(&table).unwrap();
    motion::world::ground_height(&table, up);
    println!("ground {:?}", t.elapsed());
    let t = Instant::now();
    let a = motion::rest::analysed(&clip, 0, &body, table, None);
    println!("analysed {:?}", t.elapsed());
    let t = Instant::now();
    let d = motion::discontinuity::find(&a.track);
    println!("discontinuity {:?} {}", t.elapsed(), d.len());
    let t = Instant::now();
    motion::figure::thumbnail_frame(&a.track, &[]);
    println!("thumbnail {:?}", t.elapsed());
}
