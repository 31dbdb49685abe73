// An assessment's numbers as JSON: every one of them, whatever the tables leave out.
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "analysis/assessment.hpp"

namespace ikbench {
namespace {

using Json = nlohmann::ordered_json;

// What is not defined is null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json estimate(const Estimate& of) {
  return {{"value", number(of.value)}, {"low", number(of.low)}, {"high", number(of.high)}};
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
          {"sd", number(of.std)},
          {"median", estimate(group.median)},
          {"q1", number(group.q1)},
          {"q3", number(group.q3)},
          {"min", number(of.min)},
          {"max", number(of.max)},
          {"shapiro_wilk_w", number(group.normality_w)},
          {"shapiro_wilk_p", number(group.normality)},
          {"mean_rank", number(group.mean_rank)},
          {"average_rank", number(group.average_rank)}};
}

Json test_json(const TestResult& test) {
  constexpr std::array<std::string_view, 3> roles{"assumption", "classical", "sound"};
  Json object{{"test", test.test},
              {"role", roles[static_cast<std::size_t>(test.role)]},
              {"without", test.without},
              {"symbol", test.symbol},
              {"statistic", number(test.statistic)},
              {"df", number(test.df)},
              {"df_within", number(test.df_within)},
              {"p", number(test.p)}};
  if (!test.effect_symbol.empty()) object["effect"] = {{"symbol", test.effect_symbol}, {"value", number(test.effect)}};
  add_reason(object, test.undefined);
  return object;
}

Json contrast_json(const Evidence& evidence, const Contrast& contrast) {
  Json object{{"first", evidence.groups[contrast.first].name},
              {"second", evidence.groups[contrast.second].name},
              {"difference", estimate(contrast.difference)},
              {"p", number(contrast.p)},
              {"p_tukey", number(contrast.p_pooled)},
              {"p_games_howell", number(contrast.p_unpooled)},
              {"p_paired_t", number(contrast.p_paired)},
              {"p_ranks", number(contrast.p_ranks)},
              {"p_nemenyi", number(contrast.p_nemenyi)},
              {evidence.blocks > 0 ? "share_of_blocks_ahead" : "a12", estimate(contrast.superiority)},
              {"hedges_g", estimate(contrast.g)},
              {"runs_to_see_margin", number(contrast.runs_to_see_margin)},
              {"within_margin", contrast.within_margin},
              {"relation", name_of(contrast.relation)}};
  add_reason(object, contrast.undefined);
  return object;
}

}  // namespace

std::string json_of(const Evidence& evidence) {
  const AnalysisPlan& plan = evidence.plan;
  Json object{{"quantity", evidence.quantity},
              {"better", evidence.better == Better::smaller ? "smaller" : "larger"},
              {"replicate", evidence.replicate},
              {"block", evidence.block},
              {"blocks", evidence.blocks},
              {"from_summaries", evidence.from_summaries},
              {"plan",
               {{"test", name_of(plan.test)},
                {"adjustment", name_of(plan.adjustment)},
                {"control", plan.control},
                {"significance", plan.significance},
                {"margin", plan.margin},
                {"power", plan.power},
                {"quartiles", plan.quartiles}}},
              {"notes", evidence.notes},
              {"flaw", evidence.flaw},
              {"variance_ratio", number(evidence.variance_ratio)},
              {"critical_difference", number(evidence.critical_difference)},
              {"pairs", evidence.pairs}};
  Json groups = Json::array(), tests = Json::array(), contrasts = Json::array();
  for (const GroupEvidence& group : evidence.groups) groups.push_back(group_json(group));
  for (const TestResult& test : evidence.tests) tests.push_back(test_json(test));
  for (const Contrast& contrast : evidence.contrasts) contrasts.push_back(contrast_json(evidence, contrast));
  object["groups"] = groups;
  object["tests"] = tests;
  object["contrasts"] = contrasts;
  object["sentences"] = sentences_of(evidence);
  return object.dump(2, ' ', false, Json::error_handler_t::replace);  // names may be anything
}

}  // namespace ikbench
