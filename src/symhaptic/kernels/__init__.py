"""The package's numeric functions in closed form: NumPy in, NumPy out, nothing symbolic."""
