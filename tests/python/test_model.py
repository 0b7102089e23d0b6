import gc
import math
import threading

import numpy
import pytest

import netpocket


def pendulum() -> tuple[netpocket.Model, int]:
    model = netpocket.Model()
    cord = model.add_material(EA=1e4, EI=1e-3, mass_per_length=1e-3)
    hook = model.add_node((0, 0, 0), fixed=True)
    weight = model.add_node((2 * math.sin(0.1), -2 * math.cos(0.1), 0), mass=1)
    model.add_cable(hook, weight, 8, cord)
    model.gravity = (0, -9.81, 0)
    return model, weight


def test_a_pendulum_in_twenty_lines():
    model, weight = pendulum()
    system = netpocket.System(model)
    dt = 0.5 * system.stable_step()
    before = now = system.position(weight)
    while now[0] > 0 and system.time < 10:
        before = now
        system.step(dt)
        now = system.position(weight)
    passed = system.time - dt * now[0] / (now[0] - before[0])
    expected = 2 * math.pi * math.sqrt(2 / 9.81) * (1 + 0.1**2 / 16)
    assert 4 * passed == pytest.approx(expected, rel=2e-3)
    assert abs(system.energies().error) < 1e-3 * 9.81 * 0.01


def test_many_steps_at_once_are_the_same_steps():
    model, weight = pendulum()
    one, many = netpocket.System(model), netpocket.System(model)
    dt = 0.5 * one.stable_step()
    for _ in range(1000):
        one.step(dt)
    many.step(dt, 1000)
    assert many.time == one.time
    assert (many.position(weight) == one.position(weight)).all()


def test_a_cord_falls_on_a_sphere_and_stays_out():
    model = netpocket.Model()
    cord = model.add_material(EA=1e3, EI=1e-3, mass_per_length=0.02, radius=0.005, youngs_modulus=1e8)
    first, last = model.add_node((-1, 1.2, 0)), model.add_node((1, 1.2, 0))
    model.add_cable(first, last, 16, cord)
    ball = model.add_sphere("ball", radius=1, mass=1000)
    model.contact(friction=0.2)
    model.gravity = (0, -5, 0)
    system = netpocket.System(model)
    system.step(0.3 * system.stable_step(), 4000)
    snapshot = system.snapshot()
    distance = numpy.linalg.norm(snapshot.positions - snapshot.bodies[ball].position, axis=1)
    assert distance.min() > 0.99 and snapshot.positions.shape == (17, 3)


def test_an_orbit_drifts_as_clohessy_and_wiltshire_have_it():
    radius, above = 7e6, 1.0
    rate = math.sqrt(3.986004418e14 / radius**3)
    model = netpocket.Model()
    model.orbit("hill", perigee_radius=radius)  # x is H-bar, y V-bar: z points away from the Earth
    # At rest in the axes that turn with the orbit, by -rate about x.
    ball = model.add_sphere("ball", radius=0.1, mass=1, position=(0, 0, above), velocity=(0, rate * above, 0))
    system = netpocket.System(model)
    turn = 2 * math.pi / rate
    system.step(turn / 20_000, 20_000)
    position = system.body(ball).position
    assert position == pytest.approx([0, -12 * math.pi * above, above], abs=1e-3)
    with pytest.raises(ValueError, match="hill, two_body, two_body_j2"):
        model.orbit("circle")
    with pytest.raises(ValueError, match="right angles"):
        model.orbit(x_along="v_bar", y_along="minus_v_bar")


def test_faults_are_sentences():
    model, _ = pendulum()
    with pytest.raises(IndexError, match="no node 99"):
        model.add_cable(0, 99, 2, 0)
    with pytest.raises(IndexError, match="no material 3"):
        model.add_cable(0, 1, 2, 3)
    with pytest.raises(ValueError, match="at least one"):
        model.add_cable(0, 1, 0, 0)
    with pytest.raises(ValueError, match="coincide"):
        model.add_cable(0, 0, 1, 0)
    with pytest.raises(TypeError):
        model.add_node((1, 2))
    with pytest.raises(TypeError):
        model.add_node("abc")
    assert model.find_fault() is None
    loose = netpocket.Model()
    loose.add_material(EA=-1, EI=0, mass_per_length=1)
    loose.add_node((0, 0, 0)), loose.add_node((1, 0, 0))
    loose.add_cable(0, 1, 1, 0)
    assert loose.find_fault()
    with pytest.raises(ValueError):
        netpocket.System(loose)


def test_a_step_that_is_too_long_diverges_with_a_sentence():
    model, _ = pendulum()
    system = netpocket.System(model)
    with pytest.raises(netpocket.DivergedError, match="cable"):
        system.step(20 * system.stable_step(), 2000)


def test_views_keep_their_snapshot():
    model, weight = pendulum()
    positions = netpocket.System(model).snapshot().positions
    gc.collect()
    assert positions[weight] == pytest.approx([2 * math.sin(0.1), -2 * math.cos(0.1), 0])
    assert not positions.flags.writeable and not positions.flags.owndata


def test_two_threads_at_one_system_get_an_error_and_no_crash():
    model, weight = pendulum()
    system = netpocket.System(model)
    dt = 0.5 * system.stable_step()
    worker = threading.Thread(target=lambda: system.step(dt, 300_000))
    worker.start()
    refused = 0
    while worker.is_alive():
        try:
            system.position(weight)
        except RuntimeError as error:
            assert "another thread" in str(error)
            refused += 1
    worker.join()
    assert refused > 0
