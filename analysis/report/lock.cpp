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
  const bool has_integers = found.front().integers > 0;
  Table table{.name = "lock", .caption = fmt::format(words::lock_caption, "study"_a = lock.study)};
  for (const SetUpPoint& point : lock.points) table.columns.emplace_back(point.open);
  if (has_integers) table.columns.emplace_back("integers that agree");
  table.columns.emplace_back("numbers that agree");
  if (!has_integers) table.columns.emplace_back("within the range of chance");
  const std::vector<SetUp> all = set_ups(lock);
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back();
    for (std::size_t k = 0; k < all[i].size(); ++k) row.emplace_back(lock.points[k].alternatives[all[i][k]].where);
    const auto add = [&](int agreeing, int of) { row.emplace_back(fmt::format("{} of {}", agreeing, of)); };
    if (has_integers) add(found[i].agreeing_integers, found[i].integers);
    add(found[i].agreeing, found[i].numbers);
    if (!has_integers) add(found[i].by_chance, found[i].numbers);
  }
  table.notes = {lock_sentence(lock, found), fmt::format(words::lock_note, "solvers"_a = clauses(lock.solvers))};
  return table;
}

std::string lock_sentence(const Lock& lock, std::span<const PrintedNumbers> found) {
  const std::vector<SetUp> all = set_ups(lock);
  const bool has_integers = found.front().integers > 0;
  const auto agreeing = has_integers ? &PrintedNumbers::agreeing_integers : &PrintedNumbers::by_chance;
  const int of = has_integers ? found.front().integers : found.front().numbers;
  const int most = (*std::ranges::max_element(found, {}, agreeing)).*agreeing;
  std::vector<std::string> opening;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (found[i].*agreeing == most) opening.push_back(words_of(lock, all[i]));
  }
  return fmt::format(words::lock, "set_ups"_a = all.size(), "keys"_a = opening.size(),
                     "have"_a = opening.size() == 1 ? "has" : "have",
                     "what"_a = has_integers ? "printed integers" : "printed numbers within the range of chance",
                     "agreeing"_a = most, "integers"_a = of, "where"_a = fmt::join(opening, "; or "));
}

}  // namespace ikbench::report
