"""The command line: `main` (entry and exit codes), `options`, `output` (printing), and one file per command in `commands`."""
