#include "analysis/csv/user_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
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
using numerics::lower_case;
using Index = std::uint32_t;
using Column = std::optional<std::size_t>;

const Words label_names{"solver", "algorithm", "group", "label", "method", "name"};
const Words metric_names{"metric", "quantity", "variable", "measure"};
const Words run_names{"run", "trial", "seed", "repetition", "replicate", "rep", "repeat", "run_id", "seed_id"};

// Where things are. Without a label each column of values is a group.
struct Layout {
  Column label, block, run;
  std::vector<std::size_t> values, used;  // used: columns that the user named

  bool has(std::size_t column) const {
    return column == label || column == block || column == run || std::ranges::count(values, column) > 0 ||
           std::ranges::count(used, column) > 0;
  }
};

// Numbers as settings and labels have them: whole, in order, or repeated.
bool is_setting(Sheet& sheet, const std::string& title) {
  std::vector<double> values;
  for (const Index row : sheet.rows()) values.push_back(sheet.number(row, sheet.column(title)));
  std::erase_if(values, [](double value) { return std::isnan(value); });
  const std::set<double> different(values.begin(), values.end());
  return std::ranges::all_of(values, [](double value) { return value == std::floor(value); }) ||
         std::ranges::is_sorted(values) || std::ranges::is_sorted(values, std::greater()) ||
         2 * different.size() <= values.size();
}

Layout layout_of(Sheet& sheet, const Request& request) {
  Layout layout;
  const auto named = [&](const std::vector<std::string>& names) {
    for (const std::string& name : names) layout.used.push_back(sheet.column(name));
    return names.empty() ? Column() : sheet.joined(names);
  };
  const std::size_t columns = sheet.titles().size();  // those of the file
  layout.label = named(request.label), layout.block = named(request.block);
  if (!request.run.empty()) layout.run = sheet.column(request.run);
  for (const std::string& name : request.values) {
    const std::size_t at = sheet.column(name);
    if (std::ranges::count(layout.values, at) == 0) layout.values.push_back(at);
  }
  if (!layout.label) layout.label = sheet.column_like(label_names);
  if (layout.label && !layout.values.empty()) return layout;
  std::vector<std::string> numbers, texts;
  for (std::size_t i = 0; i < columns; ++i) {
    const std::string& title = sheet.titles()[i];
    const auto is_chosen = [&](const std::string& where) { return where.starts_with(title + '='); };
    if (layout.has(i) || is_one_of(title, run_names) || std::ranges::any_of(request.where, is_chosen)) continue;
    if (title.empty() || title == "Unnamed: 0") continue;  // numbers of rows, as R and pandas write them
    (sheet.has_numbers(i) ? numbers : texts).push_back(title);
  }
  if (!layout.label && texts.size() > 1)
    sheet.refuse(fmt::format("text in the columns {}; name that of the groups with --label", listed(texts)));
  if (!layout.label && !texts.empty()) layout.label = sheet.column(texts.front());
  if (!layout.label && layout.values.empty()) {
    const auto is_alike = [&](const std::string& title) { return is_setting(sheet, title); };  // as counts are
    if (!numbers.empty() && is_alike(numbers.front()) && !(layout.block && std::ranges::all_of(numbers, is_alike)))
      sheet.refuse(
          fmt::format("the numbers of '{0}' are whole, in order or repeated: say --block '{0}' if they are of "
                      "problems, --label '{0}' if of groups, or name the column of each group, --value '{1}'",
                      numbers.front(), numerics::front(fmt::format("{}", fmt::join(numbers, "' --value '")), 300)));
    for (const std::string& title : numbers) layout.values.push_back(sheet.column(title));
  }
  if (!layout.label && layout.values.size() < 2)
    sheet.refuse("no column of labels; name that of the groups with --label, or the column of each with --value");
  if (!layout.values.empty()) return layout;
  if (numbers.size() > 1) {
    const std::string& title = sheet.titles()[*layout.label];
    const std::string or_groups =
        is_one_of(title, label_names) ? "" : fmt::format(", or, if each is a group, --block {}", in_quotes(title));
    sheet.refuse(fmt::format("numbers in the columns {}; name one with --value, what all groups had with --block{}",
                             listed(numbers), or_groups));
  }
  if (numbers.empty()) sheet.refuse("no column of numbers; name that of the values with --value");
  layout.values = {sheet.column(numbers.front())};
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
};

// Texts are numbered in the order of their first row.
Index number_of(std::string_view text, std::unordered_map<std::string_view, Index>& known) {
  return known.try_emplace(text, static_cast<Index>(known.size())).first->second;
}

