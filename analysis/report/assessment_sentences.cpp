#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

// "20 observations", "18 to 20 observations"
std::string sizes(const Evidence& evidence) {
  const auto [least, most] =
      std::ranges::minmax(evidence.groups, {}, [](const GroupEvidence& group) { return group.described.n; });
  if (least.described.n == most.described.n) {
    return fmt::format("{} {}", most.described.n, most.described.n == 1 ? "observation" : "observations");
  }
  return fmt::format("{} to {} observations", least.described.n, most.described.n);
}

Sentence design(const Evidence& evidence) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) names.push_back(name_words(evidence, i));
  std::string text = fmt::format(words::data, "quantity"_a = quantity_words(evidence.quantity, evidence.unit),
                                 "better"_a = evidence.better == Better::smaller ? "smaller" : "larger",
                                 "count"_a = names.size(), "groups"_a = names.size() == 1 ? "group" : "groups",
                                 "names"_a = listed(names), "sizes"_a = sizes(evidence));
  text += evidence.from_summaries ? words::known_summaries : ".";
  if (!evidence.replicate.empty()) text += ' ' + fmt::format(words::observation, "what"_a = evidence.replicate);
  if (evidence.scale == ValueScale::log10) text += fmt::format(" {}", words::logarithms);
  if (evidence.blocks > 0) {
    text += ' ' + fmt::format(words::blocks, "count"_a = evidence.blocks,
                              "blocks"_a = evidence.blocks == 1 ? "block" : "blocks", "what"_a = evidence.block);
  }
  return {"Data", text};
}

Sentence methods(const Evidence& evidence) {
  std::string family;
  if (!evidence.plan.control.empty()) {
    family =
        fmt::format(words::family_of_control, "control"_a = row_label(evidence.plan.control, longest_name_in_text));
  } else if (evidence.pairs > 1) {
    family = fmt::format(words::family_of_all, "pairs"_a = evidence.pairs);
  }
  if (!evidence.from_summaries && (evidence.ranks_decide() || evidence.of_outcomes) && evidence.pairs > 1) {
    family += words::correction;
  }
  std::string method = fmt::format(words::method, "test"_a = deciding_words(evidence),
                                   "level"_a = rounded_number(evidence.plan.significance, 3), "family"_a = family,
                                   "margin"_a = margin_words(evidence));
  if (evidence.blocks > 0 && !evidence.decides_within_blocks()) method += words::ignores_blocks;
  return {"Methods", evidence.of_outcomes ? fmt::format(words::method_of_shares, "method"_a = method,
                                                        "interval"_a = evidence.method->interval)
                                          : method};
}

// "F(5, 44.3) = 142, p = 4e-26"
std::string result_words(const TestResult& test) {
  if (!test.undefined.empty()) return "not defined, " + test.undefined;
  std::string df = rounded_number(test.df, 3);
  if (std::isfinite(test.df_within)) df += ", " + rounded_number(test.df_within, 3);
  std::string text = std::isfinite(test.df)
                         ? fmt::format("{}({}) = {}", test.symbol, df, rounded_number(test.statistic, 4))
                         : fmt::format("{} = {}", test.symbol, rounded_number(test.statistic, 4));
  return fmt::format("{}, {}", text, p_words(test.p));
}

// Warns of single values over decades: the largest few decide their mean, and so a test of means.
Sentence decades(const Evidence& evidence) {
  constexpr double wide = 2;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) {
    const double span = evidence.groups[i].decades;
    if (span > wide) names.push_back(fmt::format("{} ({})", name_words(evidence, i), rounded_number(span, 2)));
  }
  if (names.empty() || evidence.ranks_decide() || evidence.scale == ValueScale::log10) return {};
  return {"Caution", fmt::format(words::decades, "names"_a = listed(names))};
}

// The planned test of all groups.
Sentence all_together(const Evidence& evidence) {
  const TestResult* test = deciding_test(evidence);
  if (test == nullptr) return {};
  const std::string without = test->without.empty() ? "" : fmt::format(" ({})", test->without);
  std::string text = fmt::format("{}{}: {}", test->test, without, result_words(*test));
  if (std::isfinite(test->effect)) {
    text += fmt::format(", {} = {}", test->effect_symbol, rounded_number(test->effect, 2));
  }
  if (test->undefined.empty()) {
    text += test->p < evidence.plan.significance ? "; at least one group differs" : "; no difference is shown";
  }
  return {"All groups together", text + '.'};
}

Sentence limits(const Evidence& evidence) {
  std::vector<std::string> parts;
  if (std::ranges::count(evidence.contrasts, Relation::undecided, &Finding::relation) > 0) {
    parts.emplace_back(words::undecided_is_not_equal);
  }
  if (std::string failures = rare_failures_words(evidence); !failures.empty()) parts.push_back(std::move(failures));
  if (!evidence.flaws.empty()) parts.emplace_back(words::flawed_p);
  if (evidence.from_summaries) parts.emplace_back(words::only_summaries);
  parts.emplace_back(words::only_these_conditions);
  return {"What this does not show", fmt::format("{}.", fmt::join(parts, "; "))};
}

}  // namespace

std::vector<Sentence> sentences_of(const Evidence& evidence) {
  if (evidence.groups.empty()) return {{"", "There are no groups."}};
  std::vector<Sentence> sentences;
  const auto say = [&](Sentence sentence) { add(sentences, std::move(sentence)); };
  const auto describe = [&] {
    say(design(evidence));
    for (const std::string& note : evidence.notes) say({"Note", note});
  };
  if (evidence.groups.size() > 1 && evidence.contrasts.empty()) {
    say({"Not judged", std::string(words::described_only)});
    describe();
    return sentences;
  }
  say({"Flawed", words_of(evidence.flaws)});
  if (const auto sentences_of_answer = answer(evidence); !sentences_of_answer.empty()) {
    say({"In short", fmt::format("{}.", fmt::join(sentences_of_answer, ". "))});
  }
  say(change_words(evidence));
  describe();
  if (evidence.groups.size() < 2) {
    say({"", std::string(words::one_group)});
    return sentences;
  }
  if (evidence.constant) {
    say({"", fmt::format(words::constants, "test"_a = test_of_constants_words(evidence))});
    return sentences;
  }
  if (has_single_values(evidence)) return sentences;
  say(methods(evidence));
  say(too_few(evidence));
  say(decades(evidence));
  say(all_together(evidence));
  say(limits(evidence));
  return sentences;
}

}  // namespace ikbench::report
