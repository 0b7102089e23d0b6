"""A sweep over the radius of the target: which is caught, and how hard is it pushed?

    python3 sweep.py
"""

import numpy

import netpocket

radii = numpy.linspace(3.3, 4.5, 4)
scenarios = []
for radius in radii:
    scenario = netpocket.Scenario()
    scenario["pocket.elements_per_side"] = 1
    scenario["target.radius"] = radius
    scenario["output.end_time"] = 11
    scenarios.append(scenario)

for radius, run in zip(radii, netpocket.run_many(scenarios)):
    push = numpy.sqrt(sum(run.channels[f"contact_f{axis}"] ** 2 for axis in "xyz"))
    print(f"radius {radius:.2f} m: inside {run.channels['target_inside'][-1]:.0f}, largest push {push.max():6.1f} N")
