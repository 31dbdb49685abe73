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

#include "analysis/judge/tests_of_two.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::csv {
namespace {

using namespace judge;
using Index = std::uint32_t;

constexpr std::size_t most_groups = 100;

struct Value {
  Index group, unit, row, column;  // unit: block, run or the value itself
  double value;
};

struct Mean {
  Index group, unit, first, rows = 0;  // first: of its rows
  long double sum = 0;                 // by which the same rows in another order have the same mean
};

struct Items {
  std::vector<std::string> groups;
  std::vector<Value> values;  // by group and unit
  std::vector<Mean> means;    // of each group and unit
  Index units = 0;
  std::size_t unlabelled = 0;
};

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
        sheet.refuse(row, *unit, "is no name; write merged cells in each of their rows");
      const Index group = groups.try_emplace(name, static_cast<Index>(groups.size())).first->second;
      if (group == items.groups.size()) items.groups.emplace_back(name);
      if (group == most_groups)
        sheet.refuse(fmt::format("more than {} groups in --label; did you mean --block?", most_groups));
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
  if (layout.label && (items.unlabelled > items.values.size() ||
                       (items.groups.size() == items.values.size() && items.values.size() > 2)))  // two may be a sketch
    sheet.refuse(fmt::format("{} names each row, or none in {} of {} rows; did you mean --block, or are cells merged?",
                             in_quotes(sheet.titles()[*layout.label]), items.unlabelled, sheet.rows().size()));
  items.units = static_cast<Index>(units.size());
  Columns texts = layout.unused;
  std::erase_if(texts, [&](std::size_t column) { return sheet.has_numbers(column); });
  std::ranges::sort(items.values, {}, [](const Value& item) { return std::tuple(item.group, item.unit, item.row); });
  items.means.reserve(items.values.size());
  for (const Value& item : items.values) {
    if (items.means.empty() || items.means.back().group != item.group || items.means.back().unit != item.unit)
      items.means.push_back({.group = item.group, .unit = item.unit, .first = item.row});
    else if (layout.block && request.run.empty())
      sheet.refuse(item.row, *layout.block,
                   fmt::format("is a second row of {}; --run says which are its runs (--run row: each row is one)",
                               in_quotes(items.groups[item.group])));
    items.means.back().sum += item.value, ++items.means.back().rows;
    for (const std::size_t column : texts)  // which may name quantities
      if (const auto first = sheet.cell(items.means.back().first, column); first != sheet.cell(item.row, column))
        sheet.refuse(item.row, column,
                     fmt::format("is not {}, as in the same mean; name it in --label, --block, --run or --where",
                                 in_quotes(first)));
  }
  return items;
}

// Of each of the titles. Asks where nobody said it: no name or number does.
std::vector<Better> better_of(const Sheet& sheet, const Request& request, const std::vector<std::string>& titles) {
  std::map<std::string_view, std::string_view> said;  // "": of all
  for (const std::string_view option : request.better) {
    const std::size_t at = option.rfind('=') + 1;  // 0: of all
    const std::string_view way = option.substr(at), column = option.substr(0, at > 0 ? at - 1 : 0);
    if (way != "smaller" && way != "larger")
      sheet.refuse(fmt::format("--better {}; expected smaller, larger or COLUMN=larger", in_quotes(option)));
    if (!column.empty() && std::ranges::count(titles, column) == 0)
      sheet.refuse(
          fmt::format("--better {}: {}", in_quotes(option), base::unknown_name("column of values", column, titles)));
    if (said.try_emplace(column, way).first->second != way)
      sheet.refuse(fmt::format("--better {} contradicts an earlier --better; expected one of them", in_quotes(option)));
  }
  std::vector<Better> better;
  for (const std::string& title : titles) {
    const std::string_view way = said.contains(title) ? said[title] : said[""];
    if (way.empty())
      throw Question(sheet.said(
          fmt::format("is smaller or larger better in {}? Say --better smaller or --better larger{}", in_quotes(title),
                      titles.size() > 1 ? fmt::format("; of this column alone --better {}=larger", title) : "")));
    better.push_back(way == "larger" ? Better::larger : Better::smaller);
  }
  return better;
}

