#include "analysis/show/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/show/text.hpp"
#include "numerics/names.hpp"

namespace ikbench::show {

using namespace compare;

namespace {

constexpr std::size_t most_named = 4;  // solvers of a sentence

bool counts(const JudgedMetric& judged) {  // 88 of 100
  return is_share(judged) && judged.observations.trials == 1;
}

const std::string& solver_name(const JudgedMetric& judged, std::size_t group) {
  return judged.observations.groups[group].name;
}

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
  const double value = average_of(judged, group);
  if (std::isnan(value)) return "not known";
  if (counts(judged)) {
    const std::string count = fmt::format("{:.0f}", its.mean * its.n / 100);
    if (is_first) return fmt::format("{} of {}", count, numerics::counted(its.n, answer.noun));
    return its.n == n_of_first ? count : fmt::format("{} of {}", count, its.n);
  }
  const Observations& observed = judged.observations;
  const bool is_bound = value == observed.groups[group].at_most && value > 0;
  return with_unit((is_bound ? "at most " : "") + number_text(value), is_first ? observed.unit : "");
}

// "median error", "mean error", "solved"
std::string quantity_of(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const bool is_mean = judged.plan.test == results::Plan::Test::means;
  return fmt::format("{}{}", is_share(judged) ? "" : is_mean ? "mean " : "median ", judged.observations.quantity);
}

// "DLS (solved 100 of 100 targets)", and those after it "PSO (88)".
std::string with_number(const Answer& answer, const std::string& name, std::size_t first) {
  const JudgedMetric& judged = answer.decisive();
  const std::size_t group = place_of(judged.observations, name);
  return fmt::format("{} ({}{})", name, group == first ? quantity_of(answer) + " " : "",
                     number_of(answer, judged, group, first));
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
    const std::string& name = solver_name(judged, i);
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
  if (!others.empty()) text += (is_named ? ", " : "; ") + names_of(others, ", ");
  return text;
}

std::string all_of(const JudgedMetric& judged) {
  std::vector<std::string> names;
  for (const Group& group : judged.observations.groups) names.push_back(group.name);
  return names_of(names);
}

// Empty unless all solvers solved all targets.
std::string all_solved(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  if (judged.observations.metric != "solved") return {};
  if (!std::ranges::all_of(judged.described, [](const Description& its) { return its.mean == 100; })) return {};
  const int n = judged.described.front().n;
  const bool have_one_n = std::ranges::count(judged.described, n, &Description::n) == std::ssize(judged.described);
  const std::string what =
      counts(judged) && have_one_n && n > 1 ? "all " + numerics::counted(n, answer.noun) : "every target";
  return fmt::format("{}{} solved {}", all_of(judged), judged.described.size() == 2 ? " both" : "", what);
}

std::string usual(const JudgedMetric& judged) {
  const Observations& observed = judged.observations;
  const Headline& head = judged.headline;
  const std::size_t i = place_of(observed, head.usual), j = place_of(observed, head.other);
  const Description &its = judged.described[i], &theirs = judged.described[j];
  const auto two = [&](double first, double second) {
    return fmt::format("{} and {}", number_text(first), with_unit(number_text(second), observed.unit));
  };
  const auto [usually, not_so] =
      observed.better == Better::smaller ? std::pair("smaller", "larger") : std::pair("larger", "smaller");
  const std::string medians = two(its.median, theirs.median), means = two(its.mean, theirs.mean);
  std::string how = "medians " + medians, but = fmt::format("mean is {} ({})", not_so, means);
  if (head.is_median_worse) {
    const Finding& finding = *finding_of(judged, head.usual, head.other);
    const double ahead = finding.first == head.usual ? *finding.effect : 1 - *finding.effect;
    how = ahead > 0.5 ? fmt::format("in {:.0f} % of comparisons", 100 * ahead) : "by ranks";
    but = fmt::format("median is {} ({})", not_so, medians);
  } else if (does_one_value_decide(observed.groups[i]) || does_one_value_decide(observed.groups[j])) {
    but += ": one value decides it";
  }
  return fmt::format("{} usually has {} {} than {} ({}), but its {}", head.usual, usually, observed.quantity,
                     head.other, how, but);
}

std::string against_control(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const std::size_t control = place_of(judged.observations, judged.plan.control);
  std::vector<std::string> verdicts, names;  // in the order of the table
  for (const Finding& finding : judged.findings) {
    verdicts.push_back(verdict_words(finding, judged));
    names.push_back(with_number(answer, finding.first, control));
  }
  std::vector<std::string> parts;
  for (const auto& [verdict, who] : by_word(verdicts, names)) parts.push_back(fmt::format("{} {}", who, verdict));
  return fmt::format("Against {}: {}", with_number(answer, judged.plan.control, control), listed(parts, ", "));
}

std::string not_tested(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const Finding& finding = judged.findings.front();
  const std::string numbers = numbers_of(answer, true);
  const bool is_for_all =
      finding.n > 0 && std::ranges::count(judged.findings, finding.why, &Finding::why) == std::ssize(judged.findings);
  if (is_for_all && finding.why == Why::too_few)
    return fmt::format("Not tested: {} cannot decide it, {} can; {}", numerics::counted(finding.n, answer.noun),
                       finding.needed, numbers);
  if (is_for_all && finding.why == Why::fact)
    return fmt::format("Certain for these {}, since the solvers repeat themselves: {}", answer.noun, numbers);
  return "Not tested: " + numbers;
}

// Where no solver is best: those that none is shown to beat, and whom the one of them beats that beats most.
std::string unbeaten(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const auto against = [&](const std::string& solver, Verdict verdict) {  // the others, as the table has them
    std::vector<std::string> others;
    for (const Finding& finding : judged.findings) {
      if (finding.first == solver && finding.verdict == verdict) others.push_back(finding.second);
      if (finding.second == solver && turned(finding.verdict) == verdict) others.push_back(finding.first);
    }
    return others;
  };
  std::set<std::string> tested;
  for (const Finding& finding : judged.findings) {
    if (finding.verdict != Verdict::not_tested) tested.insert({finding.first, finding.second});
  }
  if (tested.empty()) return not_tested(answer);
  std::vector<std::string> rest, apart, same, others;  // same: as all before it
  for (const std::size_t i : answer.order) {
    const std::string& name = solver_name(judged, i);
    const auto is_same = [its = against(name, Verdict::same)](auto& other) {
      return std::ranges::count(its, other) > 0;
    };
    if (!tested.contains(name)) apart.push_back(name);
    if (!tested.contains(name) || !against(name, Verdict::worse).empty()) continue;
    rest.push_back(name);
    (std::ranges::all_of(same, is_same) ? same : others).push_back(name);
  }
  const std::string numbers = numbers_of(answer, true);
  const std::string untested = apart.empty() ? "" : "; not tested: " + names_of(apart);
  const auto are_worse = [](const std::string& names, std::ptrdiff_t count, const std::string& than) {
    return count == 0 ? "" : fmt::format("; {} {} worse than {}", names, count == 1 ? "is" : "are", than);
  };
  if (same.size() > 1) {
    const std::vector<std::string> worse = against(same.front(), Verdict::better);
    return fmt::format("{} are the same within {}{}: {}{}", names_of(same), margin_words(judged),
                       others.empty() ? "" : ", not decided against " + names_of(others), numbers,
                       are_worse(names_of(worse), std::ssize(worse), same.front()));
  }
  if (std::ranges::all_of(judged.findings, &Finding::are_all_equal))
    return fmt::format("{} are the {}: {} {}", all_of(judged), verdict_words(judged.findings.front(), judged),
                       quantity_of(answer), number_of(answer, judged, answer.order[0], answer.order[0]));
  const auto beaten = [&](const std::string& solver) { return against(solver, Verdict::better).size(); };
  const auto leader = std::ranges::max_element(rest, {}, beaten);
  if (rest.empty() || (rest.size() == 1 && beaten(*leader) == 0)) return "Not decided: " + numbers + untested;
  const auto told = [&](std::vector<std::string> names) {
    for (std::string& name : names) name = with_number(answer, name, place_of(judged.observations, rest[0]));
    return names_of(names);
  };
  if (rest.size() == 1) {
    const std::vector<std::string> open = against(*leader, Verdict::undecided);
    return fmt::format("{} is better than {}{}{}", told(rest), told(against(*leader, Verdict::better)),
                       open.empty() ? "" : "; not decided against " + told(open), untested);
  }
  std::vector<std::string> losers, winners;
  for (const std::size_t i : answer.order) {
    const std::vector<std::string> better = against(solver_name(judged, i), Verdict::worse);
    if (better.empty()) continue;
    losers.push_back(with_number(answer, solver_name(judged, i), place_of(judged.observations, rest[0])));
    winners.push_back(std::ranges::count(better, *leader) > 0 ? *leader : better.front());
  }
  std::string text = "Not decided between " + told(rest);
  for (const auto& [winner, names] : by_word(winners, losers))
    text += are_worse(names, std::ranges::count(winners, winner), winner);
  return text + untested;
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
  bool are_all = true;
  for (const Finding& finding : findings_of_best(judged)) {
    if (!is_difference(finding.verdict)) continue;
    are_all &= finding.is_within_margin;
    if (finding.is_within_margin) who.insert(finding.verdict == Verdict::better ? finding.second : finding.first);
  }
  if (who.empty()) return "";
  const std::string than = are_all ? "" : "but better than " + names_of({who.begin(), who.end()}) + ' ';
  return fmt::format(", {}by less than {}", than, margin_words(judged));
}

// "(p < 0.0001)", of the pair with the largest; empty where a verdict has none.
std::string most_p(const JudgedMetric& judged) {
  double most = 0;
  for (const Finding& finding : findings_of_best(judged)) most = std::max(most, finding.p.value_or(1));
  return most == 1
             ? ""
             : fmt::format(" (p {}{})", most < 0.0001 ? "" : "at most ", p_text(most, {judged.plan.significance}));
}

std::string best(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const std::vector<std::size_t>& order = answer.order;
  std::vector<std::string> names, beaten;
  for (const std::size_t i : order)
    (names.size() < judged.headline.best.size() ? names : beaten).push_back(solver_name(judged, i));
  const std::string losers = beaten.size() <= 2 ? listed(beaten) : fmt::format("each of the {} others", beaten.size());
  const bool are_listed = judged.findings.size() <= most_pairs;
  const bool are_unequal = equals_of(judged, order) < names.size();
  std::string text = fmt::format("{} {}{}{}: {}", names_of(names),
                                 names.size() > 1    ? "are best"
                                 : order.size() == 2 ? "is better than " + losers
                                                     : "is best",
                                 are_unequal ? ", the same within " + margin_words(judged) : "", by_little(judged),
                                 numbers_of(answer, names.size() > 1));
  if (names.size() > 1 || !are_listed)
    text += fmt::format(". {} better than {}{}",
                        names.size() == 1   ? "It is"
                        : names.size() == 2 ? "Both are"
                                            : "Each is",
                        losers, are_listed ? "" : most_p(judged));
  return text;
}

std::string sentence(const Answer& answer) {
  const JudgedMetric& judged = answer.decisive();
  const Headline& head = judged.headline;
  if (!best_of(judged).empty()) return best(answer);
  if (!head.best.empty()) return unbeaten(answer);
  if (!head.usual.empty()) return usual(judged);
  if (const std::string equal = all_solved(answer); !equal.empty()) return equal;
  if (judged.findings.empty()) {
    const bool is_solved = judged.observations.metric == "solved";
    return (is_solved ? "" : solver_name(judged, 0) + ": ") + numbers_of(answer, is_solved);
  }
  if (head.is_circle) return "No solver is best, since each is worse than another: " + numbers_of(answer, true);
  if (!judged.plan.control.empty() && answer.order.size() > 2) return against_control(answer);
  return unbeaten(answer);
}

}  // namespace

