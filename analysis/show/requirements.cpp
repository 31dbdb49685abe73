#include "analysis/show/requirements.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "analysis/show/text.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

std::string_view verdict_key(RequirementVerdict verdict) {
  switch (verdict) {
    case RequirementVerdict::met:
      return "met";
    case RequirementVerdict::failed:
      return "failed";
    case RequirementVerdict::inconclusive:
      return "inconclusive";
  }
  return "";
}

std::string_view verdict_text(RequirementVerdict verdict) {
  return verdict == RequirementVerdict::failed ? "not met" : verdict_key(verdict);
}

// Returns "97 of 100 targets", or "97.5 % of targets" if values are means of several solves.
std::string share_text(const RequirementCheck& check, const ReportModel& model) {
  if (std::isnan(check.share)) return "an unknown share of targets";
  if (check.are_counts && !check.is_exact)
    return fmt::format("{:.0f} of {}", check.share * check.n,
                       base::counted(static_cast<std::int64_t>(check.n), model.noun));
  return fmt::format("{} % of targets", number_within(100 * check.share, {0, 100, 100 * check.required}));
}

// Returns a percentage with at least so many digits, and with as many as show on which side of the required one it is.
std::string percent_text(double percent, double required, int digits) {
  for (; digits < 12; ++digits) {
    const double shown = base::number_from(number_text(percent, digits)).value_or(percent);
    if ((shown < required) == (percent < required)) break;
  }
  return number_text(percent, digits);
}

// Returns " (92-99 %)", " (deterministic)", or why there is no interval.
std::string evidence_text(const RequirementCheck& check) {
  if (!check.reason.empty()) return fmt::format(" ({})", check.reason);
  if (check.is_exact) return " (deterministic)";
  const double low = 100 * check.interval.low, high = 100 * check.interval.high;
  const int digits = high - low < 3 ? 3 : 2;
  const double required = 100 * check.required;
  return fmt::format(" ({}-{} %)", percent_text(low, required, digits), percent_text(high, required, digits));
}

// Rounds up to two digits: 356 becomes 360.
std::int64_t rounded_up(std::int64_t count) {
  std::int64_t unit = 1;
  while (count / unit >= 100) unit *= 10;
  return (count + unit - 1) / unit * unit;
}

std::string sentence(const RequirementCheck& check, const ReportModel& model) {
  std::string text = fmt::format("{} solved {}{}: at least {} %{} is {}{}", check.solver, share_text(check, model),
                                 check.metric == "in-time" ? " in time" : "", number_text(100 * check.required, 12),
                                 model.time_limit.empty() ? "" : " within " + model.time_limit,
                                 verdict_text(check.verdict), evidence_text(check));
  if (check.more_values > 0)
    text += fmt::format("; about {} more {} like these would show it", rounded_up(check.more_values), model.noun);
  const bool passes = check.verdict == RequirementVerdict::inconclusive && !check.is_strict;
  return text + (passes ? "; passes, since --strict is not given." : ".");
}

}  // namespace

std::vector<std::string> requirement_sentences(const ReportModel& model) {
  std::vector<std::string> sentences;
  for (const RequirementCheck& check : model.requirements) sentences.push_back(sentence(check, model));
  if (sentences.size() > 1) sentences.emplace_back("Each requirement is checked by itself.");
  return sentences;
}

base::OrderedJson requirements_json(const ReportModel& model) {
  base::OrderedJson list = base::OrderedJson::array();
  for (const RequirementCheck& check : model.requirements) {
    base::OrderedJson& json = list.emplace_back();
    json = {{"solver", check.solver},
            {"metric", check.metric},
            {"required", base::json_of(check.required)},
            {"share", base::json_of(check.share)},
            {"n", base::json_of(check.n)},
            {"low", base::json_of(check.interval.low)},
            {"high", base::json_of(check.interval.high)},
            {"verdict", verdict_key(check.verdict)},
            {"more_values", check.more_values}};
    json["reason"] = check.reason.empty() ? base::OrderedJson() : base::OrderedJson(check.reason);
  }
  return list;
}

}  // namespace ikbench::show
