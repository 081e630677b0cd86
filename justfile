# Recipes for people and for .ci/run. `just` lists them.

export CARGO_TERM_COLOR := "never"
set shell := ["bash", "-euo", "pipefail", "-c"]

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

# The README's first command, twice, and the tables and nets beside it give the committed bytes.
bytes:
    cargo run --release --quiet -- | head -n 1
    cargo run --release --quiet >/dev/null
    for polygon in cube rhombic-dodecahedron deltoidal-icositetrahedron octant; do \
        target/release/prove-cap degrees "$polygon" | head -n 1; done
    target/release/prove-cap construct --bidegree 4 4 --centre "sqrt(6) - sqrt(2)" | head -n 1
    git diff --exit-code -- proofs

# The checker alone replays every committed proof, and a second checker, in Python, says the same of every file.
replay:
    cargo build --release -p prove-cap-kernel
    scripts/replay target/release/prove-cap-check
    python3 checkers/python/test_page.py
    python3 checkers/python/agree.py target/release/prove-cap-check

# Coq and computer-algebra systems verify every proof and refuse a damaged copy of each; with names, those are required.
outside *required:
    cargo build --release
    scripts/outside {{ if required == "" { "" } else { "--require " + required } }} target/release/prove-cap

# The audit of the paper as LaTeX compiles, and is read back to the true coefficients (needs pdflatex).
latex:
    cargo build --release
    mkdir -p target/latex
    target/release/prove-cap audit --format latex >target/latex/audit.tex || [ $? = 1 ]
    cd target/latex && pdflatex -interaction=nonstopmode -halt-on-error audit.tex >/dev/null
    target/release/prove-cap audit target/latex/audit.tex --statement cap-2x2 | head -n 1 | tee target/latex/verdict
    grep -q '^AGREES  all 16' target/latex/verdict

# Long tests.
long:
    cargo test --release -- --ignored

# The examples run.
examples:
    cargo run --quiet --example expand_a_patch
    cargo run --quiet --example prove_a_statement >/dev/null
    cargo run --quiet --example check_a_certificate

# The prover with GMP gives the same proofs, long tests included (needs libgmp-dev, libmpfr-dev and m4).
gmp:
    cargo clippy --all-targets --features gmp -- -D warnings
    cargo test --release --features gmp -- --include-ignored

# The fuzz targets build (they are run with cargo-fuzz).
fuzz-builds:
    cargo check --quiet --manifest-path fuzz/Cargo.toml --target-dir target/fuzz

# The benchmarks build.
bench-builds:
    cargo bench --no-run --quiet
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
