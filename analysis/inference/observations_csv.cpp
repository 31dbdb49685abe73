#include "analysis/inference/observations_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "analysis/inference/not_finite.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/rounding.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"
#include "results/csv.hpp"

namespace ikbench::inference {

using namespace numerics;
using namespace results;
using namespace statistics;

namespace {

using Index = std::uint32_t;  // counts cells, since a text has at most max_csv_bytes
static_assert(max_csv_bytes < std::numeric_limits<Index>::max());

// Cuts the blanks at both ends.
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

// ASCII letters only.
std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return lower;
}

bool is_missing(std::string_view cell) {
  constexpr std::array<std::string_view, 8> words{"", "na", "n/a", "nan", "-nan", "null", "none", "<na>"};
  cell = trimmed(cell);
  return cell.size() <= 4 && std::ranges::find(words, lower_case(cell)) != words.end();
}

// One line, shortened, for a message.
std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest_quotation = 60;
  return fmt::format("'{}'", shortened(text, longest_quotation));
}

// Keeps letters, digits and '-' for names of files and anchors; "value" if nothing is left.
std::string slug(std::string_view text) {
  constexpr std::size_t longest_slug = 60;
  std::string result;
  for (const char c : lower_case(text)) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (kept) result += c;
    if (!kept && !result.empty() && result.back() != '-') result += '-';
  }
  result.resize(std::min(result.size(), longest_slug));
  while (result.ends_with('-')) result.pop_back();
  return result.empty() ? "value" : result;
}

constexpr std::size_t longest_name = 1000;  // of a group [bytes]

// Refuses what is no text, and a header with semicolons or tabs, as spreadsheets in other languages write it.
std::string_view expect_commas(std::string_view text, std::string_view source) {
  expect_text(text, source);
  const std::string_view titles = text.substr(0, text.find_first_of("\r\n"));
  if (titles.find_first_of(",\"") == std::string_view::npos && titles.find_first_of(";\t") != std::string_view::npos) {
    throw std::invalid_argument(fmt::format(
        "{}:1: no commas between the columns; expected them (and a point, not a comma, in a number)", source));
  }
  return text;
}

// A file with commas and at least one row. Every mistake throws std::invalid_argument: one sentence with the file, the
// row and what was expected. The text must outlive it.
class CsvFile {
 public:
  CsvFile(std::string_view text, std::string_view source)
      : source_(source), table_(view_csv(expect_commas(text, source), source)) {
    for (Index row = 0; row < table_.rows(); ++row) {
      std::size_t column = 0;
      while (column < header().size() && cell(row, column).empty()) ++column;
      if (column < header().size()) rows_.push_back(row);
    }
    if (rows_.empty()) refuse("no rows below the header; expected at least one");
  }

  const std::vector<std::string>& header() const { return table_.header; }
  // Numbers of the rows below the header that have a cell with a text: spreadsheets leave empty rows below a table.
  const std::vector<Index>& rows() const { return rows_; }
  std::string_view cell(std::size_t row, std::size_t column) const { return table_.cell(row, column); }

  // The number in a cell; not defined if it is missing: empty, NA, N/A, NaN, null, None or <NA>, in any case.
  double number(std::size_t row, std::size_t column) const {
    const std::string_view text = cell(row, column);
    if (is_missing(text)) return not_defined;
    const auto value = number_from(text);
    if (!value)
      refuse_cell(row, column, "expected a number with a decimal point, of at most 1.7e308, or NA if it is missing");
    return *value;
  }

  // A cell or a title as the name of a group, "(empty)" if there is none.
  std::string name_in(std::string_view text) const {
    const std::string_view name = trimmed(text);
    if (name.size() > longest_name) {
      refuse(fmt::format("{} has {} bytes; expected a name of at most {}", in_quotes(name), name.size(), longest_name));
    }
    return name.empty() ? "(empty)" : std::string(name);
  }

