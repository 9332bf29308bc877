"""The report: one HTML file that holds everything about a plan and needs nothing beside it."""
