#include "tests/analysis/report/tiny_paper.hpp"

#include "analysis/inference/ranking.hpp"
#include "analysis/report/summary.hpp"

namespace ikbench::tiny {

using namespace inference;
using namespace report;

namespace {

std::vector<Claim> claims(const Reported& reported) {
  const auto order = standings(reported.study, Metric::evaluations);
  return {{.statement = "Alpha needs the fewest evaluations",
           .verdict = first_of(order) == std::vector<std::string>{"alpha"} ? Verdict::holds : Verdict::fails,
           .evidence = "In the order of their means: " + order_words(order) + '.',
           .table = "table-1",
           .printed = Verdict::holds}};
}

StudyPieces pieces(const Reported& reported) {
  StudyPieces all = study_pieces(reported.study);
  all.tables.push_back({.name = "table-1",
                        .caption = "Table 1 as printed",
                        .columns = {{"algorithm", Align::left}, {"evaluations"}},
                        .rows = {{std::string("alpha"), std::int64_t{10}}, {std::string("beta"), std::int64_t{12}}}});
  all.figures.push_back({.name = "figure-1", .caption = "As printed.", .plot = "plot 10, 12", .data = "10 12\n"});
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
