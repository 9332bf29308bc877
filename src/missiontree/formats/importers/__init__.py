"""Foreign files to our values, a file per form."""
