"""First on the path, this hides NumPy from the package and from programs that the tests start."""

raise ImportError("hidden by the tests")
