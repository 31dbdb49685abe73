#include "tests/show/judged.hpp"

namespace {

const std::string hostile =
    "a|b <script>alert(1)</script> \\input{x} & % _ ~ \x1b[31m red \n | *new* \xff " + std::string(300, 'x');

Table with_label(const std::string& label) {
  return {.name = "results",
          .caption = label,
          .columns = {{"solver"},
                      {.name = "error", .unit = "mm"},
                      {.name = "interval", .role = ColumnRole::interval},
                      {.name = "p", .role = ColumnRole::p},
                      {"n"},
                      {"time"}},
          .rows = {{label, 0.12345678901234567, judge::Interval{1.0 / 3, 2}, 1e-7, std::int64_t{20},
                    ValueCell{4200.25, "*"}},
                   {"plain", PublishedNumber{1.5e-7, "0.0000"}, {}, 0.0005, {}, ValueCell{0.1, "", true}}},
          .notes = {label}};
}

std::ptrdiff_t ends_in(const std::string& text) { return std::ranges::count(text, '\n'); }

}  // namespace

TEST_CASE("a table of numbers has every digit, and any label as it is", "[show]") {
  const std::string text = to_csv(with_label(hostile));
  const base::CsvTable csv = base::parse_csv(text, "test");
  CHECK(csv.header == std::vector<std::string>{"solver", "error [mm]", "error printed [mm]", "low", "high", "excluded",
                                               "p", "n", "time", "time mark"});
  CHECK(csv.cell(0, 0) == hostile);
  CHECK(csv.number(0, "error [mm]") == 0.12345678901234567);
  CHECK(csv.number(0, "low") == 1.0 / 3);
  CHECK(csv.number(0, "p") == 1e-7);
  CHECK(csv.number(0, "time") == 4200.25);
  CHECK(csv.cell(1, 2) == "0.0000");
  CHECK(csv.cell(1, 3).empty());

  const auto json = to_json(with_label(hostile));
  CHECK(json[0]["error"] == 0.12345678901234567);
  CHECK(json[0]["high"] == 2.0);
  CHECK(json[1]["error_printed"] == "0.0000");
  CHECK(json[1]["low"].is_null());

  const Table ends{.columns = {{"a"}, {"b"}, {"c"}}, .rows = {{-infinity, infinity, std::nan("")}}};
  CHECK(to_json(ends).dump() == R"([{"a":"-Inf","b":"Inf","c":null}])");
  CHECK(to_csv(ends) == "a,b,c\n-Inf,Inf,\n");
}

TEST_CASE("an end that an interval excludes says so in every format, and none is rounded onto what decides", "[show]") {
  Table table{.caption = "pairs",
              .columns = {{.name = "interval", .role = ColumnRole::interval, .boundaries = {1, 1.05}},
                          {.name = "p", .role = ColumnRole::p, .boundaries = {0.05}}},
              .rows = {{judge::Interval{0, 0.8, true}, 0.04998},
                       {judge::Interval{0.5, 1, false, true}, 0.05},
                       {judge::Interval{1.00002, 1.0499}, Cell()},
                       {Cell(), Cell()}}};
  for (const auto& text : {to_text(table), to_markdown(table), to_html(table), to_latex(table)}) {
    for (const char* words : {"above 0 to 0.8", "0.5 to below 1", "above 1 to below 1.05"}) {
      INFO(words);
      CHECK(contains(text, words));
    }
  }
  table.columns.pop_back();
  for (auto& row : table.rows) row.pop_back();
  table.rows.erase(table.rows.begin() + 2);
  CHECK(to_csv(table) == "low,high,excluded\n0.0,0.8,low\n0.5,1.0,high\n,,\n");
  CHECK(to_json(table)[0]["excluded"] == "low");
  CHECK(to_json(table)[2]["excluded"].is_null());
}

TEST_CASE("readers see three digits, units, marks and small p-values", "[show]") {
  CHECK(to_text(with_label("mine")) ==
        "solver   error        paper    interval     p          n    time\n"
        "mine     0.123 mm     -        0.333 to 2   < 0.0001   20   4200 *\n"
        "plain    1.5e-07 mm   0.0000   -            0.0005     -    ≤ 0.1\n"
        "mine\n");
  const std::string latex = to_latex(with_label("mine"));
  CHECK(contains(latex,
                 "mine & 0.123 & - & 0.333 to 2 & \\textless{} 0.0001 & 20 & 4200\\rlap{\\,\\scriptsize {*}} \\\\"));
  CHECK(contains(latex, "plain & $1.5 \\times 10^{-7}$ & 0.0000 & - & 0.0005 & - & $\\le$ 0.1 \\\\"));
  CHECK(number_text(3715.4) == "3715");
  CHECK(number_within(99.97, {0, 100}) == "< 100");
  CHECK(p_text(0.04998, {0.05}) == "< 0.05");
}

