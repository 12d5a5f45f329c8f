"""The program that calls a function in C: a process of its own, which the function may end.

It gets file, name and how many arguments and results there are, and reads doubles.  It writes a
plus sign where the function is found, or a minus sign and what is wrong, and then the results of
each point at once, so that who waits for them knows at which one the program has ended.
"""

from __future__ import annotations

import ctypes
import os
import struct
import sys


def main(file: str, name: str, arguments: int, results: int) -> None:
    """Call the function at every point; what it prints itself is for people, as errors are."""
    out = os.dup(1)
    os.dup2(2, 1)
    try:
        function = getattr(ctypes.CDLL(file), name)
    except (OSError, AttributeError) as wrong:
        os.write(out, f"-{wrong}".encode())
        return
    os.write(out, b"+")
    double = ctypes.c_double
    found = [double() for _ in range(results)]
    function.argtypes = [double] * arguments
    function.restype = double if results == 1 else None
    if results > 1:
        function.argtypes += [ctypes.POINTER(double)] * results
    one = struct.Struct(f"={results}d")
    for point in struct.iter_unpack(f"={arguments}d", sys.stdin.buffer.read()):
        if results == 1:
            os.write(out, one.pack(function(*point)))
        else:
            function(*point, *found)
            os.write(out, one.pack(*(o.value for o in found)))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
