"""Small missions tried out to the end: a proof that needs no solver."""
