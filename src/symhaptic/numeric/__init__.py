"""The package's numeric functions: arguments checked, generated kernels called."""
