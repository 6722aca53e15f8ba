"""Run all benchmarks: `python -m tests.benchmarks`."""

from tests.benchmarks import (
    accuracy,
    cortex_m4,
    dynamics,
    gufuncs,
    header_kernels,
    scene_calls,
    scene_tiers,
    tiers,
)

header_kernels.main()
gufuncs.main()
tiers.main()
scene_tiers.main()
scene_calls.main()
cortex_m4.main()
accuracy.main()
dynamics.main()
