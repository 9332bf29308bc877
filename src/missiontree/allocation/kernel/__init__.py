"""
The inner loops of the search, in the part of Python that can be compiled: plain loops over columns of integers.

One source serves two speeds. Handed lists, these functions are the reference; handed arrays and compiled
(:mod:`missiontree.allocation.compiled`), they take the same steps on the same numbers. Whatever decides is an integer; floats only
propose the next prices, by the same operations in the same order.
"""
