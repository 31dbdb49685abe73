// A study in the format of IOHprofiler. A target of the path is a function, a run an instance, the number of searched
// joints the dimension, and the error [cm] the objective. Each solve lists the evaluations at which its best error
// became smaller.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "numerics/json.hpp"
#include "numerics/number.hpp"
#include "results/export.hpp"
#include "results/files.hpp"
#include "results/study.hpp"

namespace ikbench::results {

using namespace numerics;

namespace {

using Json = nlohmann::ordered_json;

constexpr int largest_id = 65535;                      // 16 bits in the tables of IOHinspector
constexpr std::string_view writer_version = "0.3.23";  // of IOHexperimenter; readers derive the format from it

struct Row {
  double evaluations, error_cm;
};

// A name for files and functions: letters, digits, _ and -.
std::string plain_name(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    name += is_plain ? c : '_';
  }
  return name.empty() ? "_" : name.substr(0, 60);
}

bool has_rows(const SolveRecord& solve) {
  return solve.counted_by == CountedBy::suite && (!solve.improved_at.empty() || is_without_answer(solve.status));
}

// The rows of a solve, from evaluation 1 to the last. A value that is not finite is no improvement; a solve without any
// finite error gets the largest.
std::vector<Row> rows_of(const SolveRecord& solve) {
  constexpr double worst = std::numeric_limits<double>::max();
  if (solve.improved_at.size() != solve.improved_to_cm.size() ||
      !std::ranges::all_of(solve.improved_at, [](double count) { return count >= 1 && std::isfinite(count); }))
    throw std::invalid_argument(
        fmt::format("the course of run {}, point {} by '{}' is damaged", solve.run, solve.point, solve.label));
  if (solve.improved_at.empty()) return {{1, solve.position_error_cm}};
  std::vector<Row> rows;
  for (std::size_t i = 0; i < solve.improved_at.size(); ++i) {
    const double error = solve.improved_to_cm[i];
    rows.push_back({solve.improved_at[i], std::isfinite(error) ? error : worst});
  }
  return rows;
}

// The number of searched joints: all, those before the wrist, or all but the last.
std::size_t dimension_of(Search search, const SolveRecord& solve) {
  const std::size_t all = solve.answer_rad.size(), left = search == Search::wrist    ? 3
                                                          : search == Search::flange ? 1
                                                                                     : 0;
  return all > left ? all - left : all;
}

// One function of one solver: the rows of all its runs, and their entries in the JSON file.
struct Function {
  std::string data = {};
  Json runs = Json::array();
};

void add_run(Function& function, const SolveRecord& solve, std::size_t dimension) {
  const std::vector<Row> rows = rows_of(solve);
  function.data += "evaluations raw_y\n";
  for (const Row& row : rows) function.data += fmt::format("{:.0f} {:.17g}\n", row.evaluations, row.error_cm);
  const Row& best = *std::ranges::min_element(rows, {}, &Row::error_cm);
  Json x = Json::array();
  for (std::size_t j = 0; j < dimension; ++j) x.push_back(solve.answer_rad[j]);
  // `best` must have exactly these three: IOHinspector silently skips a file with more.
  function.runs.push_back(
      {{"instance", solve.run},
       {"evals", static_cast<std::int64_t>(rows.back().evaluations)},
       {"best", {{"evals", static_cast<std::int64_t>(best.evaluations)}, {"y", best.error_cm}, {"x", x}}}});
}

// Writes one function of a solver into the solver's folder.
void write_function(const std::filesystem::path& folder, const std::string& study, const Series& series, int point,
                    const Function& function, std::size_t dimension) {
  const std::string name = fmt::format("target_{}", point), data_folder = fmt::format("data_f{}_{}", point, name);
  const std::string path = fmt::format("{}/IOHprofiler_f{}_DIM{}.dat", data_folder, point, dimension);
  write_file(folder / path, function.data);
  // No attributes of ours: IOHinspector evaluates their texts, and IOHanalyzer loses those of runs.
  const Json json{
      {"version", writer_version},
      {"suite", plain_name("ikbench_" + study)},
      {"function_id", point},
      {"function_name", name},
      {"maximization", false},
      {"algorithm", {{"name", series.label}, {"info", series.algorithm + " " + series.options}}},
      {"experiment_attributes", Json::array()},
      {"run_attributes", Json::array()},
      {"attributes", {"evaluations", "raw_y"}},
      {"scenarios", Json::array({Json{{"dimension", dimension}, {"path", path}, {"runs", function.runs}}})}};
  write_file(folder / fmt::format("IOHprofiler_f{}_{}.json", point, name), numerics::text_of(json, 1) + "\n");
}

void refuse_full(const std::filesystem::path& folder) {
  std::error_code none;
  if (!std::filesystem::exists(folder, none)) return;
  if (std::filesystem::is_directory(folder, none) && std::filesystem::is_empty(folder, none)) return;
  throw std::invalid_argument(
      fmt::format("{} is not an empty folder, and IOHprofiler reads every file that it finds; expected a new folder",
                  folder.string()));
}

}  // namespace

std::vector<std::string> write_iohprofiler(const StoredStudy& study, const PassSolves& pass,
                                           const std::filesystem::path& folder) {
  const Search search = definition_of(study.definition).search;
  std::map<std::string, std::map<int, Function>> functions;  // by solver and point
  std::size_t dimension = 0;
  std::set<std::string> left_out;
  pass([&](const SolveRecord& solve) {
    if (!has_rows(solve)) left_out.insert(solve.label);
  });
  pass([&](const SolveRecord& solve) {
    if (left_out.contains(solve.label)) return;
    if (solve.point > largest_id || solve.run > largest_id)
      throw std::invalid_argument(
          fmt::format("run {}, point {}: IOHprofiler's numbers end at {}; expected no more runs "
                      "and points",
                      solve.run, solve.point, largest_id));
    dimension = dimension_of(search, solve);
    add_run(functions[solve.label][solve.point], solve, dimension);
  });
  if (functions.empty())
    throw std::invalid_argument(fmt::format(
        "study '{}': no solver has the errors at its evaluations; expected trace = \"best_error\" in the study: "
        "ikbench run STUDY --set trace=best_error --out another folder",
        study.name));
  refuse_full(folder);
  write_folder(folder, [&](const std::filesystem::path& place) {
    std::set<std::string> used;
    for (const Series& series : study.series) {
      if (!functions.contains(series.label)) continue;
      std::string name = plain_name(series.label);
      for (int next = 2; !used.insert(name).second; ++next) name = fmt::format("{}-{}", plain_name(series.label), next);
      for (const auto& [point, function] : functions[series.label])
        write_function(place / name, study.name, series, point, function, dimension);
    }
  });
  std::vector<std::string> warnings;
  for (const std::string& solver : left_out)
    warnings.push_back(
        fmt::format("{} is left out: its evaluations were not counted here, or it has no trace", solver));
  return warnings;
}

}  // namespace ikbench::results
