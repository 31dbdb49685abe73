"""Answers at once with its start: what a call of a program in Python costs."""
import ikbench

ikbench.run("nothing", lambda robot: robot, lambda robot, problem: problem.start, goals=["pose"])
