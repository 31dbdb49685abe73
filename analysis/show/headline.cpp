#include "analysis/show/headline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "analysis/show/phrases.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;
using What = Statement::StatementKind;
using Names = std::vector<std::string>;

namespace {

bool has(const Names& names, const std::string& name) { return std::ranges::count(names, name) > 0; }

bool is_solved(const JudgedMetric& judged) { return judged.samples.quantity_kind == QuantityKind::solved; }

// The findings among some, by pair.
class Pairs {
 public:
  Pairs(const JudgedMetric& judged, const Names& names) {
    const std::set<std::string_view> among(names.begin(), names.end());
    for (const Comparison& comparison : judged.comparisons) {
      if (!among.contains(comparison.first) || !among.contains(comparison.second)) continue;
      all_[{comparison.first, comparison.second}] = all_[{comparison.second, comparison.first}] = &comparison;
      for (const std::string* const name : {&comparison.first, &comparison.second})
        tested_[*name] += verdict_of(comparison) != Verdict::not_tested;
      if (is_difference(verdict_of(comparison))) losers_.merge(beaten_solvers({comparison}));
    }
  }

  bool is_any() const { return !all_.empty(); }
  bool is_loser(const std::string& name) const { return losers_.contains(name); }
  int tested(const std::string& name) const { return tested_.contains(name) ? tested_.at(name) : 0; }
  const Comparison* finding(std::string_view one, std::string_view other) const {
    const auto found = all_.find({one, other});
    return found == all_.end() ? nullptr : found->second;
  }
  Verdict of(std::string_view one, std::string_view other) const {
    const Comparison* const its = finding(one, other);
    if (its == nullptr) return Verdict::not_tested;
    return its->first == one ? verdict_of(*its) : reversed(verdict_of(*its));
  }

 private:
  std::map<std::pair<std::string_view, std::string_view>, const Comparison*> all_ = {};
  std::map<std::string_view, int> tested_ = {};
  std::set<std::string> losers_ = {};
};

bool is_little(const Comparison* comparison) {
  const auto* const tested = comparison ? std::get_if<TestResult>(&comparison->result) : nullptr;
  return tested && is_difference(tested->verdict) && tested->is_below_margin;
}

bool are_alike(const Comparison* comparison) {
  return comparison && (verdict_of(*comparison) == Verdict::equivalent || all_values_equal(*comparison));
}

// Of each of some and each of the others.
bool all_pairs(const Names& some, const Names& others, auto is_so) {
  return std::ranges::all_of(some, [&](const std::string& one) {
    return std::ranges::all_of(others, [&](const std::string& other) { return one == other || is_so(one, other); });
  });
}

Names who_of(const Names& names, auto is_so) {
  Names who;
  std::ranges::copy_if(names, std::back_inserter(who), is_so);
  return who;
}

// Of the unbeaten the one that is tested most, which the others are held against; empty if all are beaten.
std::string leader_of(const Pairs& pairs, const Names& among) {
  const Names unbeaten = who_of(among, [&](auto& name) { return !pairs.is_loser(name); });
  const auto leader = std::ranges::max_element(unbeaten, {}, [&](auto& name) { return pairs.tested(name); });
  return leader == unbeaten.end() ? "" : *leader;
}

// How the second question is told.
struct Words {
  std::string_view then;                // in a plan
  std::string_view metric, per_solved;  // which stands in its place where a target failed
  std::string_view is, are, than, takes, take, as;
};
constexpr std::array all_words{
    Words{"time", "time", "time-per-solved", "is the fastest", "are the fastest", "be faster", "takes", "take",
          "as long"},
    Words{"evaluations", "evaluations", "evaluations-per-solved", "needs the fewest evaluations",
          "need the fewest evaluations", "need fewer evaluations", "takes", "take", "as many"},
    Words{"motion", "variation", "slide-variation", "moves the joints least", "move the joints least",
          "move the joints less", "moves them", "move them", "as far"}};

// Null if the answer lacks it.
const JudgedMetric* metric_of(const ReportModel& answer, const Words& words) {
  const auto found = std::ranges::find_if(answer.metrics, [&](const JudgedMetric& judged) {
    return judged.samples.metric == words.metric || judged.samples.metric == words.per_solved;
  });
  return found == answer.metrics.end() || &*found == &answer.primary() ? nullptr : &*found;
}

// Why pairs of these are not tested, if all have one reason: " (8 runs are too few, 10 are needed)", " (the machine was
// busy)".
std::string why_not(const ReportModel& answer, const JudgedMetric& judged, const Names& who) {
  std::set<std::string> reasons;
  const std::set<std::string_view> named(who.begin(), who.end());
  for (const Comparison& comparison : judged.comparisons) {
    const auto* const open = std::get_if<NotTested>(&comparison.result);
    if (!open || (!named.contains(comparison.first) && !named.contains(comparison.second))) continue;
    std::string reason = reason_text(*open, observation_noun(answer, judged));
    for (const Warning& warning : judged.samples.warnings) {
      if (open->reason == NotTestedReason::not_comparable && warning.kind == WarningKind::times_not_comparable)
        reason = warning.detail;
      if (open->reason == NotTestedReason::not_comparable && warning.kind == WarningKind::time_limit_decides)
        reason = "stopped by the time limit";
    }
    reasons.insert(std::move(reason));
  }
  return reasons.size() == 1 ? fmt::format(" ({})", *reasons.begin()) : "";
}

std::string is_or_are(const Names& who) { return who.size() == 1 ? "is" : "are"; }

// The sentence of the deciding metric.
class First {
 public:
  explicit First(const ReportModel& answer) : answer_(answer), judged_(answer.primary()) {}

