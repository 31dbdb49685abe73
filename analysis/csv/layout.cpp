#include "analysis/csv/layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "analysis/judge/describe.hpp"
#include "analysis/judge/tests_of_two.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "numerics/random.hpp"

namespace ikbench::csv {
namespace {

using Index = std::uint32_t;
using Rows = std::vector<Index>;

// A way to read the file: what the request says, then what is likeliest.
struct Way : Layout {
  Columns blocks;
  bool is_wide = false;  // each column of values is a group
  Rows rows;
  Options options;                 // of what the request left open
  std::vector<std::string> asked;  // why, as sentences
};

Columns operator+(Columns columns, const Columns& more) {
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

Columns without(Columns columns, std::size_t column) {
  std::erase(columns, column);
  return columns;
}

bool has(const Columns& columns, std::size_t column) { return std::ranges::count(columns, column) > 0; }
bool has(const Way& way, std::size_t column) {
  return column == way.label || column == way.run || has(way.values + way.blocks, column);
}

class Finder {
 public:
  Finder(Sheet& sheet, const Request& request) : sheet_(sheet) {
    const std::size_t columns = sheet.titles().size();  // those of the file
    asked_.rows = sheet.rows();
    for (const std::string& name : request.block) asked_.blocks.push_back(sheet.column(name));
    for (const std::string& name : request.values) {
      const std::size_t column = sheet.column(name);
      if (!has(asked_.values, column)) asked_.values.push_back(column);
    }
    if (!request.run.empty()) asked_.run = sheet.column(request.run);
    if (!request.label.empty()) name_groups(asked_, sheet.joined(request.label));
    Columns constant;
    for (std::size_t i = 0; i < columns; ++i) {
      if (has(asked_, i) || std::ranges::count(request.label, title(i)) > 0) continue;
      const auto is_title = [&](Index row) {  // as of who won in each row
        return !sheet.cell(row, i).empty() && std::ranges::count(sheet.titles(), sheet.cell(row, i)) > 0;
      };
      if (2 * std::ranges::count_if(sheet.rows(), is_title) > std::ssize(sheet.rows())) continue;
      const bool counts = sheet.counts_rows(i), is_constant = sheet.rows().size() > 1 && count(sheet.rows(), {i}) == 1;
      (counts ? asked_.counting : is_constant ? constant : sheet.has_numbers(i) ? numbers_ : texts_).push_back(i);
    }
    const auto names_rows = [&](std::size_t column) { return count(sheet.rows(), {column}) == sheet.rows().size(); };
    const bool are_few = numbers_.empty() || std::ranges::any_of(texts_, names_rows);  // rows with values of all groups
    for (const std::size_t column : asked_.values.empty() ? texts_ + constant : Columns()) {
      const auto row = sheet.broken_number(column);
      if (!row || !(are_few || 2 * count(sheet.rows(), {column}) > sheet.rows().size())) continue;
      const std::string_view cell = sheet.cell(*row, column);
      const bool is_one = cell.find_first_of("0123456789", cell.find_first_of(" (\xC2")) == std::string_view::npos;
      sheet.refuse(*row, column,
                   is_one ? "is no number: write it alone, its unit in the header, or name others with --value"
                          : "is no number but several: --summaries takes columns name, n, mean and sd");
    }
    for (const std::size_t column : constant) {  // of one group, or of equal values
      Columns& others = sheet.has_numbers(column) ? numbers_ : texts_;
      if (others.empty() && (&others == &numbers_ || numbers_.size() < 2)) others.push_back(column);
    }
    for (const std::size_t column : texts_) {
      std::set<std::string> units;
      for (const Index row : sheet.rows()) {
        const std::string_view cell = sheet.cell(row, column);
        units.insert(base::Title(fmt::format("v_{}", cell)).unit == cell ? std::string(cell) : "");
      }
      if (units.size() > 1 && !units.contains(""))
        sheet.refuse(fmt::format("{} has {}: convert its values to one unit, or take some with --where",
                                 titles_of({column}), fmt::join(units, " and ")));
    }
  }

  Layout found() {
    std::vector<Way> ways = by_groups();
    std::vector<Options> answers;
    for (Way& way : ways) {
      more_.clear();
      if (!find_values(way) && &way != ways.data()) continue;
      find_rows(way);
      answers.push_back(way.options);
      answers.insert(answers.end(), more_.begin(), more_.end());
    }
    Way& way = ways.front();
    refuse_groups(way);
    ask_of_measured(way);
    if (!way.asked.empty())
      throw Question(sheet_.said(fmt::format("it can be read in several ways; {}", fmt::join(way.asked, "; "))),
                     answers);
    if (way.run && sheet_.counts_rows(*way.run)) way.run.reset();  // each row is one
    std::vector<std::string> blocks;
    for (const std::size_t column : way.blocks) blocks.push_back(title(column));
    if (!blocks.empty()) way.block = sheet_.joined(blocks);
    return way;
  }

 private:
  Sheet& sheet_;
  Way asked_;                             // as far as the request says
  Columns texts_, numbers_;               // that may be labels and values
  std::map<std::size_t, Rows> texts_of_;  // as numbers, of each row of the file
  std::vector<Options> more_;             // of a way, which is less likely

  const std::string& title(std::size_t column) const { return sheet_.titles()[column]; }
  std::string where_of(std::size_t column, Index row) const {
    return fmt::format("{}={}", title(column), sheet_.cell(row, column));
  }
  std::string titles_of(const Columns& columns) const {
    std::vector<std::string> titles;
    for (const std::size_t column : columns) titles.push_back(in_quotes(title(column)));
    return listed(titles);
  }

  // What each of the rows has in the columns, numbered from 0.
  Rows classes_of(const Rows& rows, const Columns& columns) {
    std::vector<std::uint64_t> sums(rows.size());  // of random numbers of the texts, alike for the same texts alone
    for (const std::size_t column : columns) {
      Rows& texts = texts_of_[column];
      if (texts.empty()) {
        std::unordered_map<std::string_view, Index> known;
        texts.resize(sheet_.rows().back() + 1);
        for (const Index row : sheet_.rows())
          texts[row] = known.try_emplace(sheet_.cell(row, column), static_cast<Index>(known.size())).first->second;
      }
      for (std::size_t i = 0; i < rows.size(); ++i) sums[i] += numerics::Key(column << 32 | texts[rows[i]]).value();
    }
    Rows classes(rows.size());
    std::unordered_map<std::uint64_t, Index> known;
    for (std::size_t i = 0; i < rows.size(); ++i)
      classes[i] = known.try_emplace(sums[i], static_cast<Index>(known.size())).first->second;
    return classes;
  }
  static std::size_t number_of(const Rows& classes) { return classes.empty() ? 0 : std::ranges::max(classes) + 1; }
  std::size_t count(const Rows& rows, const Columns& columns) { return number_of(classes_of(rows, columns)); }
  std::size_t fewest_of(const Rows& rows, const Columns& columns) {  // texts
    return *std::ranges::min_element(columns, {}, [&](auto column) { return count(rows, {column}); });
  }
  std::size_t empty_in(const Rows& rows, std::size_t column) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(rows, [&](Index row) { return sheet_.cell(row, column).empty(); }));
  }
  std::set<std::string> units_of(const Columns& columns) const {
    std::set<std::string> units;
    for (const std::size_t column : columns) units.insert(base::Title(title(column)).unit);
    return units;
  }
  static Columns groups_of(const Way& way) { return way.blocks + (way.label ? Columns{*way.label} : Columns()); }

