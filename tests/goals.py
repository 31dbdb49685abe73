#!/usr/bin/env python3
"""The table of goals (experiments/microbenchmarks/goals.py), on measurements made up by hand."""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parents[1] / "experiments/microbenchmarks"))
import goals  # noqa: E402

OURS, KDL = "forward_kinematics/ours", "forward_kinematics/kdl"


def repetition(name, index, time, unit="ns", **more):
    return {"name": name, "run_name": name, "run_type": "iteration", "repetition_index": index, "real_time": time,
            "cpu_time": time, "time_unit": unit} | more


def rows(*benchmarks, instruction_set="x86-64-v4", peers="KDL 1.5.1, pagmo 2.18.0"):
    runs = goals.Measurements()
    runs.add({"context": {"instruction_set": instruction_set, "peers": peers}, "benchmarks": list(benchmarks)})
    return goals.rows_of(runs)


def row(number, *benchmarks, **context):
    """What is required, what is measured, and the verdict."""
    return next(tuple(each[2:]) for each in rows(*benchmarks, **context) if each[0] == number)


class Goals(unittest.TestCase):
    def test_a_ratio_is_taken_repetition_by_repetition_and_its_median_counts(self):
        # 60, 70 and 120 times; the medians of the times alone would give 300 / 5.
        benchmarks = [repetition(KDL, 2, 60), repetition(KDL, 0, 300), repetition(KDL, 1, 350),
                      repetition(OURS, 0, 5), repetition(OURS, 1, 5), repetition(OURS, 2, 0.5)]
        self.assertEqual(row("G1", *benchmarks), (">= 60", "70 (60 to 120)", "met"))

    def test_the_bound_depends_on_the_instruction_set(self):
        for name, required, verdict in (("x86-64-v4", ">= 60", "NOT MET"), ("x86-64-v3", ">= 30", "met"),
                                        ("x86-64", "no goal", "")):
            found = row("G1", repetition(KDL, 0, 59), repetition(OURS, 0, 1), instruction_set=name)
            self.assertEqual(found, (required, "59", verdict))

    def test_a_time_is_compared_in_its_unit_whatever_the_files(self):
        self.assertEqual(row("G9", repetition("study/threads/1", 0, 800, "ms")), ("<= 0.80 s", "0.80 s", "met"))
        self.assertEqual(row("G9", repetition("study/threads/1", 0, 0.81, "s")), ("<= 0.80 s", "0.81 s", "NOT MET"))

    def test_the_manner_of_a_run_is_no_part_of_a_name_and_means_are_no_repetitions(self):
        name = "ik_bat/to_tolerance/iterations:1/manual_time"
        mean = repetition(name, 0, 500, "us", run_type="aggregate")
        self.assertEqual(row("G14", repetition(name, 0, 39, "us"), mean), ("<= 40 us", "39 us", "met"))

    def test_cpu_time_counts_unless_the_benchmark_asks_for_the_clocks(self):
        for manner, time in (("", "1 s"), ("/iterations:1/real_time", "2 s"), ("/manual_time", "2 s")):
            self.assertEqual(row("G9", repetition("study/threads/1" + manner, 0, 2e9, cpu_time=1e9))[1], time)

    def test_what_was_not_measured_says_why(self):
        failed = repetition(KDL, 0, 0, error_occurred=True, error_message="the position is 1 m away")
        ours = repetition(OURS, 0, 5)
        self.assertEqual(row("G1", ours)[2], "not measured: no run of forward_kinematics/kdl")
        self.assertEqual(row("G1", ours, peers="pagmo 2.18.0")[2], "not measured: KDL is not installed")
        self.assertEqual(row("G1", ours, failed)[2], "not measured: the position is 1 m away")
        self.assertTrue(all(each[4].startswith("not measured") for each in goals.rows_of(goals.Measurements())))

    def test_accuracy_and_allocations_are_judged_by_the_worst_for_every_instruction_set(self):
        benchmarks = [repetition("allocations/a", 0, 1, allocations=0), repetition("allocations/b", 0, 1, allocations=3)]
        for name in ("x86-64", "x86-64-v3", "x86-64-v4"):
            self.assertEqual(row("G13", *benchmarks, instruction_set=name), ("<= 0", "3", "NOT MET"))

    def test_results_are_the_same_where_there_is_one_hash_only(self):
        def hashes(*values):
            return [{"name": f"result_hash/{i}", "hash": value} for i, value in enumerate(values)]
        self.assertEqual(row("G11", *hashes("17", "17"))[1:], ("1", "met"))
        self.assertEqual(row("G11", *hashes("17", "18"))[1:], ("2", "NOT MET"))
        self.assertTrue(row("G11", *hashes("17"))[2].startswith("not measured"))

    def test_of_several_ratios_the_largest_median_is_taken(self):
        times = {"a/hosted": (90, 100, 120), "a/built_in": (100, 100, 100), "b/hosted": (104, 105, 106),
                 "b/built_in": (100, 100, 100)}
        benchmarks = [repetition("shared_objects/" + name, i, time) for name, all_times in times.items()
                      for i, time in enumerate(all_times)]
        self.assertEqual(row("G16", *benchmarks), ("<= 1.10", "1.05 (1.04 to 1.06)", "met"))

    def test_growth_is_the_dearest_joint_of_a_candidate_over_the_cheapest(self):
        def size(joints, time):
            return repetition(f"forward_kinematics/joints/{joints}", 0, time, candidate_joints=50 * joints)
        self.assertEqual(row("growth", size(4, 400), size(32, 3400))[1:], ("1.06", "met"))
        self.assertEqual(row("growth", size(4, 400), size(32, 4000))[1:], ("1.25", "NOT MET"))

    def test_a_file_that_no_benchmark_wrote_is_refused(self):
        for document in ([], {"context": "none"}):
            self.assertRaises(ValueError, goals.Measurements().add, document)

    def test_the_table_has_a_line_for_each_goal_as_text_and_as_markdown(self):
        table = rows(repetition(KDL, 0, 300), repetition(OURS, 0, 5))
        self.assertEqual(goals.as_text(table).count("\n"), len(table) + 1)
        self.assertEqual(goals.as_markdown(table).count("\n"), len(table) + 2)
        self.assertIn("| G1 | KDL's forward kinematics / ours, batch of 50 | >= 60 | 60 | met |", goals.as_markdown(table))


if __name__ == "__main__":
    unittest.main()
