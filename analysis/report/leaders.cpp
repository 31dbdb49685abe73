#include "analysis/report/leaders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;

namespace {

// "Smallest typical error"
std::string first_by_words(const StudyResults& study, Metric metric, Estimand estimand) {
  if (estimand == Estimand::reliability) return fmt::format("Most often {}", within_words(study, metric));
  const std::string_view slug = info_of(metric).slug;
  if (info_of(metric).kind == Kind::count) return fmt::format("Fewest {}", slug);
  if (info_of(metric).kind == Kind::time) return fmt::format("Shortest {} {}", average_name(metric), slug);
  return fmt::format("Smallest {} {}{}", name_of(estimand), slug,
                     estimand == Estimand::mean ? " (its worst cases)" : "");
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
    return fmt::format("{} ({}; next {} {}, {}{})", own, value(order[0]), name(order[1]), value(order[1]),
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

std::vector<std::string> own_verdict(const JudgedStudy& study) {
  std::vector<std::string> sentences, alone;
  for (const Metric metric : reported_metrics()) {
    if (!is_comparable(study, metric)) continue;
    const std::vector<Estimand> all = estimands_of(study, metric);
    for (const Estimand estimand : metric == Metric::position_error_cm ? all : std::vector{all.front()}) {
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
            ? fmt::format("No solver is found better than every other in any of {} comparisons.", alone.size())
            : fmt::format("Of {} comparisons, better than every other: {}.", alone.size(), counted));
  }
  return sentences;
}

}  // namespace ikbench::report