  // Refuses a missing one, and lists all columns.
  std::size_t column(std::string_view name) const {
    const auto number = std::ranges::count(header(), name);
    if (number > 1) refuse(fmt::format("two columns {}; expected one", in_quotes(name)));
    if (number == 0) {
      refuse(
          fmt::format("no column {}; expected one of: {}{}", in_quotes(name), columns(), did_you_mean(name, header())));
    }
    return static_cast<std::size_t>(std::ranges::find(header(), name) - header().begin());
  }

  // The first column with one of these names, in any case; nullopt if there is none.
  std::optional<std::size_t> column_like(std::initializer_list<std::string_view> names) const {
    for (std::size_t column = 0; column < header().size(); ++column) {
      if (std::ranges::find(names, lower_case(header()[column])) != names.end()) return column;
    }
    return std::nullopt;
  }

  // The names of all columns, for a message.
  std::string columns() const {
    constexpr std::size_t longest_list = 200;
    std::vector<std::string> titles = header();
    std::ranges::replace(titles, "", "(empty)");
    return shortened(fmt::format("{}", fmt::join(titles, ", ")), longest_list);
  }

  // Returns the name without folders, as one line.
  std::string file_name() const { return one_line(std::string_view(source_).substr(source_.rfind('/') + 1)); }

  [[noreturn]] void refuse(std::string_view what) const {
    throw std::invalid_argument(fmt::format("{}: {}", source_, what));
  }

  // The message has the row of the cell, its column and its text.
  [[noreturn]] void refuse_cell(std::size_t row, std::size_t column, std::string_view what) const {
    refuse(fmt::format("row {} below the header, column {}: {}, {}", row + 1, in_quotes(header()[column]),
                       in_quotes(cell(row, column)), what));
  }

 private:
  std::string source_;
  CsvView table_;
  std::vector<Index> rows_;
};

constexpr Index no_label = std::numeric_limits<Index>::max();

// Texts numbered in the order of their first appearance.
class Names {
 public:
  Index index_of(const std::string& name) {
    const auto [found, is_new] = indices_.try_emplace(name, static_cast<Index>(all_.size()));
    if (is_new) all_.push_back(name);
    return found->second;
  }
  const std::vector<std::string>& all() const { return all_; }

 private:
  std::unordered_map<std::string, Index> indices_;
  std::vector<std::string> all_;
};

// A value, or the mean of several rows or runs.
struct Item {
  Index group = 0, row = 0;    // the first row of it, counted below the header
  Index block = 0, run = 0;    // 0 if there are none
  bool is_whole = true;        // false: a value of it is missing
  double value = not_defined;  // not defined if missing
};

// Counts what a group lacks.
struct Lack {
  std::size_t missing = 0, all = 0;
};

struct Contents {
  Names groups;
  std::vector<Item> items;
  std::vector<std::size_t> absent_runs;  // by group; empty if runs have no numbers
};

// Returns whether a column's name says that it numbers repetitions. "fold" does not count: folds of two data sets share
// nothing but their number.
bool names_replicates(std::string_view title) {
  constexpr std::array<std::string_view, 7> words{"run", "trial", "seed", "repetition", "replicate", "rep", "repeat"};
  std::string letters = lower_case(title);
  std::erase_if(letters, [](char c) { return c < 'a' || c > 'z'; });
  for (const std::string_view suffix : {"id", "index", "number"}) {
    if (letters.ends_with(suffix)) letters.resize(letters.size() - suffix.size());
  }
  return std::ranges::find(words, letters) != words.end();
}

Index group_index(const CsvFile& file, std::string_view name, Names& groups) {
  const Index index = groups.index_of(file.name_in(name));
  if (index >= max_groups) {
    file.refuse(fmt::format("more than {} groups, the last {}; expected the names of the groups to compare", max_groups,
                            in_quotes(name)));
  }
  return index;
}

Contents read_long(const CsvFile& file, const CsvRequest& request) {
  if (request.value.empty()) {
    file.refuse(fmt::format("no column of values; name one with --value: {}", file.columns()));
  }
  const std::size_t value = file.column(request.value);
  const std::optional<std::size_t> group = request.group.empty() ? file.column_like({"group", "solver", "algorithm"})
                                                                 : std::optional(file.column(request.group));
  if (!group) file.refuse(fmt::format("no column of groups; name one with --group: {}", file.columns()));
  Contents contents;
  contents.items.reserve(file.rows().size());
  for (const Index row : file.rows()) {
    contents.items.push_back({.group = group_index(file, file.cell(row, *group), contents.groups),
                              .row = row,
                              .value = file.number(row, value)});
  }
  return contents;
}

