// The tables of Slim et al., Robotics 2023, 12, 38, as printed: each number below stands in the paper.
#include "tests/results/samples.hpp"

namespace {

std::string_view cell(const CsvTable& table, std::size_t row, std::string_view column) {
  return table.cell(row, table.column(column));
}

// Row of Table 3.
std::size_t row_of(const CsvTable& table, std::string_view algorithm, std::string_view metric) {
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (cell(table, row, "algorithm") == algorithm && cell(table, row, "metric") == metric) return row;
  throw std::invalid_argument("no such row");
}

}  // namespace

TEST_CASE("every table has its files' text, as printed", "[published]") {
  for (const std::string name : {"table-3", "table-4", "table-5", "table-6", "table-7", "table-8"}) {
    CAPTURE(name);
    const std::string file = text_in("results/published/slim2023/" + name + ".csv");
    CHECK(to_csv(cells_of(published::table("slim2023", name))) == file);
  }
}

TEST_CASE("Table 3 has six algorithms, three metrics and the printed text", "[published][paper]") {
  const CsvTable table = published::table("slim2023", "table-3");
  std::set<std::string> algorithms;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    algorithms.emplace(cell(table, row, "algorithm"));
    CHECK(table.number(row, "n") == 20);
    CHECK(table.number(row, "min") <= table.number(row, "median"));
    CHECK(table.number(row, "median") <= table.number(row, "max"));
    CHECK(table.number(row, "min") <= table.number(row, "mean"));
    CHECK(table.number(row, "mean") <= table.number(row, "max"));
  }
  CHECK(algorithms == std::set<std::string>{"IK-BA", "BA", "DE", "PSO", "K-ABC", "MO-PSO"});
  CHECK(cell(table, row_of(table, "IK-BA", "position_error_cm"), "std") == "1.7824e-4");
  CHECK(cell(table, row_of(table, "PSO", "position_error_cm"), "min") == "0.0000");
  CHECK(cell(table, row_of(table, "MO-PSO", "variation_deg"), "max") == "164.1794");
  CHECK(table.number(row_of(table, "K-ABC", "seconds"), "median") == 0.42);
}

TEST_CASE("Table 7 keeps the misprint: with 20 bats the mean exceeds the maximum", "[published][paper]") {
  const CsvTable table = published::table("slim2023", "table-7");
  CHECK(cell(table, 2, "algorithm") == "20 bats");
  CHECK(cell(table, 2, "mean") == "83.75");
  CHECK(cell(table, 2, "max") == "80.06");
}

TEST_CASE("the printed errors of Table 8 average 2.55e-14 cm", "[published][paper]") {
  const CsvTable table = published::table("slim2023", "table-8");
  double sum = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    CHECK(table.number(row, "point") == static_cast<double>(row + 1));
    CHECK(cell(table, row, "theta4_deg") == cell(table, row, "theta1_deg"));
    sum += table.number(row, "error_cm");
  }
  CHECK(sum / 20 == Approx(2.55e-14).epsilon(2e-3));  // hand calculation; the text of the paper says 2.1196e-14
  CHECK(cell(table, 11, "error_cm") == "9.61e-14");
  CHECK(cell(table, 0, "theta1_deg") == "34.8");
  CHECK(cell(table, 19, "theta3_deg") == "54.8");
}
