"""Run all benchmarks: `python -m tests.benchmarks`."""

from tests.benchmarks import accuracy, gufuncs, header_kernels, tiers

header_kernels.main()
gufuncs.main()
tiers.main()
accuracy.main()
