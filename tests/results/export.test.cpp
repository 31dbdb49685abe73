// CSV of records, against text written by hand.
#include "tests/results/samples.hpp"

TEST_CASE("CSV has a row per solve and a column per joint", "[export]") {
  SolveRecord four_joints = sample_record("key-b", 2, 3);
  four_joints.label = "BA, \"literal\"";
  four_joints.start_rad = four_joints.answer_rad = {0.5, 1, 1.5, 2};
  four_joints.position_error_cm = std::numeric_limits<double>::quiet_NaN();
  four_joints.seconds = std::numeric_limits<double>::infinity();
  std::istringstream csv(csv_of({sample_record(), four_joints}));
  std::istringstream expected(text_in("tests/data/export.csv"));
  for (std::string line; std::getline(expected, line);) {
    std::string found;
    std::getline(csv, found);
    CHECK_THAT(found + ',', StartsWith(line + ','));  // and then what was added to the columns of schema 1
  }
  CHECK(csv.peek() == EOF);
}

TEST_CASE("CSV of no solves is the header without lists", "[export]") {
  const std::string csv = csv_of({});
  const CsvTable table = parse_csv(csv, "empty.csv");
  CHECK(table.rows() == 0);
  CHECK(table.header.front() == "study");
  CHECK(std::ranges::count(columns(), "list of numbers", &ColumnInfo::type) ==
        static_cast<std::ptrdiff_t>(columns().size() - table.header.size()));
}

TEST_CASE("every column has a name of its own, a type and a meaning", "[export]") {
  const auto list = columns();
  CHECK(list.size() >= 26);
  for (const char* type : {"integer", "list of numbers", "number", "text", "name"})
    CHECK(std::ranges::count(list, type, &ColumnInfo::type) > 0);
  for (const ColumnInfo& column : list) {
    CHECK(!column.meaning.empty());
    CHECK(std::count_if(list.begin(), list.end(), [&](auto& other) { return other.name == column.name; }) == 1);
  }
}
