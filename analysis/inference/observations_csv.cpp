#include "analysis/inference/observations_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "analysis/inference/csv_cells.hpp"
#include "analysis/inference/csv_contents.hpp"
#include "analysis/inference/not_finite.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

std::optional<double> mean_of(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional(mean(values));
}

// Averages observations of the same group, block and run. An average is whole if it has as many values as the fullest
// of its block. Otherwise it is missing or, if rows are taken as given, the mean of the values left.
std::vector<Observation> averaged(std::vector<Observation> observations, bool takes_any_rows) {
  const auto key = [](const Observation& o) { return std::tuple(o.group, o.block, o.run); };
  std::ranges::stable_sort(observations, {}, key);
  std::vector<Observation> result;
  std::unordered_map<Index, Index> most;  // by block; counts observations without a value too
  for (std::size_t first = 0, end = 0; first < observations.size(); first = end) {
    std::vector<double> values;
    for (end = first; end < observations.size() && key(observations[end]) == key(observations[first]); ++end) {
      if (observations[end].value) values.push_back(*observations[end].value);
    }
    result.push_back(observations[first]);
    result.back().count = static_cast<Index>(values.size());
    result.back().value = mean_of(values);
    most[observations[first].block] = std::max(most[observations[first].block], static_cast<Index>(end - first));
  }
  for (Observation& observation : result) {
    observation.whole = most[observation.block];
    if (observation.count < observation.whole && !takes_any_rows) observation.value.reset();
  }
  return result;
}

// Numbers of averaged values: "20", or "18 to 20".
std::string counts_in_words(const std::vector<Observation>& observations) {
  Index low = std::numeric_limits<Index>::max(), high = 0;
  for (const Observation& observation : observations) {
    if (!observation.value) continue;
    low = std::min(low, observation.count);
    high = std::max(high, observation.count);
  }
  return low >= high ? fmt::to_string(high) : fmt::format("{} to {}", low, high);
}

// Number of rows of a whole run without blocks: that of most runs, or the larger of equally frequent ones. Runs with
// more rows are refused, or reported if rows are taken as given.
std::size_t rows_of_a_run(const CsvFile& file, const CsvRequest& request, const Contents& contents,
                          Observations& result) {
  const std::vector<GroupRun> keys =
      group_runs(contents, [](const Observation& o) { return o.run; });  // each run once per row
  std::map<std::size_t, std::size_t> counts;                             // number of runs by number of rows
  for (std::size_t first = 0; first < keys.size(); first += rows_of(keys, keys[first])) {
    ++counts[rows_of(keys, keys[first])];
  }
  std::size_t whole = counts.begin()->first;
  for (const auto& [rows, count] : counts) whole = count >= counts[whole] ? rows : whole;
  const auto longer = std::ranges::find_if(keys, [&](const GroupRun& key) { return rows_of(keys, key) > whole; });
  if (longer == keys.end()) return whole;
  const auto first_row = std::ranges::find(contents.observations, *longer, [](const Observation& o) {
                           return GroupRun(o.group, o.run);
                         })->row;
  const std::string words =
      fmt::format("{} {} of {} has {} rows where other runs have {}", one_line(request.run),
                  shortened(file.table.cell(first_row, file.column(request.run)), 40),
                  shortened(contents.groups.all()[longer->first], 40), rows_of(keys, *longer), whole);
  if (!request.takes_any_rows)
    file.refuse(words +
                "; a row may be duplicated, or the other runs may lack rows; --force averages them as they are");
  result.flaws.push_back({.kind = DoubtKind::uneven_runs, .what = words});
  return whole;
}

