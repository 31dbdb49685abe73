#include "analysis/show/statements.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "analysis/show/phrases.hpp"

namespace ikbench::show {

using namespace judge;
using Kind = Statement::StatementKind;
using Names = std::vector<std::string>;

namespace {

// The metrics that a word of the plan's tie-breakers stands for, by their slugs.
struct TieBreaker {
  std::string_view word, metric;
  std::string_view ert;  // stands in place of `metric` where a target failed
};
constexpr std::array known_tie_breakers{
    TieBreaker{.word = "time", .metric = "time", .ert = "time-per-success"},
    TieBreaker{.word = "evaluations", .metric = "evaluations", .ert = "evaluations-per-success"},
    TieBreaker{.word = "motion", .metric = "variation", .ert = "slide-variation"}};

// Returns the place of a tie-breaker's metric; nullopt if the word is unknown, no metric is of it or the first one is.
std::optional<std::size_t> find_tie_breaker(const std::vector<JudgedMetric>& metrics, const std::string& word) {
  const auto tie_breaker = std::ranges::find(known_tie_breakers, word, &TieBreaker::word);
  if (tie_breaker == known_tie_breakers.end()) return {};
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const std::string& metric = metrics[i].samples.metric;
    if (metric != tie_breaker->metric && metric != tie_breaker->ert) continue;
    if (i == 0) return {};
    return i;
  }
  return {};
}

bool are_alike(const Comparison* comparison) {
  return comparison && (verdict_of(*comparison) == Verdict::equivalent || all_values_equal(*comparison));
}

// Returns the solver with the most tested pairs among those that no solver beats: the headline's reference for the
// others. Empty if every solver is beaten.
std::string find_leader(const PairIndex& pairs, const Names& unbeaten) {
  const auto leader =
      std::ranges::max_element(unbeaten, {}, [&](const std::string& name) { return pairs.tested_pairs(name); });
  return leader == unbeaten.end() ? "" : *leader;
}

// Makes the statements of one question.
class StatementMaker {
 public:
  StatementMaker(const JudgedMetric& judged, const Names& solvers)
      : judged_(judged),
        solvers_(solvers),
        pairs_(judged, solvers),
        losers_(names_that(solvers, [&](const std::string& name) { return pairs_.is_beaten(name); })),
        unbeaten_(names_that(solvers, [&](const std::string& name) { return !pairs_.is_beaten(name); })),
        leader_(find_leader(pairs_, unbeaten_)) {}

  std::vector<Statement> make() {
    const std::string& control = judged_.plan.control;
    if (pairs_.is_empty()) {
      add(Kind::no_comparison, solvers_);
    } else if (are_best()) {
      add(Kind::best, unbeaten_, losers_);
    } else if (std::ranges::count(solvers_, control) > 0 && solvers_.size() > 2) {
      add_against_control(control);
    } else {
      add_without_control();
    }
    return std::move(statements_);
  }

 private:
  const JudgedMetric& judged_;
  const Names& solvers_;
  const PairIndex pairs_;
  const Names losers_, unbeaten_;
  const std::string leader_;
  std::vector<Statement> statements_ = {};

  void add(Kind kind, const Names& solvers, const Names& against = {}) {
    if (solvers.empty() && kind != Kind::no_comparison) return;
    const auto is_small = [&](const std::string& first, const std::string& second) {
      return is_below_margin(pairs_.find(first, second));
    };
    statements_.push_back({.kind = kind,
                           .solvers = solvers,
                           .against = against,
                           .is_below_margin = !against.empty() && holds_for_pairs(solvers, against, is_small)});
  }

  bool are_best() const {
    if (losers_.empty() || unbeaten_.empty()) return false;
    const auto is_better = [&](auto& first, auto& second) { return pairs_.is_better(first, second); };
    const auto is_alike = [&](auto& first, auto& second) { return are_alike(pairs_.find(first, second)); };
    return holds_for_pairs(unbeaten_, losers_, is_better) && holds_for_pairs(unbeaten_, unbeaten_, is_alike);
  }

  void add_against_control(const std::string& control) {
    const auto add_verdict = [&](Kind kind, Verdict verdict) {
      const auto has_verdict = [&](const std::string& name) {
        return name != control && pairs_.verdict(name, control) == verdict;
      };
      add(kind, names_that(solvers_, has_verdict), {control});
    };
    add_verdict(Kind::better, Verdict::better);
    add_verdict(Kind::equivalent, Verdict::equivalent);
    add_verdict(Kind::inconclusive, Verdict::inconclusive);
    add_verdict(Kind::worse, Verdict::worse);
    add_verdict(Kind::not_tested, Verdict::not_tested);
  }

  void add_without_control() {
    const Names apart = names_that(solvers_, [&](const std::string& name) { return is_apart(name); });
    const Names leaders =
        names_that(unbeaten_, [&](const std::string& name) { return std::ranges::count(apart, name) == 0; });
    if (leaders.empty()) {
      add(Kind::cyclic, losers_);
      add(Kind::not_tested, apart);
      return;
    }
    add(kind_of_leaders(leaders), leaders);
    add_losers(leaders);
    const bool is_any_tested =
        std::ranges::any_of(apart, [&](const std::string& name) { return pairs_.tested_pairs(name) > 0; });
    add(Kind::not_tested, apart, is_any_tested ? Names{leader_} : Names());
  }

