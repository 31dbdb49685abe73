#include "analysis/tiny/paper.hpp"

#include <fmt/format.h>

#include "analysis/inference/ranking.hpp"
#include "analysis/report/summary.hpp"
#include "results/published.hpp"

namespace ikbench::tiny {

using namespace results;
using namespace inference;
using namespace report;

namespace {

Claim fewest_evaluations(const Reported& reported) {
  const auto order = standings(reported.study, Metric::evaluations);
  const bool is_first = first_of(order) == std::vector<std::string>{"alpha"};
  return {.statement = "Alpha needs the fewest evaluations",
          .verdict = is_first ? Verdict::holds : Verdict::fails,
          .evidence = fmt::format("In the order of their means: {}.", order_words(order)),
          .table = "table-1",
          .printed = Verdict::holds};
}

std::vector<Claim> claims(const Reported& reported) { return {fewest_evaluations(reported)}; }

Table printed_table() {
  const CsvTable printed = published::table("tiny", "table-1");
  Table table{.name = "table-1",
              .caption = "Table 1 as printed",
              .columns = {{"algorithm", Align::left}, {"evaluations"}},
              .rows = {}};
  for (std::size_t row = 0; row < printed.rows.size(); ++row)
    table.rows.push_back({printed.rows[row][printed.column("algorithm")], printed.number(row, "evaluations")});
  return table;
}

figures::Figure evaluations_figure(const Reported& reported) {
  figures::Figure figure{.name = "figure-1",
                         .caption = "Mean evaluations of each solver, fewest first.",
                         .settings = "set xlabel 'place'\nset ylabel 'evaluations'\n",
                         .plot = "plot 'figure-1.dat' using 0:1 with linespoints notitle"};
  for (const Standing& standing : standings(reported.study, Metric::evaluations))
    figure.data += fmt::format("{}\n", standing.mean);
  return figure;
}

StudyPieces pieces(const Reported& reported) {
  StudyPieces all = study_pieces(reported.study);
  all.tables.push_back(printed_table());
  all.figures.push_back(evaluations_figure(reported));
  return all;
}

}  // namespace

Paper paper() {
  return {.name = "tiny",
          .studies = {{"tiny", {"seed"}}},
          .claims = claims,
          .pieces = pieces,
          .sections = {.further = {{"What is printed", "", {"table-1", "figure-1"}}}}};
}

}  // namespace ikbench::tiny
