"""Any value to something to look at."""
