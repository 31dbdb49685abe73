// One judge for everything that a report and `ikbench compare` say of two: by the significance of the plan, and no
// other.
#include "analysis/inference/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/variant_comparison.hpp"
#include "analysis/papers.hpp"
#include "analysis/report/report.hpp"
#include "analysis/report/summary.hpp"
#include "results/store.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

// 20 values with that mean and a standard deviation of 1, of i = 0 to 19, whose own is sqrt(35).
double value_in(int run, double mean) { return mean + (run - 10.5) / std::sqrt(35.0); }

// Between two such samples t = (difference) / sqrt(2 / 20), of 38 degrees of freedom: p = 0.027 where it is 2.3.
constexpr double apart = 2.3 * 0.31622776601683794;

// A study of the paper's, in which IK-BA is ahead of MO-PSO in everything with p = 0.027.
void save_solves(Store& store, const std::string& name, double significance, const std::string& limits) {
  StudyEntry entry{.name = name,
                   .definition = R"({"path": {"kind": "helix", "points": 1}, "runs": 20, "published": "slim2023",)"
                                 R"( "limits": ")" +
                                 limits + R"(", "analysis": {"significance": )" + std::to_string(significance) +
                                 R"(, "margin_percent": 0}})",
                   .series = {}};
  const std::int64_t session = store.begin_session({{"cpu", "one"}});
  std::vector<SolveRecord> solves;
  for (const char* solver : {"IK-BA", "MO-PSO"}) {
    const std::string key = name + "-" + solver;
    entry.series.push_back({key, solver, "bat", "{}"});
    for (int run = 1; run <= 20; ++run) {
      const double more = solver == std::string("IK-BA") ? 0 : apart;
      SolveRecord solve{.study = name, .solver = solver, .series = key, .run = run};
      solve.target_position_m = {0.6, 0.2, 0.1};
      solve.target_rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};
      solve.position_error_cm = value_in(run, 10 + more);
      solve.variation_deg = value_in(run, 87 + more);
      solve.seconds = solve.cpu_seconds = value_in(run, 10 + more);
      solve.evaluations = static_cast<std::int64_t>(1e6 * value_in(run, 10 + more));
      solve.session = session;
      solves.push_back(solve);
    }
  }
  store.save_study(entry);
  store.append(solves);
}

struct Judged {
  std::vector<std::string> relations;  // of everything that was observed but the shares, which are all 0
  std::string text;                    // of the whole report
  std::string page;                    // report.md alone
  MetricComparison compared;
};

// The significance levels of the studies, and those given for their report.
struct Significance {
  double study, companion;
  std::optional<double> given = {};
};

Judged told_at(const Significance& at) {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save_solves(store, "own", at.study, "recorded");
  save_solves(store, "own-limits", at.companion, "enforced");
  const std::filesystem::path out = folder.path / "report";
  ReportRequest request{.study = "own", .folder = out, .figures = {.render = false}, .papers = analysis::papers()};
  if (at.given) request.plan = AnalysisPlan{.significance = *at.given, .margin = 0};
  write_report(store, request);
  Judged told;
  for (const auto& found : nlohmann::json::parse(text_of_file(out / "statistics.json"))) {
    if (found.at("from_summaries") || found.at("better") == "larger") continue;  // no error is within 0.01 cm
    for (const auto& contrast : found.at("contrasts")) told.relations.push_back(contrast.at("relation"));
  }
  for (const std::string& file : files_in(out)) {
    if (!file.starts_with("figures")) told.text += text_of_file(out / file);
  }
  told.page = text_of_file(out / "report.md");
  const std::vector<Variant> both = variants(store, store.study("own"));
  const std::vector<std::string> error{"position_error_cm"};
  const AnalysisPlan plan{.significance = at.given.value_or(at.study), .margin = 0};
  const std::vector<VariantStudy> studies{study_of_both(both[0], both[1], plan)};
  told.compared = compare_variants(studies, error).front().metrics.front();
  return told;
}

// The cell beside the claim.
std::string verdict_of(const Judged& told, const std::string& claim) {
  const std::size_t claimed = told.page.find(claim + " | ");
  REQUIRE(claimed != std::string::npos);
  const std::size_t start = claimed + claim.size() + 3;
  return told.page.substr(start, told.page.find(" |", start) - start);
}

