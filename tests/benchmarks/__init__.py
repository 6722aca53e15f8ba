"""Benchmarks: programs that print tables.  `make bench` runs them all."""