// Returns whether a column holds row numbers, as pandas and R write them, or is empty, as spreadsheets leave it.
bool is_index(const CsvFile& file, std::size_t column) {
  const std::string& title = file.header()[column];
  const auto is_empty = [&](Index row) { return file.cell(row, column).empty(); };
  return (column == 0 && (title.empty() || title == "Unnamed: 0")) ||
         (title.empty() && std::ranges::all_of(file.rows(), is_empty));
}

Contents read_wide(const CsvFile& file, const CsvRequest& request, std::vector<std::string>& notes) {
  if (!request.group.empty()) {
    file.refuse(
        fmt::format("--group {}: with --wide every column is a group; leave out --group", in_quotes(request.group)));
  }
  Contents contents;
  for (std::size_t column = 0; column < file.header().size(); ++column) {
    const std::string& title = file.header()[column];
    const bool is_asked_for = !title.empty() && (title == request.block || title == request.run);
    if (is_index(file, column) || is_asked_for) continue;
    if (names_replicates(title)) {
      notes.push_back(fmt::format("Column {} numbers the repetitions and is not a group.", in_quotes(title)));
      continue;
    }
    const std::size_t groups_before = contents.groups.all().size();
    const Index group = group_index(file, title, contents.groups);
    if (group < groups_before) file.refuse(fmt::format("two columns {}; expected one", in_quotes(title)));
    for (const Index row : file.rows()) {
      contents.items.push_back({.group = group, .row = row, .value = file.number(row, column)});
    }
  }
  if (contents.items.empty()) file.refuse("no column of values; expected one for each group");
  return contents;
}

// Refuses values without a meaning, and takes logarithms if they are asked for.
void check_values(const CsvFile& file, const CsvRequest& request, std::vector<Item>& items) {
  const auto is_missing_value = [](const Item& item) { return std::isnan(item.value); };
  if (std::ranges::all_of(items, is_missing_value)) file.refuse("all values are missing; expected at least one");
  const double best = request.better == Better::smaller ? -HUGE_VAL : HUGE_VAL;  // would beat every number
  for (Item& item : items) {
    if (item.value == best) {
      file.refuse(fmt::format(
          "row {} below the header: {}Inf, but {} values are better; expected a finite number, or {}Inf for a failure",
          item.row + 1, best > 0 ? "" : "-", best > 0 ? "larger" : "smaller", best > 0 ? "-" : ""));
    }
    if (request.scale != ValueScale::log10) continue;
    if (item.value <= 0) {
      file.refuse(fmt::format("row {} below the header: {} has no logarithm; expected positive values for typical ones",
                              item.row + 1, item.value));
    }
    item.value = std::log10(item.value);
  }
}

// Numbers the blocks or runs (`field`) by the texts of a column, and returns these.
std::vector<std::string> label(const CsvFile& file, std::size_t column, Index Item::*field, bool may_lack,
                               std::vector<Item>& items) {
  Names names;
  for (Item& item : items) {
    const std::string_view text = file.cell(item.row, column);
    if (is_missing(text) && !may_lack) file.refuse_cell(item.row, column, "expected a name or a number");
    item.*field = is_missing(text) ? no_label : names.index_of(std::string(trimmed(text)));
  }
  return names.all();
}

// Several items of one group with the same block or run.
struct Shared {
  std::ptrdiff_t count = 0;  // 0 if there are none
  Index group = 0, label = 0;
};

Shared shared(const std::vector<Item>& items, Index Item::*field) {
  std::vector<std::pair<Index, Index>> keys;
  keys.reserve(items.size());
  for (const Item& item : items) {
    if (item.*field != no_label) keys.emplace_back(item.group, item.*field);
  }
  std::ranges::sort(keys);
  const auto first = std::ranges::adjacent_find(keys);
  if (first == keys.end()) return {};
  return {.count = std::ranges::count(keys, *first), .group = first->first, .label = first->second};
}

