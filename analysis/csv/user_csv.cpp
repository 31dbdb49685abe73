#include "analysis/csv/user_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "analysis/csv/sheet.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"

namespace ikbench::csv {
namespace {

using namespace compare;
using Index = std::uint32_t;
using Column = std::optional<std::size_t>;

const Words label_names{"solver", "algorithm", "group", "label", "method", "name"};
const Words metric_names{"metric", "quantity", "variable", "measure"};
const Words run_names{"run", "trial", "seed", "repetition", "replicate", "rep", "repeat", "run_id", "seed_id"};
const Words row_names{"id", "index", "row", "point", "target", "problem", "no", "number"};

// Where things are. Without a label each column of values is a group.
struct Layout {
  Column label, block, run, rows = {};  // rows: without a label, what tells rows apart
  std::vector<std::size_t> values;

  bool has(std::size_t column) const {
    return column == label || column == block || column == run || std::ranges::count(values, column) > 0;
  }
};

// A column of whole numbers that are named as rows' are, or stand first and count rows: no group of a wide file.
bool tells_rows(const Sheet& sheet, std::size_t column) {
  const std::string_view begin = sheet.cell(sheet.rows().front(), column);
  std::int64_t next = begin == "1" ? 1 : 0;
  bool is_whole = true, counts = column == 0 && sheet.rows().size() > 4;
  for (const Index row : sheet.rows()) {
    const std::string_view text = sheet.cell(row, column);
    is_whole = is_whole && text.find_first_not_of("0123456789") == std::string_view::npos;
    counts = counts && text == std::to_string(next++);
  }
  return counts || (is_whole && is_one_of(sheet.titles()[column], row_names));
}

Layout layout_of(const Sheet& sheet, const Request& request) {
  const auto column = [&](const std::string& name) { return name.empty() ? Column() : sheet.column(name); };
  Layout layout{.label = column(request.label), .block = column(request.block), .run = column(request.run)};
  for (const std::string& each : request.values) {
    const std::size_t at = sheet.column(each);
    if (std::ranges::count(layout.values, at) == 0) layout.values.push_back(at);
  }
  if (!layout.label) layout.label = sheet.column_like(label_names);
  if (layout.label && !layout.values.empty()) return layout;
  std::vector<std::size_t> numbers, texts;
  for (std::size_t i = 0; i < sheet.titles().size(); ++i) {
    const std::string& title = sheet.titles()[i];
    const auto is_chosen = [&](const std::string& where) { return where.starts_with(title + '='); };
    if (layout.has(i) || is_one_of(title, run_names) || std::ranges::any_of(request.where, is_chosen)) continue;
    if (title.empty() || title == "Unnamed: 0") continue;  // numbers of rows, as R and pandas write them
    (sheet.has_numbers(i) ? numbers : texts).push_back(i);
  }
  if (!layout.label && texts.size() > 1)
    sheet.refuse(fmt::format("text in the columns {}; name that of the groups with --label", sheet.names_of(texts)));
  if (!layout.label && !texts.empty()) layout.label = texts.front();
  if (layout.label && numbers.size() > 1 && layout.values.empty())
    sheet.refuse(
        fmt::format("numbers in the columns {}; name one with --value, or, if each is a group, what all groups "
                    "had with --block '{}'",
                    sheet.names_of(numbers), sheet.titles()[*layout.label]));
  if (!layout.label) {
    layout.rows = sheet.column_like(run_names);
    const auto is_row = [&](std::size_t each) { return tells_rows(sheet, each); };
    if (const auto found = std::ranges::find_if(numbers, is_row); found != numbers.end()) layout.rows = *found;
    std::erase_if(numbers, is_row);
  }
  if (!layout.label && (!layout.values.empty() || numbers.size() == 1))
    sheet.refuse("no column of labels; name that of the groups with --label COLUMN");
  if (layout.values.empty()) layout.values = numbers;
  if (layout.values.empty()) sheet.refuse("no column of numbers; expected one of values");
  for (const std::size_t each : layout.values) sheet.column(sheet.titles()[each]);  // refuses two of one name
  return layout;
}

constexpr Index first_without_run = Index{1} << 31;  // units of rows that name none

struct Value {
  Index group, unit, row;  // unit: block, run or row
  double value;
};

struct Items {
  std::vector<std::string> groups;
  std::vector<Value> values;  // by group and unit
  Index units = 0;
  std::size_t unlabelled = 0;
  bool are_averaged = false;
};

// Texts are numbered in the order of their first row.
Index number_of(std::string_view text, std::unordered_map<std::string_view, Index>& known) {
  return known.try_emplace(text, static_cast<Index>(known.size())).first->second;
}

// Refuses a row that repeats another in all but this text.
void refuse_other(const Sheet& sheet, Index row, Index other, std::size_t column) {
  const std::string_view text = sheet.cell(row, column);
  if (sheet.cell(other, column) == text) return;
  sheet.refuse(other, column,
               fmt::format("repeats no row with {}: choose rows with --where '{}={}', or compare within --block '{}'",
                           in_quotes(text), sheet.titles()[column], numerics::front(text, 60), sheet.titles()[column]));
}

Items items_of(Sheet& sheet, const Layout& layout, const std::vector<std::size_t>& columns) {
  const Column unit = layout.block ? layout.block : layout.run ? layout.run : sheet.column_like(run_names);
  std::unordered_map<std::string_view, Index> groups, units;
  Items items;
  items.values.reserve(columns.size() * sheet.rows().size());
  for (const std::size_t column : columns) {
    Index used = 0;  // a column that ends before others has fewer values
    for (const Index row : sheet.rows()) used = sheet.cell(row, column).empty() ? used : row;
    for (const Index row : sheet.rows()) {
      const std::string_view name = layout.label ? sheet.cell(row, *layout.label) : sheet.titles()[column];
      if (!layout.label && !layout.block && row > used) break;
      items.unlabelled += name.empty();
      if (name.empty()) continue;
      const std::string_view own = unit ? sheet.cell(row, *unit) : "";
      if (own.empty() && (layout.block || layout.run)) sheet.refuse(row, *unit, "is no name");
      const Index group = number_of(name, groups);
      if (group == items.groups.size()) items.groups.emplace_back(name);
      if (group == most_groups)
        sheet.refuse(fmt::format("more than {} groups, the last {}; is --label right?", most_groups, in_quotes(name)));
      items.values.push_back({.group = group,
                              .unit = own.empty() ? first_without_run + row : number_of(own, units),
                              .row = row,
                              .value = sheet.number(row, column)});
    }
  }
  if (items.values.empty()) sheet.refuse("no row has a label");
  items.units = static_cast<Index>(units.size());
  const auto place = [](const Value& each) { return std::tuple(each.group, each.unit); };
  std::ranges::stable_sort(items.values, {}, place);
  const auto twice = std::ranges::adjacent_find(items.values, {}, place);
  items.are_averaged = twice != items.values.end();
  if (items.are_averaged && !layout.run)
    sheet.refuse(
        std::next(twice)->row, *unit,
        fmt::format(
            "has several rows of {}; average rows that depend on each other with --run {}{}",
            in_quotes(items.groups[twice->group]), layout.block ? "COLUMN" : sheet.titles()[*unit],
            layout.block ? "" : ", or compare what was done apart with --block COLUMN --run " + sheet.titles()[*unit]));
  return items;
}

// Rows of a mean differ in numbers alone: other text tells of several metrics or problems.
void refuse_mixed(const Sheet& sheet, const Layout& layout, const Items& items) {
  for (std::size_t column = 0; column < sheet.titles().size(); ++column) {
    if (!items.are_averaged || layout.has(column) || sheet.has_numbers(column)) continue;
    std::unordered_set<std::string_view> different;
    for (const Value& each : items.values) different.insert(sheet.cell(each.row, column));
    if (different.size() == items.values.size()) continue;  // times of day and the like
    for (std::size_t i = 1; i < items.values.size(); ++i) {
      const Value &before = items.values[i - 1], &each = items.values[i];
      if (before.group == each.group && before.unit == each.unit) refuse_other(sheet, before.row, each.row, column);
    }
  }
}

// The metric of a file of solves. What a report knows from its store, and the file does not say, is refused.
const Metric* metric_of(const Sheet& sheet, const std::string& name) {
  const auto metric = std::ranges::find(metrics(), name, &Metric::column);
  for (const char* each : {"study", "robot", "series", "status", "stop_reason"}) {
    if (metric == metrics().end() || std::ranges::count(sheet.titles(), each) == 0) return nullptr;
  }
  const std::size_t study = sheet.column("study"), status = sheet.column("status"), stop = sheet.column("stop_reason");
  const char* unknown = metric->kind == Kind::time ? "how busy the machine was" : nullptr;
  const auto has_no_answer = [](std::string_view how) {
    const auto at = std::ranges::find(results::status_names, how) - results::status_names.begin();
    return at < std::ssize(results::status_names) && is_without_answer(static_cast<results::Status>(at));
  };
  for (const Index row : sheet.rows()) {
    const std::string_view how = sheet.cell(row, status);
    if (sheet.cell(row, study) != sheet.cell(sheet.rows().front(), study))
      sheet.refuse(row, study, "is not the only one; choose with --where study=NAME");
    if (how == "tolerance_missed" || sheet.cell(row, stop) == "tolerance") unknown = "the tolerance";
    if (metric->kind == Kind::cost && has_no_answer(how)) unknown = "what a solve without an answer costs";
  }
  if (unknown)
    sheet.refuse(
        fmt::format("{} needs what this file does not say, {}; `ikbench report` knows it", in_quotes(name), unknown));
  return &*metric;
}

// "error_cm" and "error [cm]" have a unit; columns of our own have the names of a report.
Observations quantity_of(const std::string& title, bool is_larger_better) {
  const bool is_bracketed = title.ends_with(']');
  const std::size_t at = title.rfind(is_bracketed ? '[' : '_');
  Observations of{.metric = "", .quantity = title, .better = is_larger_better ? Better::larger : Better::smaller};
  for (const char c : lower_case(title)) of.metric += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '-';
  const auto metric = std::ranges::find(metrics(), title, &Metric::column);
  if (metric != metrics().end()) {
    of.metric = metric->slug, of.quantity = metric->name, of.unit = metric->unit;
    if (metric->kind == Kind::share) of.better = Better::larger;
    return of;
  }
  if (at == std::string::npos || at == 0) return of;
  const std::string unit = title.substr(at + 1, title.size() - at - (is_bracketed ? 2 : 1));
  if (!is_bracketed && !is_one_of(unit, {"cm", "mm", "m", "deg", "rad", "ms", "s"})) return of;
  of.quantity = title.substr(0, title.find_last_not_of(' ', at - 1) + 1);
  of.unit = unit;
  return of;
}

// The values of each group: means of the rows of a unit.
void fill(const Layout& layout, const Items& items, Observations& of) {
  struct Mean {
    Index group, unit, rows;
    long double sum;  // by which the same rows in another order have the same mean
    double value() const { return static_cast<double>(sum / rows); }
  };
  std::vector<Mean> means;
  for (const Value& each : items.values) {
    const bool is_next = !means.empty() && means.back().group == each.group && means.back().unit == each.unit;
    if (!is_next) means.push_back({.group = each.group, .unit = each.unit, .rows = 0, .sum = 0});
    means.back().sum += each.value;
    ++means.back().rows;
  }
  std::vector<Index> most(layout.block ? items.units : 1);
  const auto most_of = [&](const Mean& mean) -> Index& { return most[layout.block ? mean.unit : 0]; };
  for (const Mean& each : means) most_of(each) = std::max(most_of(each), each.rows);
  of.is_paired = layout.block.has_value();
  of.trials = static_cast<int>(std::ranges::max(most));
  std::vector<int> without(items.groups.size()), all(items.groups.size());
  for (const std::string& name : items.groups) of.groups.push_back({.name = name});
  for (const Mean& each : means) {
    Group& group = of.groups[each.group];
    ++all[each.group];
    const bool is_lost = std::isnan(each.value()), is_short = each.rows < most_of(each);
    without[each.group] += is_lost;
    group.lost += is_lost || is_short;
    if (!is_lost && !is_short) group.values.push_back(each.value());
  }
  const std::string rows = layout.block ? "blocks have fewer rows" : "runs have fewer rows";
  Doubt none{.kind = DoubtKind::without_answer, .what = "values are missing"};
  Doubt fewer{.kind = DoubtKind::runs_missing, .what = rows + " than others, and count as lost"};
  Doubt unlabelled{.kind = DoubtKind::runs_missing, .what = "rows have no label and are left out"};
  const auto count = [](Doubt& doubt, const std::string& who, auto number, auto most_possible) {
    if (number == 0) return;
    if (!who.empty()) doubt.who.push_back(who);
    doubt.count += static_cast<double>(number);
    doubt.of += static_cast<double>(most_possible);
  };
  for (std::size_t i = 0; i < of.groups.size(); ++i) {
    Group& group = of.groups[i];
    const int expected = layout.block ? static_cast<int>(items.units) : all[i];
    group.lost += expected - all[i];
    count(none, group.name, without[i], expected);
    count(fewer, group.name, group.lost - without[i], expected);
  }
  count(unlabelled, "", items.unlabelled, items.unlabelled + items.values.size());
  for (Doubt* doubt : {&none, &fewer, &unlabelled}) {
    if (doubt->count > 0) of.doubts.push_back(std::move(*doubt));
  }
}

// Chooses shares, ratios or differences by all values.
void settle(const Items& items, Observations& of, std::vector<std::string>& notes) {
  const auto is_outcome = [](const Value& each) {
    return std::isnan(each.value) || each.value == 0 || each.value == 1;
  };
  const auto is_above = [](const Value& each) { return each.value > 0; };
  const auto negative = std::ranges::count_if(items.values, [](const Value& each) { return each.value < 0; });
  const auto zero = std::ranges::count(items.values, 0.0, &Value::value);
  if (std::ranges::all_of(items.values, is_outcome) && std::ranges::any_of(items.values, is_above)) {
    of.scale = Scale::share;
    of.better = Better::larger;
    notes.push_back(
        fmt::format("All values of {} are 0 or 1: shares are compared, and larger ones are better.", of.quantity));
    return;
  }
  of.trials = 1;
  if (negative > 0 || std::ranges::none_of(items.values, is_above)) {
    of.scale = Scale::difference;
    if (negative > 0)
      notes.push_back(fmt::format("{} of {} values of {} are negative: differences are compared, not ratios.", negative,
                                  items.values.size(), of.quantity));
  } else if (of.scale == Scale::ratio && of.floor == 0 && zero > 0) {
    of.floor = std::numeric_limits<double>::max();
    for (const Value& each : items.values) of.floor = each.value > 0 ? std::min(of.floor, each.value) : of.floor;
    notes.push_back(fmt::format("{} of {} values of {} are 0 and count as {}, the smallest above it.", zero,
                                items.values.size(), of.quantity, of.floor));
  }
}

bool is_constant(const Group& group) {
  return group.values.size() > 1 && std::ranges::count(group.values, group.values.front()) == std::ssize(group.values);
}

}  // namespace

Quantities read(std::string_view text, std::string_view source, const Request& request) {
  Sheet sheet(text, source, request.separator, request.decimal);
  for (const std::string& each : request.where) sheet.choose(each);
  const Layout layout = layout_of(sheet, request);
  if (const Column metric = sheet.column_like(metric_names);
      metric && !layout.has(*metric) && !sheet.has_numbers(*metric)) {
    for (const Index row : sheet.rows()) refuse_other(sheet, sheet.rows().front(), row, *metric);
  }
  Quantities quantities;
  if (layout.rows && !layout.block)
    quantities.notes.push_back(
        fmt::format("Rows count as unrelated; if each was the same problem for all groups, add --block '{}'.",
                    sheet.titles()[*layout.rows]));
  const std::size_t count = layout.label ? layout.values.size() : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string title = layout.label ? sheet.titles()[layout.values[i]] : "value";
    const Items items = items_of(sheet, layout, layout.label ? std::vector{layout.values[i]} : layout.values);
    Observations of = quantity_of(title, request.is_larger_better);
    const Metric* metric = metric_of(sheet, title);
    if (metric) {
      of.scale = metric->scale, of.floor = metric->floor, of.rounding = metric->rounding;
    } else {
      refuse_mixed(sheet, layout, items);
    }
    fill(layout, items, of);
    settle(items, of, quantities.notes);
    for (Group& group : of.groups) group.may_repeat = is_constant(group);
    quantities.observed.push_back(std::move(of));
  }
  return quantities;
}

