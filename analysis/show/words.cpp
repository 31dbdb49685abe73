#include "analysis/show/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "analysis/show/text.hpp"
#include "analysis/show/then.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

constexpr std::size_t most_named = 4;  // solvers of a sentence

bool counts(const JudgedMetric& judged) {  // 88 of 100
  return is_share(judged) && judged.observations.trials == 1;
}

// "5 mm"; empty for none.
std::string limit(double value, std::string_view unit) {
  return value > 0 ? fmt::format("{}{}", number_text(value), unit) : "";
}

// "1 iteration", "200 iterations"; empty for none.
std::string limited(std::int64_t count, std::string_view nouns) { return count > 0 ? base::counted(count, nouns) : ""; }

// "1 point", "2.5 cm".
std::string with_unit(const std::string& text, const std::string& unit) {
  if (unit.empty()) return text;
  return fmt::format("{} {}", text, text == "1" && unit == "points" ? "point" : unit);
}

// A group's number: "88", "0.42"; of the first also the whole or the unit: "100 of 100 targets", "0.017 mm".
std::string number_of(const Answer& answer, const JudgedMetric& judged, std::size_t group, std::size_t first) {
  const bool is_first = group == first;
  const int n_of_first = judged.described[first].n;
  const Description& its = judged.described[group];
  const auto [value, is_bound] = shown_average(judged, group);
  if (std::isnan(value)) return "not known";
  if (counts(judged)) {
    const std::string count = fmt::format("{:.0f}", its.mean * its.n / 100);
    if (is_first) return fmt::format("{} of {}", count, base::counted(its.n, answer.noun));
    return its.n == n_of_first ? count : fmt::format("{} of {}", count, its.n);
  }
  const Observations& observed = judged.observations;
  const std::string text = number_text(value, digits_apart(value, ends_of_shares(judged)));
  const int all = its.n * observed.trials, failed = static_cast<int>(std::lround((1 - value / 100) * all));
  const std::string failures = is_share(judged) && failed > 0 && 100 * failed < all
                                   ? fmt::format(" ({} of {} failed)", failed, all)
                                   : "";  // which a rounded share would hide
  return with_unit((is_bound ? "at most " : "") + text, is_first ? observed.unit : "") + failures;
}

// "median error", "mean error", "solved"
std::string quantity_of(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const bool is_mean = judged.plan.test == results::Plan::Test::means;
  const bool has_none = is_share(judged) || judged.observations.are_logs;
  return fmt::format("{}{}", has_none ? "" : is_mean ? "mean " : "median ", judged.observations.quantity);
}

// "DLS (solved 100 of 100 targets)", and those after it "PSO (88)".
std::string with_number(const Answer& answer, const std::string& name, std::size_t first,
                        const std::string& more = "") {
  const JudgedMetric& judged = answer.decisive();
  const std::size_t group = place_of(judged.observations, name);
  return fmt::format("{} ({}{}{})", name, group == first ? quantity_of(answer) + " " : "",
                     number_of(answer, judged, group, first), more);
}

bool is_by_little(const Finding& finding) {
  const auto* const tested = std::get_if<Tested>(&finding.what);
  return tested && is_difference(tested->verdict) && tested->is_small;
}

// How many of the first in this order have its number.
std::size_t equals_of(const JudgedMetric& judged, const std::vector<std::size_t>& order) {
  const auto differs = [&](std::size_t i) { return average_of(judged, i) != average_of(judged, order[0]); };
  return static_cast<std::size_t>(std::ranges::find_if(order, differs) - order.begin());
}

