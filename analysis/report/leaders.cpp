#include "analysis/report/leaders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/shown_metrics.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_doubts.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace fmt::literals;

namespace {

// "Smallest typical error"
std::string first_by_words(const StudyResults& study, Metric metric, Estimand estimand) {
  if (estimand == Estimand::reliability) return fmt::format("Most often {}", within_words(study, metric));
  const MetricInfo& info = info_of(metric);
  const bool is_penalised = is_cost(metric) && !is_of_run(metric) && std::isfinite(tolerance_cm(study));
  const std::string penalised = is_penalised ? fmt::format(" ({})", penalty_words) : "";
  if (info.kind == Kind::count) return fmt::format("Fewest {}{}", is_of_run(metric) ? info.name : info.slug, penalised);
  if (info.kind == Kind::time) return fmt::format("Shortest {} {}{}", name_of(estimand), info.slug, penalised);
  if (is_of_run(metric)) return fmt::format("Smallest {}", info.name);
  const std::string words = fmt::format("Smallest {} {}{}", name_of(estimand), info.slug, penalised);
  if (metric != Metric::position_error_cm || estimand != Estimand::mean) return words;
  return words + " (large errors dominate)";
}

// Adds to a cost what it achieved: the answers' error or, with a tolerance, the share of solves with status ok.
class Achieved {
 public:
  Achieved(const StudyResults& study, Metric metric) {
    if (!is_cost(metric)) return;
    const bool has_tolerance = std::isfinite(tolerance_cm(study));
    if (has_tolerance && !is_of_run(metric)) return;  // unsolved ones are penalised already
    for (const Metric other : {Metric::position_error_cm, Metric::orientation_error_deg}) {
      if (other == Metric::orientation_error_deg && (has_tolerance || !study.facts.pose)) continue;
      for (const Sample& sample : samples(study, has_tolerance ? Metric::solved : other)) {
        const double mean = statistics::mean(sample.values);
        std::string& text = words_[sample.solver];
        text += (text.empty() ? "" : " and ") +
                (has_tolerance ? percent(mean) + " solved" : "error " + figures::value_words(other, mean));
      }
    }
  }
  // " with error 87 cm", " with 30 % solved"; empty if the metric is no cost.
  std::string of(const std::string& solver) const {
    const auto found = words_.find(solver);
    return found == words_.end() ? "" : " with " + found->second;
  }

 private:
  std::map<std::string, std::string> words_ = {};
};

// Finds the first solver by the deciding test, those that share its place, and its difference to the next.
class Leader {
 public:
  Leader(const JudgedStudy& study, Metric metric, Estimand estimand)
      : evidence_(study.evidence(metric, estimand)),
        metric_(metric),
        least_(estimand == Estimand::reliability ? statistics::not_defined : tolerance_of(study, metric)),
        achieved_(study, metric) {}

  std::string words() const {
    const std::vector<std::size_t> order = order_of_groups();
    if (order.empty()) return "";
    if (!evidence_.plan.control.empty() && evidence_.reference) return against_control(*evidence_.reference);
    if (order.size() == 1) return with_value(order[0]);
    const auto first = std::ranges::find_if(order, [&](std::size_t group) { return is_unbeaten(group, order); });
    if (first == order.end()) return std::string(words::each_worse);
    return first_words(*first, order);
  }

 private:
  // The others by their relation to the first.
  struct Others {
    std::vector<std::size_t> beaten = {}, beside = {}, open = {}, untested = {};
    bool all_same = true;  // all of `beside` are the same as the first
  };