  bool is_whole(std::size_t column) {  // but where it is missing
    return std::ranges::all_of(sheet_.rows(), [&](Index row) {
      const double value = sheet_.number(row, column);
      return std::isnan(value) || value == std::floor(value);
    });
  }

  // Each of its texts is in several rows.
  bool repeats(std::size_t column) {
    std::map<Index, std::size_t> texts;
    for (const Index text : classes_of(sheet_.rows(), {column})) ++texts[text];
    return std::ranges::none_of(texts, [](const auto& text) { return text.second == 1; });
  }

  // Texts that have numbers and begin with none but these, as dates and times do.
  bool is_measured(std::size_t column) const {
    const auto is_so = [&](Index row) {
      const std::string_view cell = sheet_.cell(row, column);
      return !cell.empty() && std::isalpha(static_cast<unsigned char>(cell.front())) == 0 &&
             cell.find_first_of("0123456789") != std::string_view::npos;
    };
    return 2 * std::ranges::count_if(sheet_.rows(), is_so) > std::ssize(sheet_.rows());
  }

  // Numbers that first come in order, and count nothing.
  bool are_sizes(std::size_t column) {
    std::set<double> sizes;
    bool counts = true;
    for (const Index row : sheet_.rows()) {
      const double size = sheet_.has_numbers(column) ? sheet_.number(row, column) : 0;
      if (std::isnan(size) || !sizes.insert(size).second) continue;
      if (size < *sizes.rbegin()) return false;
      counts = counts && (sizes.size() == 1 || size == *std::next(sizes.rbegin()) + 1);
    }
    return !counts;
  }

  // The first row with the text that most rows have.
  Index commonest(const Rows& rows, std::size_t column) {
    const Rows classes = classes_of(rows, {column});
    std::vector<std::size_t> counts(number_of(classes));
    for (const Index each : classes) ++counts[each];
    const auto most = std::ranges::max_element(counts) - counts.begin();
    return rows[static_cast<std::size_t>(std::ranges::find(classes, static_cast<Index>(most)) - classes.begin())];
  }

  // Numbers as settings, labels and times have them: whole, repeated, or in order but where a run begins.
  bool is_setting(std::size_t column) {
    std::array<std::size_t, 2> changes{};  // falls, rises
    double before = std::numeric_limits<double>::quiet_NaN();
    for (const Index row : sheet_.rows()) {
      const double value = sheet_.number(row, column);
      changes[0] += value < before;
      changes[1] += before < value;
      if (!std::isnan(value)) before = value;
    }
    return is_whole(column) || repeats(column) ||
           (sheet_.rows().size() > 2 && 8 * std::ranges::min(changes) < sheet_.rows().size());
  }