// "it solved 100 of 100 targets; PSO 88, mine 54"; with the first one's name "PSO solved 90 of 100 targets, mine 88".
// Those that solved as many as the first stand together.
std::string numbers_of(const Answer& answer, bool is_named) {
  const JudgedMetric& judged = answer.decisive();
  const bool is_solved = judged.observations.metric == "solved";
  const std::vector<std::size_t>& order = answer.order;
  const std::size_t equals = is_solved ? equals_of(judged, order) : 1;
  std::vector<std::string> firsts, others;
  for (const std::size_t i : order) {
    const std::string& name = judged.observations.groups[i].name;
    if (firsts.size() < equals)
      firsts.push_back(name);
    else
      others.push_back(fmt::format("{} {}", name, number_of(answer, judged, i, order[0])));
  }
  const bool are_the_best = equals > 1 && equals == judged.headline.best.size();
  const std::string who = are_the_best ? (equals == 2 ? "both" : "all") : is_named ? names_of(firsts) : "it";
  const std::string number = number_of(answer, judged, order[0], order[0]);
  std::string text = is_solved  ? fmt::format("{} solved {}", who, number)
                     : is_named ? fmt::format("{} {} {}", quantity_of(answer), who, number)
                                : fmt::format("{} {}", quantity_of(answer), number);
  const std::string them = names_of(others, ", ");
  if (!others.empty()) text += (is_named && them.find(';') == std::string::npos ? ", " : "; ") + them;
  return text;
}

// Empty unless all solvers solved all targets.
std::string all_solved(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  if (judged.observations.metric != "solved") return {};
  if (!std::ranges::all_of(judged.described, [](const Description& its) { return its.mean == 100; })) return {};
  const int n = judged.described.front().n;
  const bool have_one_n = std::ranges::count(judged.described, n, &Description::n) == std::ssize(judged.described);
  const std::string what =
      counts(judged) && have_one_n && n > 1 ? "all " + base::counted(n, answer.noun) : "every target";
  std::vector<std::string> names;
  for (const Group& group : judged.observations.groups) names.push_back(group.name);
  return fmt::format("{}{} solved {}", names_of(names), names.size() == 2 ? " both" : "", what);
}

std::string against_control(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const std::size_t control = place_of(judged.observations, judged.plan.control);
  ByWord verdicts;  // in the order of the table
  for (const Finding& finding : judged.findings)
    verdicts.add(verdict_words(finding, judged), with_number(answer, finding.first, control));
  return fmt::format("Against {}: {}", with_number(answer, judged.plan.control, control),
                     listed(verdicts.told("{1} {0}"), ", "));
}

// ", since 8 runs are too few, 10 are needed", where the pairs of these are not tested for one reason.
std::string since(const Answer& answer, const std::vector<std::string>& who) {
  std::set<std::string> reasons;
  for (const Finding& finding : answer.decisive().findings) {
    const auto* const open = std::get_if<Open>(&finding.what);
    const auto is_one = [&](const std::string& name) { return std::ranges::count(who, name) > 0; };
    if (open && (is_one(finding.first) || is_one(finding.second))) reasons.insert(reason_of(*open, answer.noun));
  }
  return reasons.size() == 1 ? ", since " + *reasons.begin() : "";
}

// What is said of several is so of each pair of them.
bool are_all(const JudgedMetric& judged, const std::vector<std::string>& names, auto is_so) {
  return std::ranges::all_of(judged.findings, [&](const Finding& finding) {
    return std::ranges::count(names, finding.first) + std::ranges::count(names, finding.second) < 2 || is_so(finding);
  });
}

