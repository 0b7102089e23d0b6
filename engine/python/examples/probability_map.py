"""A small map of captures: the target's offset from the axis against its sideways speed, as a table of pandas.

    python3 probability_map.py [RUNS]
"""

import sys

import numpy
import pandas

import netpocket

count = int(sys.argv[1]) if len(sys.argv) > 1 else 12
generator = numpy.random.default_rng(1)
offsets, speeds = generator.uniform(0, 1.2, count), generator.uniform(-0.1, 0.1, count)


def scenario_of(offset: float, speed: float) -> netpocket.Scenario:
    scenario = netpocket.Scenario()
    scenario["pocket.elements_per_side"] = 1
    scenario["pocket.mesh_columns"] = scenario["pocket.mesh_rows"] = 3
    scenario["target.radius"] = 3
    scenario["target.position"] = (offset, 7.5, 0)
    scenario["target.velocity"] = (speed, 0, 0)
    scenario["output.end_time"] = 11
    scenario["output.frame_rate"] = 10
    return scenario


runs = netpocket.run_many([scenario_of(*pair) for pair in zip(offsets, speeds)])
table = pandas.DataFrame({
    "offset": offsets,
    "speed": speeds,
    "inside": [run.channels["target_inside"][-1] > 0 for run in runs],
    "mouth": [run.channels["mouth_radius"][-1] for run in runs],
})
table["caught"] = table.inside & (table.mouth < 3)
print(table.to_string(float_format="%.3f"))
print(f"{table.caught.sum()} of {count} are caught")
