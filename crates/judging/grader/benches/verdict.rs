//! How long does a student wait for a verdict? Of that, rustc takes what a file takes in which `todo!()` still stands: compiled, started, asked
//! once. The rest is ours: questions, laws, shrinking, diagnosis, picture.

use std::fs;
use std::path::Path;

use criterion::{Criterion, criterion_group, criterion_main};
use grader::{Build, Judge, Libraries};

fn verdicts(criterion: &mut Criterion) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let folder = tempfile::tempdir().expect("a folder");
    let libraries = Libraries::build(&root, Build::of("worker")).expect("the libraries");
    let judge = Judge::in_folder(libraries, folder.path());
    for name in ["rotate_about_point", "zbuffer", "light_all", "ray_color_recursive"] {
        let exercise = course::find(name).expect("the exercise");
        let text = |program| exercise.submission(program).expect("its text");
        let files = [
            ("rustc alone", exercise.stub.to_owned()),
            ("right", text(&exercise.reference)),
            ("wrong", text(&exercise.misconceptions[0].program)),
        ];
        let mut group = criterion.benchmark_group(name);
        group.sample_size(10);
        for (what, source) in files {
            let file = folder.path().join(format!("{name}.rs"));
            group.bench_function(what, |bencher| {
                fs::write(&file, &source).expect("written");
                bencher.iter(|| judge.judge(exercise, &file, 1));
            });
        }
    }
}

criterion_group!(benches, verdicts);
criterion_main!(benches);