Observations quantity_of(const std::string& title) {
  const base::Title parts(title);
  Observations observed{.metric = "", .quantity = parts.name, .unit = parts.unit, .tells_incomplete = true};
  for (const char c : base::lower_case(title))
    observed.metric += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '-';
  return observed;
}

// The values of each group.
void fill(const Layout& layout, const Items& items, Observations& observed) {
  // In a block all groups need as many rows, since they had the same problems. A run without a block may end early.
  std::vector<Index> needed_rows(items.units);
  if (layout.block)
    for (const Mean& mean : items.means) needed_rows[mean.unit] = std::max(needed_rows[mean.unit], mean.rows);
  const auto is_complete = [&](const Mean& mean) { return !layout.block || mean.rows == needed_rows[mean.unit]; };
  observed.is_paired = layout.block.has_value();
  if (observed.scale == Scale::share)
    observed.trials = static_cast<int>(std::ranges::max(items.means, {}, &Mean::rows).rows);
  std::vector<std::size_t> groups_of(items.units), all(items.groups.size());  // complete ones of a block; of a group
  std::vector<Measured> measured(items.groups.size());
  for (const Mean& mean : items.means) {
    const auto value = static_cast<double>(mean.sum / mean.rows);
    ++all[mean.group];
    if (std::isnan(value) || !is_complete(mean)) continue;
    measured[mean.group].values.push_back(value);
    if (layout.block) ++groups_of[mean.unit];
  }
  Doubt lost{.kind = DoubtKind::incomplete,
             .what = layout.block ? "blocks incomplete"
                     : layout.run ? "runs incomplete"
                                  : "values missing"};
  Doubt without{.kind = DoubtKind::without_answer, .what = "values are no answers"};
  const auto add = [](Doubt& doubt, const std::string& group, auto count, std::size_t total) {
    if (count == 0) return;
    doubt.who.push_back(group);
    doubt.count += static_cast<double>(count), doubt.of += static_cast<double>(total);
  };
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const std::string& name = items.groups[i];
    std::vector<double>& values = measured[i].values;
    const auto lacking = static_cast<int>((layout.block ? items.units : all[i]) - values.size());
    // Such as time-outs have no end that anybody knows, so they repeat nothing.
    measured[i].may_be_copies = values.size() > 1 && std::isfinite(values.front()) &&
                                std::ranges::count(values, values.front()) == std::ssize(values);
    add(lost, name, lacking, all[i]);
    add(without, name, std::ranges::count_if(values, [](double value) { return std::isinf(value); }), values.size());
    observed.groups.push_back({.name = name,
                               .sample = lacking > 0 ? Untold{.lost = lacking, .values = std::move(values)}
                                                     : Sample(std::move(measured[i]))});
  }
  if (layout.block) {
    const auto in_all = std::ranges::count(groups_of, items.groups.size());
    lost.of = items.units, lost.count = static_cast<double>(items.units - in_all);
  }
  Doubt stray{.kind = DoubtKind::runs_missing,
              .count = static_cast<double>(items.unlabelled),
              .of = static_cast<double>(items.unlabelled + items.values.size()),
              .what = "rows without a label, left out"};
  for (Doubt* doubt : {&lost, &without, &stray})
    if (doubt->count > 0) observed.doubts.push_back(std::move(*doubt));
}

