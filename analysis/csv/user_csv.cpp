#include "analysis/csv/user_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

#include "analysis/judge/tests_of_two.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::csv {
namespace {

using namespace judge;
using base::lower_case;
using Index = std::uint32_t;

constexpr std::size_t most_last = 4;          // rows that sum up others
constexpr std::size_t most_values = 100'000;  // nobody adds such rows to more

struct Value {
  Index group, unit, row, column;  // unit: block, run or the value itself
  double value;
};

struct Mean {
  Index group, unit, rows = 0;
  long double sum = 0;  // by which the same rows in another order have the same mean
};

struct Items {
  std::vector<std::string> groups;
  std::vector<Value> values;  // by group and unit
  std::vector<Mean> means;    // of each group and unit
  Index units = 0;
  std::size_t unlabelled = 0;
};

// Texts are numbered in the order of their first row.
Index number_of(std::string_view text, std::unordered_map<std::string_view, Index>& known) {
  return known.try_emplace(text, static_cast<Index>(known.size())).first->second;
}

// Without what nobody sees.
std::string as_seen(std::string_view name) {
  std::string text = base::one_line(name);
  base::replace_marks(text, {{"\u00a0", " "},
                             {"\u2007", " "},
                             {"\u202f", " "},
                             {"\u2010", "-"},
                             {"\u2011", "-"},
                             {"\u2212", "-"},
                             {"  ", " "}});
  return std::string(base::trimmed(text));
}

Items items_of(Sheet& sheet, const Layout& layout, const Columns& columns) {
  const Column unit = layout.block ? layout.block : layout.run;
  std::unordered_map<std::string_view, Index> groups, units;
  Items items;
  items.values.reserve(columns.size() * sheet.rows().size());
  for (const std::size_t column : columns) {
    for (const Index row : sheet.rows()) {
      const std::string_view name = layout.label ? sheet.cell(row, *layout.label) : sheet.titles()[column];
      items.unlabelled += name.empty();
      if (name.empty()) continue;
      if (unit && sheet.cell(row, *unit).empty())
        sheet.refuse(row, *unit, "is no name; write merged cells in each of their rows");
      const Index group = number_of(name, groups);
      if (group == items.groups.size()) items.groups.emplace_back(name);
      if (group == most_groups)
        sheet.refuse(fmt::format("more than {} groups, the last {}; is --label right?", most_groups, in_quotes(name)));
      items.values.push_back(
          {.group = group,
           .unit = unit ? number_of(sheet.cell(row, *unit), units) : static_cast<Index>(items.values.size()),
           .row = row,
           .column = static_cast<Index>(column),
           .value = sheet.number(row, column)});
    }
  }
  if (items.values.empty()) sheet.refuse("no row has a label");
  std::set<std::string> shown;
  for (const std::string& name : items.groups)
    if (!shown.insert(as_seen(name)).second)
      sheet.refuse(fmt::format("two groups look alike, both as {}; rename one", in_quotes(name)));
  items.units = static_cast<Index>(units.size());
  std::ranges::stable_sort(items.values, {}, [](const Value& item) { return std::tuple(item.group, item.unit); });
  for (const Value& item : items.values) {
    if (items.means.empty() || items.means.back().group != item.group || items.means.back().unit != item.unit)
      items.means.push_back({.group = item.group, .unit = item.unit});
    items.means.back().sum += item.value;
    ++items.means.back().rows;
  }
  return items;
}

// Of one of the titles. Asks where the values are shares.
Better better_of(const Sheet& sheet, const Request& request, const std::vector<std::string>& titles,
                 const std::string& title, bool are_shares) {
  std::string_view said, of_all;
  for (const std::string_view option : request.better) {
    const std::size_t equals = option.rfind('=');
    const bool is_of_all = equals == std::string_view::npos;
    const std::string_view way = is_of_all ? option : option.substr(equals + 1), column = option.substr(0, equals);
    if (way != "smaller" && way != "larger")
      sheet.refuse(fmt::format("--better {}; expected smaller, larger or COLUMN=larger", in_quotes(option)));
    if (!is_of_all && std::ranges::count(titles, column) == 0)
      sheet.refuse(
          fmt::format("--better {}: {}", in_quotes(option), base::unknown_name("column of values", column, titles)));
    if (!is_of_all && column != title) continue;
    std::string_view& before = is_of_all ? of_all : said;
    if (!before.empty() && before != way)
      sheet.refuse(fmt::format("--better {} contradicts an earlier --better; expected one of them", in_quotes(option)));
    before = way;
  }
  if (said.empty()) said = of_all;
  if (said.empty() && are_shares)
    throw Question(sheet.said(fmt::format("all values of {} are 0 or 1; say which is better", in_quotes(title))),
                   {{"--better", title + "=larger"}, {"--better", title + "=smaller"}});
  return said == "larger" ? Better::larger : Better::smaller;
}

Observations quantity_of(const std::string& title) {
  const base::Title parts(title);
  Observations observed{.metric = "", .quantity = parts.name, .unit = parts.unit, .tells_incomplete = true};
  for (const char c : lower_case(title)) observed.metric += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '-';
  return observed;
}

// The values of each group.
void fill(const Layout& layout, const Items& items, Observations& observed) {
  std::vector<Index> most(layout.block ? items.units : 1);
  const auto most_of = [&](const Mean& mean) -> Index& { return most[layout.block ? mean.unit : 0]; };
  for (const Mean& mean : items.means) most_of(mean) = std::max(most_of(mean), mean.rows);
  observed.is_paired = layout.block.has_value();
  if (observed.scale == Scale::share) observed.trials = static_cast<int>(std::ranges::max(most));
  std::vector<std::size_t> groups_of(items.units), all(items.groups.size());  // complete ones of a block; of a group
  std::vector<Measured> measured(items.groups.size());
  for (const Mean& mean : items.means) {
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

// Refuses a row that is the first of each group, or one of the last, or so in each unit of a group, and has a statistic
// of the others there, or of ranks or wins of the groups, where each row has a value of all.
void refuse_totals(Sheet& sheet, const Layout& layout, const Items& items) {
  constexpr std::size_t fewest = 3;
  if (items.groups.size() < 2 || items.values.size() > most_values) return;
  for (const bool by_unit : {false, true}) {
    std::vector<Lists> kinds(1);  // values, then from either end their ranks and who is first
    std::vector<std::vector<Value>> rows;
    for (const Value& item : items.values) {
      if (rows.empty() || rows.back().back().group != item.group || (by_unit && rows.back().back().unit != item.unit))
        rows.emplace_back(), kinds[0].emplace_back();
      rows.back().push_back(item);
      kinds[0].back().push_back(printed(sheet, item.row, item.column));
    }
    const std::size_t least = std::ranges::min(rows, {}, &std::vector<Value>::size).size();
    const auto is_complete = [&](const std::vector<Value>& of) {
      return !by_unit && (layout.block || !layout.label) &&
             std::ranges::equal(of, rows.front(), {}, &Value::unit, &Value::unit);
    };
    for (const double sign : std::ranges::all_of(rows, is_complete) ? std::vector{1.0, -1.0} : std::vector<double>()) {
      Lists ranks(rows.size()), firsts(rows.size());
      for (std::size_t unit = 0; unit < least; ++unit) {
        std::vector<double> row;
        for (const std::vector<Printed>& group : kinds[0])
          row.push_back(std::isnan(group[unit].value) ? std::numeric_limits<double>::infinity()
                                                      : sign * group[unit].value);
        row = midranks(row).ranks;
        for (std::size_t g = 0; g < rows.size(); ++g) {
          ranks[g].push_back({row[g], 0.5});
          firsts[g].push_back({row[g] == std::ranges::min(row) ? 1.0 : 0.0, 0.5});
        }
      }
      kinds.insert(kinds.end(), {ranks, firsts});
    }
    for (std::size_t after = most_last + 1; after-- > 0;) {  // as many rows; if all, it is the first
      const bool is_first = after == most_last;
      if (least < fewest + (is_first ? 1 : after + 1)) continue;
      for (std::size_t k = 0; k < kinds.size(); ++k) {
        Lists lists = kinds[0], of = kinds[k];
        for (Lists* each : {&lists, &of}) {
          for (std::vector<Printed>& list : *each) {
            const auto place = static_cast<std::ptrdiff_t>(is_first ? 0 : list.size() - 1 - after);
            list.push_back(list[static_cast<std::size_t>(place)]);
            list.erase(list.begin() + place, is_first ? list.begin() + 1 : list.end() - 1);
          }
        }
        const auto is_limit = [&](const auto& list) { return list.back().value == lists.front().back().value; };
        constexpr double tried = most_last + 1;
        if (!std::ranges::all_of(lists, is_limit) &&
            (k == 0 ? are_computed(lists, tried)
                    : are_computed(lists, 4 * tried, of, k % 2 == 0)))  // mean rank, sum of firsts
          sheet.refuse(
              rows.front()[is_first ? 0 : rows.front().size() - 1 - after].row, rows.front()[0].column,
              fmt::format("sums up those {} it, as those of the other groups do; leave such rows out of the file",
                          is_first ? "below" : "above"));
      }
    }
    if (items.means.size() == items.values.size()) return;
  }
}

// Refuses groups of one value that is a statistic of all others, at an end of the file, or of another's, whose name
// theirs begins with: "A", "A_mean".
void refuse_aggregates(Sheet& sheet, const Items& items, std::size_t label) {
  constexpr std::size_t fewest = 3;
  if (items.groups.size() < 2 || items.values.size() > most_values) return;
  for (const Index row : {sheet.rows().front(), sheet.rows().back()}) {
    const auto its = std::ranges::find(items.values, row, &Value::row);
    if (its == items.values.end() || items.values.size() <= fewest * (items.groups.size() - 1) ||
        std::ranges::count(items.values, its->group, &Value::group) > 1)
      continue;
    std::vector<Printed> list;
    for (const Value& item : items.values)
      if (item.row != row) list.push_back(printed(sheet, item.row, item.column));
    list.push_back(printed(sheet, row, its->column));
    constexpr double tried = 0.3;  // its name makes a sum likely
    if (are_computed({list}, tried))
      sheet.refuse(row, its->column,
                   "is a statistic of all others, and has a name of its own; leave it out of the file");
  }
  Lists groups(items.groups.size());
  std::vector<Index> rows(groups.size());
  for (const Value& item : items.values) {
    groups[item.group].push_back(printed(sheet, item.row, item.column));
    rows[item.group] = item.row;
  }
  std::map<std::string, Lists> ends;
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (std::size_t of = 0; of < groups.size() && groups[i].size() == 1; ++of) {
      if (groups[of].size() < fewest || !items.groups[i].starts_with(items.groups[of])) continue;
      Lists& lists = ends[items.groups[i].substr(items.groups[of].size())];
      lists.push_back(groups[of]);
      lists.back().push_back(groups[i].front());
      if (are_computed(lists, static_cast<double>(groups.size())))
        sheet.refuse(rows[i], label,
                     fmt::format("sums up {}; leave such rows out of the file", in_quotes(items.groups[of])));
    }
}

// Refuses a few blocks or runs without a number where the others have one.
void refuse_unnumbered(const Sheet& sheet, std::size_t unit) {
  std::set<std::string_view> numbered, others;
  Index last = 0;
  for (const Index row : sheet.rows()) {
    const std::string_view name = sheet.cell(row, unit);
    const bool has_digit = name.find_first_of("0123456789") != std::string_view::npos;
    (has_digit ? numbered : others).insert(name);
    if (!has_digit) last = row;
  }
  if (!others.empty() && others.size() <= most_last && 4 * others.size() < numbered.size())
    sheet.refuse(last, unit,
                 "has no number, as the others have: leave rows that sum up others out of the file, or rename it");
}

// Asks where rows are no observations of their own, as steps of one run.
void ask_of_steps(const Sheet& sheet, const Items& items) {
  std::vector<std::vector<double>> groups(items.groups.size());
  for (const Value& item : items.values)
    if (!std::isnan(item.value)) groups[item.group].push_back(item.value);
  std::erase_if(groups, [](const auto& group) {  // somebody sorted it
    return std::ranges::is_sorted(group) || std::ranges::is_sorted(group, std::greater());
  });
  if (following(groups) > 4)
    throw Question(sheet.said("values follow those above them, as steps of a run do, and then each run has one value; "
                              "or rows are unrelated (--run row)"),
                   {{"--run", "row"}});
}

// What the rows were taken for.
std::string how_read(const Sheet& sheet, const Layout& layout, const Items& items,
                     const std::vector<std::string>& where) {
  const auto title_of = [&](std::size_t column) { return in_quotes(sheet.titles()[column]); };
  std::string text =
      fmt::format("Read as {} {}", items.groups.size(), layout.label ? "of " + title_of(*layout.label) : "columns");
  const Column unit = layout.block ? layout.block : layout.run;
  if (unit) text += fmt::format(" x {} of {}", items.units, title_of(*unit));
  const Index most = std::ranges::max(items.means, {}, &Mean::rows).rows;
  if (most > 1) text += fmt::format(", means of {} rows", most);
  if (!layout.block && !layout.run) text += ", rows unrelated";
  for (const std::size_t column : layout.counting)
    text += fmt::format("; {} counts rows and is left out", title_of(column));
  for (const std::string& condition : where) text += fmt::format("; only rows with {}", in_quotes(condition));
  return text + '.';
}

struct Means {
  Column n, mean, sd;
};
Means means_in(const Sheet& sheet) {
  return {.n = sheet.column_like({"n", "count", "n_runs"}),
          .mean = sheet.column_like({"mean", "avg", "average"}),
          .sd = sheet.column_like({"sd", "std", "stddev", "std_dev"})};
}

Quantities values_in(std::string_view text, std::string_view source, const Request& request) {
  Sheet sheet(text, source, request.decimal);
  if (sheet.column_like({"stop_reason"}) && sheet.column_like({"series"}))
    sheet.refuse("solves of a study, which a CSV does not say all of; `ikbench report` judges its store");
  for (const std::string& condition : request.where) sheet.choose(condition);
  if (const auto [n, mean, sd] = means_in(sheet); request.values.empty() && mean && sd) {
    std::vector<Options> answers{{"--summaries"}, {"--value", sheet.titles()[*mean]}};
    if (!n) answers.erase(answers.begin());
    throw Question(
        sheet.said("it has means and standard deviations, which --summaries compares if a column 'n' says of "
                   "how many values they are"),
        answers);
  }
  const Layout layout = layout_of(sheet, request);
  Quantities quantities;
  std::vector<std::string> titles;
  for (const std::size_t column : layout.values) titles.push_back(sheet.titles()[column]);
  if (!layout.label) titles = {"value"};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const Items items = items_of(sheet, layout, layout.label ? Columns{layout.values[i]} : layout.values);
    Observations observed = quantity_of(titles[i]);
    const auto name_of = [](const std::string& title) { return quantity_of(title).quantity; };
    if (std::ranges::count(titles, observed.quantity, name_of) > 1)
      observed.quantity = titles[i], observed.unit.clear();
    refuse_totals(sheet, layout, items);
    if (layout.label) refuse_aggregates(sheet, items, *layout.label);
    const Column unit = layout.block ? layout.block : layout.run;
    if (unit && i == 0) refuse_unnumbered(sheet, *unit);
    if (!unit && request.run.empty()) ask_of_steps(sheet, items);
    if (i == 0) quantities.notes.push_back(how_read(sheet, layout, items, request.where));
    settle(items, observed, quantities.notes);
    observed.better = better_of(sheet, request, titles, titles[i], observed.scale == Scale::share);
    for (const Value& item : items.values) {
      if (std::isinf(item.value) && (item.value < 0 || observed.better == Better::larger))
        sheet.refuse(item.row, item.column,
                     "has no meaning: inf stands for no answer, where smaller is better; otherwise write NA");
    }
    fill(layout, items, observed);
    quantities.observed.push_back(std::move(observed));
  }
  return quantities;
}

Quantities summaries_in(std::string_view text, std::string_view source, const Request& request) {
  Sheet sheet(text, source, request.decimal);
  for (const std::string& condition : request.where) sheet.choose(condition);
  const auto [n, mean, sd] = means_in(sheet);
  for (const auto& [name, found] : {std::pair("n", n), {"mean", mean}, {"sd", sd}})
    if (!found) sheet.refuse(fmt::format("no column {}; expected name, n, mean and sd", name));
  const Column quantity = sheet.column_like({"metric"});
  std::vector<std::string> texts = request.label;
  for (std::size_t i = 0; request.label.empty() && i < sheet.titles().size(); ++i) {
    if (i != quantity && !sheet.has_numbers(i)) texts.push_back(sheet.titles()[i]);
  }
  if (texts.empty()) sheet.refuse("no column of text; name that of the groups with --label");
  if (request.label.empty() && texts.size() > 1) {
    std::vector<Options> answers;
    for (const std::string& name : texts) {
      const std::size_t groups = sheet.column(name);
      answers.push_back({"--label", name});
      const auto is_again = [&](Index row) {
        return row != sheet.rows()[0] && sheet.cell(row, groups) == sheet.cell(sheet.rows()[0], groups);
      };
      for (const std::string& other : std::ranges::any_of(sheet.rows(), is_again) ? texts : std::vector<std::string>())
        if (other != name)
          answers.back().insert(
              answers.back().end(),
              {"--where", fmt::format("{}={}", other, sheet.cell(sheet.rows()[0], sheet.column(other)))});
    }
    throw Question(sheet.said(fmt::format("{} may name the groups", listed(texts))), answers);
  }
  const std::size_t label = sheet.joined(texts);
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

// With each answer, and more that it is asked for, tried: what is likeliest may be refused as a whole.
Quantities answered(std::string_view text, std::string_view source, const Request& request, int asked) {
  try {
    return request.are_summaries ? summaries_in(text, source, request) : values_in(text, source, request);
  } catch (const Question& question) {
    constexpr int most_asked = 3;
    std::vector<Options> answers;
    for (const Options& answer : asked < most_asked ? question.answers : std::vector<Options>()) {
      try {
        answered(text, source, with(request, answer), asked + 1);
        answers.push_back(answer);
      } catch (const Question& further) {
        for (const Options& more : further.answers) {
          answers.push_back(answer);
          answers.back().insert(answers.back().end(), more.begin(), more.end());
        }
      } catch (const std::invalid_argument&) {
        if (answers.empty()) throw;
      }
    }
    throw Question(question.what(), answers);
  }
}

}  // namespace

Quantities read(std::string_view text, std::string_view source, const Request& request) {
  return answered(text, source, request, 0);
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
  const bool is_share = observed.scale == Scale::share;
  const bool has_no_share = observed.scale == Scale::difference && least < 0;
  if (margin.empty()) {
    if (has_no_share) plan.margin = 0;
    return plan;
  }
  const bool is_relative = margin.ends_with('%');
  const auto number = base::number_from(std::string_view(margin).substr(0, margin.size() - is_relative));
  const char* wrong =
      !number || !(*number >= 0) || !std::isfinite(*number) ? "expected 5%, or 0.1 in the unit of the values"
      : is_relative && has_no_share
          ? "a share of values that may be negative means nothing; give a margin in their unit"
      : !is_relative && is_share          ? "shares differ by points; expected 5%"
      : !is_relative && *number > largest ? "no value is as large, so all would be the same; a share is 5%"
                                          : nullptr;
  if (wrong) throw std::invalid_argument(fmt::format("--margin {}: {}", in_quotes(margin), wrong));
  plan.margin = is_relative ? *number / 100 : 0;
  observed.absolute_margin = is_relative ? 0 : *number;
  return plan;
}

}  // namespace ikbench::csv
