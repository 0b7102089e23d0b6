"""Captures as environments for reinforcement learning: reset, step, observation, action, reward.

The shape is that of the Gymnasium interface (reset(seed=...) -> observation, info; step(action) -> observation, reward,
terminated, truncated, info). No learning library is needed.
"""

from __future__ import annotations

import os
from typing import Any, Callable, Mapping, NamedTuple, Optional, Sequence

import numpy
import numpy.typing

from . import _engine
from .errors import DivergedError

Array = numpy.typing.NDArray[numpy.float64]


class Box(NamedTuple):
    """The numbers that an observation or an action may hold."""

    low: Array
    high: Array

    @property
    def shape(self) -> tuple[int, ...]:
        return self.low.shape

    def sample(self, generator: numpy.random.Generator) -> Array:
        """An evenly distributed value. Unlimited numbers are drawn from -1 to 1."""
        low = numpy.where(numpy.isfinite(self.low), self.low, -1.0)
        high = numpy.where(numpy.isfinite(self.high), self.high, 1.0)
        return generator.uniform(low, high)


_OBSERVED = (
    "target_x", "target_y", "target_z", "target_vx", "target_vy", "target_vz",
    "spacecraft_x", "spacecraft_y", "spacecraft_z", "spacecraft_vx", "spacecraft_vy", "spacecraft_vz",
    "mouth_radius", "closing_length", "closing_speed", "rope_tension_max",
    "contact_fx", "contact_fy", "contact_fz", "target_inside",
)  # fmt: skip


def capture_terms(before: _engine.Snapshot, after: _engine.Snapshot) -> dict[str, float]:
    """Terms of the usual reward: closing the mouth round the target, gently.

    closed: how much narrower the mouth has become, m; inside: 1 while the target is inside, else 0; tension: largest
    rope tension, -kN; push: contact force on the target, -kN.
    """
    push = float(numpy.linalg.norm([after["contact_fx"], after["contact_fy"], after["contact_fz"]]))
    return {
        "closed": before["mouth_radius"] - after["mouth_radius"],
        "inside": after["target_inside"],
        "tension": -1e-3 * after["rope_tension_max"],
        "push": -1e-3 * push,
    }


class Env:
    """One capture. The action is held between steps: the rate of the closing ropes (m/s, negative winds in) and the
    force on the spacecraft (N, world axes).

    `interval`: simulated seconds of a step. `weights`: of the reward's terms, by name. `scatter`: changes the scenario
    of an episode from a random generator; the run is then built anew at each reset, else it is restored to its first
    state, to the last bit.
    """

    def __init__(
        self,
        scenario: Optional[_engine.Scenario] = None,
        *,
        interval: float = 0.1,
        most_rate: float = 1.5,
        most_force: float = 50.0,
        weights: Optional[Mapping[str, float]] = None,
        terms: Callable[[_engine.Snapshot, _engine.Snapshot], Mapping[str, float]] = capture_terms,
        scatter: Optional[Callable[[_engine.Scenario, numpy.random.Generator], None]] = None,
    ) -> None:
        self.scenario = scenario.copy() if scenario is not None else _engine.Scenario()
        self.interval = interval
        self.weights = dict(weights) if weights is not None else {"closed": 1.0, "inside": 0.1, "tension": 0.1, "push": 0.1}
        self._terms = terms
        self._scatter = scatter
        self._generator = numpy.random.default_rng()
        limits = numpy.array([most_rate, most_force, most_force, most_force])
        self.action_space = Box(-limits, limits)
        unlimited = numpy.full(len(_OBSERVED), numpy.inf)
        self.observation_space = Box(-unlimited, unlimited)
        self._start(self.scenario)

    def _start(self, scenario: _engine.Scenario) -> None:
        self.simulation = _engine.Simulation(scenario)
        self._hold(numpy.zeros(4))
        self._first = self.simulation.checkpoint()
        self._end = float(scenario["output.end_time"])

    def _hold(self, action: Array) -> None:
        self.simulation.wind(None, float(action[0]))
        self.simulation.set_force("spacecraft", action[1:4])

    def _observe(self) -> Array:
        return numpy.array([self.last[name] for name in _OBSERVED])

    def reset(self, *, seed: Optional[int] = None) -> tuple[Array, dict[str, Any]]:
        """Begins an episode. `seed`: of the scatter."""
        if seed is not None:
            self._generator = numpy.random.default_rng(seed)
        if self._scatter is not None:
            scenario = self.scenario.copy()
            self._scatter(scenario, self._generator)
            self._start(scenario)
        else:
            self.simulation.restore(self._first)
        self.last = self.simulation.snapshot()
        return self._observe(), {}

    def command(self, action: Sequence[float]) -> float:
        """Takes an action, within its limits. Returns the time (s) at which the step ends."""
        values = numpy.asarray(action, dtype=float)
        if values.shape != self.action_space.shape or not numpy.isfinite(values).all():
            raise ValueError(f"an action is {self.action_space.shape[0]} finite numbers, not {action!r}")
        self._hold(numpy.clip(values, self.action_space.low, self.action_space.high))
        return min(self.simulation.time + self.interval, self._end)

    def outcome(self, diverged: bool = False) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """What step() returns, once the simulation has been advanced."""
        before, self.last = self.last, self.simulation.snapshot()
        terms = dict(self._terms(before, self.last))
        reward = float(sum(self.weights.get(name, 0.0) * value for name, value in terms.items()))
        truncated = self.simulation.time > self._end - 1e-6
        return self._observe(), reward, diverged, truncated, {"terms": terms, "time": self.simulation.time}

    def step(self, action: Sequence[float]) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Holds an action for one interval. `terminated` says that the run has diverged."""
        until = self.command(action)
        try:
            self.simulation.advance(until)
        except DivergedError:
            return self.outcome(diverged=True)
        return self.outcome()


class VectorEnv:
    """Many captures side by side on several threads. Arrays have one row for each. An episode that ends is not begun
    anew by itself: reset(only=...) does that."""

    def __init__(self, environments: Sequence[Env], threads: Optional[int] = None) -> None:
        self.environments = list(environments)
        self.threads = threads or os.cpu_count() or 1

    def __len__(self) -> int:
        return len(self.environments)

    def reset(self, *, seed: Optional[int] = None, only: Optional[Sequence[int]] = None) -> Array:
        """Begins episodes and returns the observations of all. Environment i gets the seed `seed` + i."""
        for i in range(len(self)) if only is None else only:
            self.environments[i].reset(seed=None if seed is None else seed + i)
        return numpy.stack([env._observe() for env in self.environments])

    def step(self, actions: numpy.typing.ArrayLike) -> tuple[Array, Array, numpy.typing.NDArray[numpy.bool_],
                                                             numpy.typing.NDArray[numpy.bool_], list[dict[str, Any]]]:
        """Steps all. Raises what a run raises, except that a diverged one ends its episode."""
        rows = numpy.asarray(actions, dtype=float)
        until = [env.command(row) for env, row in zip(self.environments, rows, strict=True)]
        try:
            _engine.advance_all([env.simulation for env in self.environments], until, self.threads)
            results = [env.outcome() for env in self.environments]
        except DivergedError:
            results = [env.outcome(diverged=env.simulation.time < end - 1e-3)
                       for env, end in zip(self.environments, until)]
        observations, rewards, terminated, truncated, infos = zip(*results)
        return (numpy.stack(observations), numpy.array(rewards), numpy.array(terminated), numpy.array(truncated),
                list(infos))
