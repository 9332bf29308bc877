"""Files to values and back: safe reading, errors with lines, one JSON Schema per value."""