// Adds absent runs without a value. Groups that share more than half of the smaller one's runs were given the same
// runs; other groups have their own seeds, of which none is absent.
void add_absent_runs(Contents& contents) {
  const std::size_t groups = contents.groups.all().size();
  const Index whole = contents.observations.front().whole;
  using RunGroup = std::pair<Index, Index>;
  std::vector<RunGroup> groups_of;  // sorted
  groups_of.reserve(contents.observations.size());
  for (const Observation& o : contents.observations) {
    if (o.run != no_label) groups_of.emplace_back(o.run, o.group);
  }
  std::ranges::sort(groups_of);
  groups_of.erase(std::unique(groups_of.begin(), groups_of.end()), groups_of.end());
  const auto for_each_run = [&](const auto& use) {
    for (auto first = groups_of.begin(); first != groups_of.end();) {
      const auto end =
          std::find_if(first, groups_of.end(), [&](const RunGroup& each) { return each.first != first->first; });
      use(std::span<const RunGroup>(first, end));
      first = end;
    }
  };
  bool all_are_there = true;
  for_each_run([&](std::span<const RunGroup> run) { all_are_there = all_are_there && run.size() == groups; });
  if (all_are_there) return;
  std::vector<std::vector<std::size_t>> shared(groups, std::vector<std::size_t>(groups));
  for_each_run([&](std::span<const RunGroup> run) {
    for (const RunGroup& one : run) {
      for (const RunGroup& other : run) ++shared[one.second][other.second];
    }
  });
  for_each_run([&](std::span<const RunGroup> run) {
    for (Index group = 0; group < groups; ++group) {
      const auto is_shared = [&](const RunGroup& other) {
        return 2 * shared[group][other.second] > std::min(shared[group][group], shared[other.second][other.second]);
      };
      if (std::ranges::binary_search(run, group, {}, &RunGroup::second) || std::ranges::none_of(run, is_shared))
        continue;
      contents.observations.push_back({.group = group, .run = run.front().first, .count = 0, .whole = whole});
    }
  });
}

// For rows that are runs numbered by a column: labels the observations and adds absent runs.
void add_absent_rows(const CsvFile& file, const CsvRequest& request, Contents& contents) {
  const std::size_t rows = contents.observations.size();
  for (std::size_t column = 0; column < file.table.header.size(); ++column) {
    if (!numbers_runs(file.table.header[column], request) || contents.observations.size() > rows) continue;
    const Labels labels = labels_of(file, column);
    for (Observation& observation : contents.observations) observation.run = labels.of_row[observation.row];
    add_absent_runs(contents);
  }
}

// Counts incomplete observations by group.
struct Lack {
  std::size_t missing = 0, all = 0;
};

std::vector<Lack> lacks_of(const Contents& contents) {
  std::vector<Lack> lacks(contents.groups.all().size());
  for (const Observation& observation : contents.observations) {
    Lack& lack = lacks[observation.group];
    lack.missing += !observation.value || observation.count < observation.whole ? 1 : 0;
    ++lack.all;
  }
  return lacks;
}

// "3 of 20 values of IK-BA, 1 of 20 of BA"; empty if nothing is missing.
std::string in_words(const std::vector<Lack>& lacks, std::string_view what, const Names& groups) {
  constexpr std::size_t most_groups = 12;
  std::string words;
  std::size_t listed = 0;
  for (std::size_t group = 0; group < lacks.size(); ++group) {
    const auto [missing, all] = lacks[group];
    if (missing == 0 || listed++ >= most_groups) continue;
    words += words.empty() ? fmt::format("{} of {} {}", missing, all, what) : fmt::format(", {} of {}", missing, all);
    words += fmt::format(" of {}", one_line(groups.all()[group]));
  }
  if (listed > most_groups) words += fmt::format(" and of {} more groups", listed - most_groups);
  return words;
}

