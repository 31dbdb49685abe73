"""PSO and DE by libraries of Python, each called as its own pages do; called as peers.cpp, which has the problem too."""
import math
import sys
import time
from importlib.metadata import version

import numpy as np

POPULATION, ITERATIONS = 20, 200
INERTIA, COGNITIVE, SOCIAL, WEIGHT, CROSSOVER = 0.53514, 2.0149, 1.1312, 0.6, 0.9
LIMIT = np.radians([170, 120, 170, 120])


def reached(q, of):  # of floats by math, of a population by numpy
    q1, q2, q3, q4 = q
    x, z = -0.4 * of.sin(q4), 0.4 * of.cos(q4) + 0.42
    x, y = of.cos(q3) * x, of.sin(q3) * x
    x, z = of.cos(q2) * x + of.sin(q2) * z, of.cos(q2) * z - of.sin(q2) * x
    return of.cos(q1) * x - of.sin(q1) * y, of.sin(q1) * x + of.cos(q1) * y, z + 0.36


class Reach:
    def __init__(self, target):
        self.target, self.evaluations = target, 0

    def error(self, q, of):
        (x, y, z), (a, b, c) = reached(q, of), self.target
        return of.sqrt((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2)

    def one(self, q):
        self.evaluations += 1
        return self.error(q.tolist(), math)  # in a third of the time that NumPy takes

    def all(self, q):  # a row for each candidate
        self.evaluations += len(q)
        return self.error(q.T, np)


def by_numpy(algorithm, reach, seed):
    random = np.random.default_rng(seed)
    x = random.uniform(-LIMIT, LIMIT, (POPULATION, 4))
    own, errors, speed, rows = x.copy(), reach.all(x), 0, np.arange(POPULATION)
    for _ in range(ITERATIONS):
        if algorithm == "PSO":
            speed = (INERTIA * speed + COGNITIVE * random.random(x.shape) * (own - x) +
                     SOCIAL * random.random(x.shape) * (own[errors.argmin()] - x))
            x = np.clip(x + speed, -LIMIT, LIMIT)
        else:
            order = random.random((POPULATION, POPULATION))
            order[rows, rows] = 2  # nobody is an own partner
            a, b, c = order.argpartition(2, axis=1)[:, :3].T
            crossed = random.random(x.shape) < CROSSOVER
            crossed[rows, random.integers(4, size=POPULATION)] = True
            x = np.where(crossed, np.clip(own[a] + WEIGHT * (own[b] - own[c]), -LIMIT, LIMIT), own)
        found = reach.all(x)
        better = found < errors
        own[better], errors[better] = x[better], found[better]
    return own[errors.argmin()]


def by_pygmo(algorithm, reach, seed):
    import pygmo

    class Problem:
        get_bounds = lambda self: (-LIMIT, LIMIT)
        fitness = lambda self, q: [reach.one(q)]
        batch_fitness = lambda self, q: reach.all(q.reshape(-1, 4))

    if algorithm == "PSO":
        of = pygmo.pso_gen(ITERATIONS, INERTIA, COGNITIVE, SOCIAL, max_vel=1, variant=1, neighb_type=1, seed=seed)
        of.set_bfe(pygmo.bfe(pygmo.member_bfe()))
    else:
        of = pygmo.de(ITERATIONS, WEIGHT, CROSSOVER, variant=7, ftol=0, xtol=0, seed=seed)
    return pygmo.algorithm(of).evolve(pygmo.population(pygmo.problem(Problem()), POPULATION, seed=seed)).champion_x


def by_scipy(algorithm, reach, seed):
    from scipy.optimize import differential_evolution
    return differential_evolution(
        lambda q: reach.all(q.T), list(zip(-LIMIT, LIMIT)), strategy="rand1bin", maxiter=ITERATIONS, popsize=POPULATION // 4,
        mutation=WEIGHT, recombination=CROSSOVER, tol=0, polish=False, updating="deferred", vectorized=True, rng=seed).x


def by_mealpy(algorithm, reach, seed):
    from mealpy import DE, PSO, FloatVar
    problem = {"obj_func": reach.one, "bounds": FloatVar(-LIMIT, LIMIT), "minmax": "min", "log_to": None}
    of = (PSO.OriginalPSO(ITERATIONS, POPULATION, c1=COGNITIVE, c2=SOCIAL, w=INERTIA) if algorithm == "PSO" else
          DE.OriginalDE(ITERATIONS, POPULATION, wf=WEIGHT, cr=CROSSOVER, strategy=0))
    return of.solve(problem, seed=seed).solution


def by_pymoo(algorithm, reach, seed):
    from pymoo.algorithms.soo.nonconvex.de import DE
    from pymoo.algorithms.soo.nonconvex.pso import PSO
    from pymoo.core.problem import Problem
    from pymoo.optimize import minimize

    class Reaching(Problem):
        _evaluate = lambda self, x, out, *_, **__: out.update(F=reach.all(x))

    of = (PSO(POPULATION, w=INERTIA, c1=COGNITIVE, c2=SOCIAL, adaptive=False, initial_velocity="zero", max_velocity_rate=1,
              pertube_best=False) if algorithm == "PSO" else
          DE(POPULATION, variant="DE/rand/1/bin", F=WEIGHT, CR=CROSSOVER, prob_mut=0.0))
    return minimize(Reaching(n_var=4, n_obj=1, xl=-LIMIT, xu=LIMIT), of, ("n_gen", ITERATIONS + 1), seed=seed).X


peer, algorithm, seed, times = sys.argv[1:]
solve, seed = globals()["by_" + peer], int(seed)
lines = [list(map(float, line.split())) for line in sys.stdin]
solve(algorithm, Reach(lines[0][:3]), 0)  # imports it
print(version(peer))
for *target, q1, q2, q3, q4 in lines:
    print(*map(float, reached(np.array([q1, q2, q3, q4]), np)))
    assert math.dist(reached([q1, q2, q3, q4], math), reached(np.array([q1, q2, q3, q4]), np)) < 1e-15
    for _ in range(int(times)):
        reach, seed = Reach(target), seed + 1
        began = time.perf_counter()
        q = solve(algorithm, reach, seed)
        took = time.perf_counter() - began
        assert np.all(np.abs(q) <= LIMIT), "it answers outside the limits"
        print(took, reach.error(q.tolist(), math), reach.evaluations)
