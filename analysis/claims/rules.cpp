#include "analysis/claims/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ikbench::claims {

using namespace inference;
using namespace report;

namespace {

Claims none(const Case&) { return {}; }

constexpr NamedRule rules[]{{"smallest", smallest},
                            {"ranking", ranking},
                            {"compromise", compromise},
                            {"differ", differ},
                            {"least_spread", least_spread},
                            {"least_at_each_point", least_at_each_point},
                            {"inside_limits", inside_limits, false},
                            {"has_effect", has_effect},
                            {"in_time", in_time, false},
                            {"ratios_of_times", ratios_of_times},
                            {"rounding_level", rounding_level, false},
                            {"rate_as_printed", rate_as_printed, false},
                            {"solves_more", solves_more, false},
                            {"untested", none, false}};

// A claim that no data here can decide.
Claim untested(const Case& of) {
  Claim claim = of.begun();
  claim.verdict = Verdict::untested;
  claim.table = "";
  claim.evidence = {"What would decide it: " + of.entry.decides};
  if (!of.entry.study.empty()) {
    claim.evidence.push_back(fmt::format("`ikbench reproduce` runs the study for it ({}).", of.entry.study));
  }
  return claim;
}

}  // namespace

const NamedRule* rule_named(std::string_view name) {
  const auto* found = std::ranges::find(rules, name, &NamedRule::name);
  return found == std::end(rules) ? nullptr : found;
}

std::vector<std::string> rule_names() {
  std::vector<std::string> names;
  for (const NamedRule& each : rules) names.emplace_back(each.name);
  return names;
}

Claims judged(const ClaimsFile& file, const Reported& reported) {
  Claims claims;
  for (ClaimEntry entry : file.entries) {
    if (!reported.has_times && std::erase(entry.metrics, Metric::seconds) > 0 && entry.metrics.empty()) continue;
    const Case of{file, entry, reported};
    Claims found = rule_named(entry.rule)->rule(of);
    const bool is_of_many = entry.sentence.find('{') != std::string::npos;
    if (found.empty() && of.is_of_means() && entry.by == Claimant::paper && !is_of_many) found.push_back(untested(of));
    std::ranges::move(found, std::back_inserter(claims));
  }
  // Claims that another study could test are no shortcoming of the paper.
  if (departs_from_paper(reported.study)) {
    std::erase_if(claims, [](const Claim& claim) { return claim.verdict == Verdict::untested; });
  }
  return claims;
}

}  // namespace ikbench::claims
