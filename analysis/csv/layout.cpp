#include "analysis/csv/layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <unordered_map>

#include "numerics/names.hpp"

namespace ikbench::csv {
namespace {

using Index = std::uint32_t;
using Rows = std::vector<Index>;
using Columns = std::vector<std::size_t>;

constexpr std::size_t most_answers = 8;

// Rows by what they have in some columns, numbered from 0.
struct Classes {
  Rows of_row;  // as the rows are listed
  Index count = 1;
};

// A way to read the file, as far as it is settled.
struct Way {
  Column label, run;
  Columns values, blocks;
  bool is_wide = false;  // each column of values is a group
  Rows rows;
  std::vector<std::string> options, meaning;  // of what the request left open
};

class Finder {
 public:
  Finder(Sheet& sheet, const Request& request) : sheet_(sheet) {
    const std::size_t columns = sheet.titles().size();  // those of the file
    Way way;
    way.rows = sheet.rows();
    for (const std::string& name : request.block) way.blocks.push_back(sheet.column(name));
    for (const std::string& name : request.values) {
      const std::size_t column = sheet.column(name);
      if (std::ranges::count(way.values, column) == 0) way.values.push_back(column);
    }
    if (!request.run.empty()) way.run = sheet.column(request.run);
    if (!request.label.empty()) name_groups(way, sheet.joined(request.label));
    Columns constant;
    for (std::size_t i = 0; i < columns; ++i) {
      if (has(way, i) || std::ranges::count(request.label, title(i)) > 0) continue;
      const bool has_numbers = sheet.has_numbers(i);
      if (way.values.empty() && 2 * classes_of(way.rows, {i}).count > way.rows.size()) refuse_broken(i);
      if (has_numbers && sheet.counts_rows(i))
        counting_.push_back(i);
      else if (sheet.rows().size() > 1 && classes_of(sheet.rows(), {i}).count == 1)
        constant.push_back(i);
      else
        (has_numbers ? numbers_ : texts_).push_back(i);
    }
    for (const std::size_t column : constant) {  // of one group, or of equal values
      Columns& others = sheet.has_numbers(column) ? numbers_ : texts_;
      if (others.empty() && (&others == &numbers_ || numbers_.size() < 2)) others.push_back(column);
    }
    asked_ = way;
    ways_ = from(way, most_answers);
  }

  Layout found() {
    if (ways_.size() > 1 || !ways_.front().options.empty()) {
      std::vector<Answer> answers;
      for (const Way& way : ways_) answers.push_back({fmt::format("{}", fmt::join(way.meaning, ", ")), way.options});
      throw Question(sheet_.said(question_), std::move(answers));
    }
    const Way& way = ways_.front();
    Layout layout{.label = way.label, .values = way.values, .counting = counting_};
    if (way.run && !sheet_.counts_rows(*way.run)) layout.run = way.run;  // else each row is one
    std::vector<std::string> blocks;
    for (const std::size_t column : way.blocks) blocks.push_back(title(column));
    if (!blocks.empty()) layout.block = sheet_.joined(blocks);
    return layout;
  }

 private:
  Sheet& sheet_;
  Way asked_;
  Columns texts_, numbers_;  // that may be labels and values
  Columns counting_;
  std::map<std::size_t, Rows> texts_of_;  // as numbers, of each row of the file
  std::string question_;                  // the first
  std::vector<Way> ways_;

  const std::string& title(std::size_t column) const { return sheet_.titles()[column]; }
  std::string titles_of(const Columns& columns) const {
    std::vector<std::string> titles;
    for (const std::size_t column : columns) titles.push_back(in_quotes(title(column)));
    return listed(titles);
  }
  static bool has(const Way& way, std::size_t column) {
    return column == way.label || column == way.run || std::ranges::count(way.values, column) > 0 ||
           std::ranges::count(way.blocks, column) > 0;
  }

