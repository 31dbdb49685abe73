// What report.html is made of: pictures, findings, the arm's data, the policy, the order of pieces.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/report/encoding.hpp"
#include "analysis/report/moving_arm.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/report_html.hpp"
#include "analysis/report/report_markdown.hpp"
#include "analysis/slim2023/report_findings.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::slim2023;

namespace {

bool contains(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

StudyResults study_of(std::vector<SolveRecord> solves, const std::string& name = "s") {
  StudyResults study = make_study(name, std::move(solves));
  study.published = "slim2023";
  return study;
}

const Finding& finding_of(const std::vector<Finding>& findings, const std::string& claim) {
  const auto found = std::ranges::find_if(findings, [&](const Finding& f) { return contains(f.claim, claim); });
  REQUIRE(found != findings.end());
  return *found;
}

Verdict verdict_of(const std::vector<Finding>& findings, const std::string& claim) {
  return finding_of(findings, claim).verdict;
}

}  // namespace

TEST_CASE("bytes and digests are written in base64 as RFC 4648 and FIPS 180-4 have them", "[report]") {
  CHECK(base64("") == "");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64(std::string_view("\xff\xfe\x00", 3)) == "//4A");
  CHECK(sha256_in_base64("") == "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
  CHECK(sha256_in_base64("abc") == "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
}

TEST_CASE("a figure is an image within the page, whose bytes are those of its file", "[report]") {
  const TestFolder folder;
  const std::string svg = "<svg onload='alert(1)'><script>alert(2)</script><text>\"></text></svg>";
  std::ofstream(folder.path() / "figure-6.svg") << svg;
  ReportContent content;
  arrange({ReportFigure{{"figure-6", "of <b> and \" onload=\"alert(3)"}, true}}, {}, content);
  const std::string page = to_html(content, {.figures = folder.path()});
  CHECK(contains(page, "src=\"data:image/svg+xml;base64," + base64(svg) + "\">"));
  CHECK(contains(page, "of &lt;b&gt; and &quot; onload=&quot;alert(3)\" src="));
  CHECK(contains(page, "img-src data:"));
  CHECK(!contains(page, svg));
}

TEST_CASE("pieces come in the paper's order, and none is lost", "[report]") {
  ReportContent content;
  std::vector<Piece> pieces;
  for (const char* name : {"unheard-of", "table-7", "status", "table-3"}) pieces.emplace_back(Table{name, "caption"});
  for (const char* name : {"figure-9-a", "figure-9-b", "figure-5"})
    pieces.emplace_back(ReportFigure{{name, "caption"}});
  arrange(std::move(pieces), {}, content);
  std::string order;
  for (const auto* part : {&content.circumstances, &content.results}) {
    for (const Section& section : *part) {
      order += section.heading + ':';
      for (const Piece& piece : section.pieces) order += ' ' + name_of(piece);
      order += '\n';
    }
  }
  CHECK(order ==
        "What became of every solve: status\nResults: figure-5 table-3 figure-9-a figure-9-b\nComputing time: table-7\n"
        "Further: unheard-of\n");
}

TEST_CASE("findings hold, hold in part, are undecided or do not hold, by the store's numbers", "[report]") {
  const auto as_printed = findings(study_of(synthetic::solves({})), {}, Unit::run);
  CHECK(verdict_of(as_printed, "is the most accurate") == Verdict::holds);
  CHECK(verdict_of(as_printed, "Accuracy: IK-BA < K-ABC < DE < MO-PSO < PSO < BA") == Verdict::holds);
  CHECK(verdict_of(as_printed, "less than MO-PSO") == Verdict::undecided);  // printed 87.2 and 90.0 deg
  CHECK(verdict_of(as_printed, "less than the other solvers") == Verdict::holds);
  CHECK(verdict_of(as_printed, "Computing time: PSO < IK-BA") == Verdict::holds);
  CHECK(verdict_of(as_printed, "The solvers differ") == Verdict::holds);
  CHECK(verdict_of(as_printed, "inside the joint limits") == Verdict::holds);
  CHECK(verdict_of(findings(study_of(synthetic::solves({})), {}, Unit::point), "less than the other") ==
        Verdict::undecided);

  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) {
    if (solve.solver == "IK-BA") {
      solve.position_error_cm *= 1000;
      solve.variation_deg *= 2;
      solve.limit_violation_deg = 1;
    }
    solve.timing = Timing::parallel;
  }
  const auto otherwise = findings(study_of(solves), {}, Unit::run);
  CHECK(verdict_of(otherwise, "is the most accurate") == Verdict::does_not_hold);
  CHECK(verdict_of(otherwise, "less than MO-PSO") == Verdict::does_not_hold);
  CHECK(verdict_of(otherwise, "Computing time") == Verdict::undecided);
  CHECK(verdict_of(otherwise, "inside the joint limits") == Verdict::does_not_hold);

  solves[0].position_error_cm = not_defined;  // an answer of IK-BA that is none
  CHECK(verdict_of(findings(study_of(solves), {}, Unit::run), "is the most accurate") == Verdict::does_not_hold);
  CHECK(findings(make_study("unpublished", synthetic::solves({})), {}, Unit::run).empty());
}

TEST_CASE("where all solvers are the same to the bit, no printed ranking can be decided", "[report]") {
  std::vector<SolveRecord> solves = synthetic::solves({.runs = 3});
  for (SolveRecord& solve : solves) {
    solve.position_error_cm = solve.claimed_error_cm = 1 + 0.1 * solve.run;
    solve.variation_deg = 10 + solve.run;
    solve.seconds = solve.cpu_seconds = 0.001 * solve.run;
  }
  const auto tied = findings(study_of(solves), {}, Unit::run);
  const Finding& accuracy = finding_of(tied, "Accuracy: IK-BA < K-ABC < DE < MO-PSO < PSO < BA");
  CHECK(accuracy.verdict == Verdict::undecided);
  CHECK(contains(accuracy.evidence, "0 of 15 pairs stand in the printed order, 15 are tied; first is IK-BA, "));
  CHECK(contains(accuracy.evidence, ", which share the place."));
  CHECK(!contains(accuracy.evidence, "as printed"));
  CHECK(verdict_of(tied, "Computing time") == Verdict::undecided);
  CHECK(verdict_of(tied, "is the most accurate") == Verdict::undecided);
  CHECK(verdict_of(tied, "less than the other solvers") == Verdict::undecided);
  CHECK(verdict_of(tied, "The solvers differ") == Verdict::does_not_hold);
}

TEST_CASE("findings are judged on the printed numbers too, by Games and Howell's test", "[report]") {
  const auto all = findings(study_of(synthetic::solves({})), {}, Unit::run);
  const auto printed = [&](const char* claim) { return finding_of(all, claim).printed; };
  CHECK(printed("is the most accurate") == Verdict::holds);
  CHECK(printed("Accuracy: IK-BA") == Verdict::in_part);     // MO-PSO, PSO and DE cannot be told apart
  CHECK(printed("less than MO-PSO") == Verdict::undecided);  // 87.1916 and 89.9602 deg, std 7.8 and 25.7: p = 0.997
  CHECK(contains(finding_of(all, "less than MO-PSO").evidence, "MO-PSO 90 (p = 0.997)"));
  CHECK(printed("less than the other solvers") == Verdict::holds);
  CHECK(printed("Computing time: PSO < IK-BA") == Verdict::in_part);  // PSO and IK-BA differ, DE and K-ABC do not
  CHECK(printed("The solvers differ") == Verdict::holds);
  CHECK(!printed("inside the joint limits"));
  CHECK(tally(all) == "Of 7 findings 6 hold here; 1 cannot be decided. On the printed numbers 3 of 6 hold.");
}

TEST_CASE("an order that most pairs keep holds in part", "[report]") {
  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) {
    if (solve.solver == "PSO") solve.seconds *= 1.25;  // from the first place to the second
  }
  CHECK(verdict_of(findings(study_of(solves), {}, Unit::run), "Computing time") == Verdict::in_part);
  for (SolveRecord& solve : solves) solve.seconds = solve.cpu_seconds = 0.02 - solve.seconds;
  CHECK(verdict_of(findings(study_of(solves), {}, Unit::run), "Computing time") == Verdict::does_not_hold);
}

