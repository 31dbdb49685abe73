#include "analysis/show/headline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "analysis/show/phrases.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;
using Kind = Statement::StatementKind;
using Names = std::vector<std::string>;

namespace {

// The words of a second question.
struct TieBreakerWords {
  std::string_view tie_breaker;        // in a plan
  std::string_view is_best, are_best;  // of one solver, of several
  std::string_view be_better;
  std::string_view takes, take;  // of one solver, of several
  std::string_view as;           // follows a ratio
};
constexpr std::array words_of_tie_breakers{TieBreakerWords{.tie_breaker = "time",
                                                           .is_best = "is the fastest",
                                                           .are_best = "are the fastest",
                                                           .be_better = "be faster",
                                                           .takes = "takes",
                                                           .take = "take",
                                                           .as = "as long"},
                                           TieBreakerWords{.tie_breaker = "evaluations",
                                                           .is_best = "needs the fewest evaluations",
                                                           .are_best = "need the fewest evaluations",
                                                           .be_better = "need fewer evaluations",
                                                           .takes = "takes",
                                                           .take = "take",
                                                           .as = "as many"},
                                           TieBreakerWords{.tie_breaker = "motion",
                                                           .is_best = "moves the joints least",
                                                           .are_best = "move the joints least",
                                                           .be_better = "move the joints less",
                                                           .takes = "moves them",
                                                           .take = "move them",
                                                           .as = "as far"}};

bool is_solved(const JudgedMetric& judged) { return judged.samples.quantity_kind == QuantityKind::solved; }

std::string is_or_are(const Names& solvers) { return solvers.size() == 1 ? "is" : "are"; }

// Returns why no number of a pair is comparable, by the metric's warnings.
std::string not_comparable_text(const JudgedMetric& judged, std::string reason) {
  for (const Warning& warning : judged.samples.warnings) {
    if (warning.kind == WarningKind::times_not_comparable) reason = warning.detail;
    if (warning.kind == WarningKind::time_limit_decides) reason = "stopped by the time limit";
  }
  return reason;
}

// Returns why pairs of these solvers are not tested: " (8 runs are too few, 10 are needed)", " (the machine was busy)".
// Empty if they have several reasons.
std::string not_tested_text(const ReportModel& model, const JudgedMetric& judged, const Names& solvers) {
  std::set<std::string> reasons;
  const std::set<std::string_view> names(solvers.begin(), solvers.end());
  for (const Comparison& comparison : judged.comparisons) {
    const auto* const not_tested = std::get_if<NotTested>(&comparison.result);
    if (!not_tested || (!names.contains(comparison.first) && !names.contains(comparison.second))) continue;
    std::string reason = reason_text(*not_tested, observation_noun(model, judged));
    if (not_tested->reason == NotTestedReason::not_comparable) reason = not_comparable_text(judged, std::move(reason));
    reasons.insert(std::move(reason));
  }
  return reasons.size() == 1 ? fmt::format(" ({})", *reasons.begin()) : "";
}

// The solvers of a second question: those that no other is shown to beat or that are not separated, the worse ones, and
// those that are not tested.
struct Ranking {
  Names best, losers, untested;
};

Ranking ranking_of(const std::vector<Statement>& statements) {
  Ranking ranking;
  const auto append = [](Names& names, const Names& more) { names.insert(names.end(), more.begin(), more.end()); };
  for (const Statement& statement : statements) {
    switch (statement.kind) {
      case Kind::not_tested:
        append(ranking.untested, statement.solvers);
        break;
      case Kind::worse:
        append(ranking.losers, statement.solvers);
        break;
      case Kind::best:
        append(ranking.best, statement.solvers);
        ranking.losers = statement.against;
        break;
      case Kind::no_comparison:
      case Kind::equivalent:
      case Kind::inconclusive:
      case Kind::none_better:
      case Kind::better:
      case Kind::cyclic:
        append(ranking.best, statement.solvers);
        break;
    }
  }
  return ranking;
}

using SolverRatios = std::vector<std::pair<std::string, double>>;  // by solver

// Returns "; B takes 3 times as long, C 4 times"; of many solvers "; 6 others take 2 to 10 times as long".
std::string ratios_text(const SolverRatios& ratios, const TieBreakerWords& words, const std::string& reference) {
  if (ratios.empty()) return "";
  if (ratios.size() < max_named) {
    Names texts;
    for (const auto& [name, ratio] : ratios)
      texts.push_back(
          fmt::format("{} {}{}", name, texts.empty() ? fmt::format("{} ", words.takes) : "", ratio_text(ratio)));
    return fmt::format("; {} {}{}", fmt::join(texts, ", "), words.as, reference);
  }
  const auto [smallest, largest] = std::ranges::minmax(ratios, {}, &SolverRatios::value_type::second);
  const bool are_equal = ratio_text(smallest.second) == ratio_text(largest.second);
  const std::string from = are_equal ? "" : number_text(smallest.second, 2) + " to ";
  return fmt::format("; {} others {} {}{} {}{}", ratios.size(), words.take, from, ratio_text(largest.second), words.as,
                     reference);
}

// Writes the sentence of one question from its statements. Only the first number of a sentence has quantity and unit,
// so each QuestionTeller writes one sentence.
class QuestionTeller {
 public:
  QuestionTeller(const ReportModel& model, const HeadlineQuestion& question)
      : model_(model),
        question_(question),
        judged_(model.metrics[question.metric]),
        pairs_(judged_, question.solvers) {}

