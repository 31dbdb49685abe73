#include "analysis/csv/user_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

#include "analysis/csv/google_benchmark.hpp"
#include "analysis/csv/question.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::csv {
namespace {

using namespace judge;
using Index = std::uint32_t;

constexpr std::size_t most_groups = 100;

// One cell of values.
struct Value {
  Index group, unit, row, column;  // unit: block, run or the value itself
  double value;
};

// The mean of all values of one group and unit.
struct Mean {
  Index group, unit, first;     // first: first row
  Index rows = 0, missing = 0;  // rows with and without a value
  long double sum = 0;          // exact enough that the order of rows does not change the mean
};

// All values of one quantity.
struct Items {
  std::vector<std::string> groups;
  std::vector<Value> values;  // ordered by group and unit
  std::vector<Mean> means;    // one per group and unit
  Index units = 0;
  std::size_t unlabelled = 0;
};

// Adds the means of all groups and units. Refuses a mean whose rows have different texts.
void add_means(const Sheet& sheet, const Layout& layout, const Request& request, Items& items) {
  Columns texts = layout.unused;
  std::erase_if(texts, [&](std::size_t column) { return sheet.has_numbers(column); });
  std::ranges::sort(items.values, {}, [](const Value& item) { return std::tuple(item.group, item.unit, item.row); });
  items.means.reserve(items.values.size());
  for (const Value& item : items.values) {
    if (items.means.empty() || items.means.back().group != item.group || items.means.back().unit != item.unit)
      items.means.push_back({.group = item.group, .unit = item.unit, .first = item.row});
    else if (layout.block && request.run.empty())
      sheet.refuse(
          item.row, *layout.block,
          fmt::format(
              "is a second row of {}; name the column of repeats with --run (--run row: each row is one repeat)",
              in_quotes(items.groups[item.group])));
    Mean& mean = items.means.back();
    if (std::isnan(item.value)) {
      ++mean.missing;
    } else {
      mean.sum += item.value;
      ++mean.rows;
    }
    for (const std::size_t column : texts)  // a column of texts may name quantities, whose mean has no meaning
      if (const auto first = sheet.cell(items.means.back().first, column); first != sheet.cell(item.row, column))
        sheet.refuse(
            item.row, column,
            fmt::format(
                "is not {}, as in other rows of the same mean; name its column with --label, --block, --run or --where",
                in_quotes(first)));
  }
}

// Refuses labels that name each row, or few rows. Only a table of printed means should have such labels.
void expect_repeats(const Sheet& sheet, const Layout& layout, const Items& items, const Request& request) {
  if (!layout.label) return;
  const std::string title = in_quotes(sheet.titles()[*layout.label]);
  const bool is_each_row =
      items.groups.size() == items.values.size() && items.values.size() > 2;  // two rows may be a sketch
  if (is_each_row) sheet.refuse_units(*layout.label);
  if (is_each_row && are_summaries(sheet)) {
    MissingOption asked(
        sheet.said(fmt::format("{} has another name in each row, as in a table of published means", title)));
    answer_by_summaries(
        sheet, asked,
        request.better.empty() ? std::vector<std::string>{"--better", "smaller"} : std::vector<std::string>());
    throw asked;
  }
  if (is_each_row)
    sheet.refuse(
        fmt::format("{} has another name in each row, so no group has two values; did you mean --block?", title));
  if (items.unlabelled > items.values.size())
    sheet.refuse(fmt::format("{} has no name in {} of {} rows; if its cells are merged, write the name into each row",
                             title, items.unlabelled, sheet.rows().size()));
}

Items items_of(Sheet& sheet, const Layout& layout, const Columns& columns, const Request& request) {
  const Column unit = layout.block ? layout.block : layout.run;
  std::unordered_map<std::string_view, Index> groups, units;  // numbered in the order of their first row
  Items items;
  items.values.reserve(columns.size() * sheet.rows().size());
  for (const std::size_t column : columns) {
    std::size_t end = sheet.rows().size();
    if (!layout.label && !unit)  // columns of unequal length
      while (end > 0 && sheet.cell(sheet.rows()[end - 1], column).empty()) --end;
    if (end == 0) sheet.refuse(fmt::format("{} is empty", in_quotes(sheet.titles()[column])));
    for (const Index row : std::span(sheet.rows()).first(end)) {
      const std::string_view name = layout.label ? sheet.cell(row, *layout.label) : sheet.titles()[column];
      items.unlabelled += name.empty();
      if (name.empty()) continue;
      if (unit && sheet.cell(row, *unit).empty())
        sheet.refuse(row, *unit, "is not a name; if cells are merged, write the name into each row");
      const Index group = groups.try_emplace(name, static_cast<Index>(groups.size())).first->second;
      if (group == items.groups.size()) items.groups.emplace_back(name);
      if (group == most_groups)
        sheet.refuse(fmt::format("--label makes more than {} groups; did you mean --block?", most_groups));
      const auto next = static_cast<Index>(unit ? units.size() : items.values.size());
      items.values.push_back({.group = group,
                              .unit = unit ? units.try_emplace(sheet.cell(row, *unit), next).first->second : next,
                              .row = row,
                              .column = static_cast<Index>(column),
                              .value = sheet.number(row, column)});
    }
  }
  std::set<std::string> shown;
  for (const std::string& name : items.groups)
    if (!shown.emplace(base::trimmed(base::one_line(name))).second)
      sheet.refuse(fmt::format("two groups look alike, both as {}; rename one", in_quotes(name)));
  expect_repeats(sheet, layout, items, request);
  items.units = static_cast<Index>(units.size());
  add_means(sheet, layout, request, items);
  return items;
}

// Asks whether smaller or larger is better in a column. `are_others_said` is true if the user answered for other
// columns.
[[noreturn]] void ask_better(const Sheet& sheet, const std::string& title, bool is_one_of_several,
                             bool are_others_said) {
  MissingOption question(sheet.said(
      fmt::format("is smaller or larger better in {}? Say --better smaller or --better larger{}", in_quotes(title),
                  is_one_of_several ? fmt::format("; for this column only: --better {}=larger", title) : "")));
  for (const char* way : {"smaller", "larger"})
    question.answers.push_back({"--better", are_others_said ? fmt::format("{}={}", title, way) : way});
  throw question;
}

// Refuses a --better that says neither, before any question that would repeat it in its commands.
void refuse_wrong_directions(const Sheet& sheet, const Request& request) {
  for (const std::string_view option : request.better) {
    const std::string_view direction = option.substr(option.rfind('=') + 1);
    if (direction != "smaller" && direction != "larger")
      sheet.refuse(fmt::format("--better {}; expected smaller, larger or COLUMN=larger", in_quotes(option)));
  }
}

// Returns for each title whether smaller or larger is better. Asks if the user did not say so, because neither names
// nor numbers say so.
std::vector<Better> better_of(const Sheet& sheet, const Request& request, const std::vector<std::string>& titles) {
  std::map<std::string_view, std::string_view> directions;  // by column; "": for all columns
  for (const std::string_view option : request.better) {
    const std::size_t at = option.rfind('=') + 1;  // 0: for all columns
    const std::string_view direction = option.substr(at), column = option.substr(0, at > 0 ? at - 1 : 0);
    if (!column.empty() && std::ranges::count(titles, column) == 0)
      sheet.refuse(
          fmt::format("--better {}: {}", in_quotes(option), base::unknown_name("column of values", column, titles)));
    if (directions.try_emplace(column, direction).first->second != direction)
      sheet.refuse(fmt::format("--better {} contradicts an earlier --better; expected one of them", in_quotes(option)));
  }
  std::vector<Better> better;
  for (const std::string& title : titles) {
    const std::string_view direction = directions.contains(title) ? directions[title] : directions[""];
    if (direction.empty()) ask_better(sheet, title, titles.size() > 1, !request.better.empty());
    better.push_back(direction == "larger" ? Better::larger : Better::smaller);
  }
  return better;
}

MetricSamples quantity_of(const std::string& title) {
  const base::Title parts(title);
  MetricSamples samples{.metric = "", .quantity = parts.name, .unit = parts.unit};
  for (const char c : base::lower_case(title))
    samples.metric += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '-';
  return samples;
}

// The rows without a value, among the rows that a group should have. In a block, each group should have as many rows as
// the largest group, since all groups had the same problems. Without blocks no number of rows is expected, because a
// run may end early.
struct Gaps {
  std::vector<Index> rows_of_unit;         // empty if there are no blocks
  std::vector<std::size_t> missing, rows;  // by group