// Refuses several values of a group in one block.
void expect_one_a_block(const CsvFile& file, const Contents& contents, const Observations& result) {
  std::map<std::pair<Index, Index>, std::size_t> rows;  // by group and block
  for (const Observation& observation : contents.observations) ++rows[{observation.group, observation.block}];
  const auto several = std::ranges::find_if(rows, [](const auto& row) { return row.second > 1; });
  if (several == rows.end()) return;
  if (result.blocks.size() == 1) {
    file.refuse(fmt::format("all rows are in one block, {}, within which nothing can be judged; leave out --block",
                            in_quotes(result.blocks.front())));
  }
  std::string run = "COLUMN";
  for (const std::string& title : file.table.header) {
    if (names_replicates(title) && run == "COLUMN") run = one_line(title);
  }
  const auto& [group, block] = several->first;
  file.refuse(
      fmt::format("{} rows of {} in block {}; expected one; average the rows of a run and the runs of a block with "
                  "--run {}, or average all rows with --force",
                  several->second, in_quotes(result.groups[group].name), in_quotes(result.blocks[block]), run));
}

// "'p4' has 2 of 3 runs of 'B'"
std::string lack_in_words(const Observation& cell, std::string_view what, const Observations& result) {
  const std::string block = in_quotes(result.blocks[cell.block]), group = in_quotes(result.groups[cell.group].name);
  if (cell.count == 0) return fmt::format("{} has no value of {}", block, group);
  return fmt::format("{} has {} of {} {} of {}", block, cell.count, cell.whole, what, group);
}

// Fills one value per group and block; leaves out blocks that lack one. `what`: the averaged items.
void fill_blocks(const CsvFile& file, const Contents& cells, std::string_view what, Observations& result) {
  std::vector<std::vector<Observation>> blocks(result.blocks.size());
  for (Index block = 0; block < blocks.size(); ++block) {
    for (Index group = 0; group < result.groups.size(); ++group) {
      blocks[block].push_back({.group = group, .block = block, .count = 0});
    }
  }
  for (const Observation& cell : cells.observations) blocks[cell.block][cell.group] = cell;
  std::vector<std::string> complete;
  std::string example;
  bool some_left = false, some_averaged = false;
  std::vector<Lack> lacks(result.groups.size(), Lack{0, blocks.size()});
  for (const std::vector<Observation>& block : blocks) {
    const auto absent = std::ranges::find_if(block, [](const Observation& cell) { return !cell.value; });
    for (const Observation& cell : block) {
      lacks[cell.group].missing += cell.count < cell.whole ? 1 : 0;
      some_left = some_left || (cell.count > 0 && !cell.value);
      some_averaged = some_averaged || (cell.count < cell.whole && cell.value);
      if (absent == block.end()) result.groups[cell.group].values.push_back(*cell.value);
    }
    if (absent == block.end()) complete.push_back(result.blocks[block.front().block]);
    if (absent != block.end() && example.empty()) example = lack_in_words(*absent, what, result);
  }
  if (complete.empty()) {
    file.refuse(fmt::format("no block has a value for every group: {}{}", example,
                            some_left ? "; --force averages the values that exist" : ""));
  }
  if (const std::size_t left_out = blocks.size() - complete.size(); left_out > 0) {
    result.notes.push_back(
        fmt::format("Left out because incomplete: {} of {} blocks ({}).", left_out, blocks.size(), example));
  }
  if (const std::string words = in_words(lacks, "blocks", cells.groups); !words.empty()) {
    result.flaws.push_back(
        {.kind = some_averaged ? DoubtKind::blocks_averaged : DoubtKind::blocks_left_out, .what = words});
  }
  result.blocks = std::move(complete);
}

// Labels observations with blocks and runs, and names the blocks.
std::vector<std::string> label(const CsvFile& file, const CsvRequest& request, Contents& contents) {
  std::vector<std::string> blocks;
  if (!request.block.empty()) {
    const Labels labels = expect_labels(file, file.column(request.block));
    for (Observation& observation : contents.observations) observation.block = labels.of_row[observation.row];
    blocks = labels.names.all();
  } else if (request.is_wide && request.rows_are_blocks) {
    for (Observation& observation : contents.observations) observation.block = observation.row;
    for (std::size_t row = 0; row < file.table.rows(); ++row) blocks.push_back(fmt::to_string(row + 1));
  }
  if (!request.run.empty()) {
    const Labels labels = expect_labels(file, file.column(request.run));
    for (Observation& observation : contents.observations) observation.run = labels.of_row[observation.row];
  }
  return blocks;
}

