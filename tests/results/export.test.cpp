// CSV of records, against text written by hand.
#include "tests/results/samples.hpp"

TEST_CASE("CSV has a row per solve and a column per joint", "[export]") {
  SolveRecord four_joints = sample_record("key-b", 2, 3);
  four_joints.label = "BA, \"literal\"";
  four_joints.start_rad = four_joints.answer_rad = {0.5, 1, 1.5, 2};
  four_joints.position_error_cm = std::numeric_limits<double>::quiet_NaN();
  four_joints.seconds = std::numeric_limits<double>::infinity();
  std::istringstream csv(csv_of({sample_record(), four_joints}));
  for (const std::string line :
       {"study,robot,label,series,run,point,target_position_m_1,target_position_m_2,target_position_m_3,"
        "target_rotation_1,target_rotation_2,target_rotation_3,target_rotation_4,target_rotation_5,target_rotation_6,"
        "target_rotation_7,target_rotation_8,target_rotation_9,start_rad_1,start_rad_2,start_rad_3,start_rad_4,"
        "start_rad_5,start_rad_6,start_rad_7,answer_rad_1,answer_rad_2,answer_rad_3,answer_rad_4,answer_rad_5,"
        "answer_rad_6,answer_rad_7,reached_position_m_1,reached_position_m_2,reached_position_m_3,"
        "position_error_cm,claimed_error_cm,orientation_error,variation_deg,largest_move_deg,limit_violation_deg,"
        "evaluations,iterations,stop_reason,status,seconds,cpu_seconds,timing,"
        "session",
        "table-3,iiwa14,IK-BA,key-a,1,1,0.6,0.2,0.1,-1,0,0,0,1,0,0,0,-1,0,0,0,0,0,0,0,"
        "0.1,-0.2,0.3333333333333333,0.4,0.5,0.6,0.7,0.6,0.2,0.100019,0.0019,0.0018,1e-16,87.1916,60.25,0.5,10000,200,"
        "tolerance,limit_violated,0.2439,0.2438,parallel,1",
        "table-3,iiwa14,\"BA, \"\"literal\"\"\",key-b,2,3,0.6,0.2,0.1,-1,0,0,0,1,0,0,0,-1,0.5,1,1.5,2,,,,"
        "0.5,1,1.5,2,,,,0.6,0.2,0.100019,NaN,0.0018,1e-16,87.1916,60.25,0.5,10000,200,"
        "tolerance,limit_violated,Inf,0.2438,parallel,1"}) {
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