std::string names_of(const std::vector<std::string>& names, std::string_view last) {
  if (names.size() <= most_named) return listed(names, last);
  return fmt::format("{} and {} more", listed({names.begin(), names.begin() + 3}, ", "), names.size() - 3);
}

std::vector<std::pair<std::string, std::string>> by_word(const std::vector<std::string>& words,
                                                         const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, std::vector<std::string>>> all;
  for (std::size_t i = 0; i < words.size(); ++i) {
    auto entry = std::ranges::find(all, words[i], [](const auto& pair) { return pair.first; });
    if (entry == all.end()) entry = all.insert(entry, {words[i], {}});
    entry->second.push_back(names[i]);
  }
  std::vector<std::pair<std::string, std::string>> told;
  for (const auto& [word, where] : all) told.emplace_back(word, names_of(where));
  return told;
}

std::vector<std::string> best_of(const JudgedMetric& judged) {
  const std::vector<std::string>& best = judged.headline.best;
  const auto is_alike = [&](const Finding& finding) {  // or not of two best ones
    return std::ranges::count(best, finding.first) + std::ranges::count(best, finding.second) < 2 ||
           finding.verdict == Verdict::same || finding.are_all_equal;
  };
  return std::ranges::all_of(judged.findings, is_alike) ? best : std::vector<std::string>();
}

