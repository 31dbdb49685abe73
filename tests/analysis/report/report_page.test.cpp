// The parts of report.html: pictures, claims, the arm's data, the policy, the order of pieces.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "analysis/inference/make_study.hpp"
#include "analysis/report/moving_arm.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {  // An arm of equal joints that turn by 170 deg to either side, as a store has it.
nlohmann::json chain_of(std::size_t joints) {
  const nlohmann::json link{
      {"offset_deg", 0}, {"d_m", 0.2}, {"a_m", 0.1}, {"alpha_deg", 0}, {"limits_deg", {-170, 170}}};
  const nlohmann::json still{{"position_m", {0, 0, 0}}, {"rpy_deg", {0, 0, 0}}};
  return {{"links", std::vector(joints, link)}, {"base", still}, {"tool", still}};
}

}  // namespace

TEST_CASE("a figure is an image within the page, whose bytes are those of its file", "[report]") {
  const ScratchFolder folder;
  const std::string svg = "<svg onload='alert(1)'><script>alert(2)</script><text>\"></text></svg>";
  std::filesystem::create_directory(folder.path / "figures");
  std::ofstream(folder.path / "figures" / "figure-6.svg") << svg;
  ReportContent content;
  arrange({ReportFigure{{"figure-6", "of <b> and \" onload=\"alert(3)"}, {"svg"}}}, content);
  const std::string page = to_html(content, folder.path);
  CHECK(contains(page,
                 "src=\"data:image/svg+xml;base64,PHN2ZyBvbmxvYWQ9J2FsZXJ0KDEpJz48c2NyaXB0PmFsZXJ0KDIpPC9zY3JpcHQ+PHRl"
                 "eHQ+Ij48L3RleHQ+PC9zdmc+\">"));
  CHECK(contains(page, "of &lt;b&gt; and &quot; onload=&quot;alert(3)\" src="));
  CHECK(contains(page, "img-src data:"));
  CHECK(!contains(page, svg));
}

TEST_CASE("a figure that was not drawn has no card beside the verdict", "[report]") {
  const ScratchFolder folder;
  for (const bool is_drawn : {false, true}) {
    ReportContent content;
    content.plan.results = {{"Results", "", {"overview"}}};
    ReportFigure figure{{"overview", "of all"}};
    if (is_drawn) figure.types = {"pdf"};
    arrange({figure}, content);
    CHECK(contains(to_html(content, folder.path), "<figure id=") == is_drawn);
  }
}

TEST_CASE("pieces come in the order of their sections, and none is lost", "[report]") {
  ReportContent content;
  content.plan = {.results = {{"Results", "", {"figure-5", "unknown|table-3|status"}, {"figure-9-*"}}},
                  .further = {{"Computing time", "", {"table-7"}}}};
  std::vector<Piece> pieces;
  for (const char* name : {"unheard-of", "table-7", "status", "table-3"}) pieces.emplace_back(Table{name, "caption"});
  for (const char* name : {"figure-9-a", "figure-9-b", "figure-5"})
    pieces.emplace_back(ReportFigure{{name, "caption"}});
  arrange(std::move(pieces), content);
  std::string order;
  for (const auto* part : {&content.circumstances, &content.results}) {
    for (const Section& section : *part) {
      order += section.heading + ':';
      for (const Piece& piece : section.pieces) order += ' ' + name_of(piece);
      for (const Piece& piece : section.folded) order += " (" + name_of(piece) + ')';
      order += '\n';
    }
  }
  CHECK(order ==
        "Outcome of every solve: (status)\nResults: figure-5 table-3 (figure-9-a) (figure-9-b)\nComputing time: "
        "table-7\nFurther: (unheard-of)\n");
}

TEST_CASE("a page has both verdicts of a claim, or the one that there is", "[report]") {
  ReportContent content{.study = "s", .title = "t"};
  content.claims = {
      {.statement = "<a>", .verdict = Verdict::holds, .evidence = {"e"}, .table = "", .printed = Verdict::undecided},
      {.statement = "b", .verdict = Verdict::fails, .evidence = {"e"}, .table = ""}};
  const std::string page = to_html(content, {});
  CHECK(contains(
      page,
      "<span class=\"claim\">&lt;a&gt;</span><span class=\"word holds\">holds</span><span class=\"word undecided\">undecided</span>"));
  CHECK(contains(page, "<span class=\"word fails\">fails</span><span class=\"word \"></span>"));
  const std::string text = to_markdown(content);
  CHECK(contains(text, "| &lt;a&gt; | holds | undecided |  | e |"));
  CHECK(contains(text, "| b | fails |  |  | e |"));
}

TEST_CASE("a page tells the number of a claim, and keeps our own questions apart", "[report]") {
  ReportContent content{.study = "s", .title = "t"};
  content.claims = {
      {.statement = "ours", .verdict = Verdict::holds, .evidence = {"e"}, .table = "", .by = Claimant::us},
      {.statement = "theirs", .verdict = Verdict::depends, .evidence = {"e"}, .table = "", .section = "Fig. <6>"}};
  content.claims.back().number = "11 of 20";
  content.claims.back().depends_on = {"who <obeys>"};
  const std::string page = to_html(content, {});
  CHECK(contains(page, "<span class=\"word depends\">depends on who &lt;obeys&gt;</span>"));
  CHECK(contains(page, "<span class=\"number\">11 of 20</span>"));
  CHECK(contains(page, "Stated in: Fig. &lt;6&gt;. e"));
  CHECK(page.find(">theirs<") < page.find("Our own questions"));
  CHECK(page.find("Our own questions") < page.find(">ours<"));
  CHECK(contains(page, "Of 1 claim, "));
}

TEST_CASE("the moving arm has the first run, in few digits, and no way out of its element", "[report]") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"</script><b>", "DE"}, .runs = 2, .points = 3});
  const std::size_t joints = solves.front().answer_rad.size();
  const nlohmann::json arm = chain_of(joints);
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
  for (const char* change : {R"({"links": []})", R"({"links": "x"})", R"({"links": [0, 0]})", R"({"tool": null})",
                             R"({"tool": {"rpy_deg": [1]}})", R"({"base": {"position_m": [1e300, 0, 0]}})"}) {
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
  const nlohmann::json arm = chain_of(2);
  struct Relation {
    double first, second;     // [rad]
    double recorded_deg = 0;  // by the verifier: the worst joint, and 0 up to 1e-9 rad
    std::vector<int> joints = {};
  };
  const std::vector<Relation> answers{
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
  const ScratchFolder folder;
  {
    std::filesystem::create_directory(folder.path / "figures");
    std::ofstream stream(folder.path / "figures" / "figure-6.svg");
    stream << "<svg><path d='" << std::string(500'000, ' ') << "'/></svg>";
  }
  ReportContent content{.study = "{{{x}}}", .title = "<i>&"};
  content.motion = "{}";
  content.plan.results = {{"Results", "", {"figure-6"}}};
  arrange({ReportFigure{{"figure-6", "caption"}, {"svg"}}}, content);
  const std::string page = to_html(content, folder.path);
  CHECK(contains(page, "libjs-three") == !drawing_library());
  CHECK(contains(page, "<a href=\"figures/figure-6.svg\">figures/figure-6.svg</a>"));
  CHECK(contains(page, "<h1>&lt;i&gt;&amp;</h1>"));
  CHECK(contains(page, "<strong>{{{x}}}</strong>"));
  CHECK(!contains(page.substr(0, page.find("<script")), "http:"));
  CHECK(!contains(page.substr(0, page.find("<script")), "https:"));
  CHECK(page.size() < 50'000 + drawing_library().value_or("").size());
}
