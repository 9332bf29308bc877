"""The reading of plain English: words, clauses, who is meant, what is asked for."""
