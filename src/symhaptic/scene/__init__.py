"""What do I have?  A device in SI units, with its arm, its delay and its wall.

* ``scene``, ``loop``, ``arms``: `Scene`: its methods, its fields and their checks, the arm
* ``walls``: stability, passivity and delay margin of walls: asks ``numeric``, or ``loops`` if the
  scene has further parts
* ``limit``, ``damping``, ``safe``: what the methods return
* ``dimensionless``: alpha, beta, gamma, delta and d of a scene
* ``device_file``: a scene from a TOML file
* ``chart``, ``picture``, ``words``: results as pictures, whose colours are in ``picture``, and text
* ``simulation``, ``controller``, ``systems``: motion over time, C for a controller, other tools
* ``callables``: a formula as a function

Imports most rooms above; used by ``sweeps`` and ``cli``.
"""
