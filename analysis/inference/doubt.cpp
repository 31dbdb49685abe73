#include "analysis/inference/doubt.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "analysis/inference/text.hpp"

namespace ikbench::inference {

namespace {

struct Words {
  DoubtKind kind;
  std::string_view title;
  std::string_view text;        // a template (fmt) with the fields of a doubt as named arguments
  std::string_view brief = {};  // why solvers are not compared, in a few words
};

constexpr std::string_view times = "Times are not comparable";

using K = DoubtKind;
constexpr std::array all_words{
    // For times, gives only the reason; the solvers stand in front.
    Words{K::solved_in_parallel, times,
          "of {of} solves, {count} ran in parallel with others and {other} in a debug build.",
          "parallel or debug build"},
    Words{K::several_machines, times, "they come from different machines ({who}).", "several machines"},
    Words{K::unknown_machine, times, "the stores do not name the CPU.", "unknown machine"},
    Words{
        K::separate_sessions, times,
        "A and B were solved in separate sessions, and a machine that is slower in one of them slows all its runs. Run "
        "both as labels of one study.",
        "separate sessions"},
    Words{K::times_disturbed, times,
          "{count} of {of} solves took more than 1.1 times their CPU time, so other programs were running.",
          "other programs ran"},
    Words{
        K::times_of_programs, times,
        "{whose} have messages and another process in them. analysis.program_times = \"compared\" compares them all the "
        "same.",
        "in a process of its own"},
    Words{K::evaluations_uncounted, "Evaluations were not counted", "Nobody counted the evaluations of {who}.",
          "nobody counted"},
    Words{
        K::evaluations_claimed, "Evaluations are claimed",
        "Evaluations of {who} are not compared: these were counted by the solver itself, those of the others by ikbench.",
        "counted by itself"},
    Words{
        K::machine_loaded, "The machine was loaded",
        "The machine was loaded: {count} of {of} solves took more than {other} times as long in one repeat as in another. "
        "Verdicts on times may change on a quiet machine."},
    Words{K::slow_solves, "Some solves were slow",
          "{count} of {of} solves took more than {other} times as long as usual. The worst is {what}: {value:.3g} ms "
          "instead of {limit:.3g} ms. For the verdict such a solve counts as usual, so it decides nothing."},
    Words{K::unequal_evaluations, "Budgets differ",
          "Equal iterations are not equal evaluations: a solve of {what} makes {count:.6g}, one of {who} {of:.6g}. "
          "stop.evaluations would give all solvers the same budget."},
    Words{
        K::populations_only, "No gradient method is compared",
        "Every solver evaluates many candidates in an iteration ({count:.3g} or more). A method that follows the gradient "
        "may solve the same targets with far fewer evaluations: add solver = \"damped_least_squares\"."},
    Words{K::single_target, "There is one target",
          "All solves have the same target, so nothing is known of others: another solver may be better there."},
    Words{K::points_as_observations, "Points are no replicates",
          "Points of one run depend on each other; used as observations because --force was given."},
    Words{K::rows_share_a_run, "Rows are no replicates",
          "{what}; points of one run depend on each other and are not replicates; used as observations anyway."},
    Words{
        K::values_missing, "Values are missing",
        "Values are missing: {what}. A group that failed there looks better than it is: write Inf for a failure (-Inf "
        "if larger is better)."},
    Words{K::uneven_runs, "Some means have fewer values",
          "Fewer values than the fullest have {what}. Their means are taken as they are."},
    Words{K::no_path_for_blocks, "There are no blocks", "There are no blocks: the study does not state its path."},
    Words{K::chained_solves, "There are no blocks",
          "There are no blocks: each solve starts where the solver's previous answer left the arm."},
    Words{K::other_targets, "There are no blocks",
          "There are no blocks: the solvers did not have the same targets and starts."},
    Words{K::no_common_run, "There are no blocks", "There are no blocks: no run is complete for all solvers."},
    Words{K::single_block, "There is one block", "There are no blocks to compare, because there is only one."},
    Words{K::plan_changed, "The analysis plan was changed",
          "The analysis plan was changed after {count} of {of} solves were made: {what}."},
    Words{
        K::solvers_dropped, "The study had more solvers",
        "The study had more solvers when its solves were made: {who}. The correction for several comparisons counts only "
        "those that are left."},
    Words{K::control_absent, "The control is missing",
          "The plan's control {who} is no solver of the study, so all pairs are compared."},
    Words{K::plan_not_recorded, "The analysis plan was not recorded",
          "{count} of {of} solves have no record of the plan under which they were made."},
    Words{K::no_plan, "There is no analysis plan", "The study has no analysis plan; this is the default plan."},
    Words{
        K::no_tolerance, "The study has no tolerance",
        "The study has no tolerance (stop.tolerance_cm), so it does not say what is solved: the status ok means that an "
        "answer is inside the joint limits, however far it is from the target."},
    Words{K::wrong_claims, "Wrong claims", "Wrong claims: in {count} of {of} solves the error is not what {who} said."},
    Words{
        K::out_of_reach, "Targets are out of reach",
        "{count} of the {of} targets of a run cannot be reached. The farthest is point {other}: {what} {value:.4g} cm from "
        "the shoulder; the reach is {limit:.4g} cm. No solver can solve these, so their errors say nothing about the "
        "solvers."},
    Words{K::unknown_paper, "The paper is not known", "no published tables of '{what}'; known papers: {who}"},
    Words{K::solves_missing, "Solves are missing", "{who}: only {count} of {of} solves are stored"},
    Words{K::figure_not_drawn, "Figures were not drawn", "{who} not drawn: {what}"},
};

constexpr const Words& words_for(DoubtKind kind) { return *std::ranges::find(all_words, kind, &Words::kind); }
static_assert(std::ranges::is_sorted(all_words, {}, &Words::kind));
static_assert(all_words.size() == static_cast<std::size_t>(K::figure_not_drawn) + 1);

bool is_of_times(DoubtKind kind) { return kind <= K::times_of_programs; }

}  // namespace

std::string_view title_of(DoubtKind kind) { return words_for(kind).title; }

std::string title_of(const Doubt& doubt) {
  const bool names_solvers = doubt.kind >= K::times_disturbed && doubt.kind <= K::times_of_programs;
  if (!names_solvers || doubt.who.empty()) return std::string(title_of(doubt.kind));
  return one_line(fmt::format("Times of {} are not comparable", fmt::join(doubt.who, ", ")));
}

std::string words_of(const Doubt& doubt) {
  const std::string who = one_line(fmt::format("{}", fmt::join(doubt.who, ", ")));
  std::string text =
      fmt::format(fmt::runtime(words_for(doubt.kind).text), fmt::arg("who", who), fmt::arg("count", doubt.count),
                  fmt::arg("of", doubt.of), fmt::arg("other", doubt.other), fmt::arg("value", doubt.value),
                  fmt::arg("limit", doubt.limit), fmt::arg("what", doubt.what),
                  fmt::arg("whose", doubt.is_of_all ? "those of " + who : "they"));
  if (is_of_times(doubt.kind)) {
    const bool names_solvers = doubt.kind == K::times_disturbed && !doubt.who.empty();
    text = doubt.is_of_all ? fmt::format("{}: {}{}", times, names_solvers ? fmt::format("of {}, ", who) : "", text)
                           : fmt::format("Times of {} are not compared, because {}", who, text);
  }
  if (doubt.errors_too) text += " Solves end by their wall time, so that errors depend on that too.";
  if (!doubt.study.empty()) text = fmt::format("{}: {}", doubt.study, text);
  if (!doubt.studies.empty()) text += fmt::format(" The same holds for {}.", fmt::join(doubt.studies, ", "));
  return text;
}

std::vector<std::string> list_of(const Doubts& doubts) {
  std::vector<std::string> all;
  for (const Doubt& doubt : doubts) all.push_back(words_of(doubt));
  return all;
}

std::string words_of(const Doubts& doubts) { return fmt::format("{}", fmt::join(list_of(doubts), " ")); }

std::string_view brief_of(DoubtKind kind) { return words_for(kind).brief; }

std::string left_out_words(const Doubts& doubts) {
  std::vector<std::string> all;
  for (const Doubt& doubt : doubts)
    all.push_back(one_line(fmt::format("{} ({})", fmt::join(doubt.who, ", "), brief_of(doubt.kind))));
  return fmt::format("{}", fmt::join(all, ", "));
}

Doubts operator+(Doubts doubts, Doubts others) {
  std::ranges::move(others, std::back_inserter(doubts));
  return doubts;
}

}  // namespace ikbench::inference
