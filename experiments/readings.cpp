#include "experiments/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "numerics/names.hpp"

namespace ikbench::experiments {

using namespace numerics;

namespace {

// What a reading sets: "path.tool" of "path.tool=eq27".
std::string setting_of(const Reading& reading) { return reading.set.substr(0, reading.set.find('=')); }

const Reading& reading(const std::vector<Reading>& readings, const std::string& name) {
  std::vector<std::string> names;
  for (const Reading& each : readings) {
    if (each.set == name) return each;
    names.push_back(each.set);
  }
  throw std::invalid_argument(unknown_name("interpretation", name, names));
}

}  // namespace

std::vector<Reading> readings(std::string_view study) {
  std::vector<Reading> list;
  for (const Dimension& dimension : dimensions(study)) {
    for (const Alternative& each : dimension.alternatives) {
      if (&each == &dimension.alternatives.front()) continue;
      list.push_back({.set = each.set, .section = dimension.section, .sentence = each.sentence()});
    }
  }
  return list;
}

std::vector<Combination> one_at_a_time(const std::vector<Reading>& readings) {
  std::vector<Combination> combinations{{}};
  for (const Reading& each : readings) combinations.push_back({each});
  return combinations;
}

std::vector<Combination> full_grid(const std::vector<Reading>& readings, const std::vector<std::string>& names) {
  constexpr std::size_t most = 256;
  std::vector<std::vector<Reading>> factors;  // the readings of one setting
  for (const std::string& name : names) {
    if (std::ranges::count(names, name) > 1) {
      throw std::invalid_argument(fmt::format("the interpretation {} is given twice; expected it once", name));
    }
    const Reading& chosen = reading(readings, name);
    const auto same = std::ranges::find_if(
        factors, [&](const auto& factor) { return setting_of(factor.front()) == setting_of(chosen); });
    if (same != factors.end()) {
      same->push_back(chosen);
    } else {
      factors.push_back({chosen});
    }
  }
  std::vector<Combination> grid{{}};
  for (const auto& factor : factors) {
    const std::vector<Combination> smaller = grid;
    if (smaller.size() * (factor.size() + 1) > most) {
      throw std::invalid_argument(
          fmt::format("{} interpretations make more than {} combinations; expected fewer", names.size(), most));
    }
    for (const Reading& level : factor) {
      for (Combination combination : smaller) {
        combination.push_back(level);
        grid.push_back(std::move(combination));
      }
    }
  }
  return grid;
}

ReadingsPlan plan_readings(const std::string& name, const std::vector<Combination>& combinations, int seeds,
                           const Overrides& overrides) {
  refuse_seed(overrides);
  ReadingsPlan plan;
  SeriesList needed;
  for (const Combination& combination : combinations) {
    ReadingsPlan::Row row{.readings = combination};
    for (int seed = 1; seed <= seeds; ++seed) {
      Overrides all = overrides;
      all.push_back(fmt::format("seed={}", seed));
      for (const Reading& each : combination) all.push_back(each.set);
      const Study study = load_study(name, all);
      row.out_of_reach = static_cast<int>(unreachable(study).size());
      row.parts.resize(study.solvers.size());
      plan.solvers.clear();
      for (std::size_t s = 0; s < study.solvers.size(); ++s) {
        plan.solvers.push_back(study.solvers[s].label);
        row.parts[s].push_back(needed.add(study, s));
      }
    }
    plan.rows.push_back(std::move(row));
  }
  plan.parts = std::move(needed.parts);
  return plan;
}

}  // namespace ikbench::experiments
