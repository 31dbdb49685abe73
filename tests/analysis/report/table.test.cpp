#include "analysis/report/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::report;

namespace {

Table small_table() {
  return {.name = "small",
          .caption = "A <small> table",
          .columns = {"solver", "error_cm", "p", "n", "empty"},
          .rows = {{std::string("a|b"), 0.00019123456789, PValue{1e-310}, std::int64_t{20}, {}},
                   {std::string("[c] & d"), NAN, PValue{NAN}, std::int64_t{-3}, {}}},
          .notes = {"100 % of it"}};
}

}  // namespace

TEST_CASE("Markdown has five digits, words for what is not defined, and no empty column", "[table]") {
  CHECK(to_markdown(small_table()) ==
        "**A &lt;small&gt; table**\n\n"
        "| solver | error \\[cm\\] | p | n |\n"
        "| :--- | ---: | ---: | ---: |\n"
        "| a&#124;b | 0.00019123 | &lt; 1e-300 | 20 |\n"
        "| \\[c\\] &amp; d | not defined | not defined | -3 |\n"
        "\n100 % of it\n");
}

TEST_CASE("CSV has every digit, every column, and an empty field for what is not defined", "[table]") {
  CHECK(to_csv(small_table()) ==
        "solver,error_cm,p,n,empty\n"
        "a|b,0.00019123456789,1e-310,20,\n"
        "[c] & d,,,-3,\n");
}

TEST_CASE("LaTeX has booktabs rules, names its packages and escapes every special character", "[table]") {
  const std::string text = to_latex(small_table());
  CHECK(text.find("% Needs \\usepackage{booktabs,array,adjustbox}\n\\begin{table}\n") == 0);
  CHECK(text.find("\\caption{A \\textless{}small\\textgreater{} table}\\label{tab:small}") != std::string::npos);
  CHECK(text.find("\\begin{tabular}{lrrr}\n\\toprule\nsolver & error {[}cm{]} & p & n \\\\\n\\midrule\n") !=
        std::string::npos);
  CHECK(text.find("a\\textbar{}b & 0.00019123 & $<10^{-300}$ & 20 \\\\\n") != std::string::npos);
  CHECK(text.find("{[}c{]} \\& d & not defined & not defined & $-3$ \\\\\n") != std::string::npos);
  CHECK(text.find("100 \\% of it") > text.find("\\end{tabular}"));
}

TEST_CASE("LaTeX sets numbers alone as mathematics, not the words of an interval", "[table]") {
  const Table table{.name = "t",
                    .caption = "t",
                    .columns = {"x"},
                    .rows = {{Range{-0.395, -0.108}}, {Range{-2e-9, 3}}, {Range{0, 1}}}};
  const std::string text = to_latex(table);
  CHECK(text.find("\n$-0.395$ to $-0.108$ \\\\\n") != std::string::npos);
  CHECK(text.find("\n$-2 \\times 10^{-9}$ to 3 \\\\\n") != std::string::npos);
  CHECK(text.find("\n0 to 1 \\\\\n") != std::string::npos);
}

TEST_CASE("LaTeX scales a table to its column, and has its notes below", "[table]") {
  const Table table{.name = "t", .caption = "t", .columns = {"x"}, .rows = {{std::int64_t{1}}}, .notes = {"a note"}};
  const std::string text = to_latex(table);
  CHECK(contains(text, "\\begin{adjustbox}{max width=\\columnwidth"));
  CHECK(text.find("a note") > text.rfind("\\end{adjustbox}"));
}

TEST_CASE("an interval is one column to read and two to compute with", "[table]") {
  const Table table{.name = "t",
                    .caption = "c",
                    .columns = {"x", "interval"},
                    .rows = {{std::string("a"), Range{0.123456, 2}}, {std::string("b"), Cell()}}};
  CHECK(readable(table.rows[0][1]) == "0.123 to 2");
  CHECK(to_csv(table) == "x,interval low,interval high\na,0.123456,2\nb,,\n");
}

TEST_CASE("LaTeX writes powers of ten as such", "[table]") {
  const Table table{.name = "t", .caption = "t", .columns = {"x"}, .rows = {{7.2225e-24}, {1.0877e8}}};
  CHECK(to_latex(table).find("$7.2225 \\times 10^{-24}$") != std::string::npos);
  CHECK(to_latex(table).find("$1.0877 \\times 10^{8}$") != std::string::npos);
}

TEST_CASE("people read names of quantities, programs read ids", "[table]") {
  const Table table{.name = "t",
                    .caption = "t",
                    .columns = {"metric", "variation_deg", "holds_percent", "not_solved"},
                    .rows = {{Id{"position_error_cm"}, 1.5, 20.0, std::int64_t{0}}}};
  CHECK(readable_cells(table) ==
        std::vector<std::vector<std::string>>{{"metric", "angles variation [deg]", "holds [%]", "not solved"},
                                              {"position error [cm]", "1.5", "20", "0"}});
  CHECK(to_csv(table) == "metric,variation_deg,holds_percent,not_solved\nposition_error_cm,1.5,20,0\n");
  CHECK(to_latex(table).find('_') == std::string::npos);
}

TEST_CASE("short times are in milliseconds, but for CSV, in one unit for a table", "[table]") {
  Table table{.name = "t",
              .caption = "t",
              .columns = {"metric", "mean", "seconds", "ert"},
              .rows = {{Id{"seconds"}, 0.002, 0.001, Range{0.001, 0.01}}, {Id{"evaluations"}, 7.0, 0.05, Cell()}},
              .times = {"ert"}};
  CHECK(readable_cells(table) ==
        std::vector<std::vector<std::string>>{{"metric", "mean", "computing time [ms]", "ert [ms]"},
                                              {"computing time [ms]", "2", "1", "1 to 10"},
                                              {"evaluations", "7", "50", ""}});
  CHECK(to_csv(table) ==
        "metric,mean,seconds,ert low,ert high\nseconds,0.002,0.001,0.001,0.01\nevaluations,7,0.05,,\n");
  table.rows[1][2] = 0.1;
  CHECK(readable_cells(table)[1] == std::vector<std::string>{"computing time [s]", "0.002", "0.001", "0.001 to 0.01"});
  table.rows[1][2] = OursAndPrinted{0.001, "0.02"};  // its digits stay
  CHECK(readable_cells(table)[0][2] == "computing time [s]");
}