// Refuses a row that repeats another in all but this text.
void refuse_other_text(const Sheet& sheet, Index first, Index row, std::size_t column) {
  const std::string_view text = sheet.cell(first, column);
  if (sheet.cell(row, column) == text) return;
  sheet.refuse(row, column,
               fmt::format("repeats no row with {}: choose rows with --where '{}={}', or compare within --block '{}'",
                           in_quotes(text), sheet.titles()[column], numerics::front(text, 60), sheet.titles()[column]));
}

Items items_of(Sheet& sheet, const Layout& layout, const std::vector<std::size_t>& columns) {
  Column unit = layout.block ? layout.block : layout.run ? layout.run : sheet.column_like(run_names);
  if (unit == layout.label) unit = {};
  std::unordered_map<std::string_view, Index> groups, units;
  Items items;
  items.values.reserve(columns.size() * sheet.rows().size());
  for (const std::size_t column : columns) {
    for (const Index row : sheet.rows()) {
      const std::string_view name = layout.label ? sheet.cell(row, *layout.label) : sheet.titles()[column];
      items.unlabelled += name.empty();
      if (name.empty()) continue;
      const std::string_view unit_name = unit ? sheet.cell(row, *unit) : "";
      if (unit_name.empty() && (layout.block || layout.run)) sheet.refuse(row, *unit, "is no name");
      const Index group = number_of(name, groups);
      if (group == items.groups.size()) items.groups.emplace_back(name);
      if (group == most_groups)
        sheet.refuse(fmt::format("more than {} groups, the last {}; is --label right?", most_groups, in_quotes(name)));
      items.values.push_back({.group = group,
                              .unit = unit_name.empty() ? first_without_run + row : number_of(unit_name, units),
                              .row = row,
                              .value = sheet.number(row, column)});
    }
  }
  if (items.values.empty()) sheet.refuse("no row has a label");
  items.units = static_cast<Index>(units.size());
  const auto place = [](const Value& item) { return std::tuple(item.group, item.unit); };
  std::ranges::stable_sort(items.values, {}, place);
  const auto twice = std::ranges::adjacent_find(items.values, {}, place);
  if (twice != items.values.end() && !layout.run)
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
    if (!layout.run || layout.has(column) || sheet.has_numbers(column)) continue;
    std::unordered_set<std::string_view> different;
    for (const Value& item : items.values) different.insert(sheet.cell(item.row, column));
    if (different.size() == items.values.size()) continue;  // times of day and the like
    for (std::size_t i = 1; i < items.values.size(); ++i) {
      const Value &before = items.values[i - 1], &item = items.values[i];
      if (before.group == item.group && before.unit == item.unit)
        refuse_other_text(sheet, before.row, item.row, column);
    }
  }
}

// Of one of the titles. Asks where larger values may be better.
Better better_of(const Sheet& sheet, const Request& request, const std::vector<std::string>& titles,
                 const std::string& title, bool are_shares) {
  std::string_view said;
  for (const std::string_view option : request.better) {
    const std::size_t equals = option.rfind('=');
    const bool is_of_all = equals == std::string_view::npos;
    const std::string_view way = is_of_all ? option : option.substr(equals + 1), column = option.substr(0, equals);
    if (way != "smaller" && way != "larger")
      sheet.refuse(fmt::format("--better {}; expected smaller, larger or COLUMN=larger", in_quotes(option)));
    if (!is_of_all && std::ranges::count(titles, column) == 0)
      sheet.refuse(fmt::format("--better {}: {}", in_quotes(option),
                               numerics::unknown_name("column of values", column, titles)));
    if (is_of_all ? said.empty() : column == title) said = way;
  }
  const std::string names = lower_case(fmt::format("{} {}", title, fmt::join(request.where, " ")));
  const auto is_there = [&](std::string_view word) { return names.find(word) != std::string::npos; };
  const bool may_be_larger =
      are_shares || std::ranges::any_of(Words{"success", "solved", "rate", "accuracy", "reward", "score"}, is_there);
  if (said.empty() && may_be_larger)
    sheet.refuse(
        fmt::format("are larger or smaller values of {0} better?; --better larger or --better smaller; of this column "
                    "alone: --better '{1}=larger'",
                    in_quotes(title), title));
  return said == "larger" ? Better::larger : Better::smaller;
}

