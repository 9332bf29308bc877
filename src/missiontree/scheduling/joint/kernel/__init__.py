"""Inner loops over integers, which run as they stand or compiled; :mod:`missiontree.scheduling.joint.compiled` decides."""
