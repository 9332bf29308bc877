"""The picture of a schedule: rows of robots over time, as SVG."""
