#include "analysis/papers/multiverse.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ikbench::papers {

using namespace compare;
using results::Choice;
using results::Chosen;
using results::Dimension;

namespace {

using ChosenSolver = SolvedMultiverse::ChosenSolver;
using OfStudy = SolvedMultiverse::OfStudy;
using Names = std::vector<std::string>;

bool contains(const auto& all, const auto& one) { return std::ranges::find(all, one) != all.end(); }

std::size_t place_of(const Names& all, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(all, name) - all.begin());
}

// If it is that a solver is better in error, variation or their spread.
bool hangs_on_reading(const Claim& claim) {
  return claim.rule != nullptr && claim.rule->name == "better" && claim.metrics.size() == 1 && claim.study.empty() &&
         contains(metrics_of_readings, claim.metrics.front()->column);
}

Verdict verdict_of(const Group& own, const Group& theirs, const Claim& claim, const Plan& plan) {
  const Metric& metric = *claim.metrics.front();
  Observations observed{.metric = std::string(metric.slug),
                        .quantity = std::string(metric.name),
                        .scale = metric.scale,
                        .floor = metric.floor,
                        .rounding = metric.rounding,
                        .groups = {own, theirs}};
  return compare::verdict_of(compare::compare(claim.of == Of::spread ? deviations(observed) : observed, plan).front());
}

// How the claim's solvers, by one choice of the study and of each of them, do against each choice of each rival.
struct Against {
  const Chosen* chosen;
  Holds holds;
};
struct Part {
  Chosen chosen;
  std::vector<std::vector<Against>> rivals;
  double others;  // choices of solvers that the claim is not about
};

// One of the combinations of the choices of these solvers: by solver, its choice; none after the last.
using OwnChoices = std::map<std::size_t, std::size_t>;
OwnChoices combination(const OfStudy& study, const std::vector<std::size_t>& solvers, std::size_t number) {
  OwnChoices chosen;
  for (const std::size_t solver : solvers) {
    chosen[solver] = number % study.solvers[solver].size();
    number /= study.solvers[solver].size();
  }
  return number == 0 ? chosen : OwnChoices();
}

// None if a solver of the claim is missing.
std::vector<Part> parts_of(const SolvedMultiverse& multiverse, const Claim& claim, const results::Plan& plan) {
  const Names& solvers = multiverse.solvers;
  const std::size_t k = solvers.size(), metric = claim.metrics.front()->column == metrics_of_readings[0] ? 0 : 1;
  std::vector<std::size_t> own, rivals;
  for (const std::string& solver : claim.solvers) own.push_back(place_of(solvers, solver));
  for (const std::string& solver : claim.against.empty() ? solvers : claim.against) {
    if (!contains(claim.solvers, solver)) rivals.push_back(place_of(solvers, solver));
  }
  if (contains(own, k) || contains(rivals, k)) return {};
  // Of each pair alone, by Welch's t, at its part of the significance, as a report judges a pair of these solvers.
  const Plan of_pair{.test = Plan::Test::means,
                     .significance = plan.significance / (static_cast<double>(k * (k - 1)) / 2),
                     .margin = plan.margin};
  std::vector<Part> parts;
  for (const OfStudy& study : multiverse.studies) {
    for (std::size_t seed = 0; seed < study.solvers[0][0].parts.size(); ++seed) {
      const auto verdict = [&](const ChosenSolver& one, const ChosenSolver& other) {
        return verdict_of(multiverse.means[one.parts[seed]][metric], multiverse.means[other.parts[seed]][metric], claim,
                          of_pair);
      };
      OwnChoices chosen;
      for (std::size_t number = 0; !(chosen = combination(study, own, number)).empty(); ++number) {
        Part& part = parts.emplace_back(Part{study.chosen, {}, study.readings()});
        for (const auto& [solver, choice] : chosen) {
          const Chosen& more = study.solvers[solver][choice].chosen;
          part.chosen.insert(part.chosen.end(), more.begin(), more.end());
          part.others /= static_cast<double>(study.solvers[solver].size());
        }
        for (const std::size_t rival : rivals) {
          part.others /= static_cast<double>(study.solvers[rival].size());
          std::vector<Against>& against = part.rivals.emplace_back();
          for (const ChosenSolver& theirs : study.solvers[rival]) {
            Tally tally;
            for (const auto& [solver, choice] : chosen) tally.add(verdict(study.solvers[solver][choice], theirs));
            against.push_back({&theirs.chosen, holds_of(tally)});
          }
        }
      }
    }
  }
  return parts;
}

