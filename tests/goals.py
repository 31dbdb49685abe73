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


def repeated(name, *times, unit="ns", **more):
    """Enough repetitions for a verdict: the times, over and over."""
    return [repetition(name, i, times[i % len(times)], unit, **more) for i in range(9)]


def rows(*benchmarks, instruction_set="x86-64-v4", peers="KDL 1.5.1, pagmo 2.18.0"):
    runs = goals.Measurements()
    runs.add({"context": {"instruction_set": instruction_set, "peers": peers}, "benchmarks": list(benchmarks)})
    return goals.rows_of(runs)


def row(start, *benchmarks, **context):
    """What is required, what is measured, and the verdict, of the goal whose name or text starts so."""
    found = rows(*benchmarks, **context)
    return next(tuple(each[2:]) for each in found if start == each[0] or each[1].startswith(start))


class Goals(unittest.TestCase):
    def test_a_ratio_is_that_of_the_medians_with_an_interval_of_resamples(self):
        # One of three repetitions was disturbed; the order of a benchmark's repetitions does not count.
        benchmarks = repeated(KDL, 300, 310, 900)[::-1] + repeated(OURS, 5)
        required, measured, verdict = row("KDL", *benchmarks)
        self.assertEqual((required, measured[:9], verdict), (">= 45", "62 (60 to", "met"))

    def test_the_bound_depends_on_the_instruction_set(self):
        for name, required, verdict in (("x86-64-v4", ">= 45", "NOT MET"), ("x86-64-v3", ">= 25", "met"),
                                        ("x86-64", "no goal", "")):
            found = row("KDL", *repeated(KDL, 44), *repeated(OURS, 1), instruction_set=name)
            self.assertEqual(found, (required, "44", verdict))

    def test_an_interval_with_the_goal_in_it_has_no_verdict(self):
        for times, verdict in (((46, 55, 99), "met"), ((44, 55, 60), "not measurable now"), ((20, 35, 44), "NOT MET"),
                               ((20, 35, 46), "not measurable now")):
            self.assertEqual(row("KDL", *repeated(KDL, *times), *repeated(OURS, 1))[2], verdict)

    def test_few_repetitions_give_no_verdict_about_times(self):
        kdl, ours = repeated(KDL, 100), repeated(OURS, 1)
        self.assertEqual(row("KDL", *kdl[:6], *ours[:6])[1:], ("100", "too few repetitions"))
        self.assertEqual(row("KDL", *kdl[:7], *ours[:7])[1:], ("100", "met"))

    def test_threads_without_processors_give_no_verdict(self):
        def study(free):
            return [*repeated("study/threads/1", 2, free_cores=1.5, needed_cores=1),
                    *repeated("study/threads/2", 1, free_cores=free, needed_cores=2)]
        self.assertEqual(row("threads", *study(1.95))[1:], ("2", "met"))
        self.assertEqual(row("threads", *study(1.9))[2], "not measurable now: processors needed 2, free 1.90")
        self.assertTrue(row("threads", *study(float("nan")))[2].startswith("not measurable now: processors needed 2"))

    def test_a_time_is_shown_in_its_unit_whatever_the_files(self):
        self.assertEqual(row("round trip", repetition("round_trips/c", 0, 0.04, "ms")), ("no goal", "40 us", ""))

    def test_the_manner_of_a_run_is_no_part_of_a_name_and_means_are_no_repetitions(self):
        name = "ik_bat/to_tolerance/iterations:1/manual_time"
        mean = repetition(name, 0, 500, "us", run_type="aggregate")
        self.assertEqual(row("IK-BA with 12 bats", repetition(name, 0, 39, "us"), mean)[1], "39 us")

    def test_cpu_time_counts_unless_the_benchmark_asks_for_the_clocks(self):
        for manner, time in (("", "1 us"), ("/iterations:1/real_time", "2 us"), ("/manual_time", "2 us")):
            self.assertEqual(row("round trip", repetition("round_trips/c" + manner, 0, 2e3, cpu_time=1e3))[1], time)

    def test_what_was_not_measured_says_why(self):
        failed = repetition(KDL, 0, 0, error_occurred=True, error_message="the position is 1 m away")
        ours = repetition(OURS, 0, 5)
        self.assertEqual(row("KDL", ours)[2], "not measured: no run of forward_kinematics/kdl")
        self.assertEqual(row("KDL", ours, peers="pagmo 2.18.0")[2], "not measured: KDL is not installed")
        self.assertEqual(row("KDL", ours, failed)[2], "not measured: the position is 1 m away")
        self.assertTrue(all(each[4].startswith("not measured") for each in goals.rows_of(goals.Measurements())))

    def test_accuracy_and_allocations_are_judged_by_the_worst_for_every_instruction_set(self):
        benchmarks = [repetition("allocations/a", 0, 1, allocations=0), repetition("allocations/b", 0, 1, allocations=3)]
        for name in ("x86-64", "x86-64-v3", "x86-64-v4"):
            self.assertEqual(row("allocations", *benchmarks, instruction_set=name), ("<= 0", "3", "NOT MET"))

    def test_results_are_the_same_where_there_is_one_hash_only(self):
        def hashes(*values):
            return [{"name": f"result_hash/{i}", "hash": value} for i, value in enumerate(values)]
        self.assertEqual(row("results", *hashes("17", "17"))[1:], ("1", "met"))
        self.assertEqual(row("results", *hashes("17", "18"))[1:], ("2", "NOT MET"))
        self.assertTrue(row("results", *hashes("17"))[2].startswith("not measured"))

    def test_of_several_ratios_the_largest_median_is_taken(self):
        benchmarks = [*repeated("shared_objects/a/hosted", 90, 100, 120), *repeated("shared_objects/a/built_in", 100),
                      *repeated("shared_objects/b/hosted", 104, 105, 106), *repeated("shared_objects/b/built_in", 100)]
        self.assertEqual(row("object", *benchmarks), ("<= 1.10", "1.05 (1.04 to 1.06)", "met"))

    def test_growth_is_the_dearest_joint_of_a_candidate_over_the_cheapest(self):
        def size(joints, *times):
            return repeated(f"forward_kinematics/joints/{joints}", *times, candidate_joints=50 * joints)
        grown = row("joints", *size(4, 400), *size(32, 3400))
        self.assertEqual(grown[1:], ("1.06", "met"))
        self.assertEqual(row("joints", *size(4, 400), *size(32, 4000))[1:], ("1.25", "NOT MET"))

    def test_the_picture_has_its_points_in_order_with_their_range(self):
        def batch(size, *seconds):
            name = f"forward_kinematics/population/{size}"
            return [repetition(name, i, 1, per_candidate=each) for i, each in enumerate(seconds)]
        def joints(number):
            return [repetition(f"forward_kinematics/joints/{number}", 0, 1, per_candidate=2e-9)]
        runs = goals.Measurements()
        self.assertIsNone(goals.picture(runs))
        runs.add({"benchmarks": [*batch(5000, 7e-9, 8e-9, 9e-9), *batch(50, 9e-9), *joints(16), *joints(4)]})
        lines = goals.picture(runs).splitlines()
        for points in (["4 2.0 2.0 2.0", "16 2.0 2.0 2.0", "END"], ["50 9.0 9.0 9.0", "5000 8.0 7.0 9.0", "END"]):
            self.assertEqual(lines[lines.index(points[0]):][:3], points)
        self.assertNotIn("KDL", goals.picture(runs))

    def test_a_file_that_no_benchmark_wrote_is_refused(self):
        for document in ([], {"context": "none"}):
            self.assertRaises(ValueError, goals.Measurements().add, document)

    def test_the_table_has_a_line_for_each_goal_as_text_and_as_markdown(self):
        table = rows(*repeated(KDL, 300), *repeated(OURS, 5))
        self.assertEqual(goals.as_text(table).count("\n"), len(table) + 1)
        self.assertEqual(goals.as_markdown(table).count("\n"), len(table) + 2)
        self.assertIn("| KDL | KDL's forward kinematics / ours | >= 45 | 60 | met |", goals.as_markdown(table))


if __name__ == "__main__":
    unittest.main()