// Where no solver is best: those that none is shown to beat, and whom the one of them beats that beats most.
Sentence unbeaten(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const auto against = [&](const std::string& solver, Verdict verdict) {  // the others, as the table has them
    std::vector<std::string> others;
    for (const Finding& finding : judged.findings) {
      if (finding.first == solver && verdict_of(finding) == verdict) others.push_back(finding.second);
      if (finding.second == solver && turned(verdict_of(finding)) == verdict) others.push_back(finding.first);
    }
    return others;
  };
  std::vector<std::string> rest;
  const std::vector<std::string> apart = not_compared(answer);
  const auto is_apart = [&](const std::string& name) { return std::ranges::count(apart, name) > 0; };
  const auto beaten = [&](const std::string& solver) { return against(solver, Verdict::better).size(); };
  for (const std::string& name : answer.solvers()) {
    if (!is_apart(name) && against(name, Verdict::worse).empty()) rest.push_back(name);
  }
  if (apart.size() == answer.order.size())
    return {"Not tested" + since(answer, apart), ": " + numbers_of(answer, true)};
  const bool do_untested_lead = !apart.empty() && apart.front() == answer.solvers().front();
  const std::size_t first =
      do_untested_lead || rest.empty() ? answer.order.front() : place_of(judged.observations, rest.front());
  const auto told = [&](std::vector<std::string> names, const std::string& winner = "") {
    for (std::string& name : names) {
      const Finding* const pair = winner.empty() ? nullptr : finding_of(judged, winner, name);
      name =
          with_number(answer, name, first, pair && is_by_little(*pair) ? "; by less than " + margin_words(judged) : "");
    }
    return names_of(names);
  };
  const auto is_undecided = [](const Finding& finding) { return verdict_of(finding) == Verdict::undecided; };
  std::vector<std::string> same, others;  // same: as all before it
  const auto is_to_same = [&](const std::string& name, Verdict verdict) {
    const std::vector<std::string> such = against(name, verdict);
    return std::ranges::all_of(same, [&](const std::string& other) { return std::ranges::count(such, other) > 0; });
  };
  for (const std::string& name : rest) (is_to_same(name, Verdict::same) ? same : others).push_back(name);
  const bool are_undecided =
      std::ranges::all_of(others, [&](const std::string& name) { return is_to_same(name, Verdict::undecided); });
  Sentence sentence;
  bool are_numbers_told = false, are_losers_told = false;
  if (same.size() > 1 && are_undecided) {
    sentence = {fmt::format("{} are the same within {}{}", names_of(same), margin_words(judged),
                            others.empty() ? "" : ", not decided against " + names_of(others)),
                ": " + numbers_of(answer, true)};
    are_numbers_told = others.empty();
  } else if (rest.size() == 1 && beaten(rest.front()) > 0) {
    const std::vector<std::string> open = against(rest.front(), Verdict::undecided);
    sentence = {
        fmt::format("{} is better than {}", told(rest), told(against(rest.front(), Verdict::better), rest.front())),
        open.empty() ? "" : "; not decided against " + told(open)};
    are_losers_told = true;
  } else if (rest.size() > 1 && are_all(judged, rest, is_undecided)) {
    sentence.subject = "Not decided between " + told(rest);
    if (are_all(judged, rest, are_equal))
      sentence.rest = fmt::format(": all {} equal", std::get<Tested>(finding_of(judged, rest[0], rest[1])->what).n);
  } else if (!rest.empty()) {
    sentence.subject = "Nobody is shown to beat " + told(rest);
  }
  const auto leader = std::ranges::max_element(rest, {}, beaten);
  ByWord losers;  // by who beats them
  for (const std::string& name : answer.solvers()) {
    const std::vector<std::string> better = against(name, Verdict::worse);
    if (better.empty() || are_losers_told || is_apart(name)) continue;
    const std::string& winner =
        leader != rest.end() && std::ranges::count(better, *leader) > 0 ? *leader : better.front();
    const Finding* const pair = finding_of(judged, winner, name);
    losers.add(winner + (is_by_little(*pair) ? ", by less than " + margin_words(judged) : ""),
               are_numbers_told ? name : with_number(answer, name, first));
  }
  for (const auto& [winner, names] : losers.all)
    sentence.rest += fmt::format("; {} {} worse than {}", names_of(names), names.size() == 1 ? "is" : "are", winner);
  const auto is_join = [&](const Finding& finding) {  // of one apart and another, tested
    return is_apart(finding.first) != is_apart(finding.second) && verdict_of(finding) != Verdict::not_tested;
  };
  const std::string against_whom =
      std::ranges::any_of(judged.findings, is_join) && !rest.empty() ? rest.front() : "the others";
  if (do_untested_lead) {
    const std::string of_others = sentence.subject + sentence.rest;
    return {fmt::format("Not tested against {}{}: {}", against_whom, since(answer, apart), told(apart)),
            of_others.empty() ? "" : ". Of the others: " + of_others};
  }
  if (!apart.empty())
    sentence.rest += fmt::format("; not tested against {}{}: {}", against_whom, since(answer, apart), names_of(apart));
  return sentence;
}

// Of a best one and another.
std::vector<Finding> findings_of_best(const JudgedMetric& judged) {
  std::vector<Finding> findings = judged.findings;
  std::erase_if(findings, [&](const Finding& finding) {
    const std::vector<std::string>& best = judged.headline.best;
    return std::ranges::count(best, finding.first) == std::ranges::count(best, finding.second);
  });
  return findings;
}

