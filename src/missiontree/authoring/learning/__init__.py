"""A mission tree to a method: generalised over its entities, and tried before it is handed out."""
