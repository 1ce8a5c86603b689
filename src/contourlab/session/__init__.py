"""A session: from files to files. What a command does, without its parsing and printing."""