  // Returns the sentence of a first question, with the solvers' numbers.
  std::string primary_sentence() {
    std::string text = is_nothing_solved() ? "No target was solved. " : "";
    const std::vector<Statement>& statements = question_.statements;
    const Names& control = statements.front().against;
    const bool is_against_control = control == Names{judged_.plan.control} && model_.order.size() > 2;
    if (is_against_control) text += fmt::format("Against {}: ", with_numbers(control));
    for (const Statement& statement : statements) {
      if (&statement != &statements.front()) text += "; ";
      text += is_against_control ? control_clause(statement) : clause(statement);
    }
    return text + '.';
  }

  // Returns the sentence of a second question, with ratios to the solver that beats most of the others.
  std::string tie_breaker_sentence() const {
    const Ranking ranking = ranking_of(question_.statements);
    std::string text;
    for (const std::size_t metric : question_.untested) text += not_judged_sentence(model_.metrics[metric]);
    text += ranking.losers.empty() ? no_difference_clause(ranking) : difference_clause(ranking);
    if (!ranking.untested.empty())
      text += fmt::format("; {} {} not judged{}", names_of(ranking.untested), is_or_are(ranking.untested),
                          not_tested_text(model_, judged_, ranking.untested));
    return text + '.';
  }

 private:
  const ReportModel& model_;
  const HeadlineQuestion& question_;
  const JudgedMetric& judged_;
  const PairIndex pairs_;
  std::string first_named_ = {};  // the solver with the first number; empty: none yet

  // Words of both sentences.

  std::string same_within_margin() const { return "the same within " + margin_text(judged_); }
  std::string below_margin(bool is_so) const { return is_so ? ", by less than " + margin_text(judged_) : ""; }

  // The numbers of a first question.

  const Descriptives& descriptives_of(const std::string& name) const {
    return judged_.descriptives[index_of(judged_.samples, name)];
  }
  bool is_nothing_solved() const {
    return std::ranges::any_of(model_.metrics, [&](const JudgedMetric& other) {
      return &other != &judged_ && is_solved(other) &&
             std::ranges::all_of(other.descriptives, [](const Descriptives& shares) { return shares.mean == 0; });
    });
  }
  std::string within() const { return is_solved(judged_) ? model_.within : ""; }
  bool are_counts() const { return is_success_rate(judged_) && trials_per_value(judged_.samples) == 1; }

  std::string quantity() const {
    const std::string& name = judged_.samples.quantity;
    if (is_success_rate(judged_) || is_log_scale(judged_.samples)) return name;
    return (judged_.plan.test == results::AnalysisPlan::Test::means ? "mean " : "median ") + name;
  }

  // Returns "88" or "0.42"; for the first solver also the quantity, and the whole or the unit: "solved 100 of 100
  // targets".
  std::string number(const std::string& name) {
    if (first_named_.empty()) {
      first_named_ = name;
      return fmt::format("{} {}", quantity(), value_text(name, true));
    }
    return value_text(name, false);
  }
  std::string value_text(const std::string& name, bool is_first) const {
    const MetricSamples& samples = judged_.samples;
    const auto [value, is_bound] = displayed_average(judged_, index_of(samples, name));
    if (std::isnan(value)) return "not known";
    if (are_counts()) return count_text(value, name, is_first);
    return with_unit((is_bound ? "at most " : "") + number_within(value, percent_boundaries(judged_)),
                     is_first ? samples.unit : "");
  }
  std::string count_text(double percent, const std::string& name, bool is_first) const {
    const int n = descriptives_of(name).n;
    const std::string count = fmt::format("{:.0f}", percent * n / 100);
    if (is_first) return fmt::format("{} of {}{}", count, base::counted(n, model_.noun), within());
    return n == descriptives_of(first_named_).n ? count : fmt::format("{} of {}", count, n);
  }
  // Returns "DLS (solved 100 of 100 targets)", and after it "PSO (88)".
  std::string with_numbers(Names names) {
    for (std::string& name : names) name += fmt::format(" ({})", number(name));
    return names_of(names);
  }

