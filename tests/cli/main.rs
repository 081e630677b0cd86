//! The program: word for word, under limits, killed, and its pictures.

mod crash;
mod figures;
mod limits;
mod readback;
mod sessions;
mod verdicts;
mod words;
