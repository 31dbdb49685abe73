#include "analysis/report/leaders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/definition.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/shown_metrics.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;

namespace {

// "Smallest typical error"
std::string first_by_words(const StudyResults& study, Metric metric, Estimand estimand) {
  if (estimand == Estimand::reliability) return fmt::format("Most often {}", within_words(study, metric));
  const MetricInfo& info = info_of(metric);
  if (info.kind == Kind::count) return fmt::format("Fewest {}", is_of_run(metric) ? info.name : info.slug);
  if (info.kind == Kind::time) return fmt::format("Shortest {} {}", average_name(metric), info.slug);
  if (is_of_run(metric)) return fmt::format("Smallest {}", info.name);
  const std::string words = fmt::format("Smallest {} {}", name_of(estimand), info.slug);
  if (metric != Metric::position_error_cm || estimand != Estimand::mean) return words;
  return words + " (large errors dominate)";
}

// Which solver is first, who shares its place, and what sets it apart from the next.
class Leader {
 public:
  Leader(const Evidence& evidence, Metric metric, Estimand estimand)
      : evidence_(evidence),
        is_median_(estimand == Estimand::mean && info_of(metric).kind == Kind::time),
        metric_(metric) {}

  // The first, where it is found better than every other; else empty.
  std::string alone() const {
    const std::vector<std::size_t> order = order_of_groups();
    const auto is_beaten = [&](std::size_t other) {
      return other == order[0] || against(order[0], other).answer == Answer::better;
    };
    return order.size() > 1 && std::ranges::all_of(order, is_beaten) ? name(order[0]) : "";
  }

  std::string words() const {
    const std::vector<std::size_t> order = order_of_groups();
    if (order.empty()) return "";
    const std::string own = name(order[0]);
    if (order.size() == 1) return fmt::format("{} ({})", own, value(order[0]));
    std::vector<std::size_t> beside{order[0]};
    std::string reversed;
    bool all_same = true;
    const std::vector<std::size_t> others(order.begin() + 1, order.end());
    const auto is_tested = [&](std::size_t other) { return against(order[0], other).undefined.empty(); };
    const bool any_tested = std::ranges::any_of(others, is_tested);
    for (const std::size_t other : others) {
      const Judgement found = against(order[0], other);
      // Whom no test can set apart from the first is not beaten, unless no one is tested at all.
      if (found.answer == Answer::better || (!any_tested && !found.undefined.empty())) continue;
      if (found.answer == Answer::worse) {
        reversed += fmt::format("; but the test finds {} better", name(other));
        continue;
      }
      beside.push_back(other);
      all_same = all_same && found.answer == Answer::same;
    }
    if (beside.size() > 1) return shared(beside, all_same) + reversed + ')';
    const Judgement next = against(order[0], order[1]);
    const std::string first = value(order[0]), second = value(order[1]);
    return fmt::format("{} ({}; next {} {}, {}{})", own, first, name(order[1]),
                       first == second ? "with the same digits" : second,
                       std::isfinite(next.p) ? p_words(next.p) : "not tested", reversed);
  }

 private:
  double average(std::size_t group) const {
    const statistics::Description& of = evidence_.groups[group].described;
    return is_median_ ? of.median : of.mean;
  }
  // Those with a value, the best first.
  std::vector<std::size_t> order_of_groups() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < evidence_.groups.size(); ++i) {
      if (std::isfinite(average(i))) order.push_back(i);
    }
    std::ranges::stable_sort(
        order, {}, [&](std::size_t i) { return evidence_.better == Better::smaller ? average(i) : -average(i); });
    return order;
  }
  Judgement against(std::size_t first, std::size_t other) const {
    return judge(evidence_, evidence_.groups[first].name, evidence_.groups[other].name);
  }
  std::string name(std::size_t group) const { return name_words(evidence_, group); }
  std::string value(std::size_t group) const {
    if (evidence_.better == Better::larger) return percent(average(group));
    return figures::value_words(metric_, average(group));
  }

  // "IK-BA or DE (0.0017 cm and 0.0018 cm; undecided, p = 0.4", without the bracket at the end.
  std::string shared(const std::vector<std::size_t>& groups, bool all_same) const {
    constexpr std::size_t most = 4;
    const std::string finding = all_same ? fmt::format("the same within {}", margin_words(evidence_))
                                : groups.size() > 2 || !std::isfinite(against(groups[0], groups[1]).p)
                                    ? "undecided"
                                    : fmt::format("undecided, {}", p_words(against(groups[0], groups[1]).p));
    if (groups.size() > most) {
      return fmt::format("{} or one of {} others ({}; {}", name(groups[0]), groups.size() - 1, value(groups[0]),
                         finding);
    }
    std::vector<std::string> names, values;
    for (const std::size_t group : groups) {
      names.push_back(name(group));
      values.push_back(value(group));
    }
    return fmt::format("{} {} {} ({}; {}", fmt::join(names.begin(), names.end() - 1, ", "), all_same ? "and" : "or",
                       names.back(), listed(values), finding);
  }

  const Evidence& evidence_;
  bool is_median_;
  Metric metric_;
};

}  // namespace

