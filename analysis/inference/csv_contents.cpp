#include "analysis/inference/csv_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace results;

namespace {

void expect_few(const CsvFile& file, const Names& groups) {
  if (groups.all().size() <= max_groups) return;
  file.refuse(fmt::format("more than {} groups, the last {}; expected the names of the groups to compare", max_groups,
                          in_quotes(groups.all().back())));
}

std::size_t group_column(const CsvFile& file, const CsvRequest& request) {
  constexpr std::array<std::string_view, 3> titles{"group", "solver", "algorithm"};
  if (!request.group.empty()) return file.column(request.group);
  if (const auto column = file.column_like(titles)) return *column;
  file.refuse(fmt::format("no column of groups; name one with --group: {}", file.columns()));
}

std::vector<Index> written_rows(const CsvFile& file) {
  std::vector<Index> rows;
  for (Index row = 0; row < file.table.rows(); ++row) {
    if (!file.is_blank(row)) rows.push_back(row);
  }
  return rows;
}

// Returns whether a column holds row numbers, as pandas and R write them, or is empty, as spreadsheets leave it.
bool is_index(const CsvFile& file, std::size_t column, const std::vector<Index>& rows) {
  const std::string& title = file.table.header[column];
  if (column == 0 && (title.empty() || title == "Unnamed: 0")) return true;
  const auto is_empty = [&](std::size_t row) { return file.table.cell(row, column).empty(); };
  return title.empty() && std::ranges::all_of(rows, is_empty);
}

}  // namespace

Contents read_long(const CsvFile& file, const CsvRequest& request) {
  if (request.value.empty()) {
    file.refuse(fmt::format("no column of values; name one with --value: {}", file.columns()));
  }
  const std::size_t value = file.column(request.value);
  const std::size_t group = group_column(file, request);
  Contents contents;
  contents.observations.reserve(file.table.rows());
  for (Index row = 0; row < file.table.rows(); ++row) {
    if (file.is_blank(row)) continue;
    contents.observations.push_back(
        {.group = contents.groups.index_of(file.group_name(row, group)), .row = row, .value = file.number(row, value)});
    expect_few(file, contents.groups);
  }
  return contents;
}

Contents read_wide(const CsvFile& file, const CsvRequest& request) {
  if (!request.group.empty()) {
    file.refuse(
        fmt::format("--group {}: with --wide every column is a group; leave out --group", in_quotes(request.group)));
  }
  Contents contents;
  const std::vector<Index> rows = written_rows(file);  // once, not for every column
  for (std::size_t column = 0; column < file.table.header.size(); ++column) {
    const std::string& title = file.table.header[column];
    const bool is_asked_for = !title.empty() && (title == request.block || title == request.run);
    if (is_index(file, column, rows) || is_asked_for) continue;
    if (names_replicates(title)) {
      contents.notes.push_back(fmt::format("Column {} numbers the repetitions and is not a group.", in_quotes(title)));
      continue;
    }
    const std::size_t groups_before = contents.groups.all().size();
    if (title.size() > longest_name) {
      file.refuse(fmt::format("column {} has a name of {} bytes; expected at most {}", in_quotes(title), title.size(),
                              longest_name));
    }
    const Index group = contents.groups.index_of(title.empty() ? "(empty)" : title);
    if (group < groups_before) file.refuse(fmt::format("two columns {}; expected one", in_quotes(title)));
    expect_few(file, contents.groups);
    if (group == 0)
      contents.observations.reserve(rows.size() * std::min(file.table.header.size() - column, max_groups));
    for (const Index row : rows) {
      contents.observations.push_back({.group = group, .row = row, .value = file.number(row, column)});
    }
  }
  if (contents.groups.all().empty()) file.refuse("no column of values; expected one for each group");
  return contents;
}

void take_logarithms(const CsvFile& file, Contents& contents) {
  for (Observation& observation : contents.observations) {
    if (!observation.value) continue;
    if (!(*observation.value > 0)) {
      file.refuse(fmt::format("row {} below the header: {} has no logarithm; expected positive values for typical ones",
                              observation.row + 1, *observation.value));
    }
    observation.value = std::log10(*observation.value);
  }
}

bool names_replicates(std::string_view title) {
  constexpr std::array<std::string_view, 7> words{"run", "trial", "seed", "repetition", "replicate", "rep", "repeat"};
  std::string letters;
  std::ranges::copy_if(lower_case(title), std::back_inserter(letters), [](char c) { return c >= 'a' && c <= 'z'; });
  for (const std::string_view suffix : {"id", "index", "number"}) {
    if (letters.ends_with(suffix)) letters.resize(letters.size() - suffix.size());
  }
  return std::ranges::find(words, letters) != words.end();
}

Labels labels_of(const CsvFile& file, std::size_t column) { return *labels_of(file, column, file.table.rows()); }

std::optional<Labels> labels_of(const CsvFile& file, std::size_t column, std::size_t most) {
  Labels labels;
  labels.of_row.reserve(file.table.rows());
  for (std::size_t row = 0; row < file.table.rows(); ++row) {
    const std::string_view cell = file.table.cell(row, column);
    labels.of_row.push_back(is_missing(cell) ? no_label : labels.names.index_of(std::string(trimmed(cell))));
    if (labels.names.all().size() > most) return std::nullopt;
  }
  return labels;
}

Labels expect_labels(const CsvFile& file, std::size_t column) {
  Labels labels = labels_of(file, column);
  const auto missing = [&](std::size_t row) { return labels.of_row[row] == no_label && !file.is_blank(row); };
  for (std::size_t row = 0; row < labels.of_row.size(); ++row) {
    if (missing(row)) file.refuse_cell(row, column, "expected a name or a number");
  }
  return labels;
}

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
  std::vector<std::tuple<Index, Index, Index>> seen;  // group, run and name
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
