"""Alternative to schedule."""
