#include "analysis/inference/csv_replicates.hpp"

#include <fmt/format.h>

#include <optional>
#include <tuple>

#include "analysis/inference/text.hpp"

namespace ikbench::inference {
namespace {

// The rows of the first run that several rows of a group share.
struct SharedRun {
  std::string words = {};    // "12 rows share seed 1 of A"; empty if every row is a run of its own
  std::string told_by = {};  // a column such as problem whose names tell the rows of every run apart; or empty
};

// Returns whether the column has a different name for each row of a run, and no names but the fullest run's: such a
// column holds the problems or points that every run was given.
bool tells_rows_apart(const CsvFile& file, const Contents& contents, std::size_t column, const Labels& runs) {
  const auto run_of = [&](const Observation& o) { return runs.of_row[o.row]; };
  std::vector<GroupRun> keys = group_runs(contents, run_of);
  std::erase_if(keys, [](const GroupRun& key) { return key.second == no_label; });
  std::size_t most = 0;
  for (std::size_t first = 0; first < keys.size(); first += rows_of(keys, keys[first])) {
    most = std::max(most, rows_of(keys, keys[first]));
  }
  if (keys.empty() || rows_of(keys, keys.front()) == keys.size()) return false;  // only one run
  const std::optional<Labels> names = labels_of(file, column, most);
  if (!names || names->names.all().size() != most) return false;
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> seen;  // group, run and name
  for (const Observation& o : contents.observations) {
    if (run_of(o) == no_label) continue;
    if (names->of_row[o.row] == no_label) return false;
    seen.emplace_back(o.group, run_of(o), names->of_row[o.row]);
  }
  std::ranges::sort(seen);
  return std::ranges::adjacent_find(seen) == seen.end();
}

SharedRun shared_run(const CsvFile& file, const Contents& contents, const CsvRequest& request, std::size_t column) {
  const Labels runs = labels_of(file, column);
  const auto run_of = [&](const Observation& o) { return runs.of_row[o.row]; };
  const std::vector<GroupRun> keys = group_runs(contents, run_of);
  const auto count = [&](const Observation& o) { return rows_of(keys, {o.group, run_of(o)}); };
  const auto shared = std::ranges::find_if(contents.observations,
                                           [&](const Observation& o) { return run_of(o) != no_label && count(o) > 1; });
  if (shared == contents.observations.end()) return {};
  SharedRun result{.words =
                       fmt::format("{} rows share {} {} of {}", count(*shared), one_line(file.table.header[column]),
                                   shortened(runs.names.all()[run_of(*shared)], 40),
                                   shortened(contents.groups.all()[shared->group], 40))};
  if (request.is_wide) return result;
  for (std::size_t other = 0; other < file.table.header.size() && result.told_by.empty(); ++other) {
    const std::string& title = file.table.header[other];
    if (title.empty() || title == request.value || names_replicates(title)) continue;
    if (tells_rows_apart(file, contents, other, runs)) result.told_by = one_line(title);
  }
  return result;
}

}  // namespace

bool numbers_runs(const std::string& title, const CsvRequest& request) {
  return names_replicates(title) && title != request.group && title != request.value && title != request.block;
}

std::size_t rows_of(const std::vector<GroupRun>& keys, const GroupRun& key) {
  const auto [first, last] = std::equal_range(keys.begin(), keys.end(), key);
  return static_cast<std::size_t>(last - first);
}

std::string rows_share_a_run(const CsvFile& file, const Contents& contents, const CsvRequest& request) {
  constexpr std::string_view why = "points of one run depend on each other and are not replicates";
  for (std::size_t column = 0; column < file.table.header.size(); ++column) {
    const std::string& title = file.table.header[column];
    if (!numbers_runs(title, request)) continue;
    const auto [shared, told_by] = shared_run(file, contents, request, column);
    if (shared.empty()) continue;
    if (request.takes_any_rows) return shared;
    const std::string run = one_line(title);
    if (told_by.empty())
      file.refuse(fmt::format("{}; {}; average them with --run {}, or accept them with --force", shared, why, run));
    const std::string name = lower_case(told_by);
    if (name.starts_with("point") || name.starts_with("step")) {  // points of a path
      file.refuse(fmt::format(
          "{0}, one for each {1}, and are not replicates; if each {1} depends on the previous one, average them with "
          "--run {2}; if each was solved separately, compare within blocks with --block {1} --run {2}; or use --force",
          shared, told_by, run));
    }
    file.refuse(fmt::format(
        "{0}, one for each {1}, and are not replicates; compare within blocks with --block {1} --run {2}, or, if the "
        "rows of a run depend on each other like points of one path, average them with --run {2}, or use --force",
        shared, told_by, run));
  }
  return {};
}

}  // namespace ikbench::inference