// "error_cm" and "error [cm]" have a unit.
Observations quantity_of(const std::string& title) {
  const bool is_bracketed = title.ends_with(']');
  const std::size_t at = title.rfind(is_bracketed ? '[' : '_');
  Observations observed{.metric = "", .quantity = title, .tells_incomplete = true};
  for (const char c : lower_case(title)) observed.metric += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '-';
  if (at == std::string::npos || at == 0) return observed;
  const std::string unit = title.substr(at + 1, title.size() - at - (is_bracketed ? 2 : 1));
  if (!is_bracketed && !is_one_of(unit, {"cm", "mm", "m", "deg", "rad", "ms", "s"})) return observed;
  observed.quantity = title.substr(0, title.find_last_not_of(' ', at - 1) + 1);
  observed.unit = unit;
  return observed;
}

// The values of each group: means of the rows of a unit.
void fill(const Layout& layout, const Items& items, Observations& observed) {
  struct Mean {
    Index group, unit, rows = 0;
    long double sum = 0;  // by which the same rows in another order have the same mean
  };
  std::vector<Mean> means;
  for (const Value& item : items.values) {
    if (means.empty() || means.back().group != item.group || means.back().unit != item.unit)
      means.push_back({.group = item.group, .unit = item.unit});
    means.back().sum += item.value;
    ++means.back().rows;
  }
  std::vector<Index> most(layout.block ? items.units : 1);
  const auto most_of = [&](const Mean& mean) -> Index& { return most[layout.block ? mean.unit : 0]; };
  for (const Mean& mean : means) most_of(mean) = std::max(most_of(mean), mean.rows);
  observed.is_paired = layout.block.has_value();
  if (observed.scale == Scale::share) observed.trials = static_cast<int>(std::ranges::max(most));
  std::vector<std::size_t> groups_of(items.units), all(items.groups.size());  // complete ones of a block; of a group
  std::vector<Measured> measured(items.groups.size());
  for (const Mean& mean : means) {
    const auto value = static_cast<double>(mean.sum / mean.rows);
    ++all[mean.group];
    if (std::isnan(value) || mean.rows < most_of(mean)) continue;
    measured[mean.group].values.push_back(value);
    if (layout.block) ++groups_of[mean.unit];
  }
  Doubt lost{.kind = DoubtKind::incomplete,
             .what = layout.block ? "blocks incomplete"
                     : layout.run ? "runs incomplete"
                                  : "values missing"};
  Doubt without{.kind = DoubtKind::without_answer, .what = "values, counted as largest"};
  const auto add = [](Doubt& doubt, const std::string& group, auto count, std::size_t total) {
    if (count == 0) return;
    doubt.who.push_back(group);
    doubt.count += static_cast<double>(count), doubt.of += static_cast<double>(total);
  };
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const std::string& name = items.groups[i];
    std::vector<double>& values = measured[i].values;
    const std::size_t known = values.size();
    const auto lacking = static_cast<int>((layout.block ? items.units : all[i]) - known);
    // Such as time-outs have no end that anybody knows, so they repeat nothing.
    measured[i].may_repeat =
        known > 1 && std::isfinite(values.front()) && std::ranges::count(values, values.front()) == std::ssize(values);
    add(lost, name, lacking, all[i]);
    add(without, name, std::ranges::count_if(values, [](double value) { return std::isinf(value); }), known);
    Group& group = observed.groups.emplace_back(Group{.name = name});
    if (lacking > 0)
      group.sample = Untold{.why = Untold::Why::lost, .lost = lacking, .values = std::move(values)};
    else
      group.sample = std::move(measured[i]);
  }
  if (layout.block) {
    const auto in_all = std::ranges::count(groups_of, items.groups.size());
    lost.count = static_cast<double>(items.units - in_all), lost.of = static_cast<double>(items.units);
  }
  const auto unlabelled = static_cast<double>(items.unlabelled);
  Doubt stray{.kind = DoubtKind::runs_missing,
              .count = unlabelled,
              .of = unlabelled + static_cast<double>(items.values.size()),
              .what = "rows without a label, left out"};
  for (Doubt* doubt : {&lost, &without, &stray}) {
    if (doubt->count > 0) observed.doubts.push_back(std::move(*doubt));
  }
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

// The first column that has the same texts in all groups, and several: its rows look paired.
Column shared_by_groups(const Sheet& sheet, const Layout& layout, const Items& items) {
  for (std::size_t column = 0; column < sheet.titles().size() && items.groups.size() > 1; ++column) {
    if (layout.has(column)) continue;
    std::vector<std::vector<std::string_view>> texts(items.groups.size());
    for (const Value& item : items.values) texts[item.group].push_back(sheet.cell(item.row, column));
    for (std::vector<std::string_view>& of_group : texts) std::ranges::sort(of_group);
    if (texts.front().front() != texts.front().back() && std::ranges::count(texts, texts.front()) == std::ssize(texts))
      return column;
  }
  return {};
}

}  // namespace

