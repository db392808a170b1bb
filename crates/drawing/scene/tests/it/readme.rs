//! The README's scene is a scene.

#[test]
fn the_scene_in_the_readme_is_read_and_has_every_key() {
    let readme = include_str!("../../README.md");
    let text = readme
        .split("```toml\n")
        .nth(1)
        .and_then(|rest| rest.split("```").next())
        .expect("a scene in the README");
    let scene = scene::Scene::from_toml(text, "README.md").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((scene.objects.len(), scene.objects[0].instances.len()), (2, 2));
    // What is written has every key; so has the README.
    let written = scene.to_toml();
    for key in written
        .lines()
        .filter(|line| !line.starts_with(' '))
        .filter_map(|line| line.split_once(" = "))
        .map(|(key, _)| key)
    {
        assert!(text.contains(&format!("{key} = ")), "the README does not show `{key}`");
    }
}
