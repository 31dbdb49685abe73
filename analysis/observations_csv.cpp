#include "analysis/observations_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "analysis/csv_cells.hpp"
#include "analysis/csv_contents.hpp"
#include "analysis/text.hpp"

namespace ikbench {
namespace {

std::optional<double> mean_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0;
  for (const double value : values) sum += value / static_cast<double>(values.size());
  const bool finite = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
  const double exact = finite ? mean(values) : sum;
  return std::isfinite(exact) ? exact : sum;  // differences of huge numbers overflow, the sum of their shares does not
}

enum class Missing { spoils_the_mean, is_left_out };

// One observation for all of the same group, block and run.
std::vector<Observation> averaged(std::vector<Observation> observations, Missing missing) {
  const auto key = [](const Observation& o) { return std::tuple(o.group, o.block, o.run); };
  std::ranges::stable_sort(observations, {}, key);
  std::vector<Observation> result;
  for (std::size_t first = 0, end = 0; first < observations.size(); first = end) {
    std::vector<double> values;
    for (end = first; end < observations.size() && key(observations[end]) == key(observations[first]); ++end) {
      if (observations[end].value) values.push_back(*observations[end].value);
    }
    result.push_back(observations[first]);
    result.back().count = end - first;
    const bool spoilt = missing == Missing::spoils_the_mean && values.size() < end - first;
    result.back().value = spoilt ? std::nullopt : mean_of(values);
  }
  return result;
}

// "20", or "18 to 20".
std::string counts_in_words(const std::vector<Observation>& observations) {
  const auto [low, high] = std::ranges::minmax(observations, {}, &Observation::count);
  return low.count == high.count ? fmt::to_string(low.count) : fmt::format("{} to {}", low.count, high.count);
}

// "3 of 20 values of IK-BA, 1 of 20 of BA": a note, empty where nothing is missing.
struct LeftOut {
  std::string_view what, why;
};
std::string missing_note(const Contents& contents, LeftOut left_out) {
  constexpr std::size_t most_groups = 12;
  std::vector<std::array<std::size_t, 2>> counts(contents.groups.all().size());
  for (const Observation& observation : contents.observations) {
    counts[observation.group][0] += observation.value ? 0 : 1;
    ++counts[observation.group][1];
  }
  std::string groups;
  std::size_t listed = 0;
  for (std::size_t group = 0; group < counts.size(); ++group) {
    const auto [absent, all] = counts[group];
    if (absent == 0) continue;
    if (listed++ >= most_groups) continue;
    groups += groups.empty() ? fmt::format("{} of {} {}", absent, all, left_out.what)
                             : fmt::format(", {} of {}", absent, all);
    groups += fmt::format(" of {}", one_line(contents.groups.all()[group]));
  }
  if (listed > most_groups) groups += fmt::format(" and of {} more groups", listed - most_groups);
  return groups.empty() ? "" : fmt::format("Left out because {}: {}.", left_out.why, groups);
}

// The first group's run that several rows share, as a sentence; empty where every row is a run of its own.
std::string shared_run(const CsvFile& file, const Contents& contents, std::size_t column) {
  const Labels labels = labels_of(file, column);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> counts;
  const auto key = [&](const Observation& o) { return std::pair(o.group, labels.of_row[o.row]); };
  for (const Observation& observation : contents.observations) ++counts[key(observation)];
  for (const Observation& observation : contents.observations) {
    const std::size_t label = labels.of_row[observation.row];
    if (label == no_label || counts[key(observation)] == 1) continue;
    return fmt::format("{} rows share {} {} of {}; points of one run depend on each other and are not replicates",
                       counts[key(observation)], one_line(file.table.header[column]),
                       shortened(labels.names.all()[label], 40),
                       shortened(contents.groups.all()[observation.group], 40));
  }
  return {};
}

// Refuses rows that are no replicates, or says why they are none.
std::string flaw_of(const CsvFile& file, const Contents& contents, const CsvRequest& request) {
  for (std::size_t column = 0; column < file.table.header.size(); ++column) {
    const std::string& title = file.table.header[column];
    if (!names_replicates(title) || title == request.group || title == request.value || title == request.block)
      continue;
    const std::string shared = shared_run(file, contents, column);
    if (shared.empty()) continue;
    if (request.replicates == Replicates::as_given) return shared + "; used as observations all the same";
    file.refuse(fmt::format("{}; average them with --run {}, or insist with --force", shared, one_line(title)));
  }
  return {};
}

// The values of a group in a block, where a block is given: one each.
void expect_one_a_block(const CsvFile& file, const std::vector<Observation>& cells, const Observations& result) {
  const auto several = std::ranges::find_if(cells, [](const Observation& cell) { return cell.count > 1; });
  if (several == cells.end()) return;
  std::string run = "COLUMN";
  for (const std::string& title : file.table.header) {
    if (names_replicates(title) && run == "COLUMN") run = one_line(title);
  }
  file.refuse(fmt::format(
      "{} rows of {} in block {}, expected one; average the rows of a run and the runs of a block "
      "with --run {}, or average the rows as they are with --force",
      several->count, quoted(result.groups[several->group].name), quoted(result.blocks[several->block]), run));
}

// One value of each group in each block; the blocks that lack one are left out.
void fill_blocks(const CsvFile& file, const std::vector<Observation>& cells, Observations& result) {
  const std::size_t groups = result.groups.size();
  std::vector<std::vector<std::optional<double>>> values(result.blocks.size(),
                                                         std::vector<std::optional<double>>(groups));
  for (const Observation& cell : cells) values[cell.block][cell.group] = cell.value;
  std::vector<std::string> complete;
  std::string example;
  for (std::size_t block = 0; block < values.size(); ++block) {
    const auto absent = std::ranges::find_if_not(values[block], &std::optional<double>::has_value);
    if (absent == values[block].end()) {
      complete.push_back(result.blocks[block]);
      for (std::size_t group = 0; group < groups; ++group) {
        result.groups[group].values.push_back(*values[block][group]);
      }
    } else if (example.empty()) {
      const auto group = static_cast<std::size_t>(absent - values[block].begin());
      example = fmt::format("{} has no value of {}", quoted(result.blocks[block]), quoted(result.groups[group].name));
    }
  }
  if (complete.empty()) file.refuse("no block has a value of every group: " + example);
  if (const std::size_t left_out = values.size() - complete.size(); left_out > 0) {
    result.notes.push_back(
        fmt::format("Left out because incomplete: {} of {} blocks ({}).", left_out, values.size(), example));
  }
  result.blocks = std::move(complete);
}

// The labels of blocks and runs on the observations; the blocks' names.
std::vector<std::string> label(const CsvFile& file, const CsvRequest& request, Contents& contents) {
  std::vector<std::string> blocks;
  if (!request.block.empty()) {
    const Labels labels = expect_labels(file, file.column(request.block));
    for (Observation& observation : contents.observations) observation.block = labels.of_row[observation.row];
    blocks = labels.names.all();
  } else if (request.layout == Layout::one_column_a_group && request.rows == RowsOf::one_block) {
    for (Observation& observation : contents.observations) observation.block = observation.row;
    for (std::size_t row = 0; row < file.table.rows.size(); ++row) blocks.push_back(fmt::to_string(row + 1));
  }
  if (!request.run.empty()) {
    const Labels labels = expect_labels(file, file.column(request.run));
    for (Observation& observation : contents.observations) observation.run = labels.of_row[observation.row];
  }
  return blocks;
}

}  // namespace

