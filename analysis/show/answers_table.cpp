#include "analysis/show/answers_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

// Returns "EAIK and ssik gave all known answers to all 78 targets, ur-analytic-ik to 70." Of several runs of the same
// targets, shares are named, which are those of the table.
std::string caption_of(const AllAnswers& all) {
  const bool is_repeated = all.repeats > 1;
  std::string targets = base::counted(std::int64_t{all.targets}, "targets");
  if (is_repeated) targets += fmt::format(" in all {} runs", all.repeats);
  std::vector<std::string> complete, none, others;
  for (const AnswerSummary& solver : all.solvers) {
    const double share = solver.complete;
    if (share == 1)
      complete.push_back(solver.solver);
    else if (share == 0)
      none.push_back(solver.solver);
    else
      others.push_back(fmt::format(
          "{} to {}", solver.solver,
          is_repeated ? number_within(100 * share, {0, 100}) + " %" : fmt::format("{:.0f}", share * all.targets)));
  }
  if (!none.empty() && none.size() < all.solvers.size()) others.push_back(names_of(none) + " to none");
  const std::string rest = others.size() > max_named ? "" : listed(others);
  if (!complete.empty())
    return fmt::format("{} gave all known answers to all {}{}{}.", names_of(complete), targets,
                       rest.empty() ? "" : "; ", rest);
  return fmt::format("No solver gave all known answers to all {}{}{}.", targets, rest.empty() ? "" : ": ", rest);
}

// Returns the solver with the largest share of complete targets; of several, one that does not depend on the order of
// the study.
std::string best_of(const AllAnswers& all) {
  const auto is_worse = [](const AnswerSummary& first, const AnswerSummary& second) {
    return std::tuple(first.complete, first.coverage, second.solver) <
           std::tuple(second.complete, second.coverage, first.solver);
  };
  return std::ranges::max_element(all.solvers, is_worse)->solver;
}

// Returns the mark of a solver whose share of complete targets is shown to be smaller than that of the best one.
std::string mark_of(const JudgedMetric& complete, const std::string& best, const std::string& solver) {
  const Comparison* const pair = find_comparison(complete, best, solver);
  if (pair == nullptr) return "";
  const Verdict wanted = pair->first == best ? Verdict::better : Verdict::worse;
  return verdict_of(*pair) == wanted ? "*" : "";
}

Cell complete_cell(const AllAnswers& all, const std::string& best, std::size_t solver) {
  const Descriptives& shares = all.complete->descriptives[solver];
  const Interval share =
      wilson_interval({.share = shares.mean, .n = static_cast<double>(shares.n)}, all.complete->plan.significance);
  return ValueCell{.value = 100 * shares.mean,
                   .mark = mark_of(*all.complete, best, all.solvers[solver].solver),
                   .interval = Interval{100 * share.low, 100 * share.high}};
}

// Returns the notes of the table: what is counted, and what is wrong.
std::vector<std::string> notes_of(const AllAnswers& all, const std::string& best, bool is_limited) {
  std::vector<std::string> notes;
  notes.push_back(fmt::format(
      "A target has {} known {} on average ({} to {}): different ones{} that any solver of this study, or 100 "
      "restarts of LM, found. Wrong and doubled: of answers to all {}, other columns: of the {} that count.",
      number_text(all.mean_known), all.most_known == 1 ? "answer" : "answers", all.fewest_known, all.most_known,
      is_limited ? " inside the limits" : "", base::counted(std::int64_t{all.looked_at()}, "targets"), all.targets));
  if (all.all_targets > results::max_counted_targets)
    notes.push_back(fmt::format("Only the first {} of the {} targets are looked at.", results::max_counted_targets,
                                all.all_targets));
  if (all.unknown > 0)
    notes.push_back(fmt::format("{} {} not counted, because no answer{} is known.",
                                base::counted(std::int64_t{all.unknown}, "targets"), all.unknown == 1 ? "is" : "are",
                                is_limited ? " inside the limits" : ""));
  if (all.continua > 0)
    notes.push_back(fmt::format(
        "{} {} not counted, because a known answer is singular: there may be infinitely many, or several that coincide.",
        base::counted(std::int64_t{all.continua}, "targets"), all.continua == 1 ? "is" : "are"));
  const double significance = all.complete->plan.significance;
  std::string marks;
  if (!best.empty())
    marks = fmt::format("* worse than {} (p < {}{}). ", best, number_text(significance),
                        all.solvers.size() > 2 ? ", corrected" : "");
  notes.push_back(fmt::format("{}Brackets: {:.3g} % intervals; after coverage and answers, the range.", marks,
                              100 * (1 - significance)));
  if (!all.left_out.empty())
    notes.push_back(
        fmt::format("{} {} left out: some of the answers were not counted. `ikbench run` with the store "
                    "counts them.",
                    names_of(all.left_out), all.left_out.size() == 1 ? "is" : "are"));
  for (const AnswerSummary& solver : all.solvers)
    if (solver.wrong_beside_right > 0)
      notes.push_back(fmt::format("{} gave {} beside right ones.", solver.solver,
                                  base::counted(std::int64_t{solver.wrong_beside_right}, "wrong answers")));
  return notes;
}

}  // namespace

Table answers_table(const StudyResults& study) {
  Table table{.name = "answers",
              .caption = "All answers",
              .columns = named_columns(
                  {"solver", "complete", "coverage", "answers per target", "wrong", "doubled", "declined"})};
  const std::optional<AllAnswers> all = all_answers_of(study);
  if (!all || !all->complete) return table;
  table.caption = caption_of(*all);
  const std::string best = best_of(*all);
  const auto is_marked = [&](const AnswerSummary& solver) {
    return !mark_of(*all->complete, best, solver.solver).empty();
  };
  table.columns[1].unit = table.columns[2].unit = "%";
  for (std::size_t i = 0; i < all->solvers.size(); ++i) {
    const AnswerSummary& solver = all->solvers[i];
    table.rows.push_back({solver.solver, complete_cell(*all, best, i),
                          ValueCell{.value = 100 * solver.coverage,
                                    .interval = Interval{100 * solver.lowest_coverage, 100 * solver.highest_coverage}},
                          ValueCell{.value = solver.mean_found,
                                    .interval = Interval{static_cast<double>(solver.fewest_found),
                                                         static_cast<double>(solver.most_found)}},
                          std::int64_t{solver.wrong}, std::int64_t{solver.doubled}, std::int64_t{solver.declined}});
  }
  const bool is_limited = study.definition.limits == results::LimitPolicy::enforced;
  table.notes = notes_of(*all, std::ranges::any_of(all->solvers, is_marked) ? best : "", is_limited);
  return table;
}

}  // namespace ikbench::show
