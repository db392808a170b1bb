use canvas::*;
fn main() {
    let n: u64 = std::env::args().nth(1).unwrap().parse().unwrap();
    std::panic::set_hook(Box::new(|i| {
        println!(
            "PANIC {} {}",
            i.location().unwrap(),
            i.payload_as_str().unwrap_or("?")
        );
    }));
    let image = Image::from_fn(37, 21, |i, j| {
        Rgb::new(
            i as f32 * 0.03,
            j as f32 * 0.05,
            ((i * 7 + j * 3) % 11) as f32 * 0.2,
        )
    });
    let mut s = 0x9E3779B97F4A7C15u64;
    let mut rnd = move || {
        s ^= s << 13;
        s ^= s >> 7;
        s ^= s << 17;
        s
    };
    let mut slow = 0.0f64;
    let (mut ok, mut err) = (0, 0);
    let mut reasons = std::collections::BTreeMap::new();
    for f in [Format::Exr, Format::Png8, Format::Png16] {
        let good = codec::encode(&image, f).unwrap();
        println!("{f:?} {} bytes", good.len());
        for k in 0..n {
            let mut b = good.clone();
            let header = k % 2 == 0;
            let edits = 1 + rnd() % 4;
            for _ in 0..edits {
                let span = if header { 400.min(b.len()) } else { b.len() } as u64;
                let at = (rnd() % span) as usize;
                match rnd() % 6 {
                    0 => {
                        b.truncate(at.max(8));
                        break;
                    }
                    1 => b[at] = 0xff,
                    2 => b[at] = 0x7f,
                    3 => b[at] = 0,
                    4 => b[at] = rnd() as u8,
                    _ => b[at] ^= 1 << (rnd() % 8),
                }
            }
            let t = std::time::Instant::now();
            match codec::decode(&b) {
                Ok(_) => ok += 1,
                Err(e) => {
                    err += 1;
                    *reasons.entry(e.to_string()).or_insert(0) += 1;
                }
            }
            let t = t.elapsed().as_secs_f64();
            if t > 0.2 {
                println!("{f:?} slow {t}");
            }
            if t > slow {
                slow = t;
                std::fs::write("/tmp/slowest.bin", &b).unwrap();
            }
        }
    }
    println!("ok {ok} err {err} slowest {slow}");
    for (r, n) in reasons {
        println!("{n:6} {r}");
    }
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    println!(
        "{}",
        status
            .lines()
            .filter(|l| l.starts_with("VmHWM") || l.starts_with("VmPeak"))
            .collect::<Vec<_>>()
            .join(" ")
    );
}
