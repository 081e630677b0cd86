"""An independent checker of statements and certificates, written from FORMAT.md alone."""