// ", by less than 5 %", of all or of some that the best ones beat.
std::string by_little(const JudgedMetric& judged) {
  std::set<std::string> who;
  bool are_all = judged.headline.best.size() == 1;  // else it would speak of them
  for (const Finding& finding : findings_of_best(judged)) {
    if (!is_difference(verdict_of(finding))) continue;
    const bool is_little = is_by_little(finding);
    are_all &= is_little;
    if (is_little) who.insert(verdict_of(finding) == Verdict::better ? finding.second : finding.first);
  }
  if (who.empty()) return "";
  const std::string than = are_all ? "" : "but better than " + names_of({who.begin(), who.end()}) + ' ';
  return fmt::format(", {}by less than {}", than, margin_words(judged));
}

// " (p < 0.0001)", of the pair with the largest; empty where a verdict has none.
std::string most_p(const JudgedMetric& judged) {
  double most = 0;
  for (const Finding& finding : findings_of_best(judged)) most = std::max(most, p_of(finding).value_or(1));
  return most == 1
             ? ""
             : fmt::format(" (p {}{})", most < 0.0001 ? "" : "at most ", p_text(most, {judged.plan.significance}));
}

// "better in 43 %, worse in 3 % of comparisons"
std::string effect_words(const Finding& finding) {
  const auto* const tested = std::get_if<Tested>(&finding.what);
  if (!tested || !tested->effect || !is_difference(tested->verdict)) return "";
  const auto& [ahead, behind] = *tested->effect;
  return fmt::format("better in {} %, worse in {} % of comparisons", number_text(100 * ahead),
                     number_text(100 * behind));
}

// What differs between two whose numbers look alike or lie the other way: ": both have 0.11 mm; better in 8, worse in 0
// of 20 targets".
std::string where_alike(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const std::size_t first = answer.order[0];
  const auto* const tested = std::get_if<Tested>(&judged.findings.front().what);
  if (answer.order.size() != 2 || !tested || !tested->effect) return "";
  const auto its = shown_average(judged, first), other = shown_average(judged, answer.order[1]);
  const bool is_smaller = its.value < other.value, is_smaller_better = judged.observations.better == Better::smaller;
  if (is_difference(tested->verdict) && is_smaller != is_smaller_better && its.value != other.value)
    return ": " + effect_words(judged.findings.front());
  if (number_text(its.value) != number_text(other.value) || counts(judged)) return "";
  const auto& [ahead, behind] = *tested->effect;
  return fmt::format(": both have {} {}; {}", quantity_of(answer), number_of(answer, judged, first, first),
                     judged.observations.is_paired
                         ? fmt::format("better in {:.0f}, worse in {:.0f} of {} {}", ahead * tested->n,
                                       behind * tested->n, tested->n, answer.noun)
                         : effect_words(judged.findings.front()));
}

bool is_nothing_solved(const Answer& answer) {
  return std::ranges::any_of(answer.metrics, [&](const JudgedMetric& judged) {
    return &judged != &answer.decisive() && judged.observations.metric == "solved" &&
           std::ranges::all_of(judged.described, [](const Description& its) { return its.mean == 0; });
  });
}

// Nobody is best by the error of what nobody solved.
bool can_nobody(const Answer& answer) { return answer.decisive().plan.metric.empty() && is_nothing_solved(answer); }

Sentence best(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const std::vector<std::size_t>& order = answer.order;
  std::vector<std::string> names, beaten;
  for (const std::string& name : answer.solvers())
    (names.size() < judged.headline.best.size() ? names : beaten).push_back(name);
  const std::string losers = beaten.size() <= 2 ? listed(beaten) : fmt::format("each of the {} others", beaten.size());
  const bool are_listed = judged.findings.size() <= most_pairs;
  const bool are_unequal = equals_of(judged, order) < names.size();
  const std::string alike = where_alike(answer);
  Sentence sentence{fmt::format("{} {}{}{}", names_of(names),
                                names.size() > 1     ? (can_nobody(answer) ? "come nearest" : "are best")
                                : order.size() == 2  ? "is better than " + losers
                                : can_nobody(answer) ? "comes nearest"
                                                     : "is best",
                                are_unequal ? ", the same within " + margin_words(judged) : "", by_little(judged)),
                    alike.empty() ? ": " + numbers_of(answer, names.size() > 1) : alike};
  if (names.size() > 1 || !are_listed)
    sentence.rest += fmt::format(". {} better than {}{}",
                                 names.size() == 1   ? "It is"
                                 : names.size() == 2 ? "Both are"
                                                     : "Each is",
                                 losers, are_listed ? "" : most_p(judged));
  const auto is_fact = [](const Finding& finding) { return std::holds_alternative<Fact>(finding.what); };
  if (std::ranges::all_of(findings_of_best(judged), is_fact))
    sentence.rest += ". Certain, since the solvers repeat themselves";
  return sentence;
}

