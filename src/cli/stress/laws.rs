//! Answers to a case and to what laws make of it, held against each other.

use super::run::{program, words};
use super::{Args, made, numbers};
use crate::cli::exit::{Exit, Failure};
use crate::cli::files;
use crate::forge::{Family, Input, LAWS, Settings, find};
use crate::num::Random;
use crate::vectors::{Answer, Case};

/// Holds every law that applies on each case, for our engine or for the program that was named, and
/// prints what breaks one.
pub(super) fn hold(args: &Args, family: &Family, settings: &Settings) -> Result<Exit, Failure> {
    let program = if args.run.is_empty() { None } else { Some(program(args)?) };
    let mut session = program.as_ref().map(|program| program.session());
    let mut ask = |input: &Input, case: &Case| -> Result<Answer, String> {
        match &mut session {
            None => find(input).map(|found| found.answer).map_err(|fault| fault.to_string()),
            Some(session) => session.ask(case).map_err(words),
        }
    };
    let (mut held, mut broken) = (0u64, 0u64);
    for number in numbers(args) {
        let (input, case) = made(args, family, settings, number);
        let answer = ask(&input, &case);
        for (index, law) in LAWS.iter().enumerate().filter(|(_, l)| l.applies_to(family.kind)) {
            let mut random = Random::new(args.seed ^ u64::from(number) << 8 ^ index as u64);
            let others = law.derive(&input, &mut random);
            if others.is_empty() {
                continue;
            }
            let comment = format!("{}, law {}", case.comment, law.name);
            let cases: Vec<Case> =
                others.iter().map(|other| other.case(number, &comment, &[family.name])).collect();
            let answers: Result<Vec<Answer>, String> =
                others.iter().zip(&cases).map(|(other, case)| ask(other, case)).collect();
            let what = match (&answer, &answers) {
                // Who does not answer one of them breaks no law.
                (Ok(Answer::Skip(_)), _) => continue,
                (Ok(_), Ok(answers)) if answers.iter().any(|a| matches!(a, Answer::Skip(_))) => {
                    continue;
                }
                (Ok(answer), Ok(answers)) if law.relation.holds(answer, answers) => {
                    held += 1;
                    continue;
                }
                (Ok(answer), Ok(answers)) => {
                    let others: Vec<String> =
                        answers.iter().map(|answer| answer.to_value().to_string()).collect();
                    let (answer, relation) = (answer.to_value(), law.relation.words());
                    format!("{answer}, and {}: must be {relation}", others.join(" "))
                }
                (Err(what), _) | (_, Err(what)) => what.clone(),
            };
            broken += 1;
            let mut text = format!("{}: {what}\n{}\n", law.name, case.to_line());
            cases.iter().for_each(|case| text.push_str(&(case.to_line() + "\n")));
            files::print(&text)?;
        }
    }
    eprintln!("{}: {held} laws hold, {broken} are broken", family.name);
    Ok(if broken > 0 { Exit::Holes } else { Exit::Done })
}
