#include "analysis/show/headline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>

#include "analysis/judge/statistics/closed_tests.hpp"
#include "analysis/judge/statistics/omnibus.hpp"
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
                                                           .is_best = "is fastest",
                                                           .are_best = "are fastest",
                                                           .be_better = "be faster",
                                                           .takes = "takes",
                                                           .take = "take",
                                                           .as = "as long"},
                                           TieBreakerWords{.tie_breaker = "evaluations",
                                                           .is_best = "needs the fewest evaluations",
                                                           .are_best = "need the fewest evaluations",
                                                           .be_better = "need fewer evaluations",
                                                           .takes = "needs",
                                                           .take = "need",
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

// Returns why pairs of these solvers are not tested: "8 runs; at least 10 needed", "the machine was busy". Empty if
// they have several reasons.
std::string reason_not_tested(const ReportModel& model, const JudgedMetric& judged, const Names& solvers) {
  std::set<std::string> reasons;
  const std::set<std::string_view> names(solvers.begin(), solvers.end());
  for (const Comparison& comparison : judged.comparisons) {
    const auto* const not_tested = std::get_if<NotTested>(&comparison.result);
    if (!not_tested || (!names.contains(comparison.first) && !names.contains(comparison.second))) continue;
    reasons.insert(reason_in_metric(*not_tested, judged, observation_noun(model, judged)));
  }
  return reasons.size() == 1 ? *reasons.begin() : "";
}

std::string in_brackets(const std::string& text) { return text.empty() ? "" : fmt::format(" ({})", text); }

// Returns names with their numbers and a remark about them: "B 18 (inconclusive)", but "B 2 (18, inconclusive)" and
// "B 2 (18), B 3 (17), inconclusive", because two brackets in a row are hard to read.
std::string with_remark(std::string text, const std::string& remark, std::size_t names) {
  if (remark.empty() || !text.ends_with(')')) return text + in_brackets(remark);
  if (names > 1) return fmt::format("{}, {}", text, remark);
  text.pop_back();
  return fmt::format("{}, {})", text, remark);
}

// Returns the names, each with its number: "PSO 88"; "LM 0.1 (88)" if a name has a digit or ends with a sign, because
// two numbers side by side would read as one.
Names joined(const Names& names, const Names& numbers) {
  const auto may_end_in_number = [](const std::string& name) {
    const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
    return std::ranges::any_of(name, is_digit) || static_cast<unsigned char>(name.back()) >= 0x80;
  };
  const bool has_brackets = std::ranges::any_of(names, may_end_in_number);
  Names texts;
  for (std::size_t i = 0; i < names.size(); ++i)
    texts.push_back(fmt::format(fmt::runtime(has_brackets ? "{} ({})" : "{} {}"), names[i], numbers[i]));
  return texts;
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

// True for a statement about the solvers that no other is shown to beat.
bool is_about_leaders(Kind kind) {
  switch (kind) {
    case Kind::no_comparison:
    case Kind::best:
    case Kind::equivalent:
    case Kind::inconclusive:
    case Kind::none_better:
      return true;
    case Kind::better:
    case Kind::worse:
    case Kind::not_tested:
    case Kind::cyclic:
      return false;
  }
  return false;
}

// True if each of the best solvers of a second question is better than each of the losers.
bool has_winner(const PairIndex& pairs, const Ranking& ranking) {
  const auto is_better = [&](const std::string& name, const std::string& loser) {
    return pairs.is_better(name, loser);
  };
  return !ranking.losers.empty() && holds_for_pairs(ranking.best, ranking.losers, is_better);
}

using SolverRatios = std::vector<std::pair<std::string, double>>;  // by solver

// Returns "; B takes 3x as long as A, C 4x"; for many solvers "; 6 others take 2x to 10x as long as A". `reference` is
// " as A"; empty if the sentence names A just before.
std::string ratios_text(const SolverRatios& ratios, const TieBreakerWords& words, const std::string& reference) {
  if (ratios.empty()) return "";
  if (ratios.size() < max_named) {
    Names texts;
    for (const auto& [name, ratio] : ratios) {
      const std::string text = ratio_text(ratio);
      texts.push_back(texts.empty() ? fmt::format("{} {} {} {}{}", name, words.takes, text, words.as, reference)
                                    : fmt::format("{} {}", name, text));
    }
    return fmt::format("; {}", fmt::join(texts, ", "));
  }
  const auto [smallest, largest] = std::ranges::minmax(ratios, {}, &SolverRatios::value_type::second);
  const std::string low = ratio_text(smallest.second), high = ratio_text(largest.second);
  return fmt::format("; {} others {} {}{} {}{}", ratios.size(), words.take, low == high ? "" : low + " to ", high,
                     words.as, reference);
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
    const std::vector<Statement>& statements = question_.statements;
    std::string text = opening();
    for (const Statement& statement : statements) {
      const bool is_own_sentence = statement.kind == Kind::not_tested && !is_against_control();
      if (&statement != &statements.front()) text += is_own_sentence ? ". " : "; ";
      text += is_against_control() ? control_clause(statement) : clause(statement);
    }
    return text + '.';
  }

  // Returns the sentence of a second question, with ratios to the solver that beats most of the others.
  std::string tie_breaker_sentence() const {
    const Ranking ranking = ranking_of(question_.statements);
    std::string text;
    for (const std::size_t metric : question_.untested) text += not_compared_sentence(model_.metrics[metric]);
    text += ranking.losers.empty() ? no_difference_clause(ranking) : difference_clause(ranking);
    if (!ranking.untested.empty())
      text += fmt::format("; {} {} not tested{}", names_of(ranking.untested), is_or_are(ranking.untested),
                          in_brackets(reason_not_tested(model_, judged_, ranking.untested)));
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
  std::string below_margin(bool is_so) const { return is_so ? " by less than " + margin_text(judged_) : ""; }

  // The beginning of a first question's sentence.

  bool is_against_control() const {
    return question_.statements.front().against == Names{judged_.plan.control} && model_.order.size() > 2;
  }
  // True if shares of solved targets differ, but no pair of solvers does, and no second question names a winner.
  bool is_without_winner() const {
    const Statement& only = question_.statements.front();
    const bool is_open = only.kind == Kind::inconclusive || only.kind == Kind::none_better;
    if (question_.statements.size() > 1 || !is_open || !is_solved(judged_) || is_against_control()) return false;
    if (model_.questions.size() > 1) {
      const HeadlineQuestion& second = model_.questions.back();
      const PairIndex pairs(model_.metrics[second.metric], second.solvers);
      if (has_winner(pairs, ranking_of(second.statements))) return false;
    }
    const double first = descriptives_of(only.solvers.front()).mean;
    return std::ranges::any_of(only.solvers,
                               [&](const std::string& name) { return descriptives_of(name).mean != first; });
  }
  // Returns what stands before the first clause: "No clear winner: ", "Within 1 ms, ", "Compared with old (40 of 100
  // targets), ".
  std::string opening() {
    std::string text;
    if (is_without_winner()) text = "no clear winner: ";
    const Kind first = question_.statements.front().kind;
    if (is_solved(judged_) && !model_.time_limit.empty() && first != Kind::not_tested && first != Kind::cyclic)
      text += fmt::format("within {}, ", model_.time_limit);
    if (is_against_control())
      text += fmt::format("compared with {}, ", with_numbers(question_.statements.front().against));
    if (!is_nothing_solved()) return as_sentence(text);
    const bool is_limited = !is_solved(judged_) && !model_.time_limit.empty();
    return as_sentence((is_limited ? fmt::format("within {}, no", model_.time_limit) : "no") +
                       " solver reached any target. ") +
           as_sentence(text);
  }

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
  // True if the errors decide only because no solver reached a target.
  bool is_about_closest() const { return judged_.plan.metric.empty() && is_nothing_solved(); }
  bool are_counts() const { return is_success_rate(judged_) && trials_per_value(judged_.samples) == 1; }

  std::string quantity() const {
    const std::string& name = judged_.samples.quantity;
    if (is_solved(judged_)) return "solved";
    if (is_success_rate(judged_) || is_log_scale(judged_.samples)) return name;
    return (judged_.plan.test == results::AnalysisPlan::Test::means ? "mean " : "median ") + name;
  }
  // Returns the quantity at the beginning of a sentence. The name of a user's metric keeps its first letter.
  std::string quantity_as_title() const {
    const std::string& name = judged_.samples.quantity;
    if (!is_solved(judged_)) return model_.direction.empty() || quantity() != name ? as_sentence(quantity()) : name;
    return as_sentence(name) + (model_.time_limit.empty() ? "" : " within " + model_.time_limit);
  }

  // Call it in the order of the sentence. Returns "88" or "0.42"; for the first solver also the quantity, and the whole
  // or the unit: "solved 100 of 100 targets".
  std::string number(const std::string& name) {
    if (!first_named_.empty()) return value_text(name, false);
    first_named_ = name;
    std::string value = value_text(name, true);
    if (are_counts())
      value = fmt::format("{} of {}", count_text(name), base::counted(descriptives_of(name).n, model_.noun));
    return fmt::format("{} {}{}", quantity(), value, is_solved(judged_) && !are_counts() ? " of targets" : "");
  }
  std::string value_text(const std::string& name, bool is_first) const {
    const MetricSamples& samples = judged_.samples;
    const auto [value, is_bound] = displayed_average(judged_, index_of(samples, name));
    if (std::isnan(value)) return "not known";
    if (are_counts()) {
      const int n = descriptives_of(name).n;
      const bool has_total = is_first || n != descriptives_of(first_named_).n;
      return has_total ? fmt::format("{} of {}", count_text(name), n) : count_text(name);
    }
    return with_unit((is_bound ? "at most " : "") + number_within(value, percent_boundaries(judged_)),
                     is_first ? samples.unit : "");
  }
  std::string count_text(const std::string& name) const {
    const Descriptives& shares = descriptives_of(name);
    return fmt::format("{:.0f}", shares.mean * shares.n / 100);
  }
  // Returns "DLS (median error 1 mm)", and after it "PSO (2)".
  std::string with_numbers(Names names) {
    for (std::string& name : names) name += fmt::format(" ({})", number(name));
    return names_of(names);
  }
  Names numbers(const Names& names) {
    Names texts;
    for (const std::string& name : names) texts.push_back(number(name));
    return texts;
  }
  // Returns "PSO 88 and mine 54"; for many solvers "7 others 12 to 88".
  std::string lower_counts(const Names& names, std::string_view last) {
    if (names.size() <= max_named) return listed(joined(names, numbers(names)), last);
    const std::string highest = number(names.front()), lowest = number(names.back());
    return fmt::format("{} others {}{}", names.size(), lowest, highest == lowest ? "" : " to " + highest);
  }

  // Returns "solved all 100 targets", or "solved 97 of 100 targets".
  std::string highest_count(const std::string& name) {
    const Descriptives& shares = descriptives_of(name);
    const std::string counted = number(name);
    if (shares.mean != 100 || shares.n < 2 || !are_counts()) return counted;
    return fmt::format("solved all {}", base::counted(shares.n, model_.noun));
  }
  // Returns "LM and DLS solved all 100 targets, SLSQP 99 (inconclusive)".
  std::string success_counts(const Statement& statement) {
    const double highest = descriptives_of(statement.solvers.front()).mean;
    const auto is_highest = [&](const std::string& name) { return descriptives_of(name).mean == highest; };
    const Names firsts = names_that(statement.solvers, is_highest);
    Names others = names_that(statement.solvers, [&](const std::string& name) { return !is_highest(name); });
    const std::string text = fmt::format("{} {}", names_of(firsts), highest_count(firsts.front()));
    if (others.empty()) return text;
    return fmt::format("{}, {}", text,
                       with_remark(lower_counts(others, ", "),
                                   is_without_winner() ? "" : difference_text(statement.kind), others.size()));
  }
  std::string difference_text(Kind kind) const {
    if (kind == Kind::inconclusive) return "inconclusive";
    if (kind == Kind::none_better) return "no difference is shown";
    return same_within_margin();
  }

  // The clauses of a first question.

  std::string control_clause(const Statement& statement) {
    if (statement.kind == Kind::inconclusive)
      return fmt::format("for {} it is inconclusive", with_numbers(statement.solvers));
    return fmt::format("{} {} {}{}", with_numbers(statement.solvers), is_or_are(statement.solvers),
                       verdict_against_control(statement), below_margin(statement.is_below_margin));
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
        return "not tested" + in_brackets(reason_not_tested(model_, judged_, statement.solvers));
      case Kind::inconclusive:   // has words of its own
      case Kind::no_comparison:  // the others are not said against a control
      case Kind::best:
      case Kind::none_better:
      case Kind::cyclic:
        break;
    }
    return "";
  }

  std::string clause(const Statement& statement) {
    const Names& solvers = statement.solvers;
    if (is_solved(judged_) && statement.against.empty() && is_about_leaders(statement.kind))
      return success_counts(statement);
    switch (statement.kind) {
      case Kind::no_comparison:
        return only_number(solvers.front());
      case Kind::best:
        return model_.order.size() == 2 ? best_of_two(statement) : best_of_many(statement);
      case Kind::equivalent:
        return fmt::format("{} are {}", with_numbers(solvers), same_within_margin());
      case Kind::inconclusive:
        return is_about_closest() ? closest_solver(solvers) : no_clear_winner(solvers);
      case Kind::none_better:
        return "No solver is shown to beat " + with_numbers(solvers);
      case Kind::cyclic:
        return fmt::format("No solver is best: each of {} is worse than some other", with_numbers(solvers));
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
  std::string no_clear_winner(const Names& solvers) {
    return fmt::format("No clear winner {} {}{}", solvers.size() == 2 ? "between" : "among", with_numbers(solvers),
                       are_all_equal(solvers) ? ": all values are equal" : "");
  }
  // Returns "PSO came closest (median position error 175 mm; DE 183, inconclusive)".
  std::string closest_solver(Names solvers) {
    std::ranges::stable_sort(solvers, {}, [&](const std::string& name) {
      return displayed_average(judged_, index_of(judged_.samples, name)).value;
    });
    const std::string closest = number(solvers.front());
    const Names others(solvers.begin() + 1, solvers.end());
    std::string text = listed(joined(others, numbers(others)));
    if (others.size() > max_named)
      text = fmt::format("{} others {} to {}", others.size(), number(solvers[1]), number(solvers.back()));
    return fmt::format("{} came closest ({}; {}, inconclusive)", solvers.front(), closest, text);
  }
  std::string best_of_two(const Statement& statement) {
    const std::string &best = statement.solvers.front(), &other = statement.against.front();
    const bool is_by_ranks =
        std::ranges::count(judged_.samples.warnings, WarningKind::ranks_disagree, &Warning::kind) > 0;
    std::string is_better = is_by_ranks ? "ranks better" : "is better";
    if (is_about_closest()) is_better = "came closer";
    const std::string text =
        fmt::format("{} {} than {}{}: ", best, is_better, other, below_margin(statement.is_below_margin));
    if (is_solved(judged_)) {
      const std::string highest = highest_count(best);
      return fmt::format("{}it {}, {}", text, highest, joined({other}, {number(other)}).front());
    }
    const std::string first_number = number(best);
    return fmt::format("{}{} against {}", text, first_number, number(other));
  }
  std::string best_of_many(const Statement& statement) {
    const Names &best = statement.solvers, &losers = statement.against;
    const std::string margin = below_margin(statement.is_below_margin);
    if (is_solved(judged_) && best.size() == 1) {
      const std::string highest = highest_count(best.front());
      return fmt::format("{} is best{}: it {}, {}", best.front(), margin, highest, lower_counts(losers, " and "));
    }
    const std::string winners = is_solved(judged_) ? success_counts(statement) : best_with_numbers(best);
    return fmt::format("{}; {} {} worse{}", winners, with_numbers(losers), is_or_are(losers), margin);
  }
  // Returns "A is best (median error 1 mm)", or "A (median error 1 mm) and B (1.1) are best".
  std::string best_with_numbers(const Names& best) {
    const bool is_one = best.size() == 1;
    if (is_about_closest() && is_one) return fmt::format("{} came closest ({})", best.front(), number(best.front()));
    if (is_one) return fmt::format("{} is best ({})", best.front(), number(best.front()));
    return with_numbers(best) + (is_about_closest() ? " came closest" : " are best");
  }
  // Returns "Not tested: 2 blocks, at least 7 needed. Median yield: NPK 4.08, N 3.87"; after other clauses "Not tested
  // against LM: PSO 36 (5 targets, at least 8 needed)".
  std::string not_tested_clause(const Statement& statement) {
    const std::string reason = reason_not_tested(model_, judged_, statement.solvers);
    const std::string against = statement.against.empty() ? "" : " against " + statement.against.front();
    const bool is_first = first_named_.empty();
    if (is_first) first_named_ = statement.solvers.front();
    Names known, values, unknown;
    for (const std::string& name : statement.solvers) {
      const bool is_known = !std::isnan(displayed_average(judged_, index_of(judged_.samples, name)).value);
      (is_known || is_first ? known : unknown).push_back(name);
      if (is_known || is_first) values.push_back(value_text(name, is_first && values.empty()));
    }
    Names texts = joined(known, values);
    texts.insert(texts.end(), unknown.begin(), unknown.end());
    if (!is_first) return fmt::format("Not tested{}: {}", against, with_remark(names_of(texts), reason, texts.size()));
    return fmt::format("Not tested{}{}. {}: {}", against, reason.empty() ? "" : ": " + reason, quantity_as_title(),
                       names_of(texts, ", "));
  }
  std::string worse_clause(const Statement& statement) {
    const std::string& winner = statement.against.front();
    const std::string losers = with_numbers(statement.solvers);
    const bool is_winner_clear = (is_solved(judged_) || is_about_closest()) && winner == first_named_;
    return fmt::format("{} {} worse{}{}", losers, is_or_are(statement.solvers),
                       is_winner_clear ? "" : " than " + winner, below_margin(statement.is_below_margin));
  }
  bool are_all_equal(const Names& solvers) const {
    return holds_for_pairs(solvers, solvers, [&](const std::string& first, const std::string& second) {
      return all_values_equal(*pairs_.find(first, second));
    });
  }

  // The clauses of a second question.

  std::string not_compared_sentence(const JudgedMetric& untested) const {
    return fmt::format("{} is not compared{}. ", as_sentence(untested.samples.quantity),
                       in_brackets(reason_not_tested(model_, untested, question_.solvers)));
  }
  std::string no_difference_clause(const Ranking& ranking) const {
    const std::string& quantity = judged_.samples.quantity;
    const Kind kind = question_.statements.front().kind;
    if (kind == Kind::cyclic) return fmt::format("In {} each is worse than some other", quantity);
    if (kind == Kind::equivalent && ranking.untested.empty())
      return fmt::format("In {} they are {}", quantity, same_within_margin());
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
    if (!has_winner(pairs_, ranking))
      return fmt::format("No solver is shown to {} than {}{}", words.be_better, leader, ratios_text(ratios, words, ""));
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

// Returns how many blocks closed tests compare in a metric: "7", or "7 to 9" if pairs have different blocks in common.
std::string closed_sizes(const JudgedMetric& judged, const std::string& noun) {
  std::set<int> sizes;
  for (const Comparison& comparison : judged.comparisons)
    if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) sizes.insert(tested->n);
  const std::string fewest = sizes.size() == 1 ? "" : fmt::format("{} to ", *sizes.begin());
  return fewest + base::counted(*sizes.rbegin(), noun);
}

// Returns the p of Friedman's test, if the blocks are too few to test any pair; otherwise empty.
std::string friedman_sentence(const JudgedMetric& judged) {
  const auto has_few_blocks = [](const Comparison& comparison) {
    return is_not_tested(comparison, NotTestedReason::sample_too_small);
  };
  if (judged.comparisons.empty() || judged.plan.test != results::AnalysisPlan::Test::ranks || is_success_rate(judged) ||
      !std::ranges::all_of(judged.comparisons, has_few_blocks))
    return "";
  const std::vector<OmnibusTest> tests = friedman(judged.samples);
  if (tests.empty()) return "";
  const std::string p = p_text(tests.front().p, {judged.plan.significance});
  return fmt::format(" {} of all {}: p {}{}.", friedman_name, judged.samples.groups.size(), p[0] == '<' ? "" : "= ", p);
}

// Returns the sentences that name the tests of metrics with few blocks.
std::string few_blocks_sentences(const ReportModel& model) {
  std::string text = friedman_sentence(model.primary());
  for (const HeadlineQuestion& question : model.questions) {
    const JudgedMetric& judged = model.metrics[question.metric];
    if (!are_by_closed_tests(judged.comparisons)) continue;
    const std::string blocks = closed_sizes(judged, observation_noun(model, judged));
    const std::string quantity = &judged == &model.primary() ? "" : " in " + judged.samples.quantity;
    text += fmt::format(" Because {} are few, pairs are compared{} by {}.", blocks, quantity, closed_tests_name);
  }
  return text;
}

}  // namespace

std::string tie_breaker_sentence(const ReportModel& model) {
  if (model.questions.size() < 2) return "";
  return QuestionTeller(model, model.questions.back()).tie_breaker_sentence();
}

std::string headline(const ReportModel& model) {
  if (!model.verdict.empty()) return model.verdict;
  const std::string first = QuestionTeller(model, model.questions.front()).primary_sentence();
  const std::string second = tie_breaker_sentence(model);
  return (second.empty() ? first : first + ' ' + second) + few_blocks_sentences(model);
}

std::string ranking_note(const ReportModel& model) {
  const auto has_winner = [&](const JudgedMetric& judged) {
    return &judged != &model.primary() && !beaten_solvers(judged.comparisons).empty();
  };
  if (!model.verdict.empty() || std::ranges::none_of(model.metrics, has_winner)) return "";
  const std::string first = "Ranked by " + model.primary().samples.quantity;
  if (model.questions.size() < 2) return first;
  return fmt::format("{}, then {}", first, model.metrics[model.questions.back().metric].samples.quantity);
}

}  // namespace ikbench::show