  bool are_any() const {
    return std::ranges::any_of(missing, [](std::size_t count) { return count > 0; });
  }
  double share(std::size_t group) const {
    return static_cast<double>(missing[group]) / static_cast<double>(std::max<std::size_t>(1, rows[group]));
  }
};

Gaps gaps_of(const Layout& layout, const Items& items) {
  Gaps gaps{.rows_of_unit = std::vector<Index>(layout.block ? items.units : 0),
            .missing = std::vector<std::size_t>(items.groups.size()),
            .rows = std::vector<std::size_t>(items.groups.size())};
  if (layout.block) {
    std::size_t all = 0;
    for (const Mean& mean : items.means) {
      Index& rows = gaps.rows_of_unit[mean.unit];
      rows = std::max(rows, mean.rows + mean.missing);
    }
    for (const Index rows : gaps.rows_of_unit) all += rows;
    std::ranges::fill(gaps.rows, all);
    std::ranges::fill(gaps.missing, all);
    for (const Mean& mean : items.means) gaps.missing[mean.group] -= mean.rows;
    return gaps;
  }
  for (const Mean& mean : items.means) {
    gaps.rows[mean.group] += mean.rows + mean.missing;
    gaps.missing[mean.group] += mean.missing;
  }
  return gaps;
}

// Asks what missing values count as, if the user did not say so.
void ask_about(const Gaps& gaps, const Sheet& sheet, const Items& items, const Request& request) {
  if (!request.missing.empty() || !gaps.are_any()) return;
  std::vector<std::string> who;
  std::size_t missing = 0, rows = 0;
  for (std::size_t i = 0; i < items.groups.size(); ++i) {
    missing += gaps.missing[i];
    rows += gaps.rows[i];
    if (gaps.missing[i] > 0) who.push_back(fmt::format("{} {}", items.groups[i], gaps.missing[i]));
  }
  const std::string drop = "--missing drop leaves them out", worst = "--missing worst counts them as no answer";
  MissingOption question(sheet.said(fmt::format("{} of {} rows have no value ({}). What should they count as? {}",
                                                missing, rows, base::front(base::listed(who, ", "), 300),
                                                request.are_means ? drop : drop + "; " + worst)));
  question.answers = {{"--missing", "drop"}};
  if (!request.are_means) question.answers.push_back({"--missing", "worst"});
  throw question;
}

// Returns the value of a group in a unit with missing rows, each of which counts as no answer.
double worst_value(const MetricSamples& samples, double sum, double rows, double missing) {
  const bool is_larger_better = samples.better == Better::larger;
  if (is_proportion(samples)) return (sum + (is_larger_better ? 0 : missing)) / (rows + missing);
  return is_larger_better ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

// Returns the sample of one group, with one value per unit.
Sample sample_in(const Layout& layout, std::span<const Mean> means, const Gaps& gaps, const Request& request,
                 const MetricSamples& samples) {
  Sample measured;
  const bool is_worst = request.missing == "worst";
  const auto add = [&](Index unit, double value) {
    measured.values.push_back(value);
    if (layout.block && request.missing == "drop" && gaps.are_any()) measured.blocks.push_back(static_cast<int>(unit));
  };
  Index next = 0;  // the next unit that no row had yet
  const auto add_absent = [&](Index end) {
    for (; next < end; ++next) add(next, worst_value(samples, 0, 0, gaps.rows_of_unit[next]));
  };
  for (const Mean& mean : means) {
    if (layout.block && is_worst) add_absent(mean.unit);
    next = mean.unit + 1;
    const Index missing = layout.block ? gaps.rows_of_unit[mean.unit] - mean.rows : mean.missing;
    const auto sum = static_cast<double>(mean.sum);
    if (missing > 0 && is_worst)
      add(mean.unit, worst_value(samples, sum, mean.rows, missing));
    else if (mean.rows > 0)
      add(mean.unit, static_cast<double>(mean.sum / mean.rows));
  }
  if (layout.block && is_worst) add_absent(static_cast<Index>(gaps.rows_of_unit.size()));
  // Infinite values, such as time-outs, have no known end, so equal ones are not repeats.
  const std::vector<double>& values = measured.values;
  measured.is_constant = values.size() > 1 && std::isfinite(values.front()) &&
                         std::ranges::count(values, values.front()) == std::ssize(values);
  return measured;
}

// Adds the warnings about values that are missing, that are no answers, or that have no label.
void add_warnings(const Items& items, const Gaps& gaps, const Request& request, MetricSamples& samples) {
  Warning missing{.kind = WarningKind::incomplete,
                  .detail = request.missing == "worst" ? "rows have no value and count as no answer"
                                                       : "rows have no value and are left out"};
  Warning without{.kind = WarningKind::no_answer, .detail = "values are infinite, which means no answer"};
  const auto add = [](Warning& warning, const std::string& group, std::size_t count) {
    if (count == 0) return;
    warning.solvers.push_back(group);
    warning.count += static_cast<double>(count);
  };
  std::vector<std::size_t> infinite(items.groups.size());
  for (const Value& item : items.values) infinite[item.group] += std::isinf(item.value);
  double least = 1, most = 0;
  for (std::size_t i = 0; i < items.groups.size(); ++i) {
    const bool has_values = gaps.missing[i] < gaps.rows[i];
    add(missing, items.groups[i], gaps.missing[i]);
    add(without, items.groups[i], infinite[i]);
    for (Warning* const warning : {&missing, &without}) warning->total += static_cast<double>(gaps.rows[i]);
    if (!has_values) continue;  // a group without values is not compared
    least = std::min(least, gaps.share(i));
    most = std::max(most, gaps.share(i));
  }
  Warning favoured{.kind = WarningKind::favoured_by_drop,
                   .count = most > least + 0.1 && request.missing == "drop" ? 1.0 : 0.0,
                   .detail = fmt::format("{:.0f} to {:.0f} %", 100 * least, 100 * most)};
  for (std::size_t i = 0; i < items.groups.size(); ++i)
    if (gaps.share(i) > least + 0.1 && gaps.missing[i] < gaps.rows[i]) favoured.solvers.push_back(items.groups[i]);
  Warning stray{.kind = WarningKind::runs_missing,
                .count = static_cast<double>(items.unlabelled),
                .total = static_cast<double>(items.unlabelled + items.values.size()),
                .detail = "rows without a label, left out"};
  for (Warning* warning : {&missing, &without, &stray, &favoured})
    if (warning->count > 0) samples.warnings.push_back(std::move(*warning));
}

// Adds a warning if no value of a group differs from block to block: the blocks may be one measurement that was copied.
void warn_of_copies(MetricSamples& samples) {
  if (is_proportion(samples)) return;
  Warning copies{.kind = WarningKind::may_be_one_measurement};
  for (const Group& group : samples.groups)
    if (is_constant(group)) copies.solvers.push_back(group.name);
  if (copies.solvers.size() > 1) samples.warnings.push_back(std::move(copies));
}

// Adds the values of all groups to the samples, and the warnings about these values.
void fill(const Layout& layout, const Items& items, const Gaps& gaps, const Request& request, MetricSamples& samples) {
  samples.is_paired = layout.block.has_value();
  samples.may_hold_copies = !layout.block && request.run.empty() && !is_proportion(samples);
  if (is_proportion(samples))
    samples.kind =
        judge::Proportions{.trials_per_value = static_cast<int>(std::ranges::max(items.means, {}, &Mean::rows).rows)};
  for (Index group = 0; group < items.groups.size(); ++group) {
    const std::span means(std::ranges::lower_bound(items.means, group, {}, &Mean::group),
                          std::ranges::upper_bound(items.means, group, {}, &Mean::group));
    samples.groups.push_back({.name = items.groups[group], .sample = sample_in(layout, means, gaps, request, samples)});
  }
  add_warnings(items, gaps, request, samples);
  if (layout.block) warn_of_copies(samples);
}

// Chooses proportions, ratios or differences by all values, and notes the choice.
void settle(const Items& items, MetricSamples& samples, std::vector<std::string>& notes) {
  const auto count = [&](auto is_so) { return std::ranges::count_if(items.values, is_so, &Value::value); };
  const auto shares = count([](double value) { return value == 0 || value == 1; });
  const auto low = count([](double value) { return value <= 0; });
  if (shares > 0 && shares + count([](double value) { return std::isnan(value); }) == std::ssize(items.values)) {
    samples.kind = judge::Proportions{};
    notes.push_back(fmt::format("All values of {} are 0 or 1: shares are compared.", samples.quantity));
  } else if (low > 0) {
    samples.kind = judge::Differences{};
    notes.push_back(fmt::format("{} of {} values of {} are 0 or below: differences are compared, not ratios.", low,
                                items.values.size(), samples.quantity));
  }
}

// Returns a sentence that says what the rows were taken for.
std::string how_read(const Sheet& sheet, const Layout& layout, const Items& items,
                     const std::vector<std::string>& where) {
  const auto of = [&](Column column) {  // a title may be no noun
    return column ? fmt::format(" ({})", base::one_line(base::front(sheet.titles()[*column], 60))) : "";
  };
  std::string text = base::counted(std::ssize(items.groups), layout.label ? "labels" : "columns") + of(layout.label);
  if (const Column unit = layout.block ? layout.block : layout.run)
    text += ", " + base::counted(items.units, layout.block ? "blocks" : "runs") + of(unit);
  Index fewest = std::numeric_limits<Index>::max(), most = 0;  // rows of a mean that has a value
  for (const Mean& mean : items.means) {
    if (mean.rows == 0) continue;
    fewest = std::min(fewest, mean.rows);
    most = std::max(most, mean.rows);
  }
  if (most > 1) text += fmt::format(", means of {}{} rows", fewest < most ? fmt::format("{} to ", fewest) : "", most);
  if (!layout.block && !layout.run) text += ", rows are independent";
  std::vector<std::string> unused;
  for (const std::size_t column : layout.unused) unused.push_back(in_quotes(sheet.titles()[column]));
  for (const std::string& condition : where) text += fmt::format("; only rows with {}", in_quotes(condition));
  if (!unused.empty()) text += fmt::format("; not used: {}", base::front(base::listed(unused, ", "), 300));
  return text + '.';
}

// Notes which other column would make more blocks, and how each row counts by itself. Is called if the blocks are too
// few for any verdict.
void note_blocks(const Sheet& sheet, const Layout& layout, const Items& items, std::vector<std::string>& notes) {
  Columns others = layout.unused;
  if (layout.run) others.push_back(*layout.run);
  for (const std::size_t column : others) {
    std::set<std::pair<std::string_view, std::string_view>> blocks;
    for (const Value& item : items.values)
      blocks.emplace(sheet.cell(item.row, *layout.block), sheet.cell(item.row, column));
    if (blocks.size() * items.groups.size() == items.values.size() && layout.label)
      notes.push_back(fmt::format("If all groups had the same {0}, add --block {0}: that makes {1} blocks.",
                                  sheet.titles()[column], blocks.size()));
  }
  // Several rows of a group in a block were averaged.
  if (layout.label && items.values.size() > items.units * items.groups.size())
    notes.push_back(
        fmt::format("If each row is a measurement of its own, leave --block out and add --run row; to compare the rows "
                    "of one {}, choose them with --where, too.",
                    sheet.titles()[*layout.block]));
}

Quantities values_in(Sheet& sheet, const Request& request) {
  if (sheet.column_like({"stop_reason"}) && sheet.column_like({"series"}))
    sheet.refuse(
        "these are the solves of a study; its store has more than a CSV can hold, so compare there: ikbench report STORE");
  const std::vector<std::string> aggregates = leave_out_aggregates(sheet, request);
  const Layout layout = layout_of(sheet, request);
  expect_one_time_unit(sheet, layout.values);
  Quantities quantities;
  std::vector<std::string> titles;
  for (const std::size_t column : layout.values) titles.push_back(sheet.titles()[column]);
  if (!layout.label) titles = {"value"};
  const std::vector<Better> better = better_of(sheet, request, titles);
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const Items items = items_of(sheet, layout, layout.label ? Columns{layout.values[i]} : layout.values, request);
    MetricSamples samples = quantity_of(titles[i]);
    const auto name_of = [](const std::string& title) { return quantity_of(title).quantity; };
    if (std::ranges::count(titles, samples.quantity, name_of) > 1) {
      samples.quantity = titles[i];
      samples.unit.clear();
    }
    if (i == 0) quantities.notes.push_back(how_read(sheet, layout, items, request.where));
    if (i == 0 && !aggregates.empty())
      quantities.notes.push_back(fmt::format("Rows that summarise other rows are left out: {}.",
                                             base::front(base::names_of(aggregates), 300)));
    if (i == 0 && layout.block && min_p_paired(items.units) > AnalysisPlan().significance)
      note_blocks(sheet, layout, items, quantities.notes);
    settle(items, samples, quantities.notes);
    samples.better = better[i];
    for (const Value& item : items.values)
      if (std::isinf(item.value) && (item.value < 0 || samples.better == Better::larger))
        sheet.refuse(item.row, item.column,
                     "has no meaning here: inf stands for no answer where smaller is better; otherwise write NA");
    const Gaps gaps = gaps_of(layout, items);
    ask_about(gaps, sheet, items, request);
    fill(layout, items, gaps, request, samples);
    quantities.samples.push_back(std::move(samples));
  }
  return quantities;
}

// Returns the columns that --summaries needs. Asks how many values a mean has, if neither a column nor the request says
// so.
SummaryColumns expected_columns(const Sheet& sheet, const Request& request) {
  const SummaryColumns columns = summary_columns_of(sheet);
  for (const auto& [name, found] : {std::pair("mean", columns.mean), {"sd", columns.sd}})
    if (!found) sheet.refuse(fmt::format("there is no column {}; expected the columns name, n, mean and sd", name));
  if (columns.n && request.n > 0)
    sheet.refuse(fmt::format("column {} already gives the number of values of each mean; leave --n out",
                             in_quotes(sheet.titles()[*columns.n])));
  if (columns.n || request.n > 0) return columns;
  MissingOption question(sheet.said(
      "there is no column n: how many values has each mean? If all have 10: --n 10; otherwise add a column n"));
  question.options = {"--n", "N"};
  throw question;
}

// Returns the column of names: the one with this title, if there are several columns of texts.
std::size_t label_of_summaries(Sheet& sheet, const Request& request, const SummaryColumns& columns, Column quantity) {
  Request known = request;
  known.values = {sheet.titles()[*columns.mean], sheet.titles()[*columns.sd]};
  if (columns.n) known.values.push_back(sheet.titles()[*columns.n]);
  known.run = "row";
  if (quantity) known.block = {sheet.titles()[*quantity]};
  if (const Column name = sheet.column_like({"name"}); name && known.label.empty())
    known.label = {sheet.titles()[*name]};
  return *layout_of(sheet, known).label;
}

Quantities summaries_in(Sheet& sheet, const Request& request) {
  const SummaryColumns columns = expected_columns(sheet, request);
  const Column quantity = sheet.column_like({"metric"});
  const std::size_t label = label_of_summaries(sheet, request, columns, quantity);
  Quantities quantities;
  std::vector<std::string> titles;
  for (const Index row : sheet.rows()) {
    const std::string title(quantity ? sheet.cell(row, *quantity) : "value");
    const auto place = static_cast<std::size_t>(std::ranges::find(titles, title) - titles.begin());
    if (place == titles.size()) {
      titles.push_back(title);
      quantities.samples.push_back(quantity_of(title));
    }
    MetricSamples& samples = quantities.samples[place];
    samples.kind = judge::Differences{};
    std::vector<Group>& groups = samples.groups;
    const std::string name(sheet.cell(row, label));
    if (name.empty() || std::ranges::count(groups, name, &Group::name) > 0)
      sheet.refuse(
          row, label,
          "is empty, or the name of an earlier row; if the rows are of several problems, choose one with --where");
    const auto number = [&](std::size_t at, double least) {
      const double value = sheet.number(row, at);
      if (!(value >= least && std::isfinite(value))) sheet.refuse(row, at, "is missing or too small");
      return value;
    };
    const double size = columns.n ? number(*columns.n, 2) : request.n;
    if (size != std::floor(size) || size > 1e9)
      sheet.refuse(row, *columns.n, "is not a number of values; expected one such as 20");
    const SummaryStatistics summary{.n = static_cast<int>(size),
                                    .mean = number(*columns.mean, std::numeric_limits<double>::lowest()),
                                    .sd = number(*columns.sd, 0)};
    groups.push_back({.name = name, .sample = summary});
    if (summary.sd > 0) continue;  // a spread of 0, which may have been rounded away, would decide everything
    groups.back().sample = ExcludedSample{.reason = ExclusionReason::zero_spread, .printed = summary};
    samples.warnings.push_back({.kind = WarningKind::deterministic,
                                .solvers = {name},
                                .count = size,
                                .total = size,
                                .detail = samples.quantity});
  }
  const std::vector<Better> better = better_of(sheet, request, titles);
  for (std::size_t i = 0; i < titles.size(); ++i) quantities.samples[i].better = better[i];
  return quantities;
}

// A margin as the user wrote it.
struct MarginText {
  std::optional<double> number = {};  // empty: no number
  bool is_relative = false;           // in percent of the values
  bool has_no_share = false;          // values may be negative, so that a share of a value means nothing
};

// Returns why a margin is impossible; null if the margin is possible. `largest` is the largest size of a value.
const char* margin_error(const MarginText& margin, const MetricSamples& samples, double largest) {
  const std::optional<double>& number = margin.number;
  if (!number || !(*number >= 0) || !std::isfinite(*number)) return "expected 5%, or 0.1 in the unit of the values";
  if (margin.is_relative && *number > 99) return "everything would be the same; expected at most 99%";
  if (margin.is_relative && margin.has_no_share)
    return "values may be negative, so a percentage has no meaning; expected a margin in their unit, such as 0.1";
  if (margin.is_relative) return nullptr;
  if (is_proportion(samples)) return "shares differ by percentage points; expected 5%";
  return *number > largest ? "no value is that large, so everything would be the same; a percentage is 5%" : nullptr;
}

}  // namespace

