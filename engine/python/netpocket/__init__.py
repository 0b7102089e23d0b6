"""Netpocket: simulates the capture of space debris with a netted pocket, and cables of any kind.

    import netpocket
    scenario = netpocket.Scenario()
    scenario["closing.duration"] = 8
    simulation = netpocket.Simulation(scenario)
    simulation.advance(5)
    print(simulation.snapshot()["mouth_radius"])

SI units. The world's Y axis is the pocket's axis; the mouth opens towards +Y.
"""

from importlib.util import find_spec as _find_spec

from ._engine import (
    BodyState,
    Body,
    Channel,
    Commands,
    ContactPoint,
    Energies,
    Measurements,
    MemoryRun,
    Model,
    Parameter,
    Recording,
    RunStatistics,
    RunStatus,
    Scenario,
    Simulation,
    Snapshot,
    Structure,
    System,
    __version__,
    advance_all,
    load,
    loads,
    parameters,
    record,
)
from .environment import Env, VectorEnv
from .errors import DivergedError, FileError, Problem, RecordingError, ScenarioError
from .tables import run_many, study_table, table

if _find_spec("netpocket._pictures") is not None:  # else built without pictures
    from .pictures import Figure, Picture, figure, figure_names, render

__all__ = [
    "Body", "BodyState", "Channel", "Commands", "ContactPoint", "DivergedError", "Energies", "Env", "Figure", "FileError",
    "Measurements", "MemoryRun", "Model", "Parameter", "Picture", "Problem", "Recording",
    "RecordingError", "RunStatistics", "RunStatus", "Scenario", "ScenarioError", "Simulation", "Snapshot", "Structure", "System",
    "VectorEnv", "advance_all", "figure", "figure_names", "load", "loads", "parameters", "record", "render", "run_many",
    "study_table", "table",
]