Sentence sentence_of(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const Headline& head = judged.headline;
  if (!best_of(judged).empty()) return best(answer);
  if (!head.best.empty()) return unbeaten(answer);
  if (const std::string equal = all_solved(answer); !equal.empty()) {
    const auto is_open = [](const Finding& finding) { return std::holds_alternative<Open>(finding.what); };
    const bool is_untested = !judged.findings.empty() && std::ranges::all_of(judged.findings, is_open);
    return {equal, is_untested ? "; not tested" + since(answer, answer.solvers()) : ""};
  }
  if (judged.findings.empty()) {
    const bool is_solved = judged.observations.metric == "solved";
    return {(is_solved ? "" : judged.observations.groups[0].name + ": ") + numbers_of(answer, is_solved)};
  }
  if (head.is_circle) return {"No solver is best, since each is worse than another", ": " + numbers_of(answer, true)};
  if (!judged.plan.control.empty() && answer.order.size() > 2) return {against_control(answer)};
  return unbeaten(answer);
}

}  // namespace

std::string names_of(const std::vector<std::string>& names, std::string_view last) {
  if (names.size() <= most_named) return listed(names, last);
  return fmt::format("{} and {} more", listed({names.begin(), names.begin() + 3}, ", "), names.size() - 3);
}

void ByWord::add(const std::string& word, const std::string& name) {
  auto entry = std::ranges::find(all, word, [](const auto& pair) { return pair.first; });
  if (entry == all.end()) entry = all.insert(entry, {word, {}});
  entry->second.push_back(name);
}

std::vector<std::string> ByWord::told(const char* form) const {
  std::vector<std::string> told;
  for (const auto& [word, names] : all) told.push_back(fmt::format(fmt::runtime(form), word, names_of(names)));
  return told;
}

std::vector<std::string> best_of(const JudgedMetric& judged) {
  const auto is_alike = [](const Finding& its) { return verdict_of(its) == Verdict::same || are_equal(its); };
  return are_all(judged, judged.headline.best, is_alike) ? judged.headline.best : std::vector<std::string>();
}

std::vector<std::string> not_compared(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::count(names, name) > 0;
  };
  std::vector<std::vector<std::string>> fields;  // whom tests join
  for (const std::string& name : answer.solvers()) {
    if (std::ranges::any_of(fields, [&](const auto& field) { return is_in(field, name); })) continue;
    std::vector<std::string>& field = fields.emplace_back(1, name);
    for (std::size_t k = 0; k < field.size() && field.size() < answer.order.size(); ++k) {
      for (const Finding& finding : judged.findings) {
        if (verdict_of(finding) == Verdict::not_tested || (finding.first != field[k] && finding.second != field[k]))
          continue;
        const std::string& other = finding.first == field[k] ? finding.second : finding.first;
        if (!is_in(field, other)) field.push_back(other);
      }
    }
  }
  const std::vector<std::string>& largest = *std::ranges::max_element(fields, {}, &std::vector<std::string>::size);
  const std::set<std::string> losers = losers_of(judged.findings);
  std::string leader;
  std::vector<std::string> apart;
  for (const std::string& name : answer.solvers()) {
    const bool is_first = leader.empty() && !losers.contains(name) && is_in(largest, name);
    if (is_first) leader = name;
    const Finding* const pair = leader.empty() || is_first ? nullptr : finding_of(judged, leader, name);
    if (largest.size() == 1 || !is_in(largest, name) ||
        (pair && !losers.contains(name) && verdict_of(*pair) == Verdict::not_tested))
      apart.push_back(name);
  }
  return apart;
}