// Chooses shares, ratios or differences by all values.
void settle(const Items& items, Observations& observed, std::vector<std::string>& notes) {
  const auto count = [&](auto is_so) { return std::ranges::count_if(items.values, is_so, &Value::value); };
  const auto shares = count([](double value) { return value == 0 || value == 1; });
  const auto low = count([](double value) { return value <= 0; });
  if (shares > 0 && shares + count([](double value) { return std::isnan(value); }) == std::ssize(items.values)) {
    observed.scale = Scale::share;
    notes.push_back(fmt::format("All values of {} are 0 or 1: shares are compared.", observed.quantity));
  } else if (low > 0) {
    observed.scale = Scale::difference;
    notes.push_back(fmt::format("{} of {} values of {} are 0 or below: differences are compared, not ratios.", low,
                                items.values.size(), observed.quantity));
  }
}

// What the rows were taken for.
std::string how_read(const Sheet& sheet, const Layout& layout, const Items& items,
                     const std::vector<std::string>& where) {
  const auto of = [&](Column column) {  // a title may be no noun
    return column ? fmt::format(" ({})", base::one_line(base::front(sheet.titles()[*column], 60))) : "";
  };
  std::string text = base::counted(std::ssize(items.groups), layout.label ? "labels" : "columns") + of(layout.label);
  if (const Column unit = layout.block ? layout.block : layout.run)
    text += ", " + base::counted(items.units, layout.block ? "blocks" : "runs") + of(unit);
  const auto [shortest, longest] = std::ranges::minmax(items.means, {}, &Mean::rows);
  if (longest.rows > 1)
    text += fmt::format(", means of {}{} rows",
                        shortest.rows < longest.rows ? fmt::format("{} to ", shortest.rows) : "", longest.rows);
  if (!layout.block && !layout.run) text += ", rows unrelated";
  std::vector<std::string> unused;
  for (const std::size_t column : layout.unused) unused.push_back(in_quotes(sheet.titles()[column]));
  for (const std::string& condition : where) text += fmt::format("; only rows with {}", in_quotes(condition));
  if (!unused.empty()) text += fmt::format("; not used: {}", base::front(base::listed(unused, ", "), 300));
  return text + '.';
}

// Adds which column makes more blocks, where they are too few for any verdict.
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
}

Quantities values_in(Sheet& sheet, const Request& request) {
  if (sheet.column_like({"stop_reason"}) && sheet.column_like({"series"}))
    sheet.refuse("solves of a study, which a CSV does not say all of; `ikbench report` judges its store");
  const Layout layout = layout_of(sheet, request);
  Quantities quantities;
  std::vector<std::string> titles;
  for (const std::size_t column : layout.values) titles.push_back(sheet.titles()[column]);
  if (!layout.label) titles = {"value"};
  const std::vector<Better> better = better_of(sheet, request, titles);
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const Items items = items_of(sheet, layout, layout.label ? Columns{layout.values[i]} : layout.values, request);
    Observations observed = quantity_of(titles[i]);
    const auto name_of = [](const std::string& title) { return quantity_of(title).quantity; };
    if (std::ranges::count(titles, observed.quantity, name_of) > 1)
      observed.quantity = titles[i], observed.unit.clear();
    if (i == 0) quantities.notes.push_back(how_read(sheet, layout, items, request.where));
    if (i == 0 && layout.block && smallest_p_paired(items.units) > Plan().significance)
      note_blocks(sheet, layout, items, quantities.notes);
    settle(items, observed, quantities.notes);
    observed.better = better[i];
    for (const Value& item : items.values)
      if (std::isinf(item.value) && (item.value < 0 || observed.better == Better::larger))
        sheet.refuse(item.row, item.column,
                     "has no meaning: inf stands for no answer, where smaller is better; otherwise write NA");
    fill(layout, items, observed);
    quantities.observed.push_back(std::move(observed));
  }
  return quantities;
}

