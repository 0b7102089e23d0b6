import gc
import os
import signal
import sys
import threading
import time

import numpy
import pytest

import netpocket


def test_equals_the_recorded_run_to_the_last_bit(scenario, recording_path):
    recording = netpocket.Recording(str(recording_path))
    simulation = netpocket.Simulation(scenario)
    for index, moment in enumerate(recording.times):
        if moment > 0:
            simulation.advance(moment)
        snapshot = simulation.snapshot()
        for name in ("mouth_radius", "energy_kinetic", "closing_length"):
            assert snapshot[name] == recording[name][index]


def test_advance_does_not_depend_on_how_it_is_divided(scenario):
    whole, parts = netpocket.Simulation(scenario), netpocket.Simulation(scenario)
    whole.advance(0.7)
    for moment in (0.1, 0.23, 0.5, 0.7):
        parts.advance(moment)
    assert (whole.checkpoint()[:500] == parts.checkpoint()[:500]).all()
    parts.step(3)
    assert parts.time > whole.time


def test_checkpoints_continue_to_the_last_bit(scenario):
    first = netpocket.Simulation(scenario)
    first.advance(0.3)
    state = first.checkpoint()
    first.advance(0.6)
    second = netpocket.Simulation(scenario)
    second.restore(state)
    second.advance(0.6)
    assert (second.snapshot().positions == first.snapshot().positions).all()
    with pytest.raises(ValueError, match="another size"):
        second.restore(state[:-1])
    with pytest.raises(TypeError):
        second.restore("state")
    with pytest.raises(ValueError):
        second.restore(numpy.full(state.shape, numpy.nan))


def test_views_keep_their_owner_and_nothing_more(scenario):
    snapshot = netpocket.Simulation(scenario).snapshot()
    references = sys.getrefcount(snapshot)
    positions, tension = snapshot.positions, snapshot.tension
    assert sys.getrefcount(snapshot) == references + 2
    values = positions.copy()
    del snapshot
    gc.collect()
    assert (positions == values).all()
    with pytest.raises(ValueError):
        positions[0, 0] = 1
    assert tension.shape[0] > 100


def test_other_threads_run_while_it_advances(scenario):
    simulation = netpocket.Simulation(scenario)
    done = threading.Event()
    counted = 0

    def advance():
        simulation.advance(20)
        done.set()

    worker = threading.Thread(target=advance)
    worker.start()
    while not done.is_set():
        counted += 1
        time.sleep(0.0005)
    worker.join()
    assert counted > 5


def test_two_threads_at_one_simulation_get_an_error_and_no_crash(scenario):
    simulation = netpocket.Simulation(scenario)
    entered, released = threading.Event(), threading.Event()

    def wait(seen, interval, commands):
        entered.set()
        released.wait(60)

    simulation.add_controller(wait, rate=10)
    worker = threading.Thread(target=lambda: simulation.advance(0.3))
    worker.start()
    assert entered.wait(60)
    for use in (simulation.snapshot, simulation.checkpoint, lambda: simulation.advance(1), lambda: simulation.step()):
        with pytest.raises(RuntimeError, match="another thread"):
            use()
    released.set()
    worker.join()
    simulation.advance(0.4)


def test_controllers_are_called_at_their_rate_and_their_commands_act(scenario):
    simulation = netpocket.Simulation(scenario)
    index = [body.name for body in simulation.structure.bodies].index("spacecraft")
    times = []

    def push(seen, interval, commands):
        assert interval == pytest.approx(0.02)
        times.append(seen.time)
        commands.force(index, force=(0, 0, 100))

    simulation.add_controller(push, rate=50)
    simulation.advance(1)
    assert len(times) == 50
    assert numpy.diff(times) == pytest.approx(numpy.full(49, 0.02), abs=1e-3)
    speed = simulation.snapshot().bodies[index].velocity[2]
    assert 0.5 * 100 / 1234 < speed < 1.05 * 100 / 1210  # mass of the spacecraft, and with the pocket


def test_ropes_follow_a_commanded_rate(scenario):
    scenario["closing.start"] = 100
    simulation = netpocket.Simulation(scenario)
    begin = simulation.snapshot()["commanded_length"]
    simulation.wind(None, rate=-0.4, acceleration=2)
    simulation.advance(1)
    # An acceleration of 2 m/s^2 reaches 0.4 m/s after 0.2 s and 0.04 m.
    assert simulation.snapshot()["commanded_length"] == pytest.approx(begin - 0.04 - 0.8 * 0.4, abs=2e-3)
    with pytest.raises(IndexError):
        simulation.wind(99, rate=0)
    with pytest.raises(ValueError):
        simulation.wind(None, rate=float("nan"))
    with pytest.raises(ValueError):
        simulation.wind(None, rate=1, acceleration=0)


class Counter:
    def __init__(self):
        self.state = numpy.zeros(2)

    def update(self, seen, interval, commands):
        self.state += (1, seen.time)