  // Whether a column tells rows of a class apart as problems, runs and metrics do: by text, not everywhere another, or
  // by numbers too regular for measurements.
  bool tells_apart(Rows rows, const Columns& of_class, std::size_t column) {
    struct Class {
      Index rows = 0, different = 0, changes = 0, last = 0;
    };
    struct Text {
      Index classes = 0, most = 0;  // rows in one class
      auto operator<=>(const Text&) const = default;
    };
    Rows said = rows;
    std::erase_if(said, [&](Index row) { return sheet_.is_missing(row, column); });
    const bool are_remarks = count(said, {column}) == said.size();  // where there is none nothing is said
    if (sheet_.has_numbers(column) || are_remarks) rows = std::move(said);
    const Rows by_class = classes_of(rows, of_class), by_text = classes_of(rows, {column}),
               by_both = classes_of(rows, of_class + Columns{column});
    std::vector<Class> classes(number_of(by_class));
    std::vector<Text> texts(number_of(by_text));
    Rows alike(number_of(by_both));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Class& in = classes[by_class[i]];
      Text& text = texts[by_text[i]];
      const Index both = by_both[i];
      in.changes += in.rows++ == 0 || in.last != both;
      in.last = both;
      if (alike[both]++ == 0) ++in.different, ++text.classes;
      text.most = std::max(text.most, alike[both]);
    }
    if (std::ranges::none_of(classes, [](const Class& each) { return each.different > 1; })) return false;
    std::map<Text, std::size_t> regular;  // texts, as often
    for (const Text& text : texts) ++regular[text];
    const std::size_t single = regular[{1, 1}];
    if (!sheet_.has_numbers(column)) return texts.size() > single;
    regular.erase({1, 1});
    std::map<Index, std::size_t> sizes;  // of a text in a class, as often: most are of one in all classes, as planned
    for (const Index size : alike) ++sizes[size];
    const bool are_even = number_of(by_both) == texts.size() * classes.size() &&
                          std::ranges::any_of(sizes, [&](auto& each) { return 2 * each.second > alike.size(); });
    const auto repeats = [&](const Class& each) {
      return 2 * each.different <= each.rows && (each.changes == each.different || (are_even && each.different > 2));
    };
    const auto in_one = [](const Text& text) { return text.classes == 1; };
    const bool is_of_one =  // each repeats, in one class alone, as a run's own number
        single == 0 && classes.size() > 1 && texts.size() > classes.size() && std::ranges::all_of(texts, in_one);
    return is_of_one ||
           std::ranges::any_of(regular, [&](const auto& each) { return 2 * each.second > texts.size(); }) ||
           std::ranges::all_of(classes, repeats);
  }

  void name_groups(Way& way, std::size_t column) const {
    way.label = column;
    const std::size_t rows = way.rows.size();
    std::erase_if(way.rows, [&](Index row) { return sheet_.cell(row, column).empty(); });
    if (!way.rows.empty() && 2 * way.rows.size() < rows)
      sheet_.refuse(fmt::format("{} is empty in {} of {} rows; write it in each, also where cells are merged",
                                titles_of({column}), rows - way.rows.size(), rows));
  }

  // Refuses groups of one name or of different units.
  void refuse_groups(const Way& way) const {
    if (way.label) return;
    for (const std::size_t column : way.values) sheet_.column(title(column));  // refuses a title of two columns
    if (units_of(way.values).size() > 1)
      sheet_.refuse(fmt::format("{} have different units; convert them", titles_of(way.values)));
  }

  // Asks about a column of text that was measured, where another was taken for the values.
  void ask_of_measured(const Way& way) {
    for (const std::size_t column : asked_.values.empty() && way.label && way.asked.empty() ? texts_ : Columns()) {
      constexpr std::size_t by_chance = 8;  // rows that are in order by chance in one of 40 000 files, not by a clock
      const auto cell_of = [&](Index row) { return sheet_.cell(row, column); };
      if (has(way, column) || 2 * count(way.rows, {column}) <= way.rows.size() || !is_measured(column) ||
          (way.rows.size() >= by_chance && std::ranges::is_sorted(way.rows, {}, cell_of)))
        continue;
      throw Question(sheet_.said(fmt::format("{} of {} in line {} is no number, so it was left out; write numbers "
                                             "alone, or name others with --value",
                                             in_quotes(cell_of(way.rows.front())), titles_of({column}),
                                             sheet_.line(way.rows.front()))),
                     {with(way, "--value", way.values).options});
    }
  }
  Way with(Way way, const std::string& option, const Columns& columns) const {
    for (const std::size_t column : columns) way.options.insert(way.options.end(), {option, title(column)});
    if (option == "--label") name_groups(way, columns.front());
    if (option == "--value") way.values = columns;
    if (option == "--block") way.blocks = way.blocks + columns;
    if (option == "--run" && !columns.empty()) way.run = columns.front();
    return way;
  }