bool has_any(const Chosen& chosen, const Chosen& answers) {
  return std::ranges::any_of(answers, [&](const Choice& answer) { return contains(chosen, answer); });
}

struct Readings {
  double holds = 0, fails = 0, undecided = 0;
};

// Of a part, those that have none of these answers.
Readings count(const Part& part, const Chosen& without) {
  if (has_any(part.chosen, without)) return {};
  double all = part.others, hold = all, fail_not = all;
  for (const std::vector<Against>& rival : part.rivals) {
    double options = 0, better = 0, worse = 0;
    for (const auto& [chosen, holds] : rival) {
      if (has_any(*chosen, without)) continue;
      ++options;
      better += holds == Holds::holds;
      worse += holds == Holds::fails;
    }
    all *= options;
    hold *= better;
    fail_not *= options - worse;
  }
  return {hold, all - fail_not, fail_not - hold};
}

// Conditions.

using Outcome = double Readings::*;
bool happens(const std::vector<Part>& parts, Outcome outcome, const Chosen& without) {
  return std::ranges::any_of(parts, [&](const Part& part) { return count(part, without).*outcome > 0; });
}

// "only where no solver is clamped": the smallest sets of one or two answers, other than defaults, without which it
// never happens.
std::string where(const SolvedMultiverse& multiverse, const std::vector<Part>& parts, Outcome outcome) {
  if (!happens(parts, outcome, {})) return "nowhere";
  Chosen answers;  // all but the defaults
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    for (std::size_t a = 1; a < multiverse.dimensions[d].alternatives.size(); ++a) answers.push_back({d, a});
  }
  if (happens(parts, outcome, answers)) return "in some seeds of the default, too";
  const auto name_of = [&](const Choice& answer) {
    return multiverse.dimensions[answer.dimension].alternatives[answer.alternative].where;
  };
  Names ones, twos;
  for (const Choice& answer : answers) {
    if (!happens(parts, outcome, {answer})) ones.push_back(name_of(answer));
  }
  for (std::size_t i = 0; i < answers.size() && ones.empty(); ++i) {
    for (std::size_t j = i + 1; j < answers.size(); ++j) {
      if (!happens(parts, outcome, {answers[i], answers[j]}))
        twos.push_back(fmt::format("{} or {}", name_of(answers[i]), name_of(answers[j])));
    }
  }
  if (!ones.empty()) return fmt::format("only where {}", fmt::join(ones, " and "));
  return twos.empty() ? "" : fmt::format("only where {}", fmt::join(twos, ", and only where "));
}

}  // namespace

JudgedMultiverse judged(const Paper& paper, const SolvedMultiverse& multiverse, const results::Plan& plan) {
  JudgedMultiverse result{
      .in_readings = {},
      .table = {.name = "multiverse",
                .caption = "The claims in every reading",
                .columns = {{"claim"}, {"holds"}, {"fails"}, {"not decided"}, {"it fails"}, {"it is not decided"}},
                .is_of_study = false}};
  for (const Claim& claim : paper.claims) {
    if (!hangs_on_reading(claim)) continue;
    const std::vector<Part> parts = parts_of(multiverse, claim, plan);
    if (parts.empty()) continue;
    const auto all = [&](Outcome outcome) {
      double sum = 0;
      for (const Part& part : parts) sum += count(part, {}).*outcome;
      return static_cast<std::int64_t>(sum);
    };
    const std::int64_t hold = all(&Readings::holds), fail = all(&Readings::fails), open = all(&Readings::undecided);
    const std::string fails = where(multiverse, parts, &Readings::fails);
    result.in_readings[claim.id] = fmt::format("fails {}{}", fails.empty() ? "in some" : fails,
                                               open == 0 ? "" : "; in some others it is not decided");
    result.table.rows.push_back(
        {claim.sentence, hold, fail, open, fails, where(multiverse, parts, &Readings::undecided)});
  }
  result.table.notes = {
      fmt::format("{:.0f} readings, each with seeds 1 to {}. Each pair is judged alone, at significance / pairs.",
                  multiverse.readings(), multiverse.studies[0].solvers[0][0].parts.size())};
  show::Table on_page = result.table;  // without counts
  for (std::vector<show::Cell>& row : on_page.rows) row.erase(row.begin() + 1, row.begin() + 4);
  on_page.columns.erase(on_page.columns.begin() + 1, on_page.columns.begin() + 4);
  result.table.on_page = {on_page};
  result.table.notes.emplace_back("Counts depend on which answers are listed; they are no probabilities.");
  return result;
}

}  // namespace ikbench::papers
