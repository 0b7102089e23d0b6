"""A controller of one's own: holds the spacecraft where it is with a PD law, called 50 times a simulated second.

    python3 own_controller.py
"""

import numpy

import netpocket


class HoldPosition:
    """Force = -k (x - x0) - d v, at most `most` N. The array `state` is saved and restored with the run."""

    def __init__(self, body: int, stiffness: float = 200.0, damping: float = 500.0, most: float = 40.0) -> None:
        self.body, self.stiffness, self.damping, self.most = body, stiffness, damping, most
        self.state = numpy.full(3, numpy.nan)  # x0, m

    def update(self, seen: netpocket.Measurements, interval: float, commands: netpocket.Commands) -> None:
        body = seen.body(self.body)
        if numpy.isnan(self.state).any():
            self.state[:] = body.position
        force = -self.stiffness * (body.position - self.state) - self.damping * body.velocity
        commands.force(self.body, force=numpy.clip(force, -self.most, self.most))


def drift(controlled: bool) -> float:
    """How far a target that escapes at 0.3 m/s has pulled the spacecraft after 20 s, m."""
    scenario = netpocket.Scenario()
    scenario["pocket.elements_per_side"] = 1
    scenario["target.velocity"] = (0, 0.3, 0)
    scenario["towing.mode"] = "none"
    simulation = netpocket.Simulation(scenario)
    names = [body.name for body in simulation.structure.bodies]
    spacecraft = names.index("spacecraft")
    if controlled:
        simulation.add_controller(HoldPosition(spacecraft), rate=50)
    begin = simulation.snapshot().bodies[spacecraft].position
    simulation.advance(20)
    return float(numpy.linalg.norm(simulation.snapshot().bodies[spacecraft].position - begin))


if __name__ == "__main__":
    free, held = drift(False), drift(True)
    print(f"the spacecraft is pulled {free:.2f} m when free, {held:.2f} m when held")
