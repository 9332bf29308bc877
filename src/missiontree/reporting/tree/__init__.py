"""The picture of a mission tree: layout, cards, links, and what is lit, as SVG and as text."""