  std::string told(const std::vector<Statement>& said) {
    std::string text = is_nothing_solved() ? "No target was solved. " : "";
    const bool is_control = said.front().against == Names{judged_.plan.control} && answer_.order.size() > 2;
    if (is_control) text += fmt::format("Against {}: ", with_numbers(said.front().against));
    for (const Statement& fact : said) {
      if (&fact != &said.front()) text += "; ";
      text += is_control ? fmt::format("{} {}{}", with_numbers(fact.solvers), word(fact), little(fact)) : phrase(fact);
    }
    return text;
  }

 private:
  const ReportModel& answer_;
  const JudgedMetric& judged_;
  std::string first_ = {};  // whose number was told first, with its unit

  bool is_nothing_solved() const {
    return std::ranges::any_of(answer_.metrics, [&](const JudgedMetric& judged) {
      return &judged != &judged_ && is_solved(judged) &&
             std::ranges::all_of(judged.descriptives, [](const Descriptives& its) { return its.mean == 0; });
    });
  }
  const Descriptives& described(const std::string& name) const {
    return judged_.descriptives[index_of(judged_.samples, name)];
  }
  std::string little(const Statement& fact) const {
    return fact.is_below_margin ? ", by less than " + margin_text(judged_) : "";
  }

  // "88", "0.42"; of the first also what it is, the whole or the unit: "solved 100 of 100 targets".
  std::string number(const std::string& name) {
    const bool is_first = first_.empty();
    if (is_first) first_ = name;
    const MetricSamples& samples = judged_.samples;
    const auto [value, is_bound] = displayed_average(judged_, index_of(samples, name));
    const int n = described(name).n;
    std::string text = with_unit((is_bound ? "at most " : "") + number_within(value, percent_boundaries(judged_)),
                                 is_first ? samples.unit : "");
    if (is_success_rate(judged_) && trials_per_value(samples) == 1) {
      text = fmt::format("{:.0f}", value * n / 100);
      if (is_first)
        text += fmt::format(" of {}{}", base::counted(n, answer_.noun), within());
      else if (n != described(first_).n)
        text += fmt::format(" of {}", n);
    }
    if (std::isnan(value)) text = "not known";
    return is_first ? fmt::format("{} {}", quantity(), text) : text;
  }
  std::string within() const { return is_solved(judged_) ? answer_.within : ""; }
  std::string quantity() const {
    const bool is_mean = judged_.plan.test == results::AnalysisPlan::Test::means;
    const char* const of = is_success_rate(judged_) || is_log_scale(judged_.samples) ? ""
                           : is_mean                                                 ? "mean "
                                                                                     : "median ";
    return of + judged_.samples.quantity;
  }
  // "DLS (solved 100 of 100 targets)", and after it "PSO (88)".
  std::string with_numbers(Names names) {
    for (std::string& name : names) name += fmt::format(" ({})", number(name));
    return names_of(names);
  }

  std::string word(const Statement& fact) const {
    return fact.kind == What::better       ? "better"
           : fact.kind == What::worse      ? "worse"
           : fact.kind == What::equivalent ? "the same within " + margin_text(judged_)
           : fact.kind == What::not_tested ? "not tested" + why_not(answer_, judged_, fact.solvers)
                                           : "not decided";
  }

