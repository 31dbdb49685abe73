#!/usr/bin/env python3
"""A solver for ikbench in Python: a particle swarm. It needs only the standard library, because ikbench evaluates the
candidates."""
import ikbench


def solve(options, problem):
    draw, lower, upper = problem.random, problem.lower, problem.upper
    size, joints = problem.population, range(len(lower))
    swarm = [problem.start]
    while len(swarm) < size:
        swarm.append([draw.uniform(low, high) for low, high in zip(lower, upper)])
    speeds = [[0.0] * len(joints) for _ in swarm]
    own, own_errors = list(swarm), [float("inf")] * size
    while errors := problem.evaluate(swarm):
        for i, error in enumerate(errors):
            if error is not None and error < own_errors[i]:
                own[i], own_errors[i] = swarm[i], error
        best = own[min(range(size), key=own_errors.__getitem__)]
        for i in range(size):
            speeds[i] = [options["w"] * speeds[i][j] + options["c"] * draw.random() * (own[i][j] - swarm[i][j])
                         + options["c"] * draw.random() * (best[j] - swarm[i][j]) for j in joints]
            swarm[i] = [min(max(swarm[i][j] + speeds[i][j], lower[j]), upper[j]) for j in joints]
    return None  # the best candidate


ikbench.run("python_pso", lambda robot: robot.options, solve, version="2.0",
            options={"w": (0.7, 0, 2, "inertia"), "c": (1.5, 0, 4, "pull of both bests")})