std::string headline(const Answer& whole) {
  if (!whole.verdict.empty()) return whole.verdict;
  const bool is_nothing_solved = std::ranges::any_of(whole.metrics, [&](const JudgedMetric& judged) {
    return &judged != &whole.decisive() && judged.observations.metric == "solved" &&
           std::ranges::all_of(judged.described, [](const Description& its) { return its.mean == 0; });
  });
  return (is_nothing_solved ? "No target was solved. " : "") + sentence(with_short_names(whole, 40)) + '.';
}

std::string margin_words(const JudgedMetric& judged) {
  const auto [relative, absolute] = std::pair(judged.plan.margin, judged.observations.absolute_margin);
  const std::string words = with_unit(number_text(100 * relative), is_share(judged) ? "points" : "%");
  if (absolute == 0 || is_share(judged)) return words;
  return (relative == 0 ? "" : words + " or ") + with_unit(number_text(absolute), judged.observations.unit);
}

std::string verdict_words(const Finding& finding, const JudgedMetric& judged) {
  const std::string margin = margin_words(judged);
  const bool is_same = finding.verdict == Verdict::same;
  if (finding.are_all_equal && (is_same || finding.verdict == Verdict::undecided))
    return fmt::format("same in all {}", finding.n);
  if (is_same) return "same within " + margin;
  std::string words(compare::name_of(finding.verdict));
  if (finding.n == 0 && finding.verdict == Verdict::not_tested) return words + ": no values";
  if (finding.is_within_margin) words += ", by less than " + margin;
  switch (finding.why) {
    case Why::tested:
      break;
    case Why::lost:
      return words + ": values are missing";
    case Why::apart:
      return words + (judged.observations.groups[place_of(judged.observations, finding.first)].summary
                          ? ": one has no spread"
                          : ": not comparable");
    case Why::fact:
      return words + ": certain, without a test";
    case Why::too_few:
      return fmt::format("{}: it takes {} values", words, finding.needed);
    case Why::few_decide:
      return words + ": few values decide the mean";
  }
  return words;
}

