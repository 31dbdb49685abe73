// Texts of files, and records to put into stores.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <signal.h>

#include "base/files.hpp"
#include "base/json.hpp"
#include "base/number.hpp"
#include "base/toml_table.hpp"
#include "results/export.hpp"
#include "results/figure_style.hpp"
#include "results/fingerprint.hpp"
#include "results/merge.hpp"
#include "results/published.hpp"
#include "results/record.hpp"
#include "results/store.hpp"
#include "results/study.hpp"
#include "tests/base/cells.hpp"
#include "tests/base/processes.hpp"

using namespace ikbench::base;
using namespace ikbench::numerics;
using namespace ikbench::results;

namespace ikbench {

// A store of its own, for as long as it lives.
struct ScratchStore : ScratchFolder, results::Store {
  ScratchStore() : Store(path / "store.sqlite", Mode::write) {}
  const std::filesystem::path file = path / "store.sqlite";
};

// A record with a different value in every column, of the series and label of sample_study.
inline results::SolveRecord sample_record(const std::string& series = "key-a", int run = 1, int point = 1) {
  return {.study = "table-3",
          .robot = "iiwa14",
          .label = series == "key-b" ? "BA" : "IK-BA",
          .series = series,
          .run = run,
          .point = point,
          .target_position_m = {0.6, 0.2, 0.1},
          .target_rotation = {-1, 0, 0, 0, 1, 0, 0, 0, -1},
          .start_rad = {0, 0, 0, 0, 0, 0, 0},
          .answer_rad = {0.1, -0.2, 1.0 / 3.0, 0.4, 0.5, 0.6, 0.7},
          .reached_position_m = {0.6, 0.2, 0.100019},
          .position_error_cm = 0.0019,
          .reported_error_cm = 0.0018,
          .orientation_error = 1e-16,
          .variation_deg = 87.1916,
          .largest_move_deg = 60.25,
          .limit_violation_deg = 0.5,
          .evaluations = 10000,
          .iterations = 200,
          .stop_reason = results::StopReason::tolerance,
          .status = results::Status::limit_violated,
          .seconds = 0.2439,
          .wall_seconds = 0.25,
          .cpu_seconds = 0.2438,
          .timing = results::Timing::parallel,
          .session = 1,
          .trace_cm = {12.5, 0.25, 0.0019}};
}

inline results::StoredStudy sample_study(const std::string& name = "table-3") {
  return {.name = name,
          .definition = results::parse_definition(R"({"robot":"iiwa14","runs":20,"points":20})"),
          .series = {{.key = "key-a", .label = "IK-BA", .algorithm = "ik_ba", .options = R"({"gamma":0.1})"},
                     {.key = "key-b", .label = "BA", .algorithm = "ba", .options = "{}"}}};
}

inline void edit(const std::filesystem::path& store, const std::string& sql) {
  SQLite::Database(store.string(), SQLite::OPEN_READWRITE).exec(sql);
}

// Leaves a store as a kill in the middle of a transaction does.
inline void leave_half_written(const std::filesystem::path& store) {
  const pid_t writer = in_a_process([&] {
    SQLite::Database sqlite(store.string(), SQLite::OPEN_READWRITE);
    sqlite.exec("PRAGMA cache_size = 1; BEGIN; UPDATE solves SET trace_cm = hex(zeroblob(9000))");
    return kill(getpid(), SIGKILL) == 0;
  });
  CHECK(exit_code(writer) == -1);
  REQUIRE(std::filesystem::exists(store.string() + "-journal"));
}

inline std::string csv_of(const std::vector<results::SolveRecord>& solves) {
  const auto each = [&](const std::function<void(const results::SolveRecord&)>& take) {
    for (const results::SolveRecord& solve : solves) take(solve);
  };
  std::string text;
  results::write_csv(each, [&](std::string_view part) { text += part; });
  return text;
}

// Doubles as their bits, so that NaN equals NaN and -0.0 differs from 0.0; everything else by ==.
inline bool same(double a, double b) {
  return (a != a && b != b) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) { return same(x, y); });
}

template <class Value>
bool same(const Value& a, const Value& b) {
  return a == b;
}

inline bool same(const results::SolveRecord& a, const results::SolveRecord& b) {
  bool equal = true;
  results::for_each_column(
      [&](std::string_view, auto member, std::string_view) { equal &= same(a.*member, b.*member); });
  return equal;
}

inline std::vector<results::SolveRecord> series_of(const results::Store& store, const std::string& key) {
  std::vector<results::SolveRecord> list;
  store.for_each_in_series(key, [&](results::SolveRecord& record) { list.push_back(std::move(record)); });
  return list;
}

inline std::vector<results::SolveRecord> solves_of(const results::Store& store, const std::string& study) {
  std::vector<results::SolveRecord> list;
  store.for_each_in_study(store.study(study), [&](results::SolveRecord& record) { list.push_back(std::move(record)); });
  return list;
}

}  // namespace ikbench
