"""Schedules by constraint programming (CP-SAT of OR-Tools), rebuilt and confirmed by our own means."""
