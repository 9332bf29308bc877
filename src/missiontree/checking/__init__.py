"""Plan to findings, by code that shares nothing with the solvers."""
