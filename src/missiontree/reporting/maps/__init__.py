"""The picture of the scene: places, ways, things, and the robots' routes, as SVG."""
