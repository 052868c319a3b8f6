//! The fuzz targets as a loop in this process: seeded mutations of the seeds, on stable Rust and without cargo-fuzz.
//!
//! `FUZZ_SECONDS` is the processor time per target, `FUZZ_EXECUTIONS` their number in its place, `FUZZ_TARGET` names one target,
//! and `FUZZ_SEED` and `FUZZ_FIRST` say which inputs: a fault is repeated with the seed and the number that it is reported with.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../../fuzz/targets.rs"]
mod targets;

use rustix::time::{ClockId, clock_gettime};
use sneddon_checks::random::Stream;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Mutex;
use std::time::Duration;
use std::{env, fs, thread};
use targets::{TARGETS, Target};

/// The longest execution, in seconds of processor time.
const LONGEST: f64 = 5.0;
/// An execution that takes this long is not waited for.
const HOPELESS: f64 = 60.0;
/// The largest resident memory of the process, in megabytes.
const LARGEST: f64 = 500.0;
/// Executions per target where nothing else is asked for.
const EXECUTIONS: u64 = 300;
/// The largest input.
const BYTES: usize = 4096;

/// What is asked for by the environment.
#[derive(Clone, Copy)]
struct Asked {
    executions: u64,
    seconds: f64,
    seed: u64,
    first: u64,
}

fn number(name: &str) -> Option<f64> {
    env::var(name).ok().map(|text| text.parse().unwrap_or_else(|_| panic!("{name} = {text} is not a number")))
}

impl Asked {
    fn read() -> Self {
        let (executions, seconds) = (number("FUZZ_EXECUTIONS").map(|own| own as u64), number("FUZZ_SECONDS"));
        Self {
            executions: executions.unwrap_or(if seconds.is_some() { u64::MAX } else { EXECUTIONS }),
            seconds: seconds.unwrap_or(f64::INFINITY),
            seed: number("FUZZ_SEED").unwrap_or(0.0) as u64,
            first: number("FUZZ_FIRST").unwrap_or(0.0) as u64,
        }
    }
}

/// The processor time of this process.
fn clock() -> f64 {
    let now = clock_gettime(ClockId::ProcessCPUTime);
    now.tv_sec as f64 + now.tv_nsec as f64 * 1e-9
}

/// The largest resident memory so far in megabytes, where the system tells it.
fn peak() -> f64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmHWM"));
    line.and_then(|line| line.split_whitespace().nth(1)?.parse::<f64>().ok()).unwrap_or(0.0) / 1024.0
}

/// The words of the dictionary, in libFuzzer's form.
fn dictionary(text: &str) -> Vec<Vec<u8>> {
    let quoted = text.lines().filter_map(|line| line.strip_prefix('"')?.strip_suffix('"'));
    quoted.map(|word| word.replace("\\\"", "\"").into_bytes()).collect()
}

fn seeds(name: &str) -> Vec<Vec<u8>> {
    let mut paths: Vec<_> = fs::read_dir(Path::new("fuzz/seeds").join(name)).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.iter().map(|path| fs::read(path).unwrap()).collect()
}

/// A seed after one to eight changes; it depends on the numbers alone.
fn input(seeds: &[Vec<u8>], words: &[Vec<u8>], seed: u64, index: u64) -> Vec<u8> {
    let mut draw = Stream::new(seed ^ index.wrapping_mul(0x2545_F491_4F6C_DD1D));
    let mut bytes = draw.pick(seeds).clone();
    for _ in 0..draw.whole(1, 8) {
        let place = |draw: &mut Stream, bytes: &[u8]| draw.whole(0, bytes.len() as i64) as usize;
        let (one, other) = (place(&mut draw, &bytes), place(&mut draw, &bytes));
        let (low, high) = (one.min(other), one.max(other));
        match draw.whole(0, 8) {
            0 | 1 => drop(bytes.splice(low..low, draw.pick(words).iter().copied())),
            2 => drop(bytes.splice(low..high.min(low + 6), draw.pick(words).iter().copied())),
            3 => drop(bytes.drain(low..high.min(low + 8))),
            4 => {
                // A part of it once more, elsewhere: this nests and repeats.
                let part = bytes[low..high].to_vec();
                let at = place(&mut draw, &bytes);
                bytes.splice(at..at, part);
            }
            5 => {
                let donor = draw.pick(seeds);
                let (from, until) = (place(&mut draw, donor), place(&mut draw, donor));
                bytes.splice(low..low, donor[from.min(until)..from.max(until)].iter().copied());
            }
            6 => {
                let digits = *draw.pick(&["0", "1", "2", "7", "12", "300", "0.5", "1e-9", "99999999999999999999", "1e400"]);
                bytes.splice(low..low, digits.bytes());
            }
            7 if low < bytes.len() => bytes[low] = draw.whole(0, 255) as u8,
            _ => {
                if low < bytes.len() {
                    bytes[low] = *draw.pick(b"()+-*/^,.=<>r x\n\t[]\"'aE2");
                }
            }
        }
        bytes.truncate(BYTES);
    }
    bytes
}

