"""A first capture: change a parameter, run, look at numbers and pictures.

    python3 first_capture.py FOLDER
"""

import pathlib
import sys

import netpocket

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")

scenario = netpocket.Scenario()  # case 1 of Tang et al. (2023)
scenario["pocket.elements_per_side"] = 1  # coarse and fast
scenario["closing.duration"] = 8
scenario["output.end_time"] = 10
duration = scenario.parameter("closing.duration")
print(f"closing.duration ({duration.unit}): {duration.help}")

path = folder / "first.h5"
status = netpocket.record(scenario, str(path), overwrite=True)
recording = netpocket.Recording(str(path))
print(f"{status.message}: {status.time:.2f} s in {len(recording)} frames")

force = recording["contact_fy"]
print(f"largest push on the target along the axis: {force.min():.1f} N at t = {recording.times[force.argmin()]:.2f} s")
print(f"radius of the mouth: {recording['mouth_radius'][0]:.2f} m before, {recording['mouth_radius'][-1]:.2f} m after")

netpocket.render(recording, time=5, size=(960, 540), color_by="tension").save(folder / "first.png")
(folder / "first_force.svg").write_bytes(netpocket.figure(recording, "figure05_force"))