Sentence headline_of(const Answer& whole) {
  if (!whole.verdict.empty()) return {whole.verdict};
  Sentence sentence = sentence_of(with_short_names(whole, 40));
  if (is_nothing_solved(whole)) sentence.subject.insert(0, "No target was solved. ");
  return sentence;
}

std::string headline(const Answer& answer) {
  const auto [subject, rest] = headline_of(answer);
  const std::string then = answer.verdict.empty() ? then_of(answer) : "";
  return subject + rest + (answer.verdict.empty() ? "." : "") + (then.empty() ? "" : ' ' + then);
}

std::string margin_words(const JudgedMetric& judged) {
  const auto [relative, absolute] = std::pair(judged.plan.margin, judged.observations.absolute_margin);
  const std::string words = with_unit(number_text(100 * relative), is_share(judged) ? "points" : "%");
  if (absolute == 0 || is_share(judged)) return words;
  return (relative == 0 ? "" : words + " or ") + with_unit(number_text(absolute), judged.observations.unit);
}

std::string verdict_words(const Finding& finding, const JudgedMetric& judged) {
  const std::string margin = margin_words(judged), verdict(judge::name_of(verdict_of(finding)));
  if (const auto* const tested = std::get_if<Tested>(&finding.what)) {
    const auto size_of = [&](const std::string& name) {
      return judged.described[place_of(judged.observations, name)].n;
    };
    const int n = judged.observations.is_paired ? tested->n : size_of(finding.first), other = size_of(finding.second);
    if (tested->verdict == Verdict::same) return "same within " + margin;
    if (are_equal(finding))
      return fmt::format(
          "{}: all {} equal", verdict,
          judged.observations.is_paired || n == other ? fmt::to_string(n) : fmt::format("{} and {}", n, other));
    return verdict + (tested->is_small ? ", by less than " + margin : "");
  }
  if (std::holds_alternative<Fact>(finding.what))
    return verdict + (are_equal(finding) || is_difference(verdict_of(finding)) ? "" : " within " + margin) +
           ", for certain";
  const auto& open = std::get<Open>(finding.what);
  if (open.why == Open::Why::too_few && open.n > 0) return fmt::format("{}: it takes {}", verdict, open.needed);
  return fmt::format("{}: {}", verdict, words_of(open.why).of_pair);
}

ReasonWords words_of(Open::Why why) {
  constexpr std::array<ReasonWords, 8> all{
      {{"lost", "values are missing", "values are missing"},
       {"infinite", "infinite values have no mean", "infinite values have no mean"},
       {"apart", "not comparable", "not comparable (!)"},
       {"no_spread", "one has no spread", "not comparable (!)"},
       {"none", "one or both solved nothing", "nothing was solved"},
       {"no_answer", "neither has an answer", "no answer"},
       {"too_few", "no values", "too few to compare"},
       {"few_decide", "few values decide", "too few to compare"}}};
  return all[static_cast<std::size_t>(why)];
}

std::string reason_of(const Open& open, std::string_view noun) {
  if (open.why != Open::Why::too_few || open.n == 0) return std::string(words_of(open.why).of_pair);
  return fmt::format("{} {} too few, {} are needed", base::counted(open.n, noun), open.n == 1 ? "is" : "are",
                     open.needed);
}

EffectSize effect_size(const Finding& finding, const JudgedMetric& judged) {
  const auto* const tested = std::get_if<Tested>(&finding.what);
  if (tested && tested->g) return {judged.observations.is_paired ? "g_av" : "Hedges' g", *tested->g};
  return tested && tested->effect ? EffectSize{"A12", tested->effect->a12()} : EffectSize{};
}

std::string warning_of(const Doubt& doubt) {
  const std::string text = words_of(doubt) + '.';
  return doubt.who.empty() || !text.starts_with(doubt.who[0]) ? as_sentence(text) : text;
}

std::string unit_of(const Finding& finding, const JudgedMetric& judged) {
  if (!amount_of(finding)) return "";
  return finding.scale == Scale::ratio ? "times" : finding.scale == Scale::share ? "points" : judged.observations.unit;
}