std::string warning_of(const Doubt& doubt) {
  std::string text = words_of(doubt) + '.';
  if (doubt.who.empty() || !text.starts_with(doubt.who[0])) text[0] = static_cast<char>(std::toupper(text[0]));
  return text;
}

std::string unit_of(const Finding& finding, const JudgedMetric& judged) {
  if (!finding.estimate) return "";
  return finding.scale == Scale::ratio ? "times" : finding.scale == Scale::share ? "points" : judged.observations.unit;
}

std::vector<double> ends_of(const Finding& finding, const JudgedMetric& judged) {
  const double margin = judged.plan.margin;
  if (finding.scale == Scale::ratio) return {1, 1 + margin, 1 / (1 + margin)};
  const double end = is_share(judged) ? 100 * margin : judged.observations.absolute_margin;
  return {0, end, -end};
}

std::string amount_words(const Finding& finding, const JudgedMetric& judged) {
  if (!finding.estimate) {
    const double ahead = finding.effect.value_or(0.5);
    const bool is_shown = finding.verdict == (ahead > 0.5 ? Verdict::better : Verdict::worse) && ahead != 0.5;
    return is_shown ? fmt::format("better in {} % of comparisons", number_text(100 * ahead)) : "";
  }
  const Ends ends = ends_of(finding, judged);
  const double estimate = *finding.estimate;
  std::string text = with_unit(number_text(estimate, digits_apart(estimate, ends)), unit_of(finding, judged));
  if (finding.interval) text += fmt::format(" ({})", interval_text(*finding.interval, number_text, ends));
  return text;
}

std::vector<std::vector<std::string>> pair_rows(const Answer& answer) {
  const bool has_two = answer.decisive().described.size() == 2;
  std::vector<std::vector<std::string>> rows;
  if (answer.decisive().findings.size() > most_pairs) return rows;
  for (const JudgedMetric& judged : answer.metrics) {
    const bool is_decisive = &judged == &answer.decisive();
    if (!has_two && (!is_decisive || std::ranges::all_of(judged.findings, &Finding::are_all_equal))) continue;
    for (const Finding& finding : judged.findings) {
      if (!is_decisive && finding.verdict == Verdict::not_tested) continue;
      rows.push_back({one_line(fmt::format(
                          "{}{} vs {}", has_two && answer.metrics.size() > 1 ? judged.observations.quantity + ": " : "",
                          finding.first, finding.second)),
                      verdict_words(finding, judged), amount_words(finding, judged),
                      finding.p ? p_sentence(*finding.p, {judged.plan.significance}) : ""});
    }
  }
  return rows;
}

}  // namespace ikbench::show
