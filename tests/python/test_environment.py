import numpy
import pytest

import netpocket


@pytest.fixture
def passive(scenario):
    scenario["closing.start"] = 100
    return scenario


def episode(env, seed, steps=4):
    generator = numpy.random.default_rng(seed)
    rows = [env.reset(seed=seed)[0]]
    for _ in range(steps):
        observation, reward, terminated, truncated, info = env.step(env.action_space.sample(generator))
        rows.append(numpy.append(observation, reward))
    return numpy.concatenate(rows)


def test_reset_is_exact(passive):
    env = netpocket.Env(passive)
    assert (episode(env, 1) == episode(env, 1)).all()
    assert (episode(netpocket.Env(passive), 1) == episode(env, 1)).all()
    assert (episode(env, 2) != episode(env, 1)).any()


def test_scatter_follows_the_seed(passive):
    def scatter(scenario, generator):
        scenario["target.radius"] = generator.uniform(3, 4.5)
        scenario["target.mass"] = generator.uniform(100, 300)
        scenario["target.velocity"] = (0, -generator.uniform(0, 0.1), 0)

    env = netpocket.Env(passive, scatter=scatter)
    assert (episode(env, 1) == episode(env, 1)).all()
    assert (episode(env, 1)[:20] != episode(env, 2)[:20]).any()


def test_actions_act_and_episodes_end(passive):
    env = netpocket.Env(passive, interval=0.25)
    observation, _ = env.reset()
    begin = observation[13]  # closing_length
    for step in range(4):
        observation, reward, terminated, truncated, info = env.step([-0.5, 0, 0, 0])
        assert not terminated and truncated == (step == 3)
    assert observation[13] < begin - 0.2
    assert reward == pytest.approx(sum(env.weights[name] * value for name, value in info["terms"].items()))


@pytest.mark.parametrize("action", [[0, 0, 0], [0, 0, 0, float("nan")], [[0, 0, 0, 0]]])
def test_wrong_actions(passive, action):
    env = netpocket.Env(passive)
    env.reset()
    with pytest.raises(ValueError, match="4 finite numbers"):
        env.step(action)


def test_side_by_side_equals_one_after_the_other(passive):
    count = 6
    vector = netpocket.VectorEnv([netpocket.Env(passive) for _ in range(count)], threads=3)
    single = [netpocket.Env(passive) for _ in range(count)]
    generator = numpy.random.default_rng(3)
    observations = vector.reset(seed=5)
    assert observations.shape == (count, 20)
    for env in single:
        env.reset()
    for _ in range(3):
        actions = numpy.stack([env.action_space.sample(generator) for env in single])
        observations, rewards, terminated, truncated, infos = vector.step(actions)
        for i, env in enumerate(single):
            observation, reward, *_ = env.step(actions[i])
            assert (observation == observations[i]).all() and reward == rewards[i]
    with pytest.raises(ValueError):
        vector.step(numpy.zeros((2, 4)))
    vector.reset(only=[1])