  // Returns "LM and DLS solved all 100 targets, SLSQP 99 (not decided)".
  std::string success_counts(const Statement& statement) {
    const double highest = descriptives_of(statement.solvers.front()).mean;
    const int n = descriptives_of(statement.solvers.front()).n;
    const auto is_highest = [&](const std::string& name) { return descriptives_of(name).mean == highest; };
    const Names firsts = names_that(statement.solvers, is_highest);
    Names others = names_that(statement.solvers, [&](const std::string& name) { return !is_highest(name); });
    const std::string first_number = number(firsts.front());
    const bool are_all_solved = highest == 100 && n > 1 && trials_per_value(judged_.samples) == 1;
    std::string text = names_of(firsts) + ' ';
    text += are_all_solved ? fmt::format("solved all {}{}", base::counted(n, model_.noun), within()) : first_number;
    if (others.empty()) return text;
    return fmt::format("{}, {} ({})", text, lower_counts(std::move(others)), difference_text(statement.kind));
  }
  std::string lower_counts(Names names) {
    if (names.size() <= max_named) {
      for (std::string& name : names) name += ' ' + number(name);
      return fmt::format("{}", fmt::join(names, ", "));
    }
    const std::string highest = number(names.front()), lowest = number(names.back());
    return fmt::format("{} others {}{}", names.size(), lowest, highest == lowest ? "" : " to " + highest);
  }
  std::string difference_text(Kind kind) const {
    if (kind == Kind::inconclusive) return "not decided";
    if (kind == Kind::none_better) return "no difference is shown";
    return same_within_margin();
  }

  // The clauses of a first question.

  std::string control_clause(const Statement& statement) {
    return fmt::format("{} {}{}", with_numbers(statement.solvers), verdict_against_control(statement),
                       below_margin(statement.is_below_margin));
  }
  std::string verdict_against_control(const Statement& statement) const {
    switch (statement.kind) {
      case Kind::better:
        return "better";
      case Kind::worse:
        return "worse";
      case Kind::equivalent:
        return same_within_margin();
      case Kind::not_tested:
        return "not tested" + not_tested_text(model_, judged_, statement.solvers);
      case Kind::no_comparison:  // of these, only `inconclusive` is said against a control
      case Kind::best:
      case Kind::inconclusive:
      case Kind::none_better:
      case Kind::cyclic:
        return "not decided";
    }
    return "not decided";
  }

  std::string clause(const Statement& statement) {
    const Names& solvers = statement.solvers;
    if (is_solved(judged_) && statement.against.empty() && statement.kind <= Kind::none_better)
      return success_counts(statement);
    switch (statement.kind) {
      case Kind::no_comparison:
        return only_number(solvers.front());
      case Kind::best:
        return model_.order.size() == 2 ? best_of_two(statement) : best_of_many(statement);
      case Kind::equivalent:
        return fmt::format("{} are {}", with_numbers(solvers), same_within_margin());
      case Kind::inconclusive:
        return fmt::format("Not decided between {}{}", with_numbers(solvers),
                           are_all_equal(solvers) ? ": all values are equal" : "");
      case Kind::none_better:
        return "Nobody is shown to beat " + with_numbers(solvers);
      case Kind::cyclic:
        return "No solver is best, since each is worse than another: " + with_numbers(solvers);
      case Kind::not_tested:
        return not_tested_clause(statement);
      case Kind::better:  // only against a control, where other words stand
      case Kind::worse:
        return worse_clause(statement);
    }
    return "";
  }

  std::string only_number(const std::string& name) {
    const std::string text = number(name);
    return fmt::format("The {} of {} is{}", quantity(), name, text.substr(quantity().size()));
  }
  std::string best_solvers(const Statement& statement) {
    const bool are_many_solved = is_solved(judged_) && statement.solvers.size() > 1;
    return are_many_solved ? success_counts(statement) : with_numbers(statement.solvers);
  }
  std::string best_of_two(const Statement& statement) {
    const std::string best = best_solvers(statement);
    const bool is_by_ranks =
        std::ranges::count(judged_.samples.warnings, WarningKind::ranks_disagree, &Warning::kind) > 0;
    return fmt::format("{} is better than {}{}{}", best, with_numbers(statement.against),
                       is_by_ranks ? " by ranks" : "", below_margin(statement.is_below_margin));
  }
  std::string best_of_many(const Statement& statement) {
    const std::string best = best_solvers(statement);
    return fmt::format("{}{}; {} {} worse{}", best, is_best_text(statement.solvers.size() > 1),
                       with_numbers(statement.against), is_or_are(statement.against),
                       below_margin(statement.is_below_margin));
  }
  std::string is_best_text(bool are_many) const {
    if (is_solved(judged_) && are_many) return "";  // counts are a sentence
    if (judged_.plan.metric.empty() && is_nothing_solved()) return are_many ? " come nearest" : " comes nearest";
    return are_many ? " are best" : " is best";
  }
  std::string not_tested_clause(const Statement& statement) {
    const char* const not_tested = first_named_.empty() ? "Not tested" : "not tested";
    return fmt::format("{}{}{}: {}", not_tested,
                       statement.against.empty() ? "" : " against " + statement.against.front(),
                       not_tested_text(model_, judged_, statement.solvers), with_numbers(statement.solvers));
  }
  std::string worse_clause(const Statement& statement) {
    const std::string& winner = statement.against.front();
    const std::string losers = with_numbers(statement.solvers);
    return fmt::format("{} {} worse{}{}", losers, is_or_are(statement.solvers),
                       is_solved(judged_) && winner == first_named_ ? "" : " than " + winner,
                       below_margin(statement.is_below_margin));
  }
  bool are_all_equal(const Names& solvers) const {
    return holds_for_pairs(solvers, solvers, [&](const std::string& first, const std::string& second) {
      return all_values_equal(*pairs_.find(first, second));
    });
  }

