"""The critical chain: what makes a schedule as long as it is."""
