#include "analysis/report/assessment_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "analysis/inference/text.hpp"

namespace ikbench::report {

using namespace inference;

namespace {

constexpr std::size_t most_named = 8;    // in one sentence
constexpr double unequal_variances = 4;  // largest by smallest, from which a pooled variance is named as a danger

}  // namespace

// Three digits, and all digits before the point.
std::string number_words(double value) {
  const double size = std::abs(value);
  return size >= 1000 && size < 1e7 ? fmt::format("{:.0f}", value) : rounded_number(value, 3);
}

std::string p_words(double p) {
  if (p < 1e-300) return "p < 1e-300";
  return p > 0.9995 ? "p > 0.999" : fmt::format("p = {}", rounded_number(p, 3));
}

// "a, b and c"; of many the first, and how many more.
std::string listed(const std::vector<std::string>& items) {
  std::string text;
  const std::size_t shown = items.size() > most_named + 1 ? most_named : items.size();
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == items.size();
    text += fmt::format("{}{}", i == 0 ? "" : last ? " and " : ", ", items[i]);
  }
  return shown == items.size() ? text : fmt::format("{} and {} more", text, items.size() - shown);
}

// The same of clauses that have commas themselves.
std::string clauses(const std::vector<std::string>& items) {
  const std::size_t shown = items.size() > most_named + 1 ? most_named : items.size();
  const auto first = items.begin(), end = first + static_cast<std::ptrdiff_t>(shown);
  const std::string text = fmt::format("{}", fmt::join(first, end, "; "));
  return shown == items.size() ? text : fmt::format("{}; and {} more", text, items.size() - shown);
}

std::string name_words(const Evidence& evidence, std::size_t group) {
  return row_label(evidence.groups[group].name, longest_name_in_text);
}

std::string pair_words(const Evidence& evidence, const Contrast& contrast) {
  return fmt::format("{} and {}", name_words(evidence, contrast.first), name_words(evidence, contrast.second));
}

std::string flaw_words(const Evidence& evidence) {
  return fmt::format("Flawed: {}{}", evidence.flaw, evidence.flaw.ends_with('.') ? "" : ".");
}

// Brown and Forsythe's test has the word where the values are there: Bartlett's takes normal ones for granted.
const TestResult* variance_test(const Evidence& evidence) {
  const TestResult* by_values = evidence.test(brown_forsythe_name);
  return by_values != nullptr ? by_values : evidence.test(bartlett_name);
}

bool variances_differ(const Evidence& evidence) {
  const TestResult* test = variance_test(evidence);
  return test != nullptr && test->p < evidence.plan.significance;
}

bool pooling_misleads(const Evidence& evidence) {
  const double ratio = evidence.variance_ratio;
  return std::isinf(ratio) || (ratio > unequal_variances && variances_differ(evidence));
}

}  // namespace ikbench::report
