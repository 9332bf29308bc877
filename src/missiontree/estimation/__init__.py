"""How well, how long and how far: what one robot needs for one action in this scene."""
