"""``python -m missiontree``."""

from missiontree.cli.main import main

main()