Quantities read(std::string_view text, std::string_view source, const Request& request) {
  Sheet sheet(text, source, request.decimal);
  refuse_wrong_directions(sheet, request);
  return request.are_summaries ? summaries_in(sheet, request) : values_in(sheet, request);
}

AnalysisPlan with_margin(AnalysisPlan plan, const std::string& margin, MetricSamples& samples) {
  double least = 0, largest = 0;  // among all values; largest in size
  for (const Group& group : samples.groups) {
    const auto* const summary = std::get_if<SummaryStatistics>(&group.sample);
    for (const double value : summary ? std::span(&summary->mean, 1) : values_of(group)) {
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      largest = std::max(largest, std::abs(value));
    }
  }
  const bool has_no_share = effect_scale(samples) == EffectScale::difference && least < 0;
  if (margin.empty() && has_no_share) plan.margin = 0;
  if (margin.empty()) return plan;
  const bool is_relative = margin.ends_with('%');
  const auto number = base::number_from(std::string_view(margin).substr(0, margin.size() - is_relative));
  if (const char* const error = margin_error({number, is_relative, has_no_share}, samples, largest))
    throw std::invalid_argument(fmt::format("--margin {}: {}", in_quotes(margin), error));
  plan.margin = is_relative ? *number / 100 : 0;
  samples.absolute_margin = is_relative ? 0 : *number;
  return plan;
}

}  // namespace ikbench::csv
