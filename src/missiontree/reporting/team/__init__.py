"""Alternatives side by side: who does what, what it yields and takes."""
