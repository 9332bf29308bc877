"""Language models behind one protocol, and the stand-ins that ship with it."""