  // Of the text that this row has in the column alone.
  Way with_one(Way way, std::size_t column, Index row) const {
    std::erase_if(way.rows, [&](Index other) { return sheet_.cell(other, column) != sheet_.cell(row, column); });
    way.options.insert(way.options.end(), {"--where", where_of(column, row)});
    return way;
  }

  // One for each column that may name the groups, and one where each column may be a group.
  std::vector<Way> by_groups() {
    const Way& way = asked_;
    if (way.label) return {way};
    Columns labels, names;  // names: another text in each row
    for (const std::size_t column : texts_) {
      if (texts_.size() > 1 && 2 * empty_in(way.rows, column) > way.rows.size()) continue;  // remarks
      const std::size_t texts = count(way.rows, {column});
      if (texts == way.rows.size()) names.push_back(column);
      if (texts < way.rows.size() && texts <= most_groups) labels.push_back(column);
    }
    if (labels.empty()) labels = texts_;
    const std::size_t fewest = labels.empty() ? 0 : count(way.rows, {fewest_of(way.rows, labels)});
    const bool has_values = labels.size() > 1 && asked_.values.size() + numbers_.size() > 0;
    const Columns first = has_values ? values_of(with(way, "--label", {fewest_of(way.rows, labels)})) : Columns();
    std::ranges::stable_sort(labels, {}, [&](std::size_t column) {  // the first in the file is none of metrics
      return std::tuple(!first.empty() && column != texts_.front() && names_metrics(column, first.front()),
                        is_measured(column), count(way.rows, {column}) > 2 * fewest);  // solvers are few
    });
    Columns together;  // what names the rows
    if (!way.blocks.empty() && count(way.rows, way.blocks) == way.rows.size())
      labels = names = {};  // a row has the values of all groups
    else if (!names.empty())
      together = {names.front()};
    else if (way.blocks.empty() && !labels.empty()) {
      together = texts_;
      for (const std::size_t column : numbers_) {
        if (!has(way, column) && tells_apart(way.rows, {}, column)) together.push_back(column);
      }
      if (count(way.rows, together) < way.rows.size()) together.clear();
    }
    const bool is_text = !labels.empty();
    Columns values = is_text              ? values_of(with(way, "--label", {labels.front()}))
                     : way.values.empty() ? numbers_
                                          : way.values;
    std::erase_if(values, [&](std::size_t column) { return has(together, column); });
    const bool may_be_wide = values.size() > 1 && (!is_text || (!together.empty() && units_of(values).size() == 1));
    for (const std::size_t column : numbers_) {  // groups may have numbers, or be True and False
      const std::size_t different = count(way.rows, {column});
      const bool may_be_label =
          is_text ? labels.size() == 1 && !has(way, column) && !has(values, column) &&
                        different < count(way.rows, labels) && tells_apart(way.rows, labels, column) &&
                        count(way.rows, way.blocks + labels + Columns{column}) == way.rows.size()
                  : way.values.empty() && way.blocks.empty() && values.size() > 1 && repeats(column);
      if (may_be_label) labels.push_back(column);
    }
    if (labels.empty() && !may_be_wide)
      sheet_.refuse("no column of labels; name that of the groups with --label, or the column of each with --value");
    constexpr std::size_t most_ways = 3;  // that anybody reads
    std::vector<Way> ways;
    for (std::size_t i = 0; i < std::min(labels.size(), most_ways); ++i)
      ways.push_back(with(way, "--label", {labels[i]}));
    const bool are_numbers = !is_text && !labels.empty();  // labels, for want of text
    const Columns groups = are_numbers ? groups_in(values) : values;
    if (may_be_wide && groups.size() > 1) {
      Way wide = way;
      if (!labels.empty()) wide = together.empty() ? with(way, "--value", groups) : with(way, "--block", together);
      wide.is_wide = true;
      if (together.size() > 1 && std::ranges::all_of(together, [&](std::size_t each) { return has(texts_, each); })) {
        const std::size_t one = fewest_of(way.rows, together);
        ways.push_back(with_one(with(way, "--block", without(together, one)), one, commonest(way.rows, one)));
        ways.back().is_wide = true;
      }
      ways.insert(labels == names ? ways.begin() : ways.end(), wide);
    }
    if (ways.size() == 1 && !are_numbers)
      ways.front().options.clear();
    else
      ways.front().asked.push_back(fmt::format(
          "{} may name the groups{}, which --label says", titles_of(labels),
          may_be_wide ? ", or each column may be one, but of runs and steps, which stand below each other" : ""));
    return ways;
  }

  // Numbers but those that tell rows apart or are the same in all of a group, if there are others.
  Columns values_of(const Way& way) {
    if (!way.values.empty()) return way.values;
    if (numbers_.empty())
      sheet_.refuse(fmt::format("no column of numbers{}; name that of the values with --value",
                                way.counting.empty() ? "" : " but " + titles_of(way.counting) + ", which counts rows"));
    Columns values = numbers_;
    const std::size_t groups = count(way.rows, {*way.label});
    std::erase_if(values, [&](std::size_t column) {
      const bool is_of_group =
          groups > 1 && groups < way.rows.size() && count(way.rows, {*way.label, column}) == groups;
      return column == way.label || is_of_group || tells_apart(way.rows, {*way.label}, column);
    });
    return values.empty() ? numbers_ : values;
  }