std::string leader_sentence(const JudgedStudy& study, Metric metric, Estimand estimand) {
  const std::string words = Leader(study.evidence(metric, estimand), metric, estimand).words();
  return words.empty() ? "" : fmt::format("{}: {}.", first_by_words(study, metric, estimand), words);
}

std::string leaders_sentence(const JudgedStudy& study, Metric metric) {
  std::vector<std::string> sentences;
  for (const Estimand estimand : estimands_of(study, metric)) {
    sentences.push_back(leader_sentence(study, metric, estimand));
  }
  std::erase(sentences, "");
  return fmt::format("{}", fmt::join(sentences, " "));
}

namespace {

// Imports that lack solves: their values are of fewer than the others'.
std::string partial_imports_sentence(const JudgedStudy& study) {
  std::string list;
  for (const SolverCounts& count : counts(study)) {
    if (count.solves == count.expected || !is_imported(study, count.solver)) continue;
    list +=
        fmt::format("{}{} has {} of {} solves", list.empty() ? "" : ", ", count.solver, count.solves, count.expected);
  }
  if (list.empty()) return "";
  return fmt::format(
      "Not comparable: imported, {}; its values are of these alone. ikbench compare takes what two solvers both have.",
      list);
}

// Where there are so few blocks that no pair can differ, whatever they hold.
std::string too_few_sentence(const JudgedStudy& study) {
  const Evidence& evidence = study.evidence(Metric::position_error_cm, study.plan.estimands.front());
  if (!has_too_few(evidence)) return "";
  return fmt::format("With so few {} no two of {} solvers can be told apart, whatever they do: it takes at least {}.",
                     replicates_words(evidence), evidence.groups.size(), evidence.fewest);
}

// What solvers spent, where the study gives them no common budget.
std::string budgets_sentence(const StudyResults& study) {
  if (Definition(study.definition).number("/stop/evaluations") > 0) return "";
  std::string least, most;
  double smallest = statistics::not_defined, largest = statistics::not_defined;
  for (const std::string& solver : study.solvers) {
    std::vector<double> spent;
    for (const Solve& solve : solves_of(study, solver)) spent.push_back(value_of(study, solve, Metric::evaluations));
    const double own = statistics::median(spent);
    if (!std::isfinite(own)) continue;
    if (!(own >= smallest)) {
      smallest = own;
      least = solver;
    }
    if (!(own <= largest)) {
      largest = own;
      most = solver;
    }
  }
  if (!(smallest < largest)) return "";
  return fmt::format(
      "The study gives no limit of evaluations (stop.evaluations): {} used {} at the median of a solve, {} {}.",
      one_line(least), rounded_number(smallest, 6), one_line(most), rounded_number(largest, 6));
}

}  // namespace

std::vector<std::string> own_verdict(const JudgedStudy& study) {
  std::vector<std::string> sentences, alone;
  for (const Metric metric : shown_metrics(study).judged) {
    const bool is_reported = info_of(metric).shown == Shown::everywhere;
    if (!is_comparable(study, metric) || !(is_reported || is_of_run(metric))) continue;
    for (const Estimand estimand : estimands_of(study, metric)) {
      std::string sentence = leader_sentence(study, metric, estimand);
      if (sentence.empty()) continue;
      sentences.push_back(std::move(sentence));
      alone.push_back(Leader(study.evidence(metric, estimand), metric, estimand).alone());
    }
  }
  std::string counted;
  for (auto each = alone.begin(); each != alone.end(); ++each) {
    if (each->empty() || std::find(alone.begin(), each, *each) != each) continue;  // counted before
    counted += fmt::format("{}{} in {}", counted.empty() ? "" : ", ", *each, std::ranges::count(alone, *each));
  }
  if (study.solvers.size() > 1 && !sentences.empty()) {
    sentences.insert(
        sentences.begin(),
        counted.empty()
            ? fmt::format("No solver is shown to be better than every other in any of {} comparisons. The best values:",
                          alone.size())
            : fmt::format("Of {} comparisons by the test of the plan, better than every other: {}.", alone.size(),
                          counted));
  }
  if (study.solvers.size() > 1) {
    if (std::string few = too_few_sentence(study); !few.empty()) sentences.insert(sentences.begin(), std::move(few));
    sentences.push_back(budgets_sentence(study));
  }
  sentences.insert(sentences.begin(), partial_imports_sentence(study));
  std::erase(sentences, "");
  return sentences;
}

}  // namespace ikbench::report
