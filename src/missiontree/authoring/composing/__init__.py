"""Several understood clauses to one outline of a tree: choices, order, and the searches that follow from what is lost."""
