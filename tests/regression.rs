//! What was found once: every case of `scenes/regression`, with its story, against its snapshot.

mod support;

use serde_json::value::RawValue;
use stabline::forge::{Input, LAWS, find, test_of};
use stabline::num::Random;
use stabline::vectors::{Case, answer};
use support::{root, scenes};

/// What was found, and the case as it is written.
#[derive(serde::Deserialize)]
struct Story {
    about: String,
    case: Box<RawValue>,
}

#[test]
fn cases_are_answered_as_their_snapshots_say() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/regression"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in scenes("scenes/regression") {
        let text = std::fs::read_to_string(&path).unwrap();
        let file: Story = serde_json::from_str(&text).unwrap();
        let name = path.file_stem().unwrap().to_str().unwrap();
        let case = Case::read(file.case.get().as_bytes()).unwrap();
        let input = Input::of_case(&case).unwrap();
        let found = find(&input).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        assert_eq!(answer(&case), Ok(found.answer.clone()), "{name}: the two engines");
        let mut text = format!("{}\n", found.answer.to_value());
        for law in LAWS.iter().filter(|law| law.applies_to(case.kind)) {
            let others = law.derive(&input, &mut Random::new(1));
            let answers: Vec<_> = others.iter().map(|other| find(other).unwrap().answer).collect();
            let holds = others.is_empty() || law.relation.holds(&found.answer, &answers);
            assert!(holds, "{name}: {}: {answers:?}", law.name);
        }
        let test = test_of(&input).unwrap();
        text.push_str(&(serde_json::to_string_pretty(&test).unwrap() + "\n"));
        settings.set_description(file.about);
        settings.bind(|| insta::assert_snapshot!(name, text));
    }
}