TEST_CASE("companions say what is left with limits enforced and against a classical solver", "[report]") {
  const StudyResults study = study_of(synthetic::solves({}), "s");
  StudyResults limits = study_of(synthetic::solves({}), "s-limits");
  limits.definition = R"({"limits": "enforced"})";
  limits.solves[0].status = Status::refused;  // of IK-BA
  StudyResults context = make_study("s-context", synthetic::solves({.solvers = {"DLS"}}));
  for (SolveRecord& solve : context.solves) {
    solve.position_error_cm *= 1e-4;
    solve.variation_deg /= 2;
    solve.evaluations = 11;
  }
  auto all = findings(study, {limits, context}, Unit::run);
  CHECK(verdict_of(all, "enforced IK-BA stays the most accurate") == Verdict::holds);
  CHECK(contains(finding_of(all, "enforced").evidence, "IK-BA 1 of 400, BA 0 of 400"));
  CHECK(verdict_of(all, "classical") == Verdict::does_not_hold);
  CHECK(contains(finding_of(all, "classical").evidence, "against 11 evaluations"));

  for (SolveRecord& solve : context.solves) solve.evaluations = 20000;
  for (SolveRecord& solve : limits.solves) solve.position_error_cm *= solve.solver == "IK-BA" ? 1000 : 1;
  all = findings(study, {limits, context}, Unit::run);
  CHECK(verdict_of(all, "enforced") == Verdict::does_not_hold);
  CHECK(verdict_of(all, "classical") == Verdict::in_part);
  CHECK(findings(study, {}, Unit::run).size() + 2 == all.size());
}

