"""The paper's fleet and missions, ready to plan."""
