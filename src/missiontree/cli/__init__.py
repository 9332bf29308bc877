"""The command line: words come in, answers go out; no planning in here."""