  double average(std::size_t group) const { return evidence_.groups[group].described.mean; }
  // Groups with a value, best first.
  std::vector<std::size_t> order_of_groups() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < evidence_.groups.size(); ++i) {
      if (std::isfinite(average(i))) order.push_back(i);
    }
    std::ranges::stable_sort(
        order, {}, [&](std::size_t i) { return evidence_.better == Better::smaller ? average(i) : -average(i); });
    return order;
  }
  Finding against(std::size_t first, std::size_t other) const {
    return judge(evidence_, evidence_.groups[first].name, evidence_.groups[other].name);
  }
  bool is_unbeaten(std::size_t group, const std::vector<std::size_t>& all) const {
    return std::ranges::none_of(
        all, [&](std::size_t other) { return other != group && against(group, other).relation == Relation::worse; });
  }
  std::string name(std::size_t group) const { return name_words(evidence_, group); }
  std::string value(std::size_t group) const {
    const double mean = average(group);
    if (!std::isfinite(mean)) return "no value";
    if (statistics::without_rounding(mean - least_, least_) <= 0)
      return "at most the tolerance of " + figures::value_words(metric_, least_);
    return (evidence_.better == Better::larger ? percent(mean) : figures::value_words(metric_, mean)) +
           achieved_.of(evidence_.groups[group].name);
  }
  std::string with_value(std::size_t group) const { return fmt::format("{} ({})", name(group), value(group)); }
  // "BA 0.0019 cm"
  std::string with_values(const std::vector<std::size_t>& groups) const {
    std::vector<std::string> all;
    for (const std::size_t group : groups) all.push_back(fmt::format("{} {}", name(group), value(group)));
    return listed(all);
  }
  std::string names(const std::vector<std::size_t>& groups) const {
    std::vector<std::string> all;
    for (const std::size_t group : groups) all.push_back(name(group));
    return listed(all);
  }

  Others others_of(std::size_t first, const std::vector<std::size_t>& order) const {
    Others result;
    for (const std::size_t other : order) {
      if (other == first) continue;
      const Finding found = against(first, other);
      if (found.relation == Relation::better) {
        result.beaten.push_back(other);
      } else if (!found.why.empty()) {
        result.untested.push_back(other);
      } else if (is_unbeaten(other, order)) {
        result.beside.push_back(other);
        result.all_same = result.all_same && found.relation == Relation::same;
      } else {
        result.open.push_back(other);
      }
    }
    return result;
  }

  std::string first_words(std::size_t first, const std::vector<std::size_t>& order) const {
    const Others others = others_of(first, order);
    if (others.untested.size() + 1 == order.size()) {
      const auto is_tested = [&](std::size_t one) {
        return std::ranges::any_of(order,
                                   [&](std::size_t other) { return other != one && against(one, other).why.empty(); });
      };
      const bool is_any_tested = std::ranges::any_of(order, is_tested);
      return is_any_tested ? fmt::format(words::leader_not_tested, "first"_a = name(first), "value"_a = value(first))
                           : fmt::format(words::none_tested, "values"_a = with_values(order));
    }
    std::string remarks;
    if (!others.open.empty()) remarks += fmt::format("; undecided against {}", names(others.open));
    if (!others.untested.empty()) remarks += fmt::format("; not tested against {}", with_values(others.untested));
    if (order[0] != first) remarks += fmt::format("; the test decides, the average would name {}", name(order[0]));
    if (!others.beside.empty()) {
      std::vector<std::size_t> groups{first};
      groups.insert(groups.end(), others.beside.begin(), others.beside.end());
      return shared(groups, others.all_same, remarks);
    }
    const std::size_t second = order[0] == first ? order[1] : order[0];
    const Finding next = against(first, second);
    const std::string own = value(first), of_second = value(second);
    return fmt::format(words::leader, "first"_a = name(first), "value"_a = own, "second"_a = name(second),
                       "of_second"_a = own == of_second ? "with the same digits" : of_second,
                       "p"_a = next.is_fact            ? "a fact of these targets, because all runs are equal"
                               : std::isfinite(next.p) ? p_words(next.p)
                                                       : "not tested",
                       "remarks"_a = remarks);
  }

  // "IK-BA or DE (0.0017 cm and 0.0018 cm; undecided, p = 0.4)"
  std::string shared(const std::vector<std::size_t>& groups, bool all_same, const std::string& remarks) const {
    constexpr std::size_t most = 4;
    const std::string finding = all_same ? fmt::format("the same within {}", margin_words(evidence_))
                                : groups.size() > 2 || !std::isfinite(against(groups[0], groups[1]).p)
                                    ? "undecided"
                                    : fmt::format("undecided, {}", p_words(against(groups[0], groups[1]).p));
    if (groups.size() > most) {
      return fmt::format(words::shared_by_many, "first"_a = name(groups[0]), "others"_a = groups.size() - 1,
                         "value"_a = value(groups[0]), "finding"_a = finding, "remarks"_a = remarks);
    }
    std::vector<std::string> all, values;
    for (const std::size_t group : groups) {
      all.push_back(name(group));
      values.push_back(value(group));
    }
    const bool is_one = std::ranges::count(values, values.front()) == std::ssize(values);
    return fmt::format(
        words::shared,
        "all"_a =
            fmt::format("{} {} {}", fmt::join(all.begin(), all.end() - 1, ", "), all_same ? "and" : "or", all.back()),
        "values"_a = is_one ? "each " + values.front() : listed(values), "finding"_a = finding, "remarks"_a = remarks);
  }

  // "DE is better than the control IK-BA (0.0019 cm); worse: BA 1.68 cm; undecided: PSO 0.438 cm (p = 0.1)". Tests only
  // pairs with the control.
  std::string against_control(std::size_t control) const {
    std::map<Relation, std::vector<std::string>> found;
    std::vector<std::string> better, untested;
    for (std::size_t i = 0; i < evidence_.groups.size(); ++i) {
      if (i == control) continue;
      const Finding judged = against(i, control);
      if (judged.relation == Relation::better) {
        better.push_back(with_value(i));
      } else if (judged.relation == Relation::undefined) {
        untested.push_back(fmt::format("{} {}", name(i), value(i)));
      } else {
        found[judged.relation].push_back(
            fmt::format("{} {}{}", name(i), value(i),
                        judged.relation == Relation::undecided ? fmt::format(" ({})", p_words(judged.p)) : ""));
      }
    }
    std::string text = fmt::format(words::against_control, "better"_a = better.empty() ? "no solver" : listed(better),
                                   "are"_a = better.size() > 1 ? "are" : "is", "control"_a = name(control),
                                   "value"_a = value(control));
    const auto add = [&](const std::string& what, const std::vector<std::string>& who) {
      if (!who.empty()) text += fmt::format("; {}: {}", what, listed(who));
    };
    add("worse", found[Relation::worse]);
    add("the same within " + margin_words(evidence_), found[Relation::same]);
    add("undecided", found[Relation::undecided]);
    add("not tested", untested);
    return text;
  }

  const Evidence& evidence_;
  Metric metric_;
  double least_;  // smaller values count as this
  Achieved achieved_;
};

}  // namespace

