// Hand-made studies of papers.
#pragma once

#include "analysis/papers/claims.hpp"
#include "analysis/papers/multiverse.hpp"
#include "analysis/papers/published.hpp"
#include "analysis/papers/repeated.hpp"
#include "analysis/papers/rules.hpp"
#include "analysis/show/report_model.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/slim2023/slim2023.hpp"
#include "tests/judge/studies.hpp"

using namespace ikbench::papers;

namespace ikbench::papers {

using results::SolveRecord;
using Change = std::function<void(SolveRecord&)>;

struct Made {
  std::string name = "slim2023", paper = "slim2023", path = "helix", robot = "kuka_iiwa14";
  std::vector<std::string> solvers = {"IK-BA", "BA", "DE", "PSO", "K-ABC", "MO-PSO"};
  int runs = 20, points = 4;
  double tolerance_cm = 0;
};

// What a solver has of one metric in a run: the printed mean, spread over the runs as it is printed.
inline double as_printed(const std::string& solver, const std::string& metric, int run) {
  static const std::map<std::string, PrintedRows> printed{
      {"position_error_cm", printed_means("slim2023", "table-3", "position_error_cm")},
      {"variation_deg", printed_means("slim2023", "table-3", "variation_deg")},
      {"seconds", printed_means("slim2023", "table-3", "seconds")}};
  const PrintedRow* const row = row_of(printed.at(metric), solver);
  if (row == nullptr) return 1;
  const double place = ((run * 7) % 20 - 9.5) / 9.5;  // from -1 to 1
  return std::max(1e-6, row->numbers.mean + row->numbers.sd * place * (place > 0 ? 1.8 : 1));
}

// Each solve has the printed numbers, unless `change` says otherwise.
inline judge::JudgedStudy study_of(const Made& made, const Change& change = {}) {
  const judge::Asked asked{.start = made.tolerance_cm > 0 ? "initial" : "previous",
                           .runs = made.runs,
                           .points = made.points,
                           .rest = fmt::format(R"(, "published": "{}", "robot": "{}", "search": "wrist",
          "path": {{"kind": "{}", "targets": "fixed"}}, "stop": {{"tolerance_cm": {}, "iterations": 200}},
          "analysis": {{"tie_breakers": []}})",
                                               made.paper, made.robot, made.path, made.tolerance_cm)};
  const auto as_in_paper = [&](SolveRecord& solve) {
    solve.target_position_m = {0.1 * solve.point, 0, 0};
    solve.answer_rad = {0.1 * solve.point, 0.001 * solve.run, 0.01 * solve.label.front()};
    solve.position_error_cm = as_printed(solve.label, "position_error_cm", solve.run);
    solve.variation_deg = as_printed(solve.label, "variation_deg", solve.run);
    solve.iterations = 200;
    solve.stop_reason = SolveRecord().stop_reason;
    solve.seconds = solve.cpu_seconds = as_printed(solve.label, "seconds", solve.run) / 1000;
    solve.session = 1;
    if (change) change(solve);
  };
  judge::StudyResults study =
      judge::study(asked, as_in_paper, made.solvers, {{.id = 1, .environment = {{"cpu", "one"}}}});
  study.name = made.name;
  return judge::judge(std::move(study));
}

inline Repeated repeated(const judge::JudgedStudy& study,
                         const std::vector<const judge::JudgedStudy*>& companions = {}) {
  static std::deque<std::vector<judge::JudgedStudy>> kept;
  std::vector<judge::JudgedStudy>& all = kept.emplace_back(std::vector{study});
  for (const judge::JudgedStudy* companion : companions) all.push_back(*companion);
  return {.paper = paper_named(study.study.definition.published), .studies = all};
}

inline JudgedClaim claim_of(const Repeated& of, std::string_view id) {
  const std::vector<JudgedClaim> claims = judged_claims(of);
  const JudgedClaim* const claim = claim_named(claims, id);
  INFO(id);
  REQUIRE(claim != nullptr);
  return *claim;
}

}  // namespace ikbench::papers