// Counts the runs that each group lacks. Groups that have a run in common were given the same runs.
std::vector<std::size_t> absent_runs(const Contents& contents) {
  const std::size_t groups = contents.groups.all().size();
  std::vector<std::pair<Index, Index>> keys;  // run and group
  keys.reserve(contents.items.size());
  for (const Item& item : contents.items) {
    if (item.run != no_label) keys.emplace_back(item.run, item.group);
  }
  std::ranges::sort(keys);
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  std::vector<std::size_t> kin(groups);  // the first of the groups that were given the same runs
  std::iota(kin.begin(), kin.end(), 0);
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const std::size_t one = kin[keys[i - 1].second], other = kin[keys[i].second];
    if (keys[i - 1].first == keys[i].first && one != other) std::ranges::replace(kin, other, one);
  }
  std::vector<std::size_t> given(groups), absent(groups);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i - 1].first != keys[i].first) ++given[kin[keys[i].second]];
  }
  for (std::size_t group = 0; group < groups; ++group) absent[group] = given[kin[group]];
  for (const auto& [run, group] : keys) --absent[group];
  return absent;
}

// Refuses rows that share a run, or tells of them if they are taken as given: they are no replicates.
void look_for_runs(const CsvFile& file, const CsvRequest& request, Contents& contents, Observations& result) {
  for (std::size_t column = 0; column < file.header().size() && result.flaws.empty(); ++column) {
    const std::string& title = file.header()[column];
    if (!names_replicates(title) || title == request.group || title == request.value) continue;
    const std::vector<std::string> runs = label(file, column, &Item::run, true, contents.items);
    const Shared found = shared(contents.items, &Item::run);
    if (found.count == 0) {
      if (std::ranges::count(contents.absent_runs, 0U) == std::ssize(contents.absent_runs))
        contents.absent_runs = absent_runs(contents);
      continue;
    }
    const std::string run = one_line(title);
    const std::string words =
        fmt::format("{} rows share {} {} of {}", found.count, run, shortened(runs[found.label], 40),
                    shortened(contents.groups.all()[found.group], 40));
    if (!request.takes_any_rows) {
      file.refuse(fmt::format(
          "{0}, and are not replicates; average rows that depend on each other, such as points of a path, with --run "
          "{1}; compare problems that were solved separately within blocks with --block COLUMN --run {1}; or use --force",
          words, run));
    }
    result.flaws.push_back({.kind = DoubtKind::rows_share_a_run, .what = words});
  }
  if (!result.flaws.empty()) contents.absent_runs.clear();
}

// The numbers of items in the averages of a CSV: of those that are used, and of all.
struct Averaged {
  std::size_t least = 0, most = 0, fullest = 0;
  std::ptrdiff_t full = 0;  // averages with `fullest`

  std::string words() const { return least == most ? fmt::to_string(most) : fmt::format("{} to {}", least, most); }
};

// Averages the items of each group, block and run. A mean is whole if it has as many values as the fullest of its
// block. Otherwise it is missing, unless rows are taken as given.
Averaged average(const CsvRequest& request, std::vector<Item>& items) {
  const auto key = [](const Item& item) { return std::tuple(item.group, item.block, item.run); };
  std::ranges::stable_sort(items, {}, key);
  std::vector<Item> means;
  std::vector<std::size_t> counts, sizes, used;
  std::unordered_map<Index, std::size_t> most;  // by block; counts items without a value too
  for (std::size_t first = 0, end = 0; first < items.size(); first = end) {
    Item& of_all = means.emplace_back(items[first]);
    std::vector<double> values;
    for (end = first; end < items.size() && key(items[end]) == key(of_all); ++end) {
      of_all.is_whole = of_all.is_whole && items[end].is_whole;
      if (!std::isnan(items[end].value)) values.push_back(items[end].value);
    }
    of_all.value = mean(values);
    counts.push_back(values.size());
    sizes.push_back(end - first);
    most[of_all.block] = std::max(most[of_all.block], end - first);
  }
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (counts[i] != most[means[i].block]) {
      means[i].is_whole = false;
      if (!request.takes_any_rows) means[i].value = not_defined;
    }
    if (!std::isnan(means[i].value)) used.push_back(counts[i]);
  }
  items = std::move(means);
  const std::size_t fullest = std::ranges::max(sizes);
  return {.least = used.empty() ? 0 : std::ranges::min(used),
          .most = used.empty() ? 0 : std::ranges::max(used),
          .fullest = fullest,
          .full = std::ranges::count(sizes, fullest)};
}

