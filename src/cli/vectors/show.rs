//! A score as text, one fact a line.

use crate::vectors::{Failing, Mark, Marks, ScoreReport};

/// How many cases of a mark are listed.
const LISTED: usize = 20;

/// The score as text.
pub(super) fn text(report: &ScoreReport) -> String {
    let mut text = format!(
        "program    {}\npolicy     {}\nvectors    {} files, {} cases\n",
        report.program.join(" "),
        format!("{:?}", report.policy).to_lowercase(),
        report.files.len(),
        report.all.cases
    );
    for mark in Mark::ALL {
        text.push_str(&format!("{:<10} {}\n", mark.name(), report.all.count(mark)));
    }
    for (kind, marks) in &report.by_kind {
        text.push_str(&format!("kind {kind}: {}\n", marks_text(marks)));
    }
    for (flag, marks) in report.by_flag.iter().filter(|(_, marks)| worth_telling(marks)) {
        text.push_str(&format!("flag {flag}: {}\n", marks_text(marks)));
    }
    for mark in Mark::ALL {
        let of_mark = || report.listed.iter().filter(|case| case.mark == mark);
        for case in of_mark().take(LISTED) {
            text.push_str(&case_text(case));
        }
        if let Some(more) = of_mark().count().checked_sub(LISTED + 1) {
            text.push_str(&format!("{}: and {} more, which --json lists\n", mark.name(), more + 1));
        }
    }
    text
}

/// Flags under which all is well are left out.
fn worth_telling(marks: &Marks) -> bool {
    marks.failures() > 0 || marks.count(Mark::Waste) > 0
}

fn marks_text(marks: &Marks) -> String {
    let of = Mark::ALL.into_iter().filter(|&mark| marks.count(mark) > 0);
    let of = of.map(|mark| format!("{} {}", marks.count(mark), mark.name()));
    format!("{} cases, {}", marks.cases, of.collect::<Vec<_>>().join(", "))
}

fn case_text(case: &Failing) -> String {
    format!(
        "{}: {} {} ({}): expected {}, got {}: {}\n",
        case.mark.name(),
        case.file,
        case.tc_id,
        case.flags.join(", "),
        case.expected,
        case.got,
        case.comment
    )
}