Observations read_observations(std::string_view text, std::string_view source, const CsvRequest& request) {
  const CsvFile file = open_csv(text, source);
  Contents contents =
      request.layout == Layout::one_column_a_group ? read_wide(file, request) : read_long(file, request);
  if (std::ranges::none_of(contents.observations, [](const Observation& o) { return o.value.has_value(); })) {
    file.refuse("every value is missing, expected some");
  }
  const std::string quantity = request.value.empty() ? "value" : request.value;
  Observations result{
      .name = slug(quantity), .quantity = quantity, .better = request.better, .notes = std::move(contents.notes)};
  for (const std::string& name : contents.groups.all()) result.groups.push_back({.name = name});
  result.blocks = label(file, request, contents);
  result.replicate = "a row of " + file.name();
  if (const std::string note = missing_note(contents, {.what = "values", .why = "missing"}); !note.empty()) {
    result.notes.push_back(note +
                           (request.better == Better::smaller
                                ? " A failure without a number is better written Inf, which ranks as the worst."
                                : " A failure without a number is better written -Inf, which ranks as the worst."));
  }

  if (!request.run.empty()) {
    contents.observations = averaged(std::move(contents.observations), Missing::spoils_the_mean);
    const std::string rows = counts_in_words(contents.observations);
    if (rows != "1") {
      result.replicate = fmt::format("a run's mean over its {} rows of {}", rows, file.name());
      result.notes.push_back(fmt::format("Each observation is the mean over the {} rows of a run (column {}).", rows,
                                         quoted(request.run)));
      if (const std::string note = missing_note(contents, {.what = "runs", .why = "a row of them has no value"});
          !note.empty()) {
        result.notes.push_back(note);
      }
    }
  } else if (request.block.empty()) {
    result.flaw = flaw_of(file, contents, request);
  }

  if (result.blocks.empty()) {
    for (const Observation& observation : contents.observations) {
      if (observation.value) result.groups[observation.group].values.push_back(*observation.value);
    }
    return result;
  }
  for (Observation& observation : contents.observations) observation.run = 0;
  const auto cells = averaged(std::move(contents.observations), Missing::is_left_out);
  if (request.run.empty() && request.replicates == Replicates::checked) expect_one_a_block(file, cells, result);
  if (const std::string count = counts_in_words(cells); count != "1") {
    const std::string_view what = request.run.empty() ? "rows" : "runs";
    result.replicate = fmt::format("the mean over the {} {} of a block in {}", count, what, file.name());
    result.notes.push_back(
        fmt::format("Each observation is the mean over the {} {} of a group in a block.", count, what));
  }
  result.block = request.block.empty() ? "a row of " + file.name()
                                       : fmt::format("a value of {} in {}", quoted(request.block), file.name());
  fill_blocks(file, cells, result);
  return result;
}

}  // namespace ikbench
