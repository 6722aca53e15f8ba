"""Run all benchmarks: `python -m tests.benchmarks`."""

from tests.benchmarks import (
    accuracy,
    arrays,
    controllers,
    cortex_m4,
    dynamics,
    gufuncs,
    header_kernels,
    many_elements,
    python_calls,
    rounding_statements,
    scene_calls,
    scene_lanes,
    scene_tiers,
    sweeps,
    tiers,
)

header_kernels.main()
many_elements.main()
gufuncs.main()
tiers.main()
scene_tiers.main()
scene_calls.main()
scene_lanes.main()
arrays.main()
sweeps.main()
python_calls.main()
controllers.main()
cortex_m4.main()
rounding_statements.main()
accuracy.main()
dynamics.main()
