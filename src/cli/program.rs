//! Programs under test: a case on their standard input, an answer on their standard output.
//!
//! By default each case has a process of its own, which gets one JSON object and the end of its
//! input. As a stream one process gets one line a case and prints one line an answer; after a
//! crash or a hang the next case starts another.

use crate::vectors::{Answer, Case, Mishap, Witness};
use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

/// The most that is read of what a program prints for one case.
const MOST_BYTES: u64 = 1 << 24;

/// How often a process that closed its output is asked whether it has ended.
const POLL: Duration = Duration::from_millis(2);

/// How long a stream that has no more cases may take to end.
const PATIENCE: Duration = Duration::from_secs(1);

/// A program under test.
#[derive(Clone, Debug)]
pub(super) struct Program {
    command: Vec<OsString>,
    timeout: Duration,
    stream: bool,
}

/// A program that is asked one case after the other.
#[derive(Debug)]
pub(super) struct Session<'p> {
    program: &'p Program,
    running: Option<Stream>,
}

/// A process that is asked case after case.
#[derive(Debug)]
struct Stream {
    child: Child,
    cases: Sender<String>,
    answers: Receiver<String>,
    complaints: Receiver<String>,
}

impl Program {
    /// The program of this name, with these arguments.
    ///
    /// # Errors
    /// That it cannot be started.
    pub(super) fn new(
        command: Vec<OsString>,
        timeout: Duration,
        stream: bool,
    ) -> io::Result<Program> {
        let program = Program { command, timeout, stream };
        let mut child = program.start()?;
        end(&mut child);
        Ok(program)
    }

    /// The program, ready to be asked.
    pub(super) fn session(&self) -> Session<'_> {
        Session { program: self, running: None }
    }

    /// Its name and its arguments.
    pub(super) fn command(&self) -> Vec<String> {
        self.command.iter().map(|word| word.to_string_lossy().into_owned()).collect()
    }

    fn start(&self) -> io::Result<Child> {
        let mut command = Command::new(&self.command[0]);
        command.args(&self.command[1..]);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()
    }

    /// All that a process of its own prints for the case.
    fn whole_output(&self, case: &Case) -> Result<String, Mishap> {
        let started = Instant::now();
        let mut child = self.start().map_err(|error| Mishap::Crash(error.to_string()))?;
        let (cases, to_write) = channel();
        write_lines(child.stdin.take(), to_write);
        // The end of the channel is the end of the input. Who has ended does not need it.
        let _ = cases.send(case.to_line());
        drop(cases);
        let output = read_whole(child.stdout.take());
        let complaints = read_lines(child.stderr.take());
        let Ok(text) = output.recv_timeout(self.timeout) else {
            end(&mut child);
            return Err(Mishap::Hang);
        };
        let Some(status) = wait(&mut child, started + self.timeout) else {
            end(&mut child);
            return Err(Mishap::Hang);
        };
        match status.success() {
            true => Ok(text),
            false => Err(crash(status, &complaints)),
        }
    }
}