  // True for a solver without a tested pair, and for an unbeaten one whose pair with the leader is not tested.
  bool is_apart(const std::string& name) const {
    if (pairs_.tested_pairs(name) == 0) return true;
    if (pairs_.is_beaten(name) || name == leader_) return false;
    return pairs_.verdict(leader_, name) == Verdict::not_tested;
  }

  Kind kind_of_leaders(const Names& leaders) const {
    const auto are_all = [&](Verdict verdict) {
      return holds_for_pairs(leaders, leaders,
                             [&](auto& first, auto& second) { return pairs_.verdict(first, second) == verdict; });
    };
    if (leaders.size() > 1 && are_all(Verdict::equivalent)) return Kind::equivalent;
    if (leaders.size() > 1 && are_all(Verdict::inconclusive)) return Kind::inconclusive;
    return Kind::none_better;
  }

  // Adds the losers by their winner: the first leader that beats a loser, otherwise the first solver that does.
  void add_losers(const Names& leaders) {
    NamesByPhrase losers_by_winner;
    for (const std::string& loser : losers_) {
      const auto beats = [&](const std::string& name) { return pairs_.is_better(name, loser); };
      const auto leader = std::ranges::find_if(leaders, beats);
      losers_by_winner.add(leader != leaders.end() ? *leader : *std::ranges::find_if(solvers_, beats), loser);
    }
    for (const auto& [winner, losers] : losers_by_winner.entries) add(Kind::worse, losers, {winner});
  }
};

// Returns the solvers that a first statement leaves unseparated.
Names unseparated_solvers(const Statement& statement) {
  switch (statement.kind) {
    case Kind::best:
    case Kind::equivalent:
    case Kind::inconclusive:
    case Kind::none_better:
      return statement.solvers;
    case Kind::no_comparison:
    case Kind::better:
    case Kind::worse:
    case Kind::not_tested:
    case Kind::cyclic:
      return {};
  }
  return {};
}

}  // namespace

PairIndex::PairIndex(const JudgedMetric& judged, const Names& solvers)
    : table_(judged), groups_(judged.samples.groups.size()) {
  const std::set<std::string_view> names(solvers.begin(), solvers.end());
  for (std::size_t i = 0; i < groups_; ++i)
    if (names.contains(judged.samples.groups[i].name)) indices_[judged.samples.groups[i].name] = i;
  for (const Comparison& comparison : judged.comparisons) {
    if (!names.contains(comparison.first) || !names.contains(comparison.second)) continue;
    is_empty_ = false;
    const Verdict verdict = verdict_of(comparison);
    if (verdict == Verdict::not_tested) continue;
    ++tested_pairs_[comparison.first];
    ++tested_pairs_[comparison.second];
    if (is_difference(verdict)) beaten_.insert(verdict == Verdict::worse ? comparison.first : comparison.second);
  }
}

int PairIndex::tested_pairs(const std::string& name) const {
  const auto found = tested_pairs_.find(name);
  return found == tested_pairs_.end() ? 0 : found->second;
}

std::size_t PairIndex::index(std::string_view name) const {
  const auto found = indices_.find(name);
  return found == indices_.end() ? groups_ : found->second;
}

const Comparison* PairIndex::find(std::string_view first, std::string_view second) const {
  return table_.find(index(first), index(second));
}

Verdict PairIndex::verdict(std::string_view first, std::string_view second) const {
  return table_.verdict(index(first), index(second));
}

bool is_below_margin(const Comparison* comparison) {
  const auto* const tested = comparison ? std::get_if<TestResult>(&comparison->result) : nullptr;
  return tested && is_difference(tested->verdict) && tested->is_below_margin;
}

std::vector<Statement> make_statements(const JudgedMetric& judged, const Names& solvers) {
  return StatementMaker(judged, solvers).make();
}

std::vector<HeadlineQuestion> make_headline_questions(const std::vector<JudgedMetric>& metrics, const Names& solvers,
                                                      const Names& tie_breakers) {
  const JudgedMetric& primary = metrics.front();
  std::vector<HeadlineQuestion> questions{
      {.metric = 0, .solvers = solvers, .statements = make_statements(primary, solvers)}};
  const Names unseparated = unseparated_solvers(questions.front().statements.front());
  if (unseparated.size() < 2 || (solvers.size() > 2 && !primary.plan.control.empty())) return questions;
  const auto is_tested = [](const Statement& statement) {
    return statement.kind != Kind::not_tested && statement.kind != Kind::no_comparison;
  };
  std::vector<std::size_t> untested;
  for (const std::string& word : tie_breakers) {
    const std::optional<std::size_t> metric = find_tie_breaker(metrics, word);
    if (!metric) continue;
    std::vector<Statement> statements = make_statements(metrics[*metric], unseparated);
    if (std::ranges::any_of(statements, is_tested)) {
      questions.push_back({.metric = *metric,
                           .solvers = unseparated,
                           .statements = std::move(statements),
                           .tie_breaker = word,
                           .untested = std::move(untested)});
      return questions;
    }
    untested.push_back(*metric);
  }
  return questions;
}

}  // namespace ikbench::show