def test_the_state_of_a_controller_belongs_to_the_run(scenario):
    simulation, counter = netpocket.Simulation(scenario), Counter()
    simulation.add_controller(counter, rate=20)
    simulation.advance(0.5)
    state, counted = simulation.checkpoint(), counter.state.copy()
    simulation.advance(1)
    after = counter.state.copy()
    simulation.restore(state)
    assert (counter.state == counted).all()
    simulation.advance(1)
    assert (counter.state == after).all() and after[0] == 20


def test_what_a_controller_raises_leaves_advance_and_the_run_goes_on(scenario):
    simulation = netpocket.Simulation(scenario)
    fails = True

    def controller(seen, interval, commands):
        if seen.time > 0.2 and fails:
            raise LookupError("no target in sight")

    simulation.add_controller(controller, rate=10)
    with pytest.raises(LookupError, match="no target in sight"):
        simulation.advance(1)
    assert 0.2 < simulation.time < 0.35
    fails = False
    simulation.advance(1)
    other = netpocket.Simulation(scenario)
    other.advance(1)
    assert (simulation.snapshot().positions == other.snapshot().positions).all()


def test_measurements_end_with_the_call(scenario):
    simulation, kept = netpocket.Simulation(scenario), []
    simulation.add_controller(lambda seen, interval, commands: kept.append(seen), rate=10)
    simulation.advance(0.1)
    with pytest.raises(RuntimeError, match="only during the call"):
        kept[0].time


@pytest.mark.parametrize("controller, rate, error", [
    (5, 100, TypeError), (None, 100, TypeError), (lambda *a: None, -1, ValueError),
    (lambda *a: None, float("nan"), ValueError),
])
def test_wrong_controllers(scenario, controller, rate, error):
    with pytest.raises(error):
        netpocket.Simulation(scenario).add_controller(controller, rate=rate)


def test_a_controller_with_a_state_of_the_wrong_kind(scenario):
    counter = Counter()
    for state in ([0.0], numpy.zeros(3, dtype=int), numpy.zeros((4, 4))[:, 1]):
        counter.state = state
        with pytest.raises(TypeError, match="float64"):
            netpocket.Simulation(scenario).add_controller(counter)


def test_wrong_arguments_of_commands(scenario):
    simulation = netpocket.Simulation(scenario)
    with pytest.raises(IndexError, match="spacecraft"):
        simulation.set_force("ship", (0, 0, 1))
    with pytest.raises(ValueError):
        simulation.set_force("spacecraft", (0, 0, float("inf")))
    with pytest.raises(TypeError):
        simulation.set_force("spacecraft", (0, 0))
    for until in (float("nan"), float("inf")):
        with pytest.raises(ValueError):
            simulation.advance(until)
    with pytest.raises(ValueError):
        simulation.step(-1)


def test_control_c_stops_at_a_whole_step(scenario):
    simulation = netpocket.Simulation(scenario)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    previous = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            simulation.advance(1e5)
    finally:
        signal.signal(signal.SIGALRM, previous)
    reached = simulation.time
    assert 0 < reached < 1e5
    simulation.step()
    assert simulation.time > reached


def test_a_forked_child_can_go_on(scenario):
    simulation = netpocket.Simulation(scenario)
    simulation.advance(0.2)
    child = os.fork()
    if child == 0:
        simulation.advance(0.4)
        os._exit(0 if abs(simulation.time - 0.4) < 1e-3 else 1)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    simulation.advance(0.4)


def test_divergence_names_step_and_remedy(scenario):
    step = netpocket.Simulation(scenario).statistics.time_step
    scenario["solver.time_step"] = 5 * step
    simulation = netpocket.Simulation(scenario)
    with pytest.raises(netpocket.DivergedError, match="solver.time_step"):
        simulation.advance(1)
    assert numpy.isfinite(simulation.snapshot().positions).all()


def test_a_change_of_strategy_tells_what_needs_a_new_run(scenario):
    simulation = netpocket.Simulation(scenario)
    simulation.advance(0.2)
    other = simulation.scenario
    other["closing.duration"] = 6
    other["target.radius"] = 3
    assert simulation.change_strategy(other) == ["target.radius"]
    assert simulation.scenario["closing.duration"] == 6


def test_runs_in_memory_do_not_depend_on_jobs(scenario):
    scenarios = []
    for duration in (2, 3, 4):
        scenarios.append(scenario.copy())
        scenarios[-1]["closing.duration"] = duration
    one, two = netpocket.run_many(scenarios, jobs=1), netpocket.run_many(scenarios, jobs=3)
    for a, b in zip(one, two):
        assert a.status.reason == "finished"
        assert all((a.channels[name] == b.channels[name]).all() for name in a.channels if name != "time_step")
    assert one[0].channels["mouth_radius"][-1] < one[2].channels["mouth_radius"][-1]
    scenarios[1]["target.position"] = (4, 4, 0)
    with pytest.raises(netpocket.ScenarioError):
        netpocket.run_many(scenarios)
    with pytest.raises(ValueError):
        netpocket.run_many(scenarios[:1], jobs=-1)


def test_control_c_stops_many_runs(scenario):
    scenario["output.end_time"] = 1e4
    previous = signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, 0.5)
    begin = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt):
            netpocket.run_many([scenario, scenario])
    finally:
        signal.signal(signal.SIGALRM, previous)
    assert time.monotonic() - begin < 60
