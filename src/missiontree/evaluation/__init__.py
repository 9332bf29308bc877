"""Suites of missions whose right plans are known, and verdicts on what an author makes of them."""
