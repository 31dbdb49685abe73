#include "analysis/slim2023/readings.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "analysis/report/report.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::figures;
using namespace ikbench::report;
using namespace ikbench::slim2023;

namespace {

// Table 3 prints for IK-BA: error 0.0019 0.0019 1.7824e-4 0.0022 0.0016, variation 87.1916 87.5779 7.8247 101.8740
// 72.8021 (mean, median, std, max, min); for BA: error 1.6849, variation 301.5794.
ReadSolver solver(const std::string& label, std::vector<std::vector<double>> error_cm, double variation_deg) {
  std::vector<std::vector<double>> variation(error_cm.size(), {variation_deg, variation_deg});
  return {.label = label, .error_cm = std::move(error_cm), .variation_deg = std::move(variation)};
}

std::vector<ReadingResults> two_readings() {
  ReadingResults standard{.name = "default"};
  standard.solvers = {solver("IK-BA", {{0.0016, 0.0022}, {0.0014, 0.0020}}, 87.1916),
                      solver("BA", {{1.6849, 1.6849}, {1.6849, 1.6849}}, 301.5794)};
  ReadingResults other = standard;
  other.name = "IK-BA.step_factor=1";
  other.section = "2.4";
  other.sentence = "Ten times as far.";
  other.solvers[0] = solver("IK-BA", {{0.019, 0.019}, {0.019, 0.019}}, 87.1916);
  other.solvers[1].is_moved = false;
  return {standard, other};
}

std::vector<std::string> row_of(const Table& table, const std::string& reading, const std::string& algorithm) {
  for (const std::vector<std::string>& row : readable_cells(table)) {
    if (row[0] == reading && row[3] == algorithm) return row;
  }
  return {};
}

}  // namespace

TEST_CASE("a reading is scored by the log of our mean by the printed one", "[readings]") {
  const Table table = readings_report("slim2023", two_readings()).table;
  CHECK(table.name == "readings");
  const auto moved = row_of(table, "IK-BA.step_factor=1", "IK-BA");
  REQUIRE(moved.size() == 12);
  CHECK(moved[4] == "0.019");
  CHECK(moved[5] == "1");      // log10(0.019 / 0.0019)
  CHECK(moved[6] == "1.023");  // log10(0.019 / 0.0018): the default's mean is 0.0018
  CHECK(moved[7] == "none");
  CHECK(moved[9] == "0");
}

TEST_CASE("a printed statistic fits where ours over the seeds enclose it", "[readings]") {
  const auto row = row_of(readings_report("slim2023", two_readings()).table, "default", "IK-BA");
  REQUIRE(row.size() == 12);
  // Ours: median 0.0019 and 0.0017, std 4.2e-4 twice, max 0.0022 and 0.0020, min 0.0016 and 0.0014.
  CHECK(row[7] == "median max min");
}

TEST_CASE("an algorithm that a reading does not move has no row, and counts in the row of all", "[readings]") {
  const Table table = readings_report("slim2023", two_readings()).table;
  CHECK(row_of(table, "IK-BA.step_factor=1", "BA").empty());
  CHECK(row_of(table, "default", "BA").size() == 12);
  CHECK(row_of(table, "IK-BA.step_factor=1", "all")[5] == "0.707");  // sqrt((1 + 0) / 2)
}

TEST_CASE("the notes name the reading that is nearest to each printed mean", "[readings]") {
  const Table table = readings_report("slim2023", two_readings()).table;
  const auto says = [&](const std::string& words) {
    return std::ranges::any_of(table.notes, [&](const std::string& note) { return note.find(words) == 0; });
  };
  // log10(0.0018 / 0.0019); the printed mean of 20 runs has the error 1.7824e-4 / sqrt(20) = 4e-5, ours of four runs
  // 1.8e-4, and they differ by 1e-4.
  CHECK(
      says("Printed error of IK-BA: default -0.023 (seeds from -0.048 to +0.000); as near as the printed number's own "
           "error allows."));
  CHECK(says("IK-BA.step_factor=1: Ten times as far."));
}

TEST_CASE("an interpretation is nearer only beyond the printed mean's own error", "[readings]") {
  // BA's printed error is 1.6849 with a standard deviation of 0.9069, so 1.96 standard errors of 20 runs are 0.397.
  const auto note_for = [](double usual, double other) {
    std::vector<ReadingResults> readings = two_readings();
    readings[0].solvers[1] = solver("BA", {{usual, usual}, {usual, usual}}, 301.5794);
    readings[1].solvers[1] = solver("BA", {{other, other}, {other, other}}, 301.5794);
    const Table table = readings_report("slim2023", readings).table;
    const auto found = std::ranges::find_if(
        table.notes, [](const std::string& note) { return note.find("Printed error of BA:") == 0; });
    REQUIRE(found != table.notes.end());
    return found->substr(found->find("; ") + 2);
  };
  CHECK(note_for(2.07, 1.6849) == "as near as the printed number's own error allows.");
  CHECK(note_for(2.09, 1.70) == "no interpretation is nearer by more than the printed number's own error.");
  CHECK(note_for(2.09, 1.6849) == "closest: IK-BA.step_factor=1 (+0.000).");
  CHECK(note_for(2.5, 2.6) == "no interpretation is nearer by more than the printed number's own error.");
}

TEST_CASE("numbers that are not finite are said to be not defined, and leave the picture", "[readings]") {
  std::vector<ReadingResults> readings = two_readings();
  readings[1].solvers[0].error_cm = {{std::numeric_limits<double>::infinity(), 1.0}, {1.0, 1.0}};
  const ReadingsReport report = readings_report("slim2023", readings);
  CHECK(row_of(report.table, "IK-BA.step_factor=1", "IK-BA")[5] == "not defined");
  CHECK(report.figure.data.find("inf") == std::string::npos);
}

TEST_CASE("the figure of readings is drawn, whatever their names", "[readings]") {
  std::vector<ReadingResults> readings = two_readings();
  readings[1].name = "`touch evil` \"$(x)\" 100% {a_b} @c\n#";
  const TestFolder folder;
  const auto outcomes = write_figures({readings_report("slim2023", readings).figure}, folder.path(), {});
  CHECK(outcomes.front().error == "");
  CHECK(files_in(folder.path()) == std::set<std::string>{"readings.dat", "readings.gp", "readings.pdf", "readings.png",
                                                         "readings.svg", "style.gp"});
}

TEST_CASE("without a default there is nothing to report", "[readings]") {
  CHECK_THROWS_AS(readings_report("slim2023", {}), std::invalid_argument);
}
