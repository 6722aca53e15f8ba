"""Run all benchmarks: `python -m tests.benchmarks`."""

from tests.benchmarks import gufuncs, header_kernels

header_kernels.main()
gufuncs.main()