Quantities read_summaries(std::string_view text, std::string_view source, const Request& request) {
  Sheet sheet(text, source, request.separator, request.decimal);
  for (const std::string& each : request.where) sheet.choose(each);
  const auto column = [&](const Words& names) {
    const Column found = sheet.column_like(names);
    if (!found) sheet.refuse(fmt::format("no column {}; expected name, n, mean and sd", *names.begin()));
    return *found;
  };
  const std::size_t label = column(label_names), n = column({"n", "count"}), mean = column({"mean"}),
                    sd = column({"sd", "std", "stddev"});
  const Column quantity = sheet.column_like(metric_names);
  Quantities quantities;
  for (const Index row : sheet.rows()) {
    const std::string title(quantity ? sheet.cell(row, *quantity) : "value");
    Observations of = quantity_of(title, request.is_larger_better);
    of.scale = Scale::difference;
    auto found = std::ranges::find(quantities.observed, of.metric, &Observations::metric);
    if (found == quantities.observed.end()) found = quantities.observed.insert(found, of);
    std::vector<Group>& groups = found->groups;
    const std::string name(sheet.cell(row, label));
    if (name.empty() || std::ranges::count(groups, name, &Group::name) > 0)
      sheet.refuse(row, label, "is no name of another group");
    const auto number = [&](std::size_t at, double least) {
      const double value = sheet.number(row, at);
      if (!(value >= least)) sheet.refuse(row, at, "is not known or too small");
      return value;
    };
    const double size = number(n, 2);
    if (size != std::floor(size) || size > 1e9) sheet.refuse(row, n, "is no number of values");
    const Summary summary{
        .n = static_cast<int>(size), .mean = number(mean, std::numeric_limits<double>::lowest()), .sd = number(sd, 0)};
    const bool is_constant = summary.sd == 0;  // or its spread was rounded away: it would decide everything
    groups.push_back({.name = name, .is_apart = is_constant, .summary = summary});
    if (is_constant)
      found->doubts.push_back(
          {.kind = DoubtKind::repeats_itself, .who = {name}, .count = size, .of = size, .what = "value"});
  }
  return quantities;
}

