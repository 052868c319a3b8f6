# Daily commands; `just` lists them.

# List the commands.
default:
    @just --list

# Does it compile? With the program, and the library alone.
check:
    cargo check --all-targets
    cargo check --no-default-features --lib

# Every test, or those whose name contains the filter.
test filter='':
    cargo test {{filter}}

# Lint and test what has changed since the last commit, or since REVISION.
quick revision='HEAD':
    .ci/quick {{revision}}

# Every test with the full number of cases, optimised; docs/adversaries.md has the record.
long filter='':
    SNEDDON_LONG=1 cargo test --release {{filter}}

# Write the tables and documents that depend on a rule, after it was added or changed (needs mpmath).
rule id:
    python3 tests/oracle/rule.py {{id}}

# The Python package and its tests, in an environment of its own.
python:
    python3 -m venv target/python-venv
    target/python-venv/bin/pip install "./python[test]"
    target/python-venv/bin/python -m pytest python/tests

# Format, then lint as strictly as the acceptance run.
lint:
    cargo fmt
    cargo clippy --all-targets -- -D warnings
    cargo clippy --no-default-features --lib -- -D warnings

# Write what the examples of the documents answer today below them.
examples:
    SNEDDON_WRITE=1 cargo test --test program docs::examples_run

# The API documentation, and the tests that hold the written documents to the program.
docs:
    RUSTDOCFLAGS="-D warnings" cargo doc --no-deps
    cargo test --test architecture --test program docs

# The benchmarks.
bench filter='':
    cargo bench -p sneddon-runs -- {{filter}}

# What accuracy costs, for eight profiles: docs/speed-and-accuracy.md with its plots.
tradeoff:
    cargo run --release -p sneddon-runs --bin speed_and_accuracy

# This crate and its peers at the same places, as one table.
peers:
    benches/peers/run | tee benches/peers/table.txt

# The catalogue of profiles with reference values of 40 digits, with its output.
catalogue:
    cargo test --test rules catalogue -- --nocapture

# Set derivations of the catalogue and of random profiles with pdfLaTeX, and with Typst if its Python package is installed.
publish count='100':
    cargo build --release
    python3 tests/oracle/adversary/publish.py target/release/sneddon --random {{count}}

# What must hold before a change is accepted.
ci:
    .ci/run