  // Those of columns that may be groups: no settings, computed from others, bounds of all, or shares of any size where
  // others are none; and of one kind, where titles have two parts: "A mean", "A sd", "B mean", "B sd".
  Columns groups_in(const Columns& all) {
    if (all.size() > 2 * most_groups) return all;  // nobody has so many
    Columns columns = all, others;
    std::erase_if(columns, [&](auto column) { return column == all.front() ? is_setting(column) : is_whole(column); });
    const bool is_name =
        all.size() > 2 && is_whole(all.front()) && count(sheet_.rows(), {all.front()}) == sheet_.rows().size();
    if (columns.empty()) columns.assign(all.begin() + is_name, all.end());
    std::vector<std::vector<Printed>> lists;
    for (int end = 0; end < 2; ++end) {
      constexpr std::size_t most_rows = 1000;  // that need be seen
      lists.assign(std::min(most_rows, sheet_.rows().size()), {});
      Columns kept;
      for (const std::size_t column : columns) {
        for (std::size_t i = 0; i < lists.size(); ++i) lists[i].push_back(printed(sheet_, sheet_.rows()[i], column));
        bool is_again = false;  // one that is kept
        for (std::size_t at = 0; at < kept.size() && !is_again && !is_whole(column); ++at)
          is_again = std::ranges::all_of(lists, [&](const auto& list) { return list[at].value == list.back().value; });
        if (!is_again && (kept.size() < 2 || !are_computed(lists, static_cast<double>(columns.size()))))
          kept.push_back(column);
        else
          for (std::vector<Printed>& list : lists) list.pop_back();
      }
      columns.assign(kept.rbegin(), kept.rend());
    }
    std::map<std::size_t, double> sizes;
    Columns shares;
    double widest = 1,
           narrowest = std::numeric_limits<double>::infinity();  // largest by smallest, of others, of shares
    for (std::size_t i = 0; i < columns.size(); ++i) {
      bool is_bound = true, is_reached = false;
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (const std::vector<Printed>& list : lists) {
        const double value = list[columns.size() - 1 - i].value;
        is_bound = is_bound && std::ranges::none_of(list, [&](const Printed& other) { return other.value < value; });
        is_reached = is_reached || std::ranges::count(list, value, &Printed::value) > 1;
        if (std::isnan(value)) continue;
        least = std::min(least, value), most = std::max(most, std::abs(value)), sizes[columns[i]] += std::abs(value);
      }
      const bool is_share = least >= 0 && most <= 1;
      if (is_share) narrowest = std::min(narrowest, most / least);
      if (!is_share) widest = std::max(widest, most / std::abs(least));
      if (!(is_bound && is_reached)) (is_share ? shares : others).push_back(columns[i]);
    }
    if (narrowest < 10 * widest) others = others + shares;  // those of p have any size
    if (others.size() > 1) std::erase_if(columns, [&](std::size_t column) { return !has(others, column); });
    const auto end_of = [&](std::size_t column) {
      return std::min(title(column).find_last_of(" _.-/"), title(column).size());
    };
    const std::size_t first = columns.front(), end = end_of(first);
    Columns by_first, by_second;  // those that have that part as the first one has
    for (const std::size_t column : columns) {
      if (title(column).substr(0, end_of(column)) == title(first).substr(0, end)) by_first.push_back(column);
      if (title(column).substr(end_of(column)) == title(first).substr(end)) by_second.push_back(column);
    }
    if (std::min(by_first.size(), by_second.size()) < 2 || by_first.size() * by_second.size() != columns.size())
      return columns;
    const auto unlike = [&](const Columns& of_kind) {
      const auto size_of = [&](std::size_t column) { return sizes[column]; };
      const auto [least, most] = std::ranges::minmax(of_kind, {}, size_of);
      return sizes[most] / sizes[least];
    };
    return end < title(first).size() && unlike(by_first) < unlike(by_second) ? by_first : by_second;
  }

  // Whether there is more than one that may be a group.
  bool find_values(Way& way) {
    if (!way.values.empty()) return true;
    Columns values = way.is_wide ? numbers_ : values_of(way), likely = values;
    for (Columns* columns : {&values, &likely}) std::erase_if(*columns, [&](auto column) { return has(way, column); });
    if (way.is_wide && !values.empty()) likely = groups_in(values);
    if (!way.is_wide && !values.empty()) {
      Columns measured = values, broken = values;  // a value may repeat in two groups, but is seldom whole
      std::erase_if(measured, [&](std::size_t column) { return is_setting(column); });
      std::erase_if(broken, [&](std::size_t column) { return is_whole(column); });
      likely = {(!measured.empty() ? measured : !broken.empty() ? broken : values).front()};
      if (measured.size() > 1) {  // metrics beside each other; the first decides
        Way all = with(way, "--value", measured);
        find_rows(all);
        more_.push_back(all.options);
      }
    }
    const bool is_lone = way.is_wide && likely.size() == 1;
    const auto has_whole = std::ranges::any_of(values, [&](std::size_t column) { return is_whole(column); });
    if (likely == values || (is_lone && !asked_.blocks.empty() && !has_whole)) {
      way.values = values.empty() ? numbers_ : values;
      return true;
    }
    if (way.is_wide && !is_lone) {  // as where a file is sorted by one of them
      Way all = with(way, "--value", values);
      find_rows(all);
      more_.push_back(all.options);
    }
    way = with(way, "--value", is_lone ? values : likely);
    way.asked.push_back(fmt::format("of the numbers in {} --value names {}", titles_of(values),
                                    way.is_wide ? "those of the groups" : "one"));
    return !is_lone;
  }

