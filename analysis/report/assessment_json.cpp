#include "analysis/report/assessment_json.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include "analysis/inference/method.hpp"
#include "analysis/report/assessment_sentences.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/json.hpp"
#include "numerics/json.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

Json estimate(const Estimate& of) {
  return {{"value", json_number(of.value)}, {"low", json_number(of.low)}, {"high", json_number(of.high)}};
}

std::string_view extent_of(const Finding& contrast) {
  return contrast.is_within_margin()   ? "within the margin"
         : contrast.is_beyond_margin() ? "beyond the margin"
         : contrast.is_across_margin() ? "on both sides of the margin"
                                       : "unknown";
}

void add_reason(Json& object, const std::string& undefined) {
  if (!undefined.empty()) object["undefined"] = undefined;
}

Json group_json(const GroupEvidence& group) {
  const Description& of = group.described;
  return {{"name", group.name},
          {"n", of.n},
          {"not_finite", of.not_finite},
          {"mean", estimate(group.mean)},
          {"mean_by_bootstrap", estimate(group.bootstrapped)},
          {"sd", json_number(of.std)},
          {"median", estimate(group.median)},
          {"q1", json_number(group.q1)},
          {"q3", json_number(group.q3)},
          {"min", json_number(of.min)},
          {"max", json_number(of.max)},
          {"shapiro_wilk_w", json_number(group.normality_w)},
          {"shapiro_wilk_p", json_number(group.normality)},
          {"mean_rank", json_number(group.mean_rank)},
          {"average_rank", json_number(group.average_rank)},
          {"decades", json_number(group.decades)}};
}

Json test_json(const TestResult& test) {
  Json object{{"test", test.test},
              {"role", role_words(test.role)},
              {"without", test.without},
              {"symbol", test.symbol},
              {"statistic", json_number(test.statistic)},
              {"df", json_number(test.df)},
              {"df_within", json_number(test.df_within)},
              {"p", json_number(test.p)}};
  if (!test.effect_symbol.empty())
    object["effect"] = {{"symbol", test.effect_symbol}, {"value", json_number(test.effect)}};
  add_reason(object, test.undefined);
  return object;
}

Json contrast_json(const Evidence& evidence, const Finding& contrast) {
  Json object{{"first", evidence.groups[contrast.first].name},
              {"second", evidence.groups[contrast.second].name},
              {"difference", estimate(contrast.estimate)},
              {"p", json_number(contrast.p)},
              {"p_alone", json_number(contrast.p_alone)},
              {"p_ranks", json_number(contrast.p_ranks)},
              {evidence.blocks > 0 ? "share_of_blocks_ahead" : "a12", estimate(contrast.superiority)},
              {"typical_ratio", estimate(contrast.ratio)},
              {"hedges_g", json_number(contrast.g)},
              {"runs_to_decide", json_number(contrast.runs_to_decide.value)},
              {"runs_to_decide_low", json_number(contrast.runs_to_decide.low)},
              {"runs_to_decide_high", json_number(contrast.runs_to_decide.high)},
              {"relation", name_of(contrast.relation)},
              {"extent", extent_of(contrast)},
              {"verdict", verdict_words(evidence, contrast)}};
  add_reason(object, contrast.why);
  return object;
}

}  // namespace

std::string json_of(const Evidence& evidence) {
  constexpr std::array scales{"plain", "log10", "share"};
  const AnalysisPlan& plan = evidence.plan;
  Json object{{"quantity", evidence.quantity},
              {"unit", evidence.unit},
              {"better", evidence.better == Better::smaller ? "smaller" : "larger"},
              {"scale", scales[static_cast<std::size_t>(evidence.scale)]},
              {"replicate", evidence.replicate},
              {"block", evidence.block},
              {"blocks", evidence.blocks},
              {"method", evidence.method == nullptr ? "" : evidence.method->title},
              {"from_summaries", evidence.from_summaries},
              {"of_outcomes", evidence.of_outcomes},
              {"plan",
               {{"test", plan.test},
                {"adjustment", name_of(plan.adjustment)},
                {"control", plan.control},
                {"significance", plan.significance},
                {"margin", plan.margin},
                {"margin_cm", plan.margin_cm},
                {"margin_absolute", evidence.margin},
                {"power", plan.power},
                {"quartiles", plan.quartiles}}},
              {"notes", evidence.notes},
              {"flaw", words_of(evidence.flaws)},
              {"variance_ratio", json_number(evidence.variance_ratio)},
              {"critical_difference", json_number(evidence.critical_difference)},
              {"pairs", evidence.pairs}};
  Json groups = Json::array(), tests = Json::array(), contrasts = Json::array();
  for (const GroupEvidence& group : evidence.groups) groups.push_back(group_json(group));
  for (const TestResult& test : evidence.tests) tests.push_back(test_json(test));
  for (const Finding& contrast : evidence.contrasts) contrasts.push_back(contrast_json(evidence, contrast));
  object["groups"] = groups;
  object["tests"] = tests;
  object["contrasts"] = contrasts;
  object["sentences"] = words_of(sentences_of(evidence));
  return numerics::text_of(object, 2);  // names may be anything
}

}  // namespace ikbench::report