TEST_CASE("what stands in place of a number has its own column in files of numbers", "[show]") {
  const Table table{
      .name = "results",
      .caption = "Results",
      .columns = {{"solver"}, {"solved", "%"}, {"motion", "deg"}},
      .rows = {{"A", ValueCell{.value = 100, .interval = judge::Interval{96.3, 100}}, 339.0},
               {"B", ValueCell{.value = 0.5, .mark = "*", .interval = judge::Interval{0.1, 1.25}},
                ValueCell{.value = 1.634, .mark = "*", .relative_to_reference = judge::EffectScale::ratio}},
               {"C", {}, ValueCell{.value = 1.0312, .relative_to_reference = judge::EffectScale::ratio}},
               {"D", {}, ValueCell{.value = -20, .relative_to_reference = judge::EffectScale::difference}}}};
  CHECK(to_csv(table) ==
        "solver,solved [%],solved low [%],solved high [%],solved mark,"
        "motion [deg],motion times,motion difference [deg],motion mark\n"
        "A,100.0,96.3,100.0,,339.0,,,\n"
        "B,0.5,0.1,1.25,*,,1.634,,*\n"
        "C,,,,,,1.0312,,\n"
        "D,,,,,,,-20.0,\n");
  CHECK(to_json(table)[1]["motion_times"] == 1.634);
  CHECK(to_text(table) ==
        "solver   solved               motion\n"
        "A        100 % (96-100)       339 deg\n"
        "B        0.5 % (0.1-1.25) *   1.6x *\n"
        "C        -                    1.03x\n"
        "D        -                    -20 deg\n");
  CHECK(
      to_latex(table).find(
          "A & 100 & {\\scriptsize (96--100)} & 339 deg \\\\\nB & 0.5 & {\\scriptsize (0.1--1.25)}\\rlap{\\,\\scriptsize {*}} & 1.6x\\rlap{\\,\\scriptsize {*}} \\\\") !=
      std::string::npos);
  CHECK(contains(to_latex(table), "\\multicolumn{2}{c@{\\hspace{14pt}}}{solved {[}\\%{]}}"));
  CHECK(contains(to_latex(table), "\\caption{\\textnormal{Results}}"));
}

TEST_CASE("ours has the decimals of the printed, and is not rounded onto all", "[show]") {
  const Table table{.columns = {{.name = "solved", .unit = "%", .boundaries = {0, 100}}},
                    .rows = {{PublishedNumber{99.96, "99.99"}},
                             {PublishedNumber{99.996, "99.99"}},
                             {PublishedNumber{0.1234567, "0.12"}},
                             {PublishedNumber{0, "0"}},
                             {PublishedNumber{100, "100.00"}}}};
  const std::string text = to_text(table);
  for (const char* ours : {"99.96 %", "< 100 %", "0.123 %", "\n0 %", "\n100 %"}) CHECK(contains(text, ours));
}

TEST_CASE("LaTeX has quotes that open, minus signs and powers", "[show]") {
  CHECK(latex_text("'a' of TRAC-IK's (-3.5 to 2e-06), a-1") == "`a' of TRAC-IK's ($-$3.5 to $2 \\times 10^{-6}$), a-1");
}

TEST_CASE("a name with a comma stands between semicolons", "[show]") {
  CHECK(listed({"A", "B", "C"}) == "A, B and C");
  CHECK(listed({"A", "B, b", "C"}) == "A; B, b and C");
  CHECK(listed({"A", "B, b", "C"}, ", ") == "A; B, b; C");
}

TEST_CASE("short names stay different, and lose what they share", "[show]") {
  const std::vector<std::string> swept{"DLS", "BFGS (ours) h=1e-07 stall=5", "BFGS (ours) h=0.001 stall=20"};
  CHECK(base::short_names(swept, 24)[swept[0]] == "DLS");
  CHECK(base::short_names(swept, 24)[swept[1]] == "BFGS … h=1e-07 stall=5");
  CHECK(base::short_names(swept, 20)[swept[2]] == "BFGS … h=0.001 stall=20");
  const std::string half(20, 'x');
  auto names = base::short_names({half + "1" + half, half + "2" + half}, 24);
  CHECK(names[half + "1" + half] != names[half + "2" + half]);
}

TEST_CASE("no label breaks a page, Markdown, LaTeX or a screen", "[show]") {
  const Table table = with_label(hostile);
  const std::string html = to_html(table), markdown = to_markdown(table), latex = to_latex(table),
                    screen = to_text(table);
  CHECK(html.find("<script") == std::string::npos);
  for (const std::string& text : {html, markdown, latex, screen}) CHECK(text.find('\x1b') == std::string::npos);
  CHECK(ends_in(screen) <= ends_in(to_text(with_label("mine"))) + 2);  // a head of two lines beside a long label
  CHECK(ends_in(markdown) == ends_in(to_markdown(with_label("mine"))));
  CHECK(ends_in(latex) == ends_in(to_latex(with_label("mine"))));
  CHECK(character_count(screen.substr(0, screen.rfind('\n', screen.size() - 2))) < 3 * 140);  // head and two rows
  const auto pipes = [](const std::string& text) { return std::ranges::count(text, '|'); };
  CHECK(pipes(markdown) == pipes(to_markdown(with_label("mine"))));
  CHECK(markdown.find("<script") == std::string::npos);
  CHECK(latex.find("\\input") == std::string::npos);
  CHECK(contains(to_latex(with_label(std::string(61, 'x'))), "\\raggedright\\let\\\\\\tabularnewline xxx"));
  CHECK(contains(latex, "\\textbackslash{}input\\{x\\} \\& \\% \\_ \\raisebox{-.6ex}{\\textasciitilde}"));
}