// Adds the doubt that values are missing, "3 of 20 runs of IK-BA, 1 of 20 of BA", or were averaged without them.
void add_lacks(const std::vector<Lack>& lacks, std::string_view what, bool are_averaged, std::string_view consequence,
               Observations& result) {
  constexpr std::size_t most_groups = 12;
  std::string words;
  std::size_t listed = 0;
  for (std::size_t group = 0; group < lacks.size(); ++group) {
    const auto [missing, all] = lacks[group];
    if (missing == 0 || listed++ >= most_groups) continue;
    words += words.empty() ? fmt::format("{} of {} {}", missing, all, what) : fmt::format(", {} of {}", missing, all);
    words += fmt::format(" of {}", one_line(result.groups[group].name));
  }
  if (listed > most_groups) words += fmt::format(" and of {} more groups", listed - most_groups);
  if (listed > 0) {
    result.flaws.push_back(
        {.kind = are_averaged ? DoubtKind::uneven_runs : DoubtKind::values_missing, .what = words.append(consequence)});
  }
}

// Joins a group's equal measurements to one: they are copies. Keeps equal whole numbers, which may be chance, unless no
// group varies and the groups differ. Keeps outcomes of 0 and 1.
void join_equal(Observations& result, std::string_view what) {
  const bool is_log = result.scale == ValueScale::log10;
  const auto given = [&](double value) { return is_log ? std::pow(10, value) : value; };
  const auto is_constant = [&](const Group& group) {
    if (group.values.size() < 2) return false;
    const double first = group.values.front();
    return std::ranges::all_of(group.values, [&](double value) {  // one is added for logarithms near 0
      return value == first || without_rounding(value - first, std::abs(first) + (is_log ? 1 : 0)) == 0;
    });
  };
  const bool none_varies =
      std::ranges::all_of(result.groups, is_constant) && std::ranges::any_of(result.groups, [&](const Group& group) {
        return group.values.front() != result.groups.front().values.front();
      });
  const bool are_outcomes = std::ranges::all_of(result.groups, [&](const Group& group) {
    return std::ranges::all_of(group.values, [&](double value) { return given(value) == 0 || given(value) == 1; });
  });
  std::vector<std::string> names;
  for (Group& group : result.groups) {
    if (!is_constant(group) || are_outcomes || !std::isfinite(group.values.front())) continue;
    const double value = given(group.values.front());
    if (value == std::round(value) && !none_varies) continue;
    names.push_back(fmt::format("{} ({})", one_line(group.name), group.values.size()));
    group.values.resize(1);
  }
  if (names.empty()) return;
  result.notes.push_back(fmt::format(
      "Equal {0} are one observation: all {0} of {1} have the same value, to the last bit, so no test uses "
      "them as repetitions, and more of them change nothing. For a test, compare over several problems (--block COLUMN).",
      what, fmt::join(names, ", ")));
}

// Takes the observations of independent groups.
void fill_groups(const CsvRequest& request, const Contents& contents, Observations& result) {
  std::vector<Lack> lacks(result.groups.size());
  for (std::size_t group = 0; group < contents.absent_runs.size(); ++group) {
    lacks[group] = {contents.absent_runs[group], contents.absent_runs[group]};
  }
  for (const Item& item : contents.items) {
    if (!std::isnan(item.value)) result.groups[item.group].values.push_back(item.value);
    lacks[item.group].missing += std::isnan(item.value) || !item.is_whole ? 1 : 0;
    ++lacks[item.group].all;
  }
  const bool are_there =
      std::ranges::none_of(contents.items, [](const Item& item) { return std::isnan(item.value); }) &&
      std::ranges::all_of(contents.absent_runs, [](std::size_t count) { return count == 0; });
  add_lacks(lacks, request.run.empty() ? "values" : "runs", are_there, "", result);
  join_equal(result, request.run.empty() ? "rows" : "runs");
}