/// What one target did.
#[derive(Default)]
struct Tally {
    executions: u64,
    slowest: f64,
    faults: Vec<String>,
}

fn shown(name: &str, asked: Asked, index: u64, bytes: &[u8], what: &str) -> String {
    format!(
        "{name}: {what}\n  FUZZ_TARGET={name} FUZZ_SEED={} FUZZ_FIRST={index} FUZZ_EXECUTIONS=1\n  {:?}",
        asked.seed,
        String::from_utf8_lossy(bytes)
    )
}

/// Runs one target on a stack as large as that of the program; this thread watches the other one.
fn attack((name, body): Target, asked: Asked, words: &[Vec<u8>]) -> Tally {
    let (seeds, running) = (seeds(name), Mutex::new(None::<(u64, f64)>));
    let work = || {
        let (start, mut tally) = (clock(), Tally::default());
        let mut known = peak();
        for index in asked.first.. {
            if tally.executions >= asked.executions || clock() - start > asked.seconds {
                break;
            }
            let bytes = input(&seeds, words, asked.seed, index);
            let before = clock();
            *running.lock().unwrap() = Some((index, before));
            let done = catch_unwind(AssertUnwindSafe(|| body(&bytes)));
            let seconds = clock() - before;
            *running.lock().unwrap() = None;
            (tally.executions, tally.slowest) = (tally.executions + 1, tally.slowest.max(seconds));
            if let Err(payload) = done {
                let why = payload.downcast_ref::<String>().cloned().or_else(|| payload.downcast_ref::<&str>().map(|own| (*own).to_owned()));
                tally.faults.push(shown(name, asked, index, &bytes, &format!("a panic: {}", why.unwrap_or_default())));
            }
            if seconds > LONGEST {
                tally.faults.push(shown(name, asked, index, &bytes, &format!("{seconds:.1} s")));
            }
            if seconds > 0.01 || index % 256 == 0 {
                let now = peak();
                if now > LARGEST && now > known {
                    tally.faults.push(shown(name, asked, index, &bytes, &format!("{now:.0} MB")));
                }
                known = known.max(now);
            }
        }
        tally
    };
    thread::scope(|scope| {
        let worker = thread::Builder::new().stack_size(8 << 20).spawn_scoped(scope, work).unwrap();
        let mut told = None;
        while !worker.is_finished() {
            thread::sleep(Duration::from_millis(20));
            let now = *running.lock().unwrap();
            let Some((index, since)) = now else { continue };
            let seconds = clock() - since;
            // Told at once: what comes after may be an abort.
            if seconds > LONGEST && told != Some(index) {
                told = Some(index);
                eprintln!("{}", shown(name, asked, index, &input(&seeds, words, asked.seed, index), "more than 5 s"));
            }
            if seconds > HOPELESS {
                eprintln!("{name}: number {index} is not waited for");
                std::process::exit(1);
            }
        }
        worker.join().unwrap()
    })
}

#[test]
fn no_input_panics_hangs_or_takes_much_memory() {
    let (asked, words) = (Asked::read(), dictionary(include_str!("../../fuzz/sneddon.dict")));
    let only = env::var("FUZZ_TARGET").ok();
    let mut faults = Vec::new();
    for target in TARGETS {
        if only.as_deref().is_some_and(|only| only != target.0) {
            continue;
        }
        let tally = attack(target, asked, &words);
        println!(
            "{}: {} executions, the slowest {:.2} s, {} faults, at most {:.0} MB",
            target.0,
            tally.executions,
            tally.slowest,
            tally.faults.len(),
            peak()
        );
        faults.extend(tally.faults);
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}
