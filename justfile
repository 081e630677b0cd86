# Recipes for people and for .ci/run. `just` lists them.

default:
    @just --list

# The tests, as the README has them.
test:
    cargo test

# Formatting, lints, documentation.
lint:
    cargo fmt --check
    cargo clippy --workspace --all-targets -- -D warnings
    cargo clippy --lib --no-default-features -- -D warnings
    RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --quiet

# The checker alone replays every committed proof.
replay:
    cargo build --release -p prove-cap-kernel
    scripts/replay target/release/prove-cap-check
    python3 checkers/python/agree.py target/release/prove-cap-check

# Coq and the computer-algebra systems that are installed verify every proof; five minutes.
outside:
    cargo build --release
    scripts/outside target/release/prove-cap

# Long tests.
long:
    cargo test --release -- --ignored

# The examples run.
examples:
    cargo run --quiet --example expand_a_patch
    cargo run --quiet --example prove_a_statement
    cargo run --quiet --example check_a_certificate

# The prover with GMP gives the same proofs (needs libgmp-dev and libmpfr-dev).
gmp:
    cargo test --features gmp

# Everything that must be green before a change is handed in.
check: lint test replay examples

# Benchmarks of the library.
bench:
    cargo bench

# Whole processes side by side with Singular, SymPy and grobx, where they can be had; half an hour.
bench-peers: peers
    cargo build --release
    cargo build --release --features gmp --target-dir target/gmp
    benches/peers/run num=target/release/prove-cap gmp=target/gmp/release/prove-cap
    benches/peers/systems.py target/release/prove-cap
    hyperfine -N --warmup 1 "python3 benches/peers/grid.py" "target/release/prove-cap bound cap-2x2 --set w=0.467959158138040 --set z=2.370695072453977"
    for net in degrees-cube/4x2 construct-cube-4x4; do python3 benches/peers/nets.py proofs/$net/statement.toml; \
        hyperfine -N --warmup 1 "target/release/prove-cap check proofs/$net/statement.toml proofs/$net/certificate.txt"; done

# Installs the peers; what cannot be installed is `not run` later. grobx needs CPython 3.12.
peers:
    -command -v Singular hyperfine || apt-get install -y -qq singular-ui hyperfine
    -python3 -c "import sympy, numpy" || python3 -m pip install -q sympy numpy
    -${PYTHON312:-python3.12} -m pip install -q grobx
