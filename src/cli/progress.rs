//! Progress on standard error: a bar, JSON lines, or nothing.

use super::interrupt;
use crate::report::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// The option `--progress`, to be flattened into a subcommand's `Args`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(super) struct ProgressArgs {
    /// How to show progress on standard error [default: bar at a terminal, else none]
    #[arg(long, value_enum)]
    progress: Option<Style>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Style {
    /// A bar with an estimate of the time left
    Bar,
    /// One JSON object a line, at most four a second
    Json,
    /// Nothing
    None,
}

/// The shortest time between two JSON lines.
const INTERVAL: Duration = Duration::from_millis(250);

/// Shows progress, and passes an interrupt on to the computation, for as long as it lives.
pub(super) struct Reporter {
    show: Show,
}

enum Show {
    Bar(ProgressBar),
    Json(Mutex<JsonLines>),
    Nothing,
}

struct JsonLines {
    stage: String,
    started: Instant,
    shown: Option<Instant>,
    done: u64,
    total: u64,
}

impl ProgressArgs {
    /// Starts to report; from now on an interrupt asks the computation to stop.
    pub(super) fn reporter(self) -> Reporter {
        let by_default = if std::io::stderr().is_terminal() { Style::Bar } else { Style::None };
        let show = match self.progress.unwrap_or(by_default) {
            Style::Bar => Show::Bar(bar()),
            Style::Json => Show::Json(Mutex::new(JsonLines {
                stage: String::new(),
                started: Instant::now(),
                shown: None,
                done: 0,
                total: 0,
            })),
            Style::None => Show::Nothing,
        };
        interrupt::watch();
        Reporter { show }
    }
}

fn bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::stderr());
    let template = "{msg} [{wide_bar}] {pos}/{len} {elapsed}, about {eta} left";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style.progress_chars("=> "));
    }
    bar
}

impl Progress for Reporter {
    fn begin(&self, stage: &str, total: u64) {
        match &self.show {
            Show::Bar(bar) => {
                bar.reset();
                bar.set_length(total);
                bar.set_message(stage.to_owned());
            }
            Show::Json(lines) => {
                if let Ok(mut lines) = lines.lock() {
                    lines.stage = stage.to_owned();
                    lines.started = Instant::now();
                    lines.done = 0;
                    lines.total = total;
                    lines.show();
                }
            }
            Show::Nothing => {}
        }
    }

    fn advance(&self, steps: u64) {
        match &self.show {
            Show::Bar(bar) => bar.inc(steps),
            Show::Json(lines) => {
                if let Ok(mut lines) = lines.lock() {
                    lines.done += steps;
                    let due = lines.shown.is_none_or(|shown| shown.elapsed() >= INTERVAL);
                    if due || lines.done == lines.total {
                        lines.show();
                    }
                }
            }
            Show::Nothing => {}
        }
    }

    fn is_interrupted(&self) -> bool {
        interrupt::is_raised()
    }
}

impl JsonLines {
    fn show(&mut self) {
        self.shown = Some(Instant::now());
        let elapsed = self.started.elapsed().as_secs_f64();
        let left = (self.done > 0)
            .then(|| elapsed * (self.total.saturating_sub(self.done)) as f64 / self.done as f64);
        let line = serde_json::json!({
            "stage": self.stage,
            "done": self.done,
            "total": self.total,
            "elapsed_seconds": (elapsed * 1e3).round() / 1e3,
            "left_seconds": left.map(|left| (left * 1e3).round() / 1e3),
        });
        // Progress that nobody can read must not end the work.
        let _ = writeln!(std::io::stderr(), "{line}");
    }
}

impl Drop for Reporter {
    fn drop(&mut self) {
        interrupt::unwatch();
        if let Show::Bar(bar) = &self.show {
            bar.finish_and_clear();
        }
    }
}

/// Passes progress on, and keeps the time of each stage.
pub(super) struct Stopwatch {
    reporter: Reporter,
    begun: Mutex<Vec<(String, Instant)>>,
}

impl Stopwatch {
    pub(super) fn new(reporter: Reporter) -> Stopwatch {
        Stopwatch { reporter, begun: Mutex::new(Vec::new()) }
    }

    /// The stages so far, and how many microseconds each took.
    pub(super) fn stages(&self) -> Vec<(String, u64)> {
        let Ok(begun) = self.begun.lock() else { return Vec::new() };
        let now = Instant::now();
        let ends = begun.iter().skip(1).map(|(_, start)| *start).chain([now]);
        let took = |((stage, start), end): (&(String, Instant), Instant)| {
            (stage.clone(), (end - *start).as_micros() as u64)
        };
        begun.iter().zip(ends).map(took).collect()
    }
}

impl Progress for Stopwatch {
    fn begin(&self, stage: &str, total: u64) {
        if let Ok(mut begun) = self.begun.lock() {
            begun.push((stage.to_owned(), Instant::now()));
        }
        self.reporter.begin(stage, total);
    }

    fn advance(&self, steps: u64) {
        self.reporter.advance(steps);
    }

    fn is_interrupted(&self) -> bool {
        self.reporter.is_interrupted()
    }
}

/// The most memory to use, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MemoryLimit(pub u64);

/// Reports progress, and interrupts at a memory limit as well.
pub(super) struct Watch {
    reporter: Reporter,
    limit: Option<MemoryLimit>,
}

impl Watch {
    pub(super) fn new(reporter: Reporter, limit: Option<MemoryLimit>) -> Watch {
        Watch { reporter, limit }
    }

    fn is_over_limit(&self) -> bool {
        self.limit.is_some_and(|MemoryLimit(bytes)| {
            memory_stats::memory_stats().is_some_and(|used| used.physical_mem as u64 > bytes)
        })
    }
}

impl Progress for Watch {
    fn begin(&self, stage: &str, total: u64) {
        self.reporter.begin(stage, total);
    }

    fn advance(&self, steps: u64) {
        self.reporter.advance(steps);
    }

    fn is_interrupted(&self) -> bool {
        self.reporter.is_interrupted() || self.is_over_limit()
    }
}