constexpr std::array<const char*, 3> judged_claims{"IK-BA is the most accurate", "of all three",
                                                   "With all limits enforced, IK-BA is the most accurate"};

}  // namespace

TEST_CASE("where the plan says 0.05, p = 0.027 decides", "[judge]") {
  const Judged told = told_at({.study = 0.05, .companion = 0.05});
  CHECK(told.relations == std::vector<std::string>(5, "first is better"));
  for (const char* claim : judged_claims) CHECK(verdict_of(told, claim) == "holds");
  CHECK(is_regression(told.compared));
}

TEST_CASE("where the plan says 0.01, nothing is decided at 0.05: in no claim, table, sentence or comparison",
          "[judge]") {
  // The plan is the study's, or one that is given for the report; its companion is judged by it whatever it says
  // itself.
  const Judged told =
      told_at(GENERATE(Significance{.study = 0.01, .companion = 0.01}, Significance{.study = 0.01, .companion = 0.05},
                       Significance{.study = 0.05, .companion = 0.05, .given = 0.01}));
  CHECK(told.relations == std::vector<std::string>(5, "undecided"));
  for (const char* claim : judged_claims) CHECK(verdict_of(told, claim) == "undecided");
  for (const char* other : {"p >= 0.05", "p &gt;= 0.05", "at 0.05", "95 %"}) CHECK(!contains(told.text, other));
  CHECK(told.compared.finding().relation == Relation::undecided);
}

TEST_CASE("a study finds its evidence once for each metric, and of times that are not comparable only describes them",
          "[judge]") {
  std::vector<SolveRecord> solves;
  for (const char* solver : {"A", "B"}) {
    for (int run = 1; run <= 20; ++run) {
      SolveRecord solve{.solver = solver, .run = run};
      solve.position_error_cm = solve.seconds = value_in(run, 10);
      solve.timing = Timing::parallel;
      solves.push_back(solve);
    }
  }
  const JudgedStudy study(make_study("own", solves));
  const Evidence& error = study.evidence(Metric::position_error_cm);
  const Evidence& time = study.evidence(Metric::seconds);
  CHECK(&study.evidence(Metric::position_error_cm) == &error);
  CHECK(error.contrasts.size() == 1);
  CHECK(time.groups.size() == 2);
  CHECK(time.contrasts.empty());
  CHECK(judge(time, "A", "B").why == words_of(timing_doubts(study)));
}

TEST_CASE("the one rule: found before small, small before open", "[judge]") {
  CHECK(relation_of(1, 0.04, 0.05, true) == Relation::better);
  CHECK(relation_of(-1, 0.04, 0.05) == Relation::worse);
  CHECK(relation_of(1, 0.04, 0.01, true) == Relation::same);
  CHECK(relation_of(1, 0.04, 0.01) == Relation::undecided);
  CHECK(relation_of(0, statistics::not_defined, 0.05) == Relation::undecided);
}

TEST_CASE("a judgement of two, the other way round, is the opposite", "[judge]") {
  Observations observed{.name = "error", .quantity = "error [cm]", .unit = "cm"};
  for (const auto& [name, mean] : {std::pair("one", 10.0), std::pair("other", 12.0)}) {
    Group group{.name = name};
    for (int run = 1; run <= 20; ++run) group.values.push_back(value_in(run, mean));
    observed.groups.push_back(group);
  }
  const Finding found = judge(evidence(observed, {}), "one", "other"),
                back = judge(evidence(observed, {}), "other", "one");
  CHECK(found.relation == Relation::better);
  CHECK(back.relation == Relation::worse);
  CHECK(found.p == back.p);
  CHECK(found.estimate.value == Approx(-2));
  CHECK(back.estimate.low == -found.estimate.high);

  observed.flaws = {{DoubtKind::single_target}};
  CHECK(judge(evidence(observed, {}), "one", "other").relation == Relation::undefined);
  CHECK(judge(evidence(observed, {}), "one", "other").why == words_of(observed.flaws));
  observed.flaws.clear();
  for (double& value : observed.groups[1].values) value = statistics::not_defined;
  CHECK(judge(evidence(observed, {}), "one", "other").relation == Relation::better);
  CHECK(judge(evidence(observed, {}), "one", "none").why == "none is left out of the comparison");
}