  // Whether some of a few texts have values ten times those of all others, as metrics do.
  bool names_metrics(std::size_t column, std::size_t value) {
    constexpr std::size_t most_metrics = 8;
    const Rows texts = classes_of(sheet_.rows(), {column});
    std::map<Index, std::set<double>> sizes;
    for (std::size_t i = 0; i < texts.size(); ++i)
      sizes[texts[i]].insert(std::abs(sheet_.number(sheet_.rows()[i], value)));
    std::vector<std::pair<double, double>> ranges;
    for (const auto& [text, of_text] : sizes) ranges.emplace_back(*of_text.begin(), *of_text.rbegin());
    std::ranges::sort(ranges);
    double largest = ranges.front().second;
    return ranges.size() <= most_metrics && std::ranges::any_of(ranges, [&](const auto& range) {
             return range.first > 10 * std::exchange(largest, std::max(largest, range.second));
           });
  }

  // Whether values of each class follow each other along a column that rises in equal steps.
  bool is_curve(Rows rows, const Columns& of_class, std::size_t step, std::size_t value) {
    std::ranges::stable_sort(rows, {}, [&](Index row) { return sheet_.number(row, step); });
    std::map<Index, Rows> curves;
    const Rows classes = classes_of(rows, of_class);
    for (std::size_t i = 0; i < rows.size(); ++i) curves[classes[i]].push_back(rows[i]);
    std::vector<std::vector<double>> values;
    for (const auto& [of, curve] : curves) {
      values.emplace_back();
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const auto rise = [&](std::size_t at) {
          return sheet_.number(curve[at], step) - sheet_.number(curve[at - 1], step);
        };
        if (i > 0 && !(rise(1) > 0 && std::abs(rise(i) - rise(1)) <= 1e-6 * rise(1))) return false;
        if (const double number = sheet_.number(curve[i], value); !std::isnan(number)) values.back().push_back(number);
      }
    }
    constexpr std::size_t fewest = 8;
    return rows.size() >= fewest * curves.size() &&
           following(values) > 2.5 * std::sqrt(static_cast<double>(values.size()));
  }

  // Gives blocks and runs to what tells rows apart.
  void find_rows(Way& way) {
    Columns run, open;
    if (way.run && !sheet_.counts_rows(*way.run)) run = {*way.run};  // else each row is one
    const Columns known = groups_of(way) + run;
    const bool is_open = run.empty() && way.blocks.empty();
    if (is_open ? way.run.has_value() : count(way.rows, known) == way.rows.size()) return;
    if (way.is_wide && is_open) return find_blocks(way);
    for (const std::size_t column : way.run ? texts_ : texts_ + numbers_) {  // means of a run's numbers, as of points
      if (!has(way, column) && tells_apart(way.rows, known, column)) open.push_back(column);
    }
    if (open.empty() && (way.run || is_open)) return;
    const std::string rows = way.label ? "rows of one " + titles_of({*way.label}) : "rows";
    const bool is_first = way.blocks == asked_.blocks;  // else the rest was said with it
    if (open.empty()) {
      way = with(way, "--run", {sheet_.column("row")});
      if (is_first) way.asked.push_back(rows + " have the same --block, as repetitions (--run row)");
      return;
    }
    Columns needed = open, texts, numbers;  // the rest follows from them, as how a row ended; numbers: or dates
    for (std::size_t i = open.size(); i-- > 0;) {
      const Columns others = without(needed, open[i]);
      if (count(way.rows, known + others) == count(way.rows, known + needed)) needed = others;
    }
    for (const std::size_t column : needed)
      (sheet_.has_numbers(column) || is_measured(column) ? numbers : texts).push_back(column);
    Columns one;  // of which one text is taken: metrics, or the steps of a curve
    const std::size_t value = way.values.front();
    for (const std::size_t column : needed) {
      if (sheet_.has_numbers(column) ? is_curve(way.rows, known + without(needed, column), column, value)
                                     : has(texts, column) && names_metrics(column, value))
        one = {column};
    }
    const bool is_mixed = !one.empty(), is_of_steps = is_mixed && sheet_.has_numbers(one.front());
    if (!is_mixed && !texts.empty()) one = {fewest_of(way.rows, texts)};
    if (std::ranges::count(way.options, "--where") > 0) one.clear();
    const Index taken = is_of_steps ? way.rows.back() : one.empty() ? 0 : commonest(way.rows, one.front());
    const std::string where = one.empty() ? "" : where_of(one.front(), taken);
    if (is_first)
      way.asked.push_back(fmt::format(
          "{} differ in {}: runs, whose rows are averaged (--run), problems that all had "
          "(--block){}, or nothing that matters (--run row)",
          rows, titles_of(open),
          !one.empty()
              ? fmt::format(", {}, of which --where {} takes one", is_of_steps ? "steps of a curve" : "metrics",
                            base::one_line(base::front(where, 60)))
              : ""));
    const auto are_shared = [&](const Columns& columns) {
      return count(way.rows, groups_of(way) + columns) > count(way.rows, way.blocks + columns);
    };
    const auto has_gaps = [&](std::size_t column) { return empty_in(way.rows, column) > 0; };
    if (std::ranges::any_of(needed, has_gaps) && !way.run) {  // which name no problem
      way = with(way, "--run", {sheet_.column("row")});
      return;
    }
    // Problems have names, or numbers that grow by more than 1; the last of several numbers is that of runs.
    Columns blocks = needed, run_of;
    if (!way.run && (numbers.size() > 1 || (!numbers.empty() && !are_sizes(numbers.front()))))
      run_of = {numbers.back()}, blocks = without(needed, numbers.back());
    const bool are_blocks =
        way.run || (texts.empty() && is_first ? are_shared(needed) && (needed.size() > 2 || are_sizes(needed.front()))
                                              : texts.empty() || !way.label || are_shared(texts));
    const Way of_runs = with(way, "--run", {needed.front()});
    std::vector<Way> ways{are_blocks ? with(with(way, "--block", blocks), "--run", run_of) : of_runs};
    if (texts.empty() && is_first && are_shared(needed))
      ways.push_back(are_blocks ? of_runs : with(way, "--block", {needed.front()}));
    if (!one.empty() && is_first) ways.insert(is_mixed ? ways.begin() : ways.end(), with_one(way, one.front(), taken));
    for (Way& each : ways) {
      const auto place = std::ssize(more_);
      find_rows(each);
      if (&each != ways.data()) more_.insert(more_.begin() + place, each.options);
    }
    const std::vector<std::string> asked = way.asked;
    way = ways.front();
    way.asked = asked;
  }

  // Columns are groups: asks what rows are.
  void find_blocks(Way& way) {
    way.asked.push_back(titles_of(way.values) +
                        " are groups; rows are problems that all had (--block row, or the column "
                        "that names them) or unrelated (--run row)");
    const auto names_rows = [&](std::size_t column) {
      return !has(way, column) && is_setting(column) && count(way.rows, {column}) == way.rows.size();
    };
    const auto names = std::ranges::find_if(numbers_, names_rows);
    const std::size_t name = names != numbers_.end() ? *names : sheet_.column("row");
    const Way of_blocks = with(way, "--block", {name});
    const auto follows = [&](std::size_t value) { return is_curve(way.rows, {}, name, value); };
    if (std::ranges::all_of(way.values, follows)) {
      const std::string where = where_of(name, way.rows.back());
      way.asked.back() += fmt::format(" or steps of a curve, of which --where {} takes one", where);
      way.options.insert(way.options.end(), {"--where", where, "--run", "row"});
      more_.push_back(of_blocks.options);
    } else {
      way = of_blocks;
    }
  }
};

}  // namespace