impl Session<'_> {
    /// What the program answers.
    ///
    /// # Errors
    /// [`Mishap`] where it does not.
    pub(super) fn ask(&mut self, case: &Case) -> Result<Answer, Mishap> {
        self.ask_for_witness(case).map(|(answer, _)| answer)
    }

    /// What the program answers, with the line that it shows for it, if it does.
    ///
    /// # Errors
    /// [`Mishap`] where it does not answer.
    pub(super) fn ask_for_witness(
        &mut self,
        case: &Case,
    ) -> Result<(Answer, Option<Witness>), Mishap> {
        let text = match self.program.stream {
            true => self.next_line(case)?,
            false => self.program.whole_output(case)?,
        };
        let read = Answer::read(case.kind, &text).and_then(|answer| {
            let witness = Witness::read(case.kind, &answer, &text)?;
            Ok((answer, witness))
        });
        read.map_err(|error| {
            let shown: String = text.trim().chars().take(80).collect();
            Mishap::Unreadable(format!("{error}: {shown:?}"))
        })
    }

    /// The line that the running process prints for the case.
    fn next_line(&mut self, case: &Case) -> Result<String, Mishap> {
        if self.running.is_none() {
            let started = self.program.start();
            let mut child = started.map_err(|error| Mishap::Crash(error.to_string()))?;
            let (cases, to_write) = channel();
            write_lines(child.stdin.take(), to_write);
            let answers = read_lines(child.stdout.take());
            let complaints = read_lines(child.stderr.take());
            self.running = Some(Stream { child, cases, answers, complaints });
        }
        let stream = self.running.as_mut().expect("it was just started");
        // A process that has ended is found out by the answer that is lacking.
        let _ = stream.cases.send(case.to_line());
        match stream.answers.recv_timeout(self.program.timeout) {
            Ok(line) => Ok(line),
            Err(RecvTimeoutError::Timeout) => {
                end(&mut stream.child);
                self.running = None;
                Err(Mishap::Hang)
            }
            Err(RecvTimeoutError::Disconnected) => {
                let ended = wait(&mut stream.child, Instant::now() + PATIENCE);
                let mishap = match ended {
                    Some(status) => crash(status, &stream.complaints),
                    None => Mishap::Crash("closed its output".to_owned()),
                };
                self.running = None;
                Err(mishap)
            }
        }
    }
}

impl Drop for Stream {
    fn drop(&mut self) {
        // Without another sender the writer ends, and with it the process's input.
        self.cases = channel().0;
        if wait(&mut self.child, Instant::now() + PATIENCE).is_none() {
            end(&mut self.child);
        }
    }
}

/// Ends a process that is not waited for any longer.
fn end(child: &mut Child) {
    // It may have ended by itself.
    let _ = child.kill();
    let _ = child.wait();
}

fn wait(child: &mut Child, until: Instant) -> Option<ExitStatus> {
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Some(status),
            Ok(None) | Err(_) if Instant::now() >= until => return None,
            Ok(None) | Err(_) => thread::sleep(POLL),
        }
    }
}

/// How a process ended, with the last line that it printed to its standard error.
fn crash(status: ExitStatus, complaints: &Receiver<String>) -> Mishap {
    let mut last = String::new();
    while let Ok(line) = complaints.recv_timeout(Duration::from_millis(50)) {
        if !line.trim().is_empty() {
            last = line.trim().chars().take(200).collect();
        }
    }
    Mishap::Crash(match last.as_str() {
        "" => status.to_string(),
        last => format!("{status}: {last}"),
    })
}

fn write_lines(input: Option<ChildStdin>, lines: Receiver<String>) {
    let Some(mut input) = input else { return };
    thread::spawn(move || {
        for line in lines {
            // Who does not read on has its reasons; the answer, or its lack, tells.
            if writeln!(input, "{line}").and_then(|()| input.flush()).is_err() {
                return;
            }
        }
    });
}

fn read_lines(output: Option<impl Read + Send + 'static>) -> Receiver<String> {
    let (sender, lines) = channel();
    let Some(output) = output else { return lines };
    thread::spawn(move || {
        let mut output = BufReader::new(output);
        loop {
            let mut line = Vec::new();
            let read = output.by_ref().take(MOST_BYTES).read_until(b'\n', &mut line);
            let line = String::from_utf8_lossy(&line).into_owned();
            if !matches!(read, Ok(1..)) || sender.send(line).is_err() {
                return;
            }
        }
    });
    lines
}

fn read_whole(output: Option<impl Read + Send + 'static>) -> Receiver<String> {
    let (sender, whole) = channel();
    let Some(output) = output else { return whole };
    thread::spawn(move || {
        let mut bytes = Vec::new();
        // What could be read is judged, whatever ended it.
        let _ = output.take(MOST_BYTES).read_to_end(&mut bytes);
        let _ = sender.send(String::from_utf8_lossy(&bytes).into_owned());
    });
    whole
}
