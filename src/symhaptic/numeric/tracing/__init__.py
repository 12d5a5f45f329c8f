"""Where do stable walls end?  Regions, extremes and delay margins in numbers.

* ``margin``: `max_delay` and `delay_margin`
* ``losses``, ``bands``, ``periods``, ``directions``, ``loops``: how a delay margin is found
* ``extremes``: `max_stable_stiffness`, and the limits at a damping or a stiffness
* ``region``, ``arcs``, ``sides``, ``corners``, ``shape``, ``output``: the stable region
* ``robust``: walls that no spring destabilises
* ``grid``: the paper's own method, to compare with
"""
