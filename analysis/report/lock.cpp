#include "analysis/report/lock.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace fmt::literals;

namespace {

std::string words_of(const Lock& lock, const SetUp& chosen) {
  std::vector<std::string> where;
  for (std::size_t i = 0; i < chosen.size(); ++i) where.push_back(lock.points[i].alternatives[chosen[i]].where);
  return listed(where);
}

}  // namespace

std::vector<SetUp> set_ups(const Lock& lock) {
  std::vector<SetUp> all{{}};
  for (const SetUpPoint& point : lock.points) {
    std::vector<SetUp> longer;
    for (const SetUp& begun : all) {
      for (std::size_t i = 0; i < point.alternatives.size(); ++i) {
        longer.push_back(begun);
        longer.back().push_back(i);
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::vector<std::string> overrides_of(const Lock& lock, const SetUp& chosen) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    std::ranges::copy(lock.points[i].alternatives[chosen[i]].set, std::back_inserter(all));
  return all;
}

Table lock_table(const Lock& lock, std::span<const PrintedNumbers> found) {
  Table table{.name = "lock", .caption = fmt::format(words::lock_caption, "study"_a = lock.study)};
  for (const SetUpPoint& point : lock.points) table.columns.emplace_back(point.open);
  table.columns.insert(table.columns.end(), {"integers that agree", "numbers that agree"});
  const std::vector<SetUp> all = set_ups(lock);
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back();
    for (std::size_t k = 0; k < all[i].size(); ++k) row.emplace_back(lock.points[k].alternatives[all[i][k]].where);
    row.emplace_back(fmt::format("{} of {}", found[i].agreeing_integers, found[i].integers));
    row.emplace_back(fmt::format("{} of {}", found[i].agreeing, found[i].numbers));
  }
  table.notes = {lock_sentence(lock, found), fmt::format(words::lock_note, "solvers"_a = clauses(lock.solvers))};
  return table;
}

std::string lock_sentence(const Lock& lock, std::span<const PrintedNumbers> found) {
  const std::vector<SetUp> all = set_ups(lock);
  const auto best = std::ranges::max_element(found, {}, &PrintedNumbers::agreeing_integers);
  const int integers = best->integers;
  std::vector<std::string> opening;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (found[i].agreeing_integers == best->agreeing_integers) opening.push_back(words_of(lock, all[i]));
  }
  const bool is_open = best->agreeing_integers == integers;
  const auto wording = !is_open              ? words::lock_stays_shut
                       : opening.size() == 1 ? words::lock_has_one_key
                                             : words::lock_has_several_keys;
  return fmt::format(fmt::runtime(wording), "set_ups"_a = all.size(), "integers"_a = integers,
                     "agreeing"_a = best->agreeing_integers, "keys"_a = opening.size(),
                     "where"_a = fmt::join(opening, "; or "));
}

}  // namespace ikbench::report