  std::string phrase(const Statement& fact) {
    const auto& who = fact.solvers;
    const bool is_begin = first_.empty();
    const bool are_many = who.size() > 1, is_nearest = judged_.plan.metric.empty() && is_nothing_solved();
    if (is_solved(judged_) && fact.against.empty() && fact.kind <= What::none_better) return counted(fact);
    switch (fact.kind) {
      case What::no_comparison: {
        const std::string its = number(who.front());
        return fmt::format("The {} of {} is{}", quantity(), who.front(), its.substr(quantity().size()));
      }
      case What::best: {
        const std::string best = is_solved(judged_) && are_many ? counted(fact) : with_numbers(who);
        const bool is_odd =
            std::ranges::count(judged_.samples.warnings, WarningKind::ranks_disagree, &Warning::kind) > 0;
        if (answer_.order.size() == 2)
          return fmt::format("{} is better than {}{}{}", best, with_numbers(fact.against), is_odd ? " by ranks" : "",
                             little(fact));
        const char* const is = is_solved(judged_) && are_many ? ""
                               : is_nearest                   ? (are_many ? " come nearest" : " comes nearest")
                               : are_many                     ? " are best"
                                                              : " is best";
        return fmt::format("{}{}; {} {} worse{}", best, is, with_numbers(fact.against), is_or_are(fact.against),
                           little(fact));
      }
      case What::equivalent:
        return fmt::format("{} are the same within {}", with_numbers(who), margin_text(judged_));
      case What::inconclusive:
        return fmt::format("Not decided between {}{}", with_numbers(who),
                           who_are_equal(who) ? ": all values are equal" : "");
      case What::none_better:
        return "Nobody is shown to beat " + with_numbers(who);
      case What::cyclic:
        return "No solver is best, since each is worse than another: " + with_numbers(who);
      case What::not_tested:
        return fmt::format("{}ot tested{}{}: {}", is_begin ? 'N' : 'n',
                           fact.against.empty() ? "" : " against " + fact.against.front(),
                           why_not(answer_, judged_, who), with_numbers(who));
      default:
        return fmt::format("{} {} worse{}{}", with_numbers(who), is_or_are(who),
                           is_solved(judged_) && fact.against.front() == first_ ? "" : " than " + fact.against.front(),
                           little(fact));
    }
  }
  bool who_are_equal(const Names& who) const {
    const Pairs pairs(judged_, who);
    return all_pairs(who, who, [&](auto& one, auto& other) { return all_values_equal(*pairs.finding(one, other)); });
  }

