"""A random policy in many environments side by side, as a learning loop would step them.

    python3 random_policy.py [ENVIRONMENTS] [STEPS]
"""

import sys
import time

import numpy

import netpocket

count = int(sys.argv[1]) if len(sys.argv) > 1 else 100
steps = int(sys.argv[2]) if len(sys.argv) > 2 else 10

scenario = netpocket.Scenario()
scenario["pocket.mesh_columns"] = scenario["pocket.mesh_rows"] = 2
scenario["pocket.elements_per_side"] = 1
scenario["closing.start"] = 100  # the policy closes the mouth


def scatter(changed: netpocket.Scenario, generator: numpy.random.Generator) -> None:
    changed["target.radius"] = generator.uniform(3, 4.5)


environments = netpocket.VectorEnv([netpocket.Env(scenario, scatter=scatter) for _ in range(count)])
generator = numpy.random.default_rng(0)
observations = environments.reset(seed=0)
begin = time.perf_counter()
total = numpy.zeros(count)
for _ in range(steps):
    actions = numpy.stack([env.action_space.sample(generator) for env in environments.environments])
    observations, rewards, terminated, truncated, infos = environments.step(actions)
    total += rewards
seconds = time.perf_counter() - begin
print(f"{count} environments, {steps} steps each: {count * steps / seconds:.0f} steps a second")
print(f"observations {observations.shape}, mean reward {total.mean():.3f}, {terminated.sum()} diverged")
