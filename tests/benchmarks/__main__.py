"""Run all benchmarks: `python -m tests.benchmarks`."""

from tests.benchmarks import accuracy, dynamics, gufuncs, header_kernels, tiers

header_kernels.main()
gufuncs.main()
tiers.main()
accuracy.main()
dynamics.main()