std::vector<double> ends_of(const Finding& finding, const JudgedMetric& judged) {
  const double margin = judged.plan.margin;
  if (finding.scale == Scale::ratio) return {1, 1 + margin, 1 / (1 + margin)};
  const double end = is_share(judged) ? 100 * margin : judged.observations.absolute_margin;
  return {0, end, -end};
}

std::string amount_words(const Finding& finding, const JudgedMetric& judged) {
  constexpr double least = 5e-5;  // of a ratio from 1: beyond the digits that readers see
  const Amount* const amount = amount_of(finding);
  const bool is_decided = is_difference(verdict_of(finding));
  if (!amount || (is_decided && finding.scale == Scale::ratio && std::abs(amount->value - 1) < least))
    return effect_words(finding);
  const Ends ends = ends_of(finding, judged);
  std::string text = with_unit(number_text(amount->value, digits_apart(amount->value, ends)), unit_of(finding, judged));
  if (amount->interval) text += fmt::format(" ({})", interval_text(*amount->interval, number_text, ends));
  return text;
}

std::vector<std::vector<std::string>> pair_rows(const Answer& answer) {
  const bool has_two = answer.decisive().described.size() == 2;
  std::vector<std::vector<std::string>> rows;
  if (answer.decisive().findings.size() > most_pairs) return rows;
  for (const JudgedMetric& judged : answer.metrics) {
    const bool is_decisive = &judged == &answer.decisive();
    if (!has_two && (!is_decisive || std::ranges::all_of(judged.findings, are_equal))) continue;
    for (const Finding& finding : judged.findings) {
      if (!is_decisive && verdict_of(finding) == Verdict::not_tested) continue;
      rows.push_back({one_line(fmt::format(
                          "{}{} vs {}", has_two && answer.metrics.size() > 1 ? judged.observations.quantity + ": " : "",
                          finding.first, finding.second)),
                      verdict_words(finding, judged), amount_words(finding, judged),
                      p_of(finding) ? p_sentence(*p_of(finding), {judged.plan.significance}) : ""});
    }
  }
  return rows;
}

std::string stops_of(const StudyResults& study) {
  const numerics::StopRule& stop = study.definition.stop;
  std::vector<std::string> tolerances{limit(10 * stop.tolerance_cm(), " mm"), limit(stop.tolerance_deg(), " deg")};
  std::erase(tolerances, "");
  std::vector<std::string> stops{listed(tolerances) + (stop.adds_squares ? " (squares added)" : ""),
                                 limited(stop.iterations, "iterations"), limited(stop.evaluations, "evaluations"),
                                 limit(1000 * stop.seconds, " ms")};
  std::erase(stops, "");
  return listed(stops, " or ");
}

std::string ends_of_unsolved(const StudyResults& study) {
  if (!study.definition.has_tolerance()) return "";  // nothing is solved or not
  ByWord reasons;
  for (const std::string& label : study.labels) {
    std::set<std::string> of_label;
    for (const Solve& solve : study.of(label)) {
      if (solve.status != results::Status::ok)
        of_label.insert(!results::is_in_order(solve.status) ? with_blanks(results::name_of(solve.status))
                        : solve.stop_reason == results::StopReason::finished
                            ? "the solver itself"
                            : with_blanks(results::name_of(solve.stop_reason)));
    }
    if (!of_label.empty()) reasons.add(listed({of_label.begin(), of_label.end()}, " or "), label);
  }
  return reasons.all.empty() ? ""
                             : fmt::format("What ended unsolved solves: {}.", fmt::join(reasons.told("{} ({})"), "; "));
}

const std::string& title_of(const StudyResults& study) {
  return study.definition.title.empty() ? study.name : study.definition.title;
}

std::string what_is_solved(const StudyResults& study) {
  const results::Definition& definition = study.definition;
  const bool is_one_each = definition.draws_targets && definition.points == 1;
  return fmt::format("{}, {}{} ({})", std::filesystem::path(definition.robot).stem().string(),
                     is_one_each ? "" : base::counted(definition.runs, "runs") + " of ",
                     base::counted(is_one_each ? definition.runs : definition.points, "targets"),
                     with_blanks(definition.path));
}

}  // namespace ikbench::show