Printed printed(Sheet& sheet, std::size_t row, std::size_t column) {
  const std::string_view text = sheet.cell(row, column);
  const std::size_t mark = text.find_last_of(".,"), exponent = std::min(text.find_first_of("eEdD"), text.size());
  const double shift = exponent < text.size() ? base::number_from(text.substr(exponent + 1)).value_or(0) : 0;
  const double value = sheet.number(row, column);
  return {value, std::pow(10, shift - (mark < exponent ? static_cast<double>(exponent - mark - 1) : 0)) / 2};
}

namespace {

// That a number like the others has these digits: by Cauchy's law, whose tails are long, or as one of several equal
// ones. It is as coarse as they are; where all have as many digits, fewer are none of theirs.
double chance_of(const Printed& last, const std::vector<double>& sorted, double half, double coarsest) {
  std::uint64_t grain = 0;  // in the finest digit
  double equal = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    grain = std::gcd(grain, static_cast<std::uint64_t>(std::min(std::round(std::abs(sorted[i]) / (2 * half)), 1e18)));
    equal += (i > 0 && sorted[i] == sorted[i - 1]) || (i + 1 < sorted.size() && sorted[i] == sorted[i + 1]);
  }
  const double step = 2 * half * static_cast<double>(grain), steps = std::abs(last.value) / step,
               as_printed = 2 * (half == coarsest ? std::min(half, last.half) : last.half),
               digit = std::abs(steps - std::round(steps)) < 1e-6 ? std::max(step, as_printed) : as_printed,
               spread = std::max(judge::quantile(sorted, 0.75) - judge::quantile(sorted, 0.25), digit) / 2,
               place = (last.value - judge::quantile(sorted, 0.5)) / spread,
               chance = digit / (std::numbers::pi * spread * (1 + place * place));
  const bool is_equal = std::ranges::binary_search(sorted, last.value);
  return std::clamp(chance, is_equal ? equal / static_cast<double>(sorted.size()) : 0, 1.0);
}

