"""Mission methods: what is said in a certain way is done in certain steps."""
