//! The trusted part: what it accepts, what it refuses, and in what words.

mod best;
mod reject;
mod theorem;
