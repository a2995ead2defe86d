"""The version of this package, that of include/tetloft/version.hpp (a test compares them)."""

__version__ = "0.1.0"