  void refuse_broken(std::size_t column) const {
    if (const auto row = sheet_.broken_number(column))
      sheet_.refuse(*row, column, "is no number: write it alone, its unit in the header, or name others with --value");
  }

  Classes classes_of(const Rows& rows, const Columns& columns) {
    Classes classes{.of_row = Rows(rows.size())};
    for (const std::size_t column : columns) {
      Rows& texts = texts_of_[column];
      if (texts.empty()) {
        std::unordered_map<std::string_view, Index> known;
        texts.resize(sheet_.rows().back() + 1);
        for (const Index row : sheet_.rows())
          texts[row] = known.try_emplace(sheet_.cell(row, column), static_cast<Index>(known.size())).first->second;
      }
      std::unordered_map<std::uint64_t, Index> known;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::uint64_t both = std::uint64_t{classes.of_row[i]} << 32 | texts[rows[i]];
        classes.of_row[i] = known.try_emplace(both, static_cast<Index>(known.size())).first->second;
      }
      classes.count = static_cast<Index>(known.size());
    }
    return classes;
  }
  // Of groups, blocks and further columns.
  Classes classes_of(const Way& way, Columns columns = {}) {
    columns.insert(columns.end(), way.blocks.begin(), way.blocks.end());
    if (way.label) columns.push_back(*way.label);
    return classes_of(way.rows, columns);
  }
  bool is_one_each(const Way& way, const Columns& further = {}) {
    return classes_of(way, further).count == way.rows.size();
  }

  // Numbers as settings and labels have them: whole, in order, or repeated.
  bool is_setting(std::size_t column) {
    std::vector<double> values;
    for (const Index row : sheet_.rows()) values.push_back(sheet_.number(row, column));
    std::erase_if(values, [](double value) { return std::isnan(value); });
    const std::set<double> different(values.begin(), values.end());
    return std::ranges::all_of(values, [](double value) { return value == std::floor(value); }) ||
           std::ranges::is_sorted(values) || std::ranges::is_sorted(values, std::greater()) ||
           2 * different.size() <= values.size();
  }

  // Whether a column tells the rows of a class apart as problems, runs and metrics do: by text, not everywhere another,
  // or by numbers too regular for measurements.
  bool tells_apart(const Rows& rows, const Classes& classes, std::size_t column) {
    struct Seen {
      Index rows = 0, different = 0, changes = 0, last = 0;
    };
    std::vector<Seen> seen(classes.count);
    std::vector<std::pair<Index, Index>> cells;  // text and class
    const Classes texts = classes_of(rows, {column});
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (sheet_.is_missing(rows[i], column)) continue;
      Seen& before = seen[classes.of_row[i]];
      cells.emplace_back(texts.of_row[i], classes.of_row[i]);
      if (before.rows++ > 0 && before.last != texts.of_row[i]) ++before.changes;
      before.last = texts.of_row[i];
    }
    std::ranges::sort(cells);
    std::map<std::pair<Index, Index>, std::size_t> alike;  // texts, by their classes and their most rows in one
    std::size_t different = 0;
    bool are_in_all = true;
    for (std::size_t begin = 0, end = 0; begin < cells.size(); begin = end, ++different) {
      Index in = 0, most = 0;
      for (; end < cells.size() && cells[end].first == cells[begin].first; ++in) {
        const std::size_t first = end;
        while (end < cells.size() && cells[end] == cells[first]) ++end;
        most = std::max(most, static_cast<Index>(end - first));
        ++seen[cells[first].second].different;
      }
      ++alike[{in, most}];
      are_in_all = are_in_all && in == classes.count;
    }
    if (std::ranges::none_of(seen, [](const Seen& each) { return each.different > 1; })) return false;
    if (!sheet_.has_numbers(column)) return different > alike[{1, 1}];
    alike.erase({1, 1});
    const auto repeats = [&](const Seen& each) {
      return 2 * each.different <= each.rows &&
             (each.changes + 1 == each.different || (are_in_all && each.different > 2));
    };
    return std::ranges::any_of(alike, [&](const auto& each) { return 2 * each.second > different; }) ||
           std::ranges::all_of(seen, repeats);
  }