  // The clauses of a second question.

  std::string not_judged_sentence(const JudgedMetric& untested) const {
    return fmt::format("{} is not judged{}. ", as_sentence(untested.samples.quantity),
                       not_tested_text(model_, untested, question_.solvers));
  }
  std::string no_difference_clause(const Ranking& ranking) const {
    const std::string& quantity = judged_.samples.quantity;
    const Kind kind = question_.statements.front().kind;
    if (kind == Kind::cyclic) return fmt::format("By {} each is worse than another", quantity);
    if (kind == Kind::equivalent && ranking.untested.empty())
      return fmt::format("By {} they are {}", quantity, same_within_margin());
    return fmt::format("No difference in {} is shown", quantity);
  }
  std::string difference_clause(const Ranking& ranking) const {
    const TieBreakerWords& words =
        *std::ranges::find(words_of_tie_breakers, question_.tie_breaker, &TieBreakerWords::tie_breaker);
    const auto is_better = [&](const std::string& name, const std::string& loser) {
      return pairs_.is_better(name, loser);
    };
    const std::string leader = *std::ranges::max_element(ranking.best, {}, [&](const std::string& name) {
      return std::ranges::count_if(ranking.losers, [&](const std::string& loser) { return is_better(name, loser); });
    });
    const SolverRatios ratios = ratios_to(leader, ranking.losers);
    if (!holds_for_pairs(ranking.best, ranking.losers, is_better))
      return fmt::format("None is shown to {} than {}{}", words.be_better, leader, ratios_text(ratios, words, ""));
    const bool is_one = ranking.best.size() == 1;
    const bool are_small = holds_for_pairs(
        ranking.best, ranking.losers,
        [&](const std::string& name, const std::string& loser) { return is_below_margin(pairs_.find(name, loser)); });
    return fmt::format("{} {}{}{}", names_of(ranking.best), is_one ? words.is_best : words.are_best,
                       below_margin(are_small), ratios_text(ratios, words, is_one ? "" : " as " + leader));
  }
  // Returns the ratios of the losers that the leader beats, where they are known.
  SolverRatios ratios_to(const std::string& leader, const Names& losers) const {
    SolverRatios ratios;
    for (const std::string& loser : losers) {
      const Comparison* const pair = pairs_.find(leader, loser);
      if (pair == nullptr || !pairs_.is_better(leader, loser)) continue;
      if (!pair->estimate || pair->scale != EffectScale::ratio) continue;
      ratios.emplace_back(loser, pair->first == loser ? pair->estimate->value : 1 / pair->estimate->value);
    }
    return ratios;
  }
};

}  // namespace

std::string tie_breaker_sentence(const ReportModel& model) {
  if (model.questions.size() < 2) return "";
  return QuestionTeller(model, model.questions.back()).tie_breaker_sentence();
}

std::string headline(const ReportModel& model) {
  if (!model.verdict.empty()) return model.verdict;
  const std::string first = QuestionTeller(model, model.questions.front()).primary_sentence();
  const std::string second = tie_breaker_sentence(model);
  return second.empty() ? first : first + ' ' + second;
}

std::string ranking_note(const ReportModel& model) {
  const auto has_winner = [&](const JudgedMetric& judged) {
    return &judged != &model.primary() && !beaten_solvers(judged.comparisons).empty();
  };
  if (!model.verdict.empty() || std::ranges::none_of(model.metrics, has_winner)) return "";
  const std::string first = "Judged by " + model.primary().samples.quantity;
  if (model.questions.size() < 2) return first;
  return fmt::format("{}, then {}", first, model.metrics[model.questions.back().metric].samples.quantity);
}

}  // namespace ikbench::show
