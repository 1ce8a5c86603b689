"""The command line: parse, call, print. Inside: `main` (entry and exit codes), `output` (what goes to stdout), one file a command."""