// Adds notes on means over a run's rows, and on runs that have none.
void add_run_notes(const CsvFile& file, const CsvRequest& request, const Contents& runs, Observations& result) {
  if (std::ranges::none_of(runs.observations, [](const Observation& run) { return run.value.has_value(); })) {
    file.refuse("no run is complete; --force averages the rows that have a value");
  }
  const std::string rows = counts_in_words(runs.observations);
  if (std::ranges::all_of(runs.observations, [](const Observation& run) { return run.whole == 1; })) return;
  result.replicate = fmt::format("the mean of a run over its {} rows of {}", rows, file.name());
  result.notes.push_back(
      fmt::format("Each observation is the mean over the {} rows of a run (column {}).", rows, in_quotes(request.run)));
  if (request.takes_any_rows) return;
  if (const std::string words = in_words(lacks_of(runs), "runs", runs.groups); !words.empty()) {
    result.notes.push_back(fmt::format("Left out because rows are missing: {}.", words));
  }
}

bool is_constant(const Group& group, bool is_log) {
  const double first = group.values.empty() ? 0 : group.values.front();
  const auto is_first = [&](double value) {  // one is added for logarithms near 0
    return value == first || without_rounding(value - first, std::abs(first) + (is_log ? 1 : 0)) == 0;
  };
  return group.values.size() > 1 && std::ranges::all_of(group.values, is_first);
}

// Joins a group's equal measurements to one: they are copies. Keeps equal whole numbers, which may be chance, unless no
// group varies and the groups differ. Keeps outcomes of 0 and 1.
void join_equal(Observations& result, std::string_view what) {
  const auto given = [&](double value) { return result.scale == ValueScale::log10 ? std::pow(10, value) : value; };
  const auto is_outcome = [&](double value) { return given(value) == 0 || given(value) == 1; };
  const auto is_other = [&](const Group& group) {
    return group.values.front() != result.groups.front().values.front();
  };
  const auto is_constant_group = [&](const Group& group) {
    return is_constant(group, result.scale == ValueScale::log10);
  };
  const bool none_varies =
      std::ranges::all_of(result.groups, is_constant_group) && std::ranges::any_of(result.groups, is_other);
  const bool are_outcomes = std::ranges::all_of(
      result.groups, [&](const Group& group) { return std::ranges::all_of(group.values, is_outcome); });
  std::vector<std::string> names;
  for (Group& group : result.groups) {
    if (!is_constant_group(group) || are_outcomes || !std::isfinite(group.values.front())) continue;
    const double value = given(group.values.front());
    if (value == std::round(value) && !none_varies) continue;
    names.push_back(fmt::format("{} ({})", one_line(group.name), group.values.size()));
    group.values.resize(1);
  }
  if (names.empty()) return;
  result.notes.push_back(
      fmt::format("Equal {0} are one observation: all {0} of {1} have the same value, to the last bit, so no test uses "
                  "them as repetitions. For a test, compare over several problems (--block COLUMN).",
                  what, fmt::join(names, ", ")));
}

// Takes the observations of independent groups.
void fill_groups(const CsvRequest& request, const Contents& contents, Observations& result) {
  for (const Observation& observation : contents.observations) {
    if (observation.value) result.groups[observation.group].values.push_back(*observation.value);
  }
  const bool are_rows = request.run.empty();
  if (const std::string words = in_words(lacks_of(contents), are_rows ? "values" : "runs", contents.groups);
      !words.empty()) {
    result.flaws.push_back({.kind = are_rows ? DoubtKind::values_missing : DoubtKind::runs_incomplete, .what = words});
  }
  join_equal(result, are_rows ? "rows" : "runs");
}