// Takes one observation for each group in each block. Leaves out blocks that lack one.
void fill_blocks(const CsvFile& file, const CsvRequest& request, Contents& contents, Observations& result) {
  const std::string_view what = request.run.empty() ? "rows" : "runs";
  const Shared several = shared(contents.items, &Item::block);
  if (several.count > 0 && result.blocks.size() == 1) {
    file.refuse(fmt::format("all rows are in one block, {}, within which nothing can be judged; leave out --block",
                            in_quotes(result.blocks.front())));
  }
  if (several.count > 0 && request.run.empty() && !request.takes_any_rows) {
    file.refuse(fmt::format(
        "{} rows of {} in block {}; expected one; average rows and runs with --run COLUMN, or all rows with --force",
        several.count, in_quotes(result.groups[several.group].name), in_quotes(result.blocks[several.label])));
  }
  for (Item& item : contents.items) item.run = 0;
  if (const Averaged averaged = average(request, contents.items); averaged.most > 1) {
    result.replicate =
        fmt::format("the mean over the {} {} of a block in {}", averaged.words(), what, file.file_name());
  }
  result.block = request.block.empty() ? "a row of " + file.file_name()
                                       : fmt::format("a value of {} in {}", in_quotes(request.block), file.file_name());

  std::vector<std::vector<const Item*>> items(result.blocks.size(), std::vector<const Item*>(result.groups.size()));
  std::vector<Lack> left_out(result.groups.size(), {0, result.blocks.size()}), averaged = left_out;
  for (const Item& item : contents.items) items[item.block][item.group] = &item;
  const auto has_value = [](const Item* item) { return item != nullptr && !std::isnan(item->value); };
  std::vector<std::size_t> order(items.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!request.block.empty())  // the order of rows must not decide what a bootstrap draws
    std::ranges::sort(order, {}, [&](std::size_t block) { return std::string_view(result.blocks[block]); });
  std::vector<std::string> complete;
  for (const std::size_t block : order) {
    const bool is_left_out = !std::ranges::all_of(items[block], has_value);
    for (std::size_t group = 0; group < result.groups.size(); ++group) {
      const Item* item = items[block][group];
      (is_left_out ? left_out : averaged)[group].missing += has_value(item) && item->is_whole ? 0 : 1;
    }
    if (is_left_out) continue;
    complete.push_back(result.blocks[block]);
    for (std::size_t group = 0; group < result.groups.size(); ++group) {
      result.groups[group].values.push_back(items[block][group]->value);
    }
  }
  if (complete.empty()) {
    file.refuse(fmt::format("no block has a value for every group{}",
                            request.takes_any_rows ? "" : "; --force averages the values that exist"));
  }
  add_lacks(left_out, "blocks", false, "; these blocks are left out for all groups", result);
  add_lacks(averaged, "blocks", true, "", result);
  result.blocks = std::move(complete);
}

}  // namespace