struct Statistic {
  double value = 0, rounding = 0;  // what that of the values adds
  bool is_of_two = false, is_usual = false;
};
std::vector<Statistic> statistics_of(const std::vector<double>& values, double half) {
  const judge::Description of = judge::described(values);
  double logarithms = 0;
  for (const double value : values) logarithms += std::log(value);
  std::vector<Statistic> computed;
  for (const double each : {of.mean, of.mean * of.n, of.median})
    computed.push_back({.value = each, .rounding = half / 2, .is_usual = true});
  for (const double each :
       {std::exp(logarithms / of.n), of.smallest, of.largest, of.sd, of.sd * std::sqrt(1 - 1.0 / of.n)})
    computed.push_back({.value = each, .rounding = half / 2});
  for (const bool is_turned : {false, true}) {
    const double a = values[is_turned], b = values[!is_turned], ratio = a / b,
                 of_ratio = std::abs(ratio) * half * (1 / std::abs(a) + 1 / std::abs(b));
    if (values.size() > 2) continue;
    computed.push_back({.value = a - b, .rounding = 2 * half, .is_of_two = true});
    for (const double each : {ratio, ratio - 1, 1 - ratio})
      for (const double scale : {1.0, 100.0})
        computed.push_back({.value = scale * each, .rounding = scale * of_ratio, .is_of_two = true});
  }
  return computed;
}

}  // namespace

bool are_computed(const Lists& lists, double tried, const Lists& of, std::size_t one) {
  std::vector<double> chances;  // of each statistic
  std::vector<Statistic> computed;
  for (std::size_t at = 0; at < lists.size(); ++at) {
    const Printed& last = lists[at].back();
    std::vector<double> values, from;
    double half = std::numeric_limits<double>::infinity(), coarsest = 0;
    for (std::size_t i = 0; i + 1 < lists[at].size(); ++i) {
      const Printed& each = lists[at][i];
      if (!of.empty()) from.push_back(of[at][i].value);
      if (!std::isfinite(each.value)) continue;
      values.push_back(each.value);
      half = std::min(half, each.half), coarsest = std::max(coarsest, each.half);
    }
    if (std::isinf(last.value)) return false;
    if (values.size() < 2 || std::isnan(last.value)) continue;
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    const double sum = std::accumulate(from.begin(), from.end(), 0.0), chance = chance_of(last, sorted, half, coarsest);
    computed = of.empty() ? statistics_of(values, half)
                          : std::vector{Statistic{.value = one == 0 ? sum / static_cast<double>(from.size()) : sum,
                                                  .is_usual = true}};
    chances.resize(computed.size(), 1);
    for (std::size_t i = 0; i < computed.size(); ++i) {
      const Statistic& its = computed[i];
      const double slack =
          last.half + (its.is_of_two ? its.rounding : std::min(its.rounding, last.half)) + 1e-14 * std::abs(last.value);
      const bool is_near = std::abs(last.value - its.value) <= slack;
      chances[i] *= !is_near                                 ? judge::unknown
                    : its.is_of_two || slack > 3 * last.half ? std::min(1.0, chance * slack / last.half)
                                                             : chance;
    }
  }
  for (std::size_t i = 0; i < chances.size(); ++i) {
    const double share = computed[i].is_usual ? 0.5 : 1.0 / static_cast<double>(chances.size());
    if (chances[i] < 2e-3 * share / tried) return true;
  }
  return false;
}

double following(const std::vector<std::vector<double>>& lists) {
  double sum = 0, count = 0;
  for (const std::vector<double>& list : lists) {
    const std::vector<double> ranks = judge::midranks(list).ranks;
    const auto n = static_cast<double>(ranks.size());
    double steps = 0, spread = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
      spread += std::pow(ranks[i] - (n + 1) / 2, 2);
      steps += i > 0 ? std::pow(ranks[i] - ranks[i - 1], 2) : 0;
    }
    if (spread == 0) continue;
    sum += (2 - steps / spread) / std::sqrt(20 / (5 * n + 7));
    ++count;
  }
  return count > 0 ? sum / std::sqrt(count) : 0;
}

Request with(Request request, const Options& options) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::string& option = options[i];
    request.are_summaries |= option == "--summaries";
    if (option == "--run") request.run = options[++i];
    for (const auto& [name, values] : {std::pair{"--value", &request.values},
                                       {"--label", &request.label},
                                       {"--block", &request.block},
                                       {"--where", &request.where},
                                       {"--better", &request.better}}) {
      if (option == name) values->push_back(options[++i]);
    }
  }
  return request;
}

Layout layout_of(Sheet& sheet, const Request& request) { return Finder(sheet, request).found(); }

}  // namespace ikbench::csv