  void name_groups(Way& way, std::size_t column) const {
    way.label = column;
    std::erase_if(way.rows, [&](Index row) { return sheet_.cell(row, column).empty(); });
  }
  Way with(Way way, const std::string& option, const Columns& columns, const std::string& meaning) const {
    for (const std::size_t column : columns) way.options.insert(way.options.end(), {option, title(column)});
    way.meaning.push_back(meaning);
    if (option == "--label") name_groups(way, columns.front());
    if (option == "--value") way.values = columns;
    if (option == "--block") way.blocks.insert(way.blocks.end(), columns.begin(), columns.end());
    if (option == "--run") way.run = columns.front();
    return way;
  }

  // Ways to read the file from here on, the likeliest first; this one if it leaves nothing open.
  std::vector<Way> from(const Way& way, std::size_t most) {
    if (!way.label && !way.is_wide) return by_groups(way, most);
    if (way.values.empty()) return by_values(way, most);
    return by_rows(way, most);
  }
  void add(std::vector<Way>& ways, std::size_t most, const Way& way, std::size_t most_of_way = 1) {
    if (ways.size() < most)
      std::ranges::move(from(way, std::min(most - ways.size(), most_of_way)), std::back_inserter(ways));
  }
  void ask(const std::string& what) {
    if (question_.empty()) question_ = what;
  }

  std::vector<Way> by_groups(const Way& way, std::size_t most) {
    const auto is_name = [&](std::size_t column) { return classes_of(way.rows, {column}).count == way.rows.size(); };
    Columns labels = texts_, names;  // names: another text in each row
    std::ranges::copy_if(texts_, std::back_inserter(names), is_name);
    if (names.size() < labels.size()) std::erase_if(labels, is_name);
    const auto is_small = [&](std::size_t column) { return classes_of(way.rows, {column}).count <= most_groups; };
    if (std::ranges::any_of(labels, is_small)) std::erase_if(labels, std::not_fn(is_small));
    if (!way.blocks.empty() && is_one_each(way)) labels = names = {};  // a row has the values of all groups
    Columns together;                                                  // what names the rows
    if (!names.empty())
      together = {names.front()};
    else if (way.blocks.empty() && !labels.empty()) {
      together = texts_;
      const Classes all = classes_of(way.rows, {});
      std::ranges::copy_if(numbers_, std::back_inserter(together),
                           [&](std::size_t column) { return !has(way, column) && tells_apart(way.rows, all, column); });
      if (classes_of(way.rows, together).count < way.rows.size()) together.clear();
    }
    const bool is_text = !labels.empty();
    Columns values = way.values.empty() ? numbers_ : way.values;
    if (is_text)
      values = values_of(with(way, "--label", {labels.front()}, ""));
    else if (way.values.empty() && way.blocks.empty() && values.size() > 1)
      std::ranges::copy_if(numbers_, std::back_inserter(labels), [&](std::size_t column) {
        return 2 * classes_of(way.rows, {column}).count <= way.rows.size() && is_setting(column);
      });
    std::erase_if(values, [&](std::size_t column) { return std::ranges::count(together, column) > 0; });
    const bool may_be_wide = values.size() > 1 && (!is_text || !together.empty());
    if (labels.empty() && !may_be_wide)
      sheet_.refuse("no column of labels; name that of the groups with --label, or the column of each with --value");
    std::vector<Way> ways;
    const auto add_wide = [&](bool is_there) {
      if (!is_there) return;
      Way wide = way;
      if (!together.empty())
        wide = with(way, "--block", together, "each column is a group");
      else if (!labels.empty())
        wide = with(way, "--value", numbers_, "the groups are " + titles_of(numbers_));
      wide.is_wide = true;
      add(ways, most, wide, most);
    };
    if (labels.size() == 1 && !may_be_wide) {
      Way labelled = way;
      name_groups(labelled, labels.front());
      return from(labelled, most);
    }
    if (labels.size() + may_be_wide > 1)
      ask(fmt::format("{} may name the groups{}; say which does with --label", titles_of(is_text ? texts_ : labels),
                      may_be_wide ? ", or each column may be one" : ""));
    add_wide(may_be_wide && labels == names);
    for (const std::size_t column : labels)
      add(ways, most, with(way, "--label", {column}, titles_of({column}) + " names the groups"), 2);
    add_wide(may_be_wide && labels != names);
    return ways;
  }