Observations read_observations(std::string_view text, std::string_view source, const CsvRequest& request) {
  const CsvFile file(text, source);
  const std::string quantity =
      (request.scale == ValueScale::log10 ? "typical " : "") + (request.value.empty() ? "value" : request.value);
  Observations result{.name = slug(quantity),
                      .quantity = quantity,
                      .unit = split_unit(quantity).unit,
                      .better = request.better,
                      .scale = request.scale,
                      .replicate = "a row of " + file.file_name()};
  Contents contents = request.is_wide ? read_wide(file, request, result.notes) : read_long(file, request);
  check_values(file, request, contents.items);
  for (const std::string& name : contents.groups.all()) result.groups.push_back({.name = name});
  if (!request.block.empty()) {
    result.blocks = label(file, file.column(request.block), &Item::block, false, contents.items);
  } else if (request.is_wide && request.rows_are_blocks) {
    for (const Index row : file.rows()) result.blocks.push_back(fmt::to_string(row + 1));
    for (Item& item : contents.items) {
      item.block = static_cast<Index>(std::ranges::lower_bound(file.rows(), item.row) - file.rows().begin());
    }
  }
  if (request.run.empty() && request.block.empty()) look_for_runs(file, request, contents, result);
  if (!request.run.empty()) {
    label(file, file.column(request.run), &Item::run, false, contents.items);
    const Averaged rows = average(request, contents.items);
    if (2 * rows.full < std::ssize(contents.items) && result.blocks.empty() && !request.takes_any_rows) {
      file.refuse(
          fmt::format("only {} of {} runs have {} rows; a row may be duplicated, or rows may be missing; "
                      "--force averages them as they are",
                      rows.full, contents.items.size(), rows.fullest));
    }
    if (rows.most == 0) file.refuse("no run has a value in each of its rows; --force averages the rows that have one");
    if (rows.most > 1)
      result.replicate = fmt::format("the mean of a run over its {} rows of {}", rows.words(), file.file_name());
    if (result.blocks.empty()) contents.absent_runs = absent_runs(contents);
  }
  if (result.blocks.empty()) {
    fill_groups(request, contents, result);
  } else {
    fill_blocks(file, request, contents, result);
  }
  std::ranges::move(notes_of_not_finite(result.groups), std::back_inserter(result.notes));
  return result;
}

namespace {

std::size_t expect_column(const CsvFile& file, std::initializer_list<std::string_view> titles) {
  if (const auto column = file.column_like(titles)) return *column;
  file.refuse(fmt::format("no column {}; found only: {}", fmt::join(titles, " or "), file.columns()));
}

}  // namespace

std::vector<Observations> read_summaries(std::string_view text, std::string_view source) {
  const CsvFile file(text, source);
  const std::size_t name = expect_column(file, {"name", "group", "solver", "algorithm"});
  const std::size_t mean = expect_column(file, {"mean"}), std = expect_column(file, {"sd", "std", "stddev"});
  const std::size_t n = expect_column(file, {"n", "count"});
  const auto quantity = file.column_like({"metric", "quantity", "variable"});

  std::vector<Observations> result;
  std::size_t groups = 0;
  for (const Index row : file.rows()) {
    const double count = file.number(row, n);
    GroupSummary summary{.mean = file.number(row, mean), .std = file.number(row, std)};
    if (!(count >= 1 && count <= std::numeric_limits<int>::max() && count == std::floor(count))) {
      file.refuse_cell(row, n, "expected the number of observations, a whole number from 1");
    }
    summary.n = static_cast<int>(count);
    if (!std::isfinite(summary.mean)) file.refuse_cell(row, mean, "expected a finite number");
    const bool is_single = summary.n == 1 && std::isnan(summary.std);  // one value has no spread
    if (!is_single && !(summary.std >= 0 && std::isfinite(summary.std))) {
      file.refuse_cell(row, std, "expected a standard deviation, a finite number from 0");
    }

    const std::string of = quantity ? file.name_in(file.cell(row, *quantity)) : "value";
    auto summaries = std::ranges::find(result, of, &Observations::quantity);
    if (summaries == result.end()) {
      result.push_back({.name = slug(of), .quantity = of, .unit = split_unit(of).unit});
      summaries = result.end() - 1;
    }
    double all = count;
    std::string group = file.name_in(file.cell(row, name));
    for (const Group& other : summaries->groups) {
      if (other.name == group) file.refuse_cell(row, name, "given twice; expected each group once per metric");
      all += other.summary->n;
    }
    if (all > std::numeric_limits<int>::max()) file.refuse_cell(row, n, "expected at most 2147483647 in all groups");
    if (++groups > max_groups) file.refuse(fmt::format("expected at most {} groups", max_groups));
    summaries->groups.push_back({.name = std::move(group), .summary = summary});
  }
  return result;
}

}  // namespace ikbench::inference
