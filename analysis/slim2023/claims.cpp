#include "analysis/slim2023/claims.hpp"

#include "analysis/slim2023/companion_claims.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/slim2023/solver_claims.hpp"
#include "analysis/slim2023/study_claims.hpp"

namespace ikbench::slim2023 {

using namespace inference;
using namespace report;

const std::vector<std::pair<std::string, ClaimRule>>& claim_rules() {
  static const std::vector<std::pair<std::string, ClaimRule>> rules{
      {"smallest", smallest},
      {"largest", largest},
      {"ranking", ranking},
      {"compromise", compromise},
      {"differ", differ},
      {"least_at_each_point", least_at_each_point},
      {"least_spread", least_spread},
      {"smoothest", smoothest},
      {"inside_limits", inside_limits},
      {"has_effect", has_effect},
      {"singularities", singularities},
      {"real_time", real_time},
      {"only_offline", only_offline},
      {"circle", circle},
      {"untested", [](const Reported&, const ClaimEntry&) { return std::nullopt; }}};
  return rules;
}

std::vector<std::string> claim_tests() {
  std::vector<std::string> names;
  for (const auto& [name, rule] : claim_rules()) names.push_back(name);
  return names;
}

std::vector<Claim> judged_claims(const Reported& reported, const std::vector<ClaimEntry>& entries) {
  const bool is_papers = !printed_table_3(reported.study, Metric::position_error_cm).empty();
  std::vector<Claim> claims;
  for (const ClaimEntry& entry : entries) {
    for (const auto& [name, rule] : claim_rules()) {
      if (name != entry.test) continue;
      if (std::optional<Claim> claim = rule(reported, entry)) {
        claims.push_back(std::move(*claim));
      } else if (is_papers && entry.by == By::paper) {
        claims.push_back(untested(entry));
      }
    }
  }
  // What another study could test is no shortcoming of the paper's.
  if (departs_from_paper(reported.study)) {
    std::erase_if(claims, [](const Claim& claim) { return claim.verdict == Verdict::untested; });
  }
  return claims;
}

std::vector<Claim> claims(const Reported& reported) { return judged_claims(reported, claim_entries(claim_tests())); }

}  // namespace ikbench::slim2023