  // Numbers but those that tell rows apart or are the same in all of a group, if there are others.
  Columns values_of(const Way& way) {
    if (!way.values.empty()) return way.values;
    if (numbers_.empty()) {
      for (const std::size_t column : texts_) refuse_broken(column);
      sheet_.refuse(
          counting_.empty()
              ? "no column of numbers; name that of the values with --value"
              : fmt::format("no column of numbers but {}, which counts the rows; --value takes it all the same",
                            titles_of({counting_.front()})));
    }
    Columns values = numbers_;
    const Classes groups = classes_of(way.rows, {*way.label});
    std::erase_if(values, [&](std::size_t column) {
      const bool is_of_group = groups.count > 1 && groups.count < way.rows.size() &&
                               classes_of(way.rows, {*way.label, column}).count == groups.count;
      return column == way.label || is_of_group || tells_apart(way.rows, groups, column);
    });
    return values.empty() ? numbers_ : values;
  }

  std::vector<Way> by_values(const Way& way, std::size_t most) {
    std::vector<Way> ways;
    Columns values = way.is_wide ? numbers_ : values_of(way);
    std::erase_if(values, [&](std::size_t column) { return has(way, column); });
    Columns measured;
    if (way.is_wide)
      std::ranges::copy_if(values, std::back_inserter(measured),
                           [&](std::size_t column) { return !is_setting(column); });
    if (way.is_wide ? measured.empty() || measured == values : values.size() == 1) {
      Way valued = way;
      valued.values = values;
      return from(valued, most);
    }
    ask(fmt::format("numbers in {}; name {} with --value", titles_of(values),
                    way.is_wide ? "those of the groups" : "one"));
    for (const std::size_t value : way.is_wide ? Columns() : values)
      add(ways, most, with(way, "--value", {value}, titles_of({value}) + " is compared"), 2);
    for (const Columns& groups : {measured, values}) {
      if (way.is_wide && groups.size() > 1)
        add(ways, most, with(way, "--value", groups, "the groups are " + titles_of(groups)), 2);
    }
    return ways;
  }