// Takes one observation for each group in each block.
void fill_paired(const CsvFile& file, const CsvRequest& request, Contents& contents, Observations& result) {
  const std::string_view what = request.run.empty() ? "rows" : "runs";
  if (request.run.empty() && !request.takes_any_rows) expect_one_a_block(file, contents, result);
  for (Observation& observation : contents.observations) observation.run = 0;
  contents.observations = averaged(std::move(contents.observations), request.takes_any_rows);
  if (const std::string count = counts_in_words(contents.observations); count != "1") {
    result.replicate = fmt::format("the mean over the {} {} of a block in {}", count, what, file.name());
    result.notes.push_back(
        fmt::format("Each observation is the mean over the {} {} of a group in a block.", count, what));
  }
  result.block = request.block.empty() ? "a row of " + file.name()
                                       : fmt::format("a value of {} in {}", in_quotes(request.block), file.name());
  fill_blocks(file, contents, what, result);
}

// Infinity is a failure. On the other side it would beat every number.
void refuse_infinitely_good(const CsvFile& file, const Contents& contents, Better better) {
  const double best = better == Better::smaller ? -HUGE_VAL : HUGE_VAL;
  const auto found = std::ranges::find(contents.observations, best, [](const Observation& o) { return o.value; });
  if (found == contents.observations.end()) return;
  file.refuse(fmt::format(
      "row {} below the header: {}, but {} values are better; expected a finite number, or {} for a failure",
      found->row + 1, best > 0 ? "Inf" : "-Inf", better == Better::smaller ? "smaller" : "larger",
      best > 0 ? "-Inf" : "Inf"));
}

}  // namespace

Observations read_observations(std::string_view text, std::string_view source, const CsvRequest& request) {
  const CsvFile file = open_csv(text, source);
  Contents contents = request.is_wide ? read_wide(file, request) : read_long(file, request);
  refuse_infinitely_good(file, contents, request.better);
  const bool is_typical = request.scale == ValueScale::log10;
  if (is_typical) take_logarithms(file, contents);
  if (std::ranges::none_of(contents.observations, [](const Observation& o) { return o.value.has_value(); })) {
    file.refuse("all values are missing; expected at least one");
  }
  const std::string quantity = (is_typical ? "typical " : "") + (request.value.empty() ? "value" : request.value);
  Observations result{.name = slug(quantity),
                      .quantity = quantity,
                      .unit = split_unit(quantity).unit,
                      .better = request.better,
                      .scale = request.scale};
  result.notes = std::move(contents.notes);
  for (const std::string& name : contents.groups.all()) result.groups.push_back({.name = name});
  result.blocks = label(file, request, contents);
  result.replicate = "a row of " + file.name();
  if (request.run.empty() && request.block.empty()) {
    if (std::string shared = rows_share_a_run(file, contents, request); !shared.empty()) {
      result.flaws.push_back({.kind = DoubtKind::rows_share_a_run, .what = std::move(shared)});
    }
    if (result.flaws.empty()) add_absent_rows(file, request, contents);
  }
  if (const std::string words = in_words(lacks_of(contents), "values", contents.groups); !words.empty()) {
    result.notes.push_back(
        fmt::format("Missing and left out: {}. For a failed run, write {} instead, which ranks as the worst.", words,
                    request.better == Better::smaller ? "Inf" : "-Inf"));
  }

  if (!request.run.empty()) {
    const std::size_t whole = result.blocks.empty() ? rows_of_a_run(file, request, contents, result) : 0;
    contents.observations = averaged(std::move(contents.observations), request.takes_any_rows);
    for (Observation& run : contents.observations) run.whole = whole == 0 ? run.whole : static_cast<Index>(whole);
    if (result.blocks.empty()) add_absent_runs(contents);
    add_run_notes(file, request, contents, result);
  }

  if (result.blocks.empty()) {
    fill_groups(request, contents, result);
  } else {
    fill_paired(file, request, contents, result);
  }
  std::ranges::move(notes_of_not_finite(result.groups), std::back_inserter(result.notes));
  return result;
}

}  // namespace ikbench::inference