TEST_CASE("a circle is led to rounding error where its errors are of the order of rounding", "[report]") {
  StudyResults circle = study_of(synthetic::solves({.solvers = {"IK-BA", "BA"}, .runs = 1}));
  circle.definition = R"({"path": {"kind": "circle"}})";
  const auto verdict = [&](double first, double second) {
    for (SolveRecord& solve : circle.solves) solve.position_error_cm = solve.solver == "IK-BA" ? first : second;
    return verdict_of(findings(circle, {}, Unit::run), "Dobot");
  };
  // The targets are 60 to 100 cm away, so that rounding is some 2e-14 cm.
  CHECK(verdict(3e-14, 1) == Verdict::holds);  // the second solver is of no account
  CHECK(verdict(3e-12, 0) == Verdict::does_not_hold);
}

TEST_CASE("real time is judged by the slowest target, and only where all are reached it holds", "[report]") {
  StudyResults study = study_of(synthetic::solves({.runs = 2}));
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"12 bats"}, .runs = 1});
  const auto verdict = [&] {
    StudyResults companion = study_of(solves, "s-time");
    companion.definition = R"({"stop": {"tolerance_cm": 0.1}})";
    return verdict_of(findings(study, {companion}, Unit::run), "real time");
  };
  CHECK(verdict() == Verdict::holds);
  solves[3].position_error_cm = 0.2;
  CHECK(verdict() == Verdict::in_part);
  solves[4].seconds = solves[4].cpu_seconds = 0.06;  // 60 ms
  CHECK(verdict() == Verdict::does_not_hold);
}

TEST_CASE("a page has both verdicts of a finding, or the one that there is", "[report]") {
  ReportContent content{.study = "s", .title = "t"};
  content.findings = {
      {.claim = "<a>", .verdict = Verdict::holds, .evidence = "e", .table = "", .printed = Verdict::undecided},
      {.claim = "b", .verdict = Verdict::does_not_hold, .evidence = "e", .table = ""}};
  const std::string page = to_html(content, {});
  CHECK(contains(page, "here: holds</span> <span class=\"badge undecided\">printed: undecided</span>"));
  CHECK(contains(page, "here: does not hold</span></span>"));
  const std::string text = to_markdown(content);
  CHECK(contains(text, "| &lt;a&gt; | holds | undecided | e |"));
  CHECK(contains(text, "| b | does not hold |  | e |"));
}

TEST_CASE("the moving arm has the first run, in few digits, and no way out of its element", "[report]") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"</script><b>", "DE"}, .runs = 2, .points = 3});
  const std::size_t joints = solves.front().answer_rad.size();
  const nlohmann::json link{{"a_m", 0.1}, {"alpha_rad", 0}, {"d_m", 0.2}, {"offset_rad", 0}};
  const nlohmann::json arm{{"kind", "denavit_hartenberg"},
                           {"links", std::vector(joints, link)},
                           {"tip_m", {0, 0, 0}},
                           {"lower_deg", std::vector(joints, -170)},
                           {"upper_deg", std::vector(joints, 170)}};
  const auto entry_of = [](const nlohmann::json& of) {
    return StudyEntry{.name = "s", .definition = nlohmann::json{{"arm", of}}.dump(), .series = {}};
  };
  const StudyEntry entry = entry_of(arm);
  solves[1].start_rad = solves[0].answer_rad;
  solves[2].answer_rad[0] = not_defined;
  const auto text = moving_arm(entry, make_study("s", solves));
  REQUIRE(text);
  CHECK(!contains(*text, "<"));
  const auto json = nlohmann::json::parse(*text);
  REQUIRE(json["solvers"].size() == 2);
  const auto& first = json["solvers"][0];
  CHECK(first["name"] == "</script><b>");
  CHECK(first["run"] == 1);
  REQUIRE(first["steps"].size() == 3);
  CHECK(first["steps"][0].contains("start"));
  CHECK(!first["steps"][1].contains("start"));  // where the answer before left the arm
  CHECK(first["steps"][2]["answer"][0].is_null());
  CHECK(first["steps"][0]["answer"][1].get<double>() == Approx(solves[0].answer_rad[1]).margin(5.1e-6));

  CHECK(!moving_arm({.name = "s", .definition = "{}", .series = {}}, make_study("s", solves)));
  CHECK(!moving_arm({.name = "s", .definition = "no JSON", .series = {}}, make_study("s", solves)));
  CHECK(!moving_arm(entry, make_study("s", std::vector<SolveRecord>{})));

  // A foreign store may say anything of its arm; the page draws none that it does not know to the last joint.
  for (const char* change :
       {R"({"kind": "__proto__"})", R"({"kind": "dobot_magician"})", R"({"links": []})", R"({"links": "x"})",
        R"({"links": [0, 0]})", R"({"tip_m": null})", R"({"upper_deg": [1]})", R"({"lower_deg": [1e300]})"}) {
    CAPTURE(change);
    nlohmann::json other = arm;
    other.merge_patch(nlohmann::json::parse(change));
    CHECK(!moving_arm(entry_of(other), make_study("s", solves)));
  }
  solves[1].answer_rad.push_back(0);
  CHECK(!moving_arm(entry, make_study("s", solves)));
}