  // "LM and DLS solved all 100 targets, SLSQP 99 (not decided)"
  std::string counted(const Statement& fact) {
    const double most = described(fact.solvers.front()).mean;
    const int n = described(fact.solvers.front()).n;
    const Names firsts = who_of(fact.solvers, [&](auto& name) { return described(name).mean == most; });
    const std::string its = number(firsts.front());
    std::string text = fmt::format("{} {}", names_of(firsts),
                                   most == 100 && n > 1 && trials_per_value(judged_.samples) == 1
                                       ? fmt::format("solved all {}{}", base::counted(n, answer_.noun), within())
                                       : its);
    Names others = who_of(fact.solvers, [&](auto& name) { return described(name).mean != most; });
    if (others.empty()) return text;
    const std::string best = number(others.front()), worst = number(others.back());
    const bool are_many = others.size() > most_named;
    for (std::string& name : others) name += ' ' + number(name);
    return fmt::format("{}, {} ({})", text,
                       are_many
                           ? fmt::format("{} others {}{}", others.size(), worst, best == worst ? "" : " to " + best)
                           : fmt::format("{}", fmt::join(others, ", ")),
                       fact.kind == What::inconclusive  ? "not decided"
                       : fact.kind == What::none_better ? "no difference is shown"
                                                        : "the same within " + margin_text(judged_));
  }
};

// "B takes 3 times as long", of each whom the first is ahead of; of many how the ratios span.
std::string ratios_told(const std::vector<std::pair<std::string, double>>& ratios, const Words& words,
                        const std::string& as_whom) {
  if (ratios.empty()) return "";
  std::vector<std::string> told;
  for (const auto& [name, ratio] : ratios)
    told.push_back(
        fmt::format("{} {}{}", name, told.empty() ? fmt::format("{} ", words.takes) : "", ratio_text(ratio)));
  const auto [least, most] = std::ranges::minmax(ratios, {}, &std::pair<std::string, double>::second);
  const std::string from =
      ratio_text(least.second) == ratio_text(most.second) ? "" : number_text(least.second, 2) + " to ";
  return fmt::format("; {} {}{}",
                     told.size() < most_named
                         ? fmt::format("{}", fmt::join(told, ", "))
                         : fmt::format("{} others {} {}{}", told.size(), words.take, from, ratio_text(most.second)),
                     words.as, as_whom);
}

// The sentence of the second question. All are held against one, who is ahead of most.
std::string then_told(const ReportModel& answer, const HeadlineQuestion& question) {
  const JudgedMetric& judged = *question.metric;
  const Words& words =
      *std::ranges::find_if(all_words, [&](const Words& its) { return metric_of(answer, its) == &judged; });
  Names best, losers, untested;
  for (const Statement& fact : question.statements) {
    Names& who = fact.kind == What::not_tested ? untested : fact.kind == What::worse ? losers : best;
    who.insert(who.end(), fact.solvers.begin(), fact.solvers.end());
    if (fact.kind == What::best) losers = fact.against;
  }
  Names all = best;
  all.insert(all.end(), losers.begin(), losers.end());
  const Pairs pairs(judged, all);
  const auto is_ahead = [&](auto& one, auto& other) { return pairs.of(one, other) == Verdict::better; };
  std::string text = question.preface;
  if (losers.empty()) {
    text += question.statements.front().kind == What::cyclic
                ? fmt::format("By {} each is worse than another", judged.samples.quantity)
            : question.statements.front().kind == What::equivalent && untested.empty()
                ? fmt::format("By {} they are the same within {}", judged.samples.quantity, margin_text(judged))
                : fmt::format("No difference in {} is shown", judged.samples.quantity);
  } else {
    const std::string first = *std::ranges::max_element(best, {}, [&](const std::string& name) {
      return std::ranges::count_if(losers, [&](auto& loser) { return is_ahead(name, loser); });
    });
    std::vector<std::pair<std::string, double>> ratios;
    for (const std::string& loser : losers) {
      const Comparison* const pair = pairs.finding(first, loser);
      if (pair && is_ahead(first, loser) && pair->estimate && pair->scale == EffectScale::ratio)
        ratios.emplace_back(loser, pair->first == loser ? pair->estimate->value : 1 / pair->estimate->value);
    }
    const bool is_clear = all_pairs(best, losers, is_ahead);
    const auto is_so = [&](auto& one, auto& other) { return is_little(pairs.finding(one, other)); };
    text += is_clear ? fmt::format("{} {}{}", names_of(best), best.size() == 1 ? words.is : words.are,
                                   all_pairs(best, losers, is_so) ? ", by less than " + margin_text(judged) : "")
                     : fmt::format("None is shown to {} than {}", words.than, first);
    text += ratios_told(ratios, words, is_clear && best.size() > 1 ? " as " + first : "");
  }
  if (untested.empty()) return text + '.';
  return fmt::format("{}; {} {} not judged{}.", text, names_of(untested), is_or_are(untested),
                     why_not(answer, judged, untested));
}

}  // namespace