Plan with_margin(Plan plan, const std::string& margin, Observations& of) {
  const auto is_negative = [](const Group& group) {
    return group.summary ? group.summary->mean < 0
                         : std::ranges::any_of(group.values, [](double each) { return each < 0; });
  };
  const bool is_share = of.scale == Scale::share;
  const bool has_no_share = of.scale == Scale::difference && std::ranges::any_of(of.groups, is_negative);
  if (margin.empty()) {
    if (has_no_share) plan.margin = 0;
    return plan;
  }
  const bool is_relative = margin.ends_with('%');
  const auto number = numerics::number_from(std::string_view(margin).substr(0, margin.size() - is_relative));
  const char* wrong = !number || !(*number >= 0) || !std::isfinite(*number)
                          ? "expected 5%, or 0.1 in the unit of the values"
                      : is_relative && has_no_share
                          ? "a share of values that may be negative means nothing; give a margin in their unit"
                      : !is_relative && is_share ? "shares differ by points; expected 5%"
                                                 : nullptr;
  if (wrong) throw std::invalid_argument(fmt::format("--margin {}: {}", in_quotes(margin), wrong));
  plan.margin = is_relative ? *number / 100 : 0;
  of.absolute_margin = is_relative ? 0 : *number;
  return plan;
}

}  // namespace ikbench::csv