  std::vector<Way> by_rows(const Way& way, std::size_t most) {
    const Column run = way.run && !sheet_.counts_rows(*way.run) ? way.run : Column();  // else each row is one
    if (way.run && !run && way.blocks.empty()) return {way};
    const Columns further = run ? Columns{*run} : Columns();
    if ((run || !way.blocks.empty()) && is_one_each(way, further)) return {way};
    std::vector<Way> ways;
    const auto add_blocks = [&](const Columns& columns) {
      Columns all = way.blocks;
      all.insert(all.end(), columns.begin(), columns.end());
      if (!way.label || classes_of(way, columns).count > classes_of(way.rows, all).count)
        add(ways, most, with(way, "--block", columns, "all had the same " + titles_of(columns)));
    };
    const auto add_run = [&](std::size_t column) {
      add(ways, most,
          with(way, "--run", {column},
               fmt::format(fmt::runtime(is_one_each(way, {column}) ? "{} only numbers the rows"
                                                                   : "rows of one {} count as their mean"),
                           titles_of({column}))));
    };
    const auto add_row = [&] {
      add(ways, most,
          with(way, "--run", {sheet_.column("row")},
               way.blocks.empty() ? "rows have nothing in common" : "rows of a block are repetitions"));
    };
    if (way.is_wide && way.blocks.empty() && !run) {
      ask(fmt::format("{} are groups; say whether rows are problems that all had (--block)", titles_of(way.values)));
      for (const std::size_t column : numbers_) {
        const bool is_setting_of_all =
            way.options.empty() && way.values.size() > 2 && column == way.values.front() && is_setting(column);
        if (!is_one_each(way, {column}) || (has(way, column) && !is_setting_of_all)) continue;
        Way within = with(way, "--block", {column}, "all had the same " + titles_of({column}));
        std::erase(within.values, column);
        add(ways, most, within);
      }
      add(ways, most, with(way, "--block", {sheet_.column("row")}, "each row is a problem that all had"));
      add_row();
      return ways;
    }
    Columns open;
    const Classes classes = classes_of(way, further);
    for (const Columns* columns : {&texts_, &numbers_}) {
      if (way.run && columns == &numbers_) continue;  // such as points, of which means are taken
      std::ranges::copy_if(*columns, std::back_inserter(open), [&](std::size_t column) {
        return !has(way, column) && tells_apart(way.rows, classes, column);
      });
    }
    if (open.empty() && (way.run || way.blocks.empty())) return {way};
    const std::string rows = way.label ? "rows of one " + titles_of({*way.label}) : "rows";
    ask(open.empty() ? fmt::format("several {} have the same {}; say whether they are repetitions (--run row)", rows,
                                   titles_of(way.blocks))
                     : fmt::format("{} differ in {}; say what that is: runs, whose rows are averaged (--run), problems "
                                   "that all had (--block), or metrics or settings (--where takes one)",
                                   rows, titles_of(open)));
    Columns texts, numbers, needed = open;  // the rest follows from them, as how a row ended
    for (std::size_t i = open.size(); i-- > 0 && !way.run;) {
      Columns others = needed;
      std::erase(others, open[i]);
      if (classes_of(way, others).count == classes_of(way, needed).count) needed = others;
    }
    for (const std::size_t column : needed) (sheet_.has_numbers(column) ? numbers : texts).push_back(column);
    if (!texts.empty()) {
      add_blocks(texts);
      const std::size_t chosen = *std::ranges::min_element(
          texts, {}, [&](std::size_t column) { return classes_of(way.rows, {column}).count; });
      const std::string_view text = sheet_.cell(way.rows.front(), chosen);
      const std::string condition = fmt::format("{}={}", title(chosen), text);
      Way one = with(way, "--where", {}, fmt::format("{} is one metric or setting of several", in_quotes(condition)));
      one.options.insert(one.options.end(), {"--where", condition});
      std::erase_if(one.rows, [&](Index row) { return sheet_.cell(row, chosen) != text; });
      add(ways, most, one);
      if (texts.size() == 1 && !way.run && needed == open) add_run(chosen);
    } else {
      for (const std::size_t column : numbers) add_run(column);
      if (!numbers.empty()) add_blocks({numbers.begin(), numbers.end() - (numbers.size() > 1)});
    }
    // The groups may have numbers, or be True and False.
    const bool may_be_label = !asked_.label && way.label && std::ranges::count(way.options, "--label") == 0;
    if (may_be_label && texts.empty() && numbers.size() == 1 && is_one_each(way, numbers) &&
        classes_of(way.rows, numbers).count < classes_of(way.rows, {*way.label}).count)
      add(ways, most, with(asked_, "--label", numbers, titles_of(numbers) + " names the groups"));
    const bool is_numbered = texts.empty() && numbers.size() == 1 && way.blocks.empty() && is_one_each(way, numbers);
    if (!way.run && !is_numbered && (texts.empty() || way.blocks.empty())) add_row();
    return ways;
  }
};

}  // namespace

Layout layout_of(Sheet& sheet, const Request& request) { return Finder(sheet, request).found(); }

}  // namespace ikbench::csv
