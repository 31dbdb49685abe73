#include "experiments/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "experiments/series_key.hpp"
#include "numerics/names.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace solvers;

namespace {

// What a reading sets: "path.tool" of "path.tool=eq27".
std::string setting_of(const Reading& reading) { return reading.set.substr(0, reading.set.find('=')); }

Reading reading(const std::string& name) {
  std::vector<std::string> names;
  for (const Reading& each : readings()) {
    if (each.set == name) return each;
    names.push_back(each.set);
  }
  throw std::invalid_argument(unknown_name("interpretation", name, names));
}

}  // namespace

const std::vector<Reading>& readings() {
  static const std::vector<Reading> list{
      {"path.tool=eq27", "2.2", "The tool is horizontal, as Eq. 27 prints it."},
      {"path.phase=cos_sin", "2.2", "The helix starts in front of the arm and winds the other way."},
      {"path.start_deg=90", "2.2", "The helix starts a quarter turn later."},
      {"path.start_deg=180", "2.2", "The helix starts half a turn later."},
      {"path.start_deg=270", "2.2", "The helix starts three quarters of a turn later."},
      {"path.spacing=k_over_n_minus_1", "2.2", "The last point lies at the end of the path."},
      {"search=all_joints", "2.3", "All seven joints are searched for the position alone; the orientation is ignored."},
      {"bounds=initial", "2.4", "No solver is clamped to the joint limits after its initial candidates."},
      {"bounds=clamp", "2.4", "Every solver is clamped to the joint limits."},
      {"IK-BA.step_factor=1", "2.4", "Eq. 14 as printed, without the factor 0.1 of Yang's code."},
      {"IK-BA.epsilon=truncated", "2.4", "eps is a normal number truncated to [-1, 1]."},
      {"IK-BA.acceptance=loudness", "2.4", "A better candidate is kept when rand < A, as Algorithm 1 says."},
      {"IK-BA.acceptance=yang2020", "2.4", "A better candidate is kept when rand > A, as in Yang's code."},
      {"IK-BA.bounds=clamp", "2.4", "The bats are clamped to the joint limits."},
      {"IK-BA.f_max=0", "2.4", "The frequency is 0: Eqs. 5, 7 and 13 have no effect."},
      {"PSO.coefficients=as_printed", "2.5", "w = 1.1312, c1 = 2.0149, c2 = 0.53514 as Table 1 labels them."},
      {"PSO.bounds=initial", "2.5", "The particles may leave the joint limits."},
      {"BA.best_of=evaluated", "2.6", "The best may be any evaluated candidate, not only an accepted one."},
      {"BA.bounds=initial", "2.6", "The bats may leave the joint limits."},
      {"K-ABC.colony=half", "2.7", "Half of the colony are food sources, half are onlookers."},
      {"K-ABC.neighbour=random", "2.7", "A source is compared with a random other one (plain ABC)."},
      {"K-ABC.fitness_unit=m", "2.7", "The roulette uses the error in metres."},
      {"K-ABC.bounds=initial", "2.7", "The sources may leave the joint limits."},
      {"MO-PSO.leader=per_particle", "2.8", "Each particle has its own leader."},
      {"MO-PSO.final_point=knee", "2.8", "The answer is the knee of the front, not the point with the smallest error."},
      {"MO-PSO.archive=100", "2.8", "The archive has 100 members."},
      {"MO-PSO.archive=200", "2.8", "The archive has 200 members."},
      {"DE.replacement=generation", "2.9", "Better trials replace their parents at the end of the generation."},
      {"DE.bounds=reflect", "2.9", "Joints outside the limits are reflected."},
      {"DE.bounds=resample", "2.9", "Joints outside the limits are drawn again."},
      {"DE.bounds=initial", "2.9", "The candidates may leave the joint limits."},
      {"wrist_branch=positive", "2.10", "Joint 6 is always positive."},
      {"wrist_branch=negative", "2.10", "Joint 6 is always negative."},
      {"wrist_branch=inside", "2.10", "The wrist takes the nearer branch inside the limits."}};
  return list;
}

std::vector<Combination> one_at_a_time() {
  std::vector<Combination> combinations{{}};
  for (const Reading& each : readings()) combinations.push_back({each});
  return combinations;
}

std::vector<Combination> full_grid(const std::vector<std::string>& names) {
  constexpr std::size_t most = 256;
  std::vector<std::vector<Reading>> factors;  // the readings of one setting
  for (const std::string& name : names) {
    if (std::ranges::count(names, name) > 1) {
      throw std::invalid_argument(fmt::format("the interpretation {} is given twice; expected it once", name));
    }
    const Reading chosen = reading(name);
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

ReadingsPlan plan_readings(const std::vector<Combination>& combinations, int seeds, const Overrides& overrides) {
  for (const std::string& text : overrides) {
    if (text.starts_with("seed=")) {
      throw std::invalid_argument(fmt::format("--set {}: interpretations use the seeds 1 to --seeds", text));
    }
  }
  ReadingsPlan plan;
  std::map<std::string, std::size_t> known;  // series key to part
  for (const Combination& combination : combinations) {
    ReadingsPlan::Row row{.readings = combination};
    for (int seed = 1; seed <= seeds; ++seed) {
      Overrides all = overrides;
      all.push_back(fmt::format("seed={}", seed));
      for (const Reading& each : combination) all.push_back(each.set);
      const Study study = load_study("slim2023", all);
      row.out_of_reach = static_cast<int>(unreachable(study).size());
      row.parts.resize(study.solvers.size());
      plan.solvers.clear();
      for (std::size_t s = 0; s < study.solvers.size(); ++s) {
        plan.solvers.push_back(study.solvers[s].label);
        const auto [found, is_new] = known.try_emplace(series_key(study, study.solvers[s]), plan.parts.size());
        if (is_new) {
          plan.parts.push_back(study);
          plan.parts.back().solvers = {study.solvers[s]};
        }
        row.parts[s].push_back(found->second);
      }
    }
    plan.rows.push_back(std::move(row));
  }
  return plan;
}

}  // namespace ikbench::experiments
