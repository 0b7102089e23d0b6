import copy
import math
import pickle

import numpy
import pytest

import netpocket


def test_every_parameter_can_be_read_and_set_to_what_it_is(scenario):
    before = scenario.text()
    for key in scenario:
        scenario[key] = scenario[key]
    assert scenario.text() == before
    assert len(scenario) == len(scenario.keys()) == len(netpocket.parameters()) > 80


def test_the_table_says_unit_help_and_limits(scenario):
    parameter = scenario.parameter("net.diameter")
    assert (parameter.unit, parameter.type) == ("m", "number")
    assert parameter.minimum < scenario["net.diameter"] < parameter.maximum
    assert parameter.help and "net.diameter" in repr(parameter)
    assert "cycloid" in scenario.parameter("closing.law").choices


def test_values_of_every_kind(scenario):
    scenario["closing.duration"] = numpy.float64(7.5)
    scenario["pocket.mesh_rows"] = numpy.int32(3)
    scenario["contact.cords"] = False
    scenario["closing.law"] = "quintic"
    scenario["target.position"] = numpy.array([0, 8, 0.5])
    scenario["rods.profile"] = [(0.6, 0), (4.8, 5.3), (7.5, 12)]
    scenario.apply("net.diameter=0.006")
    again = netpocket.loads(scenario.text())
    assert again == scenario
    assert again["target.position"] == (0, 8, 0.5)
    assert again["net.diameter"] == 0.006


@pytest.mark.parametrize("key, value, says", [
    ("closing.duration", "fast", "closing.duration takes a number in s, not 'fast'"),
    ("closing.duration", True, "not True"),
    ("pocket.mesh_rows", 2.5, "whole number"),
    ("contact.cords", 1, "not 1"),
    ("closing.law", "cyclod", "one of"),
    ("target.position", (1, 2), "three numbers"),
    ("target.position", "abc", "three numbers"),
    ("target.position", None, "three numbers"),
    ("rods.profile", [(1, 2, 3)], "not"),
    ("name", 5, "not 5"),
])
def test_values_of_the_wrong_kind_are_type_errors(scenario, key, value, says):
    before = scenario.text()
    with pytest.raises(TypeError, match="(?s)" + says.replace("(", r"\(")):
        scenario[key] = value
    assert scenario.text() == before


@pytest.mark.parametrize("value", [-1, math.nan, math.inf, 1e9])
def test_values_beyond_the_limits_name_the_key(scenario, value):
    with pytest.raises(netpocket.ScenarioError) as error:
        scenario["closing.duration"] = value
    assert error.value.problems[0].key == "closing.duration"
    assert scenario["closing.duration"] == 10


def test_unknown_keys_name_the_nearest(scenario):
    for use in (lambda: scenario["closing.duratoin"], lambda: scenario.parameter("closing.duratoin")):
        with pytest.raises(KeyError, match="closing.duration"):
            use()
    with pytest.raises(KeyError, match="closing.duration"):
        scenario["closing.duratoin"] = 1
    assert "closing.duratoin" not in scenario and "closing.duration" in scenario


def test_problems_of_a_file_carry_file_line_and_key(tmp_path):
    path = tmp_path / "bad.toml"
    path.write_text('name = "bad"\n[net]\ndiametr = 0.01\n[closing]\nduration = -1\n')
    with pytest.raises(netpocket.ScenarioError) as error:
        netpocket.load(str(path))
    problems = error.value.problems
    assert [problem.line for problem in problems] == [3, 5]
    assert all(problem.file == str(path) for problem in problems)
    assert "diameter" in problems[0].message and problems[1].key == "closing.duration"
    assert str(path) + ":3" in str(error.value)
    assert pickle.loads(pickle.dumps(error.value)).problems == problems
    with pytest.raises(netpocket.ScenarioError, match="nothing.toml"):
        netpocket.load(str(tmp_path / "nothing.toml"))


def test_check_says_what_cannot_be_simulated(scenario):
    scenario.check()
    scenario["target.position"] = (4, 4, 0)
    with pytest.raises(netpocket.ScenarioError, match="overlaps"):
        scenario.check()
    with pytest.raises(netpocket.ScenarioError, match="overlaps"):
        netpocket.Simulation(scenario)


def test_copies_are_independent(scenario):
    for other in (scenario.copy(), copy.copy(scenario), copy.deepcopy(scenario), pickle.loads(pickle.dumps(scenario))):
        assert other == scenario
        other["closing.duration"] = 3
        assert other != scenario and scenario["closing.duration"] == 10


def test_items_of_lists_are_reached_by_their_number():
    scenario = netpocket.loads('[[controller]]\nkind = "attitude_pd"\nrate = 20\n')
    assert scenario["controller.0.rate"] == 20 and "controller.0.rate" in scenario.keys()
    scenario["controller.0.rate"] = 50
    assert netpocket.loads(scenario.text())["controller.0.rate"] == 50
    with pytest.raises(KeyError):
        scenario["controller.1.rate"]


def test_shipped_scenarios_load():
    import os
    import pathlib

    files = sorted(pathlib.Path(os.environ["NETPOCKET_SOURCE"], "scenarios").glob("*.toml"))
    assert len(files) > 3
    for file in files:
        netpocket.load(str(file)).check()
