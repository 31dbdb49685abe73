#include "analysis/slim2023/paper_claims.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/slim2023/companion_claims.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/ranking_claims.hpp"
#include "analysis/slim2023/study_claims.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace inference;
using namespace report;

std::vector<Claim> claims(const Reported& reported) {
  const JudgedStudy& study = reported.study;
  std::vector<Claim> result;
  const auto add = [&](std::optional<Claim> claim) {
    if (claim) result.push_back(std::move(*claim));
  };
  const std::vector<Comparison> rows = compare(study);
  const auto is_printed = [](const Comparison& row) { return std::isfinite(row.paper_mean); };
  if (std::ranges::any_of(rows, is_printed)) {
    add(most_accurate(study, rows));
    add(accuracy(study, rows));
    for (Claim& claim : variation(study, rows)) result.push_back(std::move(claim));
    add(computing_time(study, rows));
    add(solvers_differ(study));
    add(inside_limits(study));
    for (const JudgedStudy& companion : reported.companions) {
      if (companion.name == study.name + "-limits") add(accurate_inside_limits(study, companion));
      if (companion.name == study.name + "-context") add(better_than_classical(study, companion));
    }
  }
  add(real_time(study));
  add(circle(study));
  for (const JudgedStudy& companion : reported.companions) {
    add(real_time(companion));
    add(circle(companion));
  }
  return result;
}

}  // namespace ikbench::slim2023