Sentence leader_sentence(const JudgedStudy& study, Metric metric, Estimand estimand) {
  const std::string words = Leader(study, metric, estimand).words();
  if (words.empty()) return {};
  return {first_by_words(study, metric, estimand), words + '.'};
}

std::vector<Sentence> leader_sentences(const JudgedStudy& study, Metric metric) {
  std::vector<Sentence> sentences;
  for (const Estimand estimand : estimands_of(study, metric)) add(sentences, leader_sentence(study, metric, estimand));
  return sentences;
}

namespace {

// Warns of imports that lack solves.
Sentence partial_imports_sentence(const JudgedStudy& study) {
  std::string list;
  for (const SolverCounts& count : counts(study)) {
    if (count.solves == count.expected || !is_imported(study, count.solver)) continue;
    list +=
        fmt::format("{}{} has {} of {} solves", list.empty() ? "" : ", ", count.solver, count.solves, count.expected);
  }
  if (list.empty()) return {};
  return {"Not comparable",
          fmt::format("imported, {}; its values are of these alone. ikbench compare takes what two solvers both have.",
                      list)};
}

// Warns that too few observations exist for any pair to differ.
std::string too_few_sentence(const JudgedStudy& study) {
  const Evidence& evidence = study.evidence(Metric::position_error_cm, primary_estimand(study));
  if (!has_too_few(evidence)) return "";
  return fmt::format("With so few {} no two of {} solvers can be told apart, whatever they do: it takes at least {}.",
                     replicates_words(evidence), evidence.groups.size(), evidence.fewest);
}

// Reports the evaluations that solvers used, if the study sets no common budget.
std::string budgets_sentence(const StudyResults& study) {
  if (study.facts.stop.evaluations > 0) return "";
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

// Leaders by every quantity except the primary one.
std::vector<Sentence> exploratory_sentences(const JudgedStudy& study) {
  std::vector<Sentence> sentences;
  for (const Metric metric : shown_metrics(study).judged) {
    const bool is_reported = info_of(metric).shown == Shown::everywhere;
    if (!is_comparable(study, metric) || !(is_reported || is_of_run(metric))) continue;
    for (const Estimand estimand : estimands_of(study, metric)) {
      if (metric == Metric::position_error_cm && estimand == primary_estimand(study)) continue;
      add(sentences, leader_sentence(study, metric, estimand));
    }
  }
  return sentences;
}

}  // namespace

std::vector<Sentence> own_verdict(const JudgedStudy& study) {
  const Evidence& judged = study.evidence(Metric::position_error_cm, primary_estimand(study));
  const bool has_several = study.solvers.size() > 1;
  std::vector<Sentence> sentences;
  add(sentences, partial_imports_sentence(study));
  if (has_several) add(sentences, {"", too_few_sentence(study)});
  add(sentences, leader_sentence(study, Metric::position_error_cm, primary_estimand(study)));
  add(sentences, change_words(judged));
  const std::vector<Sentence> others = exploratory_sentences(study);
  if (has_several && !others.empty()) {
    add(sentences, {"Exploratory", fmt::format(words::exploratory, "count"_a = others.size())});
  }
  std::ranges::copy(others, std::back_inserter(sentences));
  if (const std::string failures = rare_failures_words(judged); !failures.empty()) add(sentences, {"", failures + '.'});
  if (has_several) add(sentences, {"", budgets_sentence(study)});
  return sentences;
}

}  // namespace ikbench::report