std::vector<Statement> statements_of(const JudgedMetric& judged, const Names& among) {
  const Pairs pairs(judged, among);
  if (!pairs.is_any()) return {{What::no_comparison, among}};
  std::vector<Statement> said;
  const auto add = [&](What what, const Names& who, const Names& against = {}) {
    if (who.empty()) return;
    const auto is_so = [&](auto& one, auto& other) { return is_little(pairs.finding(one, other)); };
    said.push_back({what, who, against, !against.empty() && all_pairs(who, against, is_so)});
  };
  const auto are = [&](const Names& who, Verdict verdict) {
    return all_pairs(who, who, [&](auto& one, auto& other) { return pairs.of(one, other) == verdict; });
  };
  const std::string leader = leader_of(pairs, among);
  const auto is_apart = [&](auto& name) {
    const bool is_beside = pairs.is_loser(name) || name == leader || pairs.of(leader, name) != Verdict::not_tested;
    return pairs.tested(name) == 0 || !is_beside;
  };
  const Names apart = who_of(among, is_apart), losers = who_of(among, [&](auto&name) { return pairs.is_loser(name); }),
              unbeaten = who_of(among, [&](auto&name) { return !pairs.is_loser(name); }),
              rest = who_of(unbeaten, [&](auto&name) { return !has(apart, name); });
  const auto is_ahead = [&](auto& one, auto& other) { return pairs.of(one, other) == Verdict::better; };
  if (!losers.empty() && !unbeaten.empty() && all_pairs(unbeaten, losers, is_ahead) &&
      all_pairs(unbeaten, unbeaten, [&](auto& one, auto& other) { return are_alike(pairs.finding(one, other)); })) {
    add(What::best, unbeaten, losers);
    return said;
  }
  if (const std::string& control = judged.plan.control; has(among, control) && among.size() > 2) {
    for (const auto& [verdict, what] : {std::pair{Verdict::better, What::better},
                                        {Verdict::equivalent, What::equivalent},
                                        {Verdict::inconclusive, What::inconclusive},
                                        {Verdict::worse, What::worse},
                                        {Verdict::not_tested, What::not_tested}})
      add(what,
          who_of(among, [&, its = verdict](auto& name) { return name != control && pairs.of(name, control) == its; }),
          {control});
    return said;
  }
  if (rest.empty()) {
    add(What::cyclic, losers);
    add(What::not_tested, apart);
    return said;
  }
  add(rest.size() > 1 && are(rest, Verdict::equivalent)     ? What::equivalent
      : rest.size() > 1 && are(rest, Verdict::inconclusive) ? What::inconclusive
                                                            : What::none_better,
      rest);
  NamesByPhrase worse;  // by the winner, an unbeaten one if there is one
  for (const std::string& loser : losers) {
    const auto beats = [&](const std::string& name) { return is_ahead(name, loser); };
    const auto winner = std::ranges::find_if(rest, beats);
    worse.add(winner != rest.end() ? *winner : *std::ranges::find_if(among, beats), loser);
  }
  for (const auto& [winner, who] : worse.entries) add(What::worse, who, {winner});
  const bool are_joined = std::ranges::any_of(apart, [&](auto& name) { return pairs.tested(name) > 0; });
  add(What::not_tested, apart, are_joined ? Names{leader} : Names());
  return said;
}

std::vector<HeadlineQuestion> headline_questions(const ReportModel& answer) {
  const JudgedMetric& first = answer.primary();
  std::vector<HeadlineQuestion> all{{.metric = &first, .statements = statements_of(first, answer.solvers())}};
  const auto& [what, unbeaten, against, is_little] = all.front().statements.front();
  const Names rest = what == What::no_comparison || what > What::none_better ? Names() : unbeaten;
  std::string before;
  for (const std::string& then : answer.tie_breakers) {
    const auto words = std::ranges::find(all_words, then, &Words::then);
    const JudgedMetric* const judged = words == all_words.end() ? nullptr : metric_of(answer, *words);
    if (judged == nullptr || rest.size() < 2 || (answer.order.size() > 2 && !first.plan.control.empty())) continue;
    std::vector<Statement> said = statements_of(*judged, rest);
    const auto is_judged = [](const Statement& fact) {
      return fact.kind != What::not_tested && fact.kind != What::no_comparison;
    };
    if (std::ranges::any_of(said, is_judged)) {
      all.push_back({.metric = judged, .statements = std::move(said), .preface = before});
      break;
    }
    before +=
        fmt::format("{} is not judged{}. ", as_sentence(judged->samples.quantity), why_not(answer, *judged, rest));
  }
  return all;
}

std::string tie_breaker_sentence(const ReportModel& answer) {
  const std::vector<HeadlineQuestion> questions = headline_questions(answer);
  return questions.size() < 2 ? "" : then_told(answer, questions.back());
}

std::string headline(const ReportModel& answer) {
  if (!answer.verdict.empty()) return answer.verdict;
  const std::vector<HeadlineQuestion> questions = headline_questions(answer);
  const std::string then = questions.size() < 2 ? "" : ' ' + then_told(answer, questions.back());
  return First(answer).told(questions.front().statements) + '.' + then;
}

std::string ranking_note(const ReportModel& answer) {
  const auto has_winner = [&](const JudgedMetric& judged) {
    return &judged != &answer.primary() && !beaten_solvers(judged.comparisons).empty();
  };
  if (!answer.verdict.empty() || std::ranges::none_of(answer.metrics, has_winner)) return "";
  const std::vector<HeadlineQuestion> questions = headline_questions(answer);
  return fmt::format("Judged by {}{}", answer.primary().samples.quantity,
                     questions.size() < 2 ? "" : ", then " + questions[1].metric->samples.quantity);
}

}  // namespace ikbench::show
