//! Work without the lock of the interpreter, and the documents it writes, which Ctrl-C ends.

use crate::error::Fault;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use sneddon::num::work;
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

/// How often signals are looked at.
const LOOK: Duration = Duration::from_millis(10);
/// The stack of the thread that works, as large as that of a main thread.
const STACK: usize = 8 << 20;

thread_local! {
    /// One flag for each thread that calls, kept for good.
    static STOP: &'static AtomicBool = Box::leak(Box::new(AtomicBool::new(false)));
}

/// Runs work in a thread of its own while this one looks at signals; an exception of a handler, such as `KeyboardInterrupt`, ends the work
/// and is raised.
pub(crate) fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let stop = STOP.with(|own| *own);
    let failed = |_| PyRuntimeError::new_err("no thread could be started");
    let (done, told) = (Mutex::new(false), Condvar::new());
    thread::scope(|scope| {
        let run = || {
            // Dropped where the work panics as well.
            let _told = Told(&done, &told);
            // The interpreter keeps its state of this thread for the whole work. Without it every call of a Python function would make and
            // discard one, with its stack, which takes ten times as long as a short function.
            Python::attach(|py| py.detach(|| work::stoppable(stop, work)))
        };
        let worker = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, run).map_err(failed)?;
        let mut raised = None;
        let is_done = || {
            let guard = done.lock().unwrap_or_else(PoisonError::into_inner);
            let waited = told.wait_timeout_while(guard, LOOK, |own| !*own);
            *waited.unwrap_or_else(PoisonError::into_inner).0
        };
        while raised.is_none() && !py.detach(is_done) {
            raised = py.check_signals().err();
            stop.store(raised.is_some(), Ordering::Relaxed);
        }
        let result = py.detach(|| worker.join());
        stop.store(false, Ordering::Relaxed);
        match (raised, result) {
            (Some(raised), _) => Err(raised),
            (None, Ok(result)) => Ok(result),
            (None, Err(panic)) => std::panic::resume_unwind(panic),
        }
    })
}

/// Says that the work is done, when it is dropped.
struct Told<'a>(&'a Mutex<bool>, &'a Condvar);

impl Drop for Told<'_> {
    fn drop(&mut self) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.1.notify_all();
    }
}

/// Returns a document as text; after Ctrl-C its rest is not written.
pub(crate) fn written<T>(write: impl FnOnce(&mut dyn Write) -> io::Result<T>) -> Result<String, Fault> {
    let mut out = UntilStopped(Vec::new());
    write(&mut out).map_err(|error| Fault::new(error.to_string()))?;
    Ok(String::from_utf8_lossy(&out.0).into_owned())
}

/// A buffer whose writes fail after Ctrl-C, so that the rest of a long document is not written.
struct UntilStopped(Vec<u8>);

impl Write for UntilStopped {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if work::is_stopped() { Err(io::Error::other("the work was stopped")) } else { self.0.write(bytes) }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