Quantities read(std::string_view text, std::string_view source, const Request& request) {
  Sheet sheet(text, source, request.decimal);
  if (sheet.column_like({"stop_reason"}) && sheet.column_like({"series"}))
    sheet.refuse("solves of a study, which a CSV does not say all of; `ikbench report` judges its store");
  for (const std::string& condition : request.where) sheet.choose(condition);
  const Layout layout = layout_of(sheet, request);
  if (const Column metric = sheet.column_like(metric_names);
      metric && !layout.has(*metric) && !sheet.has_numbers(*metric)) {
    for (const Index row : sheet.rows()) refuse_other_text(sheet, sheet.rows().front(), row, *metric);
  }
  Quantities quantities;
  std::vector<std::string> titles;
  for (const std::size_t column : layout.values) titles.push_back(sheet.titles()[column]);
  if (!layout.label) titles = {"value"};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const Items items = items_of(sheet, layout, layout.label ? std::vector{layout.values[i]} : layout.values);
    Observations observed = quantity_of(titles[i]);
    const auto name_of = [](const std::string& title) { return quantity_of(title).quantity; };
    if (std::ranges::count(titles, observed.quantity, name_of) > 1)
      observed.quantity = titles[i], observed.unit.clear();
    refuse_mixed(sheet, layout, items);
    const Column rows = i > 0 || layout.run || layout.block ? Column() : shared_by_groups(sheet, layout, items);
    if (rows)
      quantities.notes.push_back(
          fmt::format("Rows count as unrelated; if each was the same problem for all groups, add --block '{}'.",
                      sheet.titles()[*rows]));
    settle(items, observed, quantities.notes);
    observed.better = better_of(sheet, request, titles, titles[i], observed.scale == Scale::share);
    for (const Value& item : items.values) {
      if (std::isinf(item.value) && (item.value < 0 || observed.better == Better::larger))
        sheet.refuse(item.row, layout.values[layout.label ? i : item.group],
                     "is no worst value: inf stands for no answer where smaller is better; else write NA");
    }
    fill(layout, items, observed);
    quantities.observed.push_back(std::move(observed));
  }
  return quantities;
}

Quantities read_summaries(std::string_view text, std::string_view source, const Request& request) {
  Sheet sheet(text, source, request.decimal);
  for (const std::string& condition : request.where) sheet.choose(condition);
  const auto column = [&](const Words& names) {
    const Column found = sheet.column_like(names);
    if (!found) sheet.refuse(fmt::format("no column {}; expected name, n, mean and sd", *names.begin()));
    return *found;
  };
  const std::size_t label = column(label_names), n = column({"n", "count", "n_runs"}),
                    mean = column({"mean", "avg", "average"}), sd = column({"sd", "std", "stddev", "std_dev"});
  const Column quantity = sheet.column_like(metric_names);
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
      sheet.refuse(row, label, "is no name of another group");
    const auto number = [&](std::size_t at, double least) {
      const double value = sheet.number(row, at);
      if (!(value >= least && std::isfinite(value))) sheet.refuse(row, at, "is not known or too small");
      return value;
    };
    const double size = number(n, 2);
    if (size != std::floor(size) || size > 1e9) sheet.refuse(row, n, "is no number of values");
    const Summary summary{
        .n = static_cast<int>(size), .mean = number(mean, std::numeric_limits<double>::lowest()), .sd = number(sd, 0)};
    const bool is_constant = summary.sd == 0;  // or its spread was rounded away: it would decide everything
    groups.push_back({.name = name, .sample = summary});
    if (is_constant) groups.back().sample = Untold{.why = Untold::Why::no_spread, .printed = summary};
    if (is_constant)
      observed.doubts.push_back(
          {.kind = DoubtKind::repeats_itself, .who = {name}, .count = size, .of = size, .what = "value"});
  }
  for (std::size_t i = 0; i < titles.size(); ++i)
    quantities.observed[i].better = better_of(sheet, request, titles, titles[i], false);
  return quantities;
}

Plan with_margin(Plan plan, const std::string& margin, Observations& observed) {
  const auto is_negative = [](const Group& group) {
    const auto* const summary = std::get_if<Summary>(&group.sample);
    return summary ? summary->mean < 0 : std::ranges::any_of(values_of(group), [](double each) { return each < 0; });
  };
  const bool is_share = observed.scale == Scale::share;
  const bool has_no_share = observed.scale == Scale::difference && std::ranges::any_of(observed.groups, is_negative);
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
  observed.absolute_margin = is_relative ? 0 : *number;
  return plan;
}

}  // namespace ikbench::csv