TEST_CASE("the moving arm has the joint limits violated where the store has them so, and nowhere else", "[report]") {
  constexpr double degree = std::numbers::pi / 180, limit = 170 * degree;
  const nlohmann::json link{{"a_m", 0.1}, {"alpha_rad", 0}, {"d_m", 0.2}, {"offset_rad", 0}};
  const nlohmann::json arm{{"kind", "denavit_hartenberg"},
                           {"links", std::vector(2, link)},
                           {"tip_m", {0, 0, 0}},
                           {"lower_deg", std::vector(2, -170)},
                           {"upper_deg", std::vector(2, 170)}};
  struct Answer {
    double first, second;     // [rad]
    double recorded_deg = 0;  // by the verifier: the worst joint, and 0 up to 1e-9 rad
    std::vector<int> joints = {};
  };
  const std::vector<Answer> answers{
      {.first = limit, .second = -limit},  // 2.967059..., which five digits make 2.96706: beyond
      {.first = limit + 0.9e-9, .second = 0},
      {.first = 0, .second = limit + 1e-6, .recorded_deg = 1e-6 / degree, .joints = {1}},
      {.first = limit, .second = -3, .recorded_deg = 3 / degree - 170, .joints = {1}},
      {.first = -limit - 0.1, .second = limit + 0.2, .recorded_deg = 0.2 / degree, .joints = {0, 1}},
      {.first = not_defined, .second = 3, .recorded_deg = not_defined}};
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"A"}, .runs = 1, .points = 6});
  for (std::size_t i = 0; i < answers.size(); ++i) {
    solves[i].answer_rad = {answers[i].first, answers[i].second};
    solves[i].start_rad = {0, 0};
    solves[i].limit_violation_deg = answers[i].recorded_deg;
  }
  const StudyEntry entry{.name = "s", .definition = nlohmann::json{{"arm", arm}}.dump(), .series = {}};
  const auto text = moving_arm(entry, make_study("s", solves));
  REQUIRE(text);
  const auto steps = nlohmann::json::parse(*text)["solvers"][0]["steps"];
  REQUIRE(steps.size() == answers.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    CAPTURE(i);
    std::vector<int> joints;
    double worst_deg = 0;
    for (const auto& outside : steps[i]["outside"]) {
      joints.push_back(outside["joint"]);
      worst_deg = std::max(worst_deg, outside["by"].get<double>());
    }
    CHECK(joints == answers[i].joints);
    if (std::isfinite(answers[i].recorded_deg)) CHECK(worst_deg == Approx(answers[i].recorded_deg).margin(1e-12));
  }
}

TEST_CASE("a page says why it has no moving arm, and a picture too large for it is a link", "[report]") {
  const TestFolder folder;
  {
    std::ofstream stream(folder.path() / "figure-6.svg");
    stream << "<svg><path d='" << std::string(500'000, ' ') << "'/></svg>";
  }
  ReportContent content{.study = "{{{x}}}", .title = "<i>&"};
  arrange({ReportFigure{{"figure-6", "caption"}, true}}, {}, content);
  const std::string page = to_html(content, {.figures = folder.path(), .motion = "{}"});
  CHECK(contains(page, "libjs-three"));
  CHECK(contains(page, "<a href=\"figures/figure-6.svg\">figures/figure-6.svg</a>"));
  CHECK(contains(page, "<h1>&lt;i&gt;&amp;</h1>"));
  CHECK(contains(page, "<strong>{{{x}}}</strong>"));
  CHECK(!contains(page, "http:"));
  CHECK(!contains(page, "https:"));
  CHECK(page.size() < 50'000);
}
