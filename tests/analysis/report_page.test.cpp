// What report.html is made of: pictures, findings, the arm's data, the policy, the order of pieces.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/descriptive.hpp"
#include "analysis/moving_arm.hpp"
#include "analysis/report_content.hpp"
#include "analysis/report_findings.hpp"
#include "analysis/report_html.hpp"
#include "analysis/report_svg.hpp"
#include "analysis/sha256.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;

namespace {

bool contains(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

StudyResults study_of(std::vector<SolveRecord> solves, const std::string& name = "s") {
  StudyResults study = make_study(name, std::move(solves));
  study.published = "slim2023";
  return study;
}

Verdict verdict_of(const std::vector<Finding>& findings, const std::string& claim) {
  const auto found = std::ranges::find_if(findings, [&](const Finding& f) { return contains(f.claim, claim); });
  REQUIRE(found != findings.end());
  return found->verdict;
}

}  // namespace

TEST_CASE("SHA-256 gives the digests of FIPS 180-4's examples", "[report]") {
  // NIST, "Examples with Intermediate Values": the digests of no byte, of abc and of the message of 448 bits, in
  // base64.
  CHECK(sha256_in_base64("") == "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
  CHECK(sha256_in_base64("abc") == "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
  CHECK(sha256_in_base64("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "JI1qYdIGOLjlwCaTDD5gOaM85Flk/yFn9uzt1BnbBsE=");
}

TEST_CASE("a picture goes into a page without scripts, links, styles and events", "[report]") {
  const auto svg = inline_svg(
      "<?xml version='1.0'?><!DOCTYPE svg><svg viewBox='0 0 9 9' onload='alert(1)' style='x'><title>t</title>"
      "<script>alert(2)</script><!-- > --><style>@import 'x';</style><a "
      "xlink:href='javascript:alert(3)'><text>no</text></a>"
      "<foreignObject><body onload='x'/></foreignObject><image xlink:href='http://x/y.png'/><defs><path id='p' "
      "d='M0,0'/></defs>"
      "<rect fill='#ffffff'/><use xlink:href='#p'/><use xlink:href='http://x/y.svg#p'/><rect clip-path='url(#c)' "
      "fill='url(http://x)' width='2'/><g fill='none'>\n</g><text color='rgb(  1,  2, 3)'>a "
      "&lt;script&gt;</text></svg>",
      "f-");
  REQUIRE(svg);
  CHECK(*svg ==
        "<svg viewBox=\"0 0 9 9\"><defs><path id=\"f-p\" d=\"M0,0\"/></defs><use href=\"#f-p\"/><use/><rect "
        "clip-path=\"url(#f-c)\" width=\"2\"/><text color=\"rgb(1,2,3)\">a &lt;script&gt;</text></svg>");
}

TEST_CASE("what is no whole SVG is not shown", "[report]") {
  for (const char* text : {"", "text", "<svg", "<svg>", "<svg><g>", "<svg><g></svg></g>", "<svg x></svg>",
                           "<svg x='></svg>", "<svg><!--</svg>", "</svg>", "<p><svg/></p>"}) {
    CAPTURE(text);
    CHECK(!inline_svg(text, "f-"));
  }
}

TEST_CASE("pieces come in the paper's order, and none is lost", "[report]") {
  ReportContent content;
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

TEST_CASE("a page says why it has no moving arm, and a picture too large for it is a link", "[report]") {
  const TestFolder folder;
  {
    std::ofstream stream(folder.path() / "figure-6.svg");
    stream << "<svg><path d='" << std::string(500'000, ' ') << "'/></svg>";
  }
  ReportContent content{.study = "{{{x}}}", .title = "<i>&"};
  arrange({ReportFigure{{"figure-6", "caption"}, true}}, content);
  const std::string page = to_html(content, {.figures = folder.path(), .motion = "{}"});
  CHECK(contains(page, "libjs-three"));
  CHECK(contains(page, "<a href=\"figures/figure-6.svg\">figures/figure-6.svg</a>"));
  CHECK(contains(page, "<h1>&lt;i&gt;&amp;</h1>"));
  CHECK(contains(page, "<strong>{{{x}}}</strong>"));
  CHECK(!contains(page, "http:"));
  CHECK(!contains(page, "https:"));
  CHECK(page.size() < 50'000);
}