Quantities summaries_in(Sheet& sheet, const Request& request) {
  const Column n = sheet.column_like({"n", "count", "n_runs"}), mean = sheet.column_like({"mean", "avg", "average"}),
               sd = sheet.column_like({"sd", "std", "stddev", "std_dev"}), quantity = sheet.column_like({"metric"});
  for (const auto& [name, found] : {std::pair("n", n), {"mean", mean}, {"sd", sd}})
    if (!found) sheet.refuse(fmt::format("no column {}; expected name, n, mean and sd", name));
  Request known = request;
  known.values = {sheet.titles()[*n], sheet.titles()[*mean], sheet.titles()[*sd]}, known.run = "row";
  if (quantity) known.block = {sheet.titles()[*quantity]};
  const std::size_t label = *layout_of(sheet, known).label;
  Quantities quantities;
  std::vector<std::string> titles;
  for (const Index row : sheet.rows()) {
    const std::string title(quantity ? sheet.cell(row, *quantity) : "value");
    const auto place = static_cast<std::size_t>(std::ranges::find(titles, title) - titles.begin());
    if (place == titles.size()) titles.push_back(title), quantities.observed.push_back(quantity_of(title));
    Observations& observed = quantities.observed[place];
    observed.scale = Scale::difference;
    std::vector<Group>& groups = observed.groups;
    const std::string name(sheet.cell(row, label));
    if (name.empty() || std::ranges::count(groups, name, &Group::name) > 0)
      sheet.refuse(row, label, "is no name of another group; --where takes rows of one problem");
    const auto number = [&](std::size_t at, double least) {
      const double value = sheet.number(row, at);
      if (!(value >= least && std::isfinite(value))) sheet.refuse(row, at, "is not known or too small");
      return value;
    };
    const double size = number(*n, 2);
    if (size != std::floor(size) || size > 1e9) sheet.refuse(row, *n, "is no number of values");
    const Summary summary{.n = static_cast<int>(size),
                          .mean = number(*mean, std::numeric_limits<double>::lowest()),
                          .sd = number(*sd, 0)};
    groups.push_back({.name = name, .sample = summary});
    if (summary.sd > 0) continue;  // else, or if it was rounded away, the spread would decide everything
    groups.back().sample = Untold{.why = Untold::Why::no_spread, .printed = summary};
    observed.doubts.push_back(
        {.kind = DoubtKind::repeats_itself, .who = {name}, .count = size, .of = size, .what = "value"});
  }
  const std::vector<Better> better = better_of(sheet, request, titles);
  for (std::size_t i = 0; i < titles.size(); ++i) quantities.observed[i].better = better[i];
  return quantities;
}

}  // namespace

Quantities read(std::string_view text, std::string_view source, const Request& request) {
  Sheet sheet(text, source, request.decimal);
  return request.are_summaries ? summaries_in(sheet, request) : values_in(sheet, request);
}

Plan with_margin(Plan plan, const std::string& margin, Observations& observed) {
  double least = 0, largest = 0;  // of all values
  for (const Group& group : observed.groups) {
    const auto* const summary = std::get_if<Summary>(&group.sample);
    for (const double value : summary ? std::span(&summary->mean, 1) : values_of(group)) {
      least = std::min(least, value);
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
  }
  const bool has_no_share = observed.scale == Scale::difference && least < 0;
  if (margin.empty() && has_no_share) plan.margin = 0;
  if (margin.empty()) return plan;
  const bool is_relative = margin.ends_with('%');
  const auto number = base::number_from(std::string_view(margin).substr(0, margin.size() - is_relative));
  const char* wrong =
      !number || !(*number >= 0) || !std::isfinite(*number) ? "expected 5%, or 0.1 in the unit of the values"
      : is_relative && *number > 99                         ? "so all would be the same; expected at most 99%"
      : is_relative && has_no_share
          ? "a share of values that may be negative means nothing; give a margin in their unit"
      : !is_relative && observed.scale == Scale::share ? "shares differ by points; expected 5%"
      : !is_relative && *number > largest              ? "no value is as large, so all would be the same; a share is 5%"
                                                       : nullptr;
  if (wrong) throw std::invalid_argument(fmt::format("--margin {}: {}", in_quotes(margin), wrong));
  plan.margin = is_relative ? *number / 100 : 0;
  observed.absolute_margin = is_relative ? 0 : *number;
  return plan;
}

}  // namespace ikbench::csv
