#include "experiments/microbenchmarks/goal_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <set>

namespace ikbench::microbenchmarks {

namespace {

using Values = std::vector<double>;  // one a repetition

// A goal's bound for each instruction set that has one.
struct Bound {
  bool at_least;
  std::optional<double> v4, v3, other;

  std::optional<double> of(std::string_view instruction_set) const {
    if (instruction_set == "x86-64-v4") return v4;
    if (instruction_set == "x86-64-v3") return v3;
    return other;
  }
};

Bound at_least(double v4, double v3) { return {true, v4, v3, {}}; }
Bound at_most(double v4, double v3) { return {false, v4, v3, {}}; }
Bound always_at_most(double bound) { return {false, bound, bound, bound}; }
const Bound none{};

struct Goal {
  std::string number, words;
  Bound bound;
  std::function<Values(const Measurements&)> measure;
  std::vector<std::string> needs;  // benchmarks, to say which is missing
  std::string unit = "";
  std::string peer = "";  // without which it cannot be measured
};

double median(Values values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// Repetition by repetition.
Values quotients(const Values& a, const Values& b) {
  Values quotients;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) quotients.push_back(a[i] / b[i]);
  return quotients;
}

Goal ratio(std::string number, std::string words, Bound bound, const std::string& over, const std::string& under,
           std::string peer = "") {
  return {std::move(number),
          std::move(words),
          bound,
          [=](const Measurements& all) { return quotients(all.nanoseconds(over), all.nanoseconds(under)); },
          {over, under},
          "",
          std::move(peer)};
}

Goal time(std::string number, std::string words, Bound bound, const std::string& name, double unit,
          const std::string& unit_name) {
  return {std::move(number),
          std::move(words),
          bound,
          [=](const Measurements& all) {
            Values values = all.nanoseconds(name);
            for (double& value : values) value /= unit;
            return values;
          },
          {name},
          unit_name};
}

Goal counter(std::string number, std::string words, Bound bound, const std::string& name, const std::string& key,
             const std::string& unit) {
  return {std::move(number),
          std::move(words),
          bound,
          [=](const Measurements& all) { return all.counter(name, key); },
          {name},
          unit};
}

// Cost per candidate and joint, the dearest over the cheapest size; the median of each, as no two are neighbours in
// time.
Goal growth(std::string words, const std::string& prefix) {
  return {"growth",
          std::move(words),
          at_most(1.1, 1.1),
          [=](const Measurements& all) -> Values {
            Values costs;
            for (const std::string& name : all.names(prefix)) {
              const Values costs_of_one = quotients(all.nanoseconds(name), all.counter(name, "candidate_joints"));
              if (!costs_of_one.empty()) costs.push_back(median(costs_of_one));
            }
            if (costs.size() < 2) return {};
            const auto [cheapest, dearest] = std::minmax_element(costs.begin(), costs.end());
            return {*dearest / *cheapest};
          },
          {prefix + "*"}};
}

Values largest_counter(const Measurements& all, const std::vector<std::string>& names,
                       const std::vector<std::string>& keys) {
  Values values;
  for (const std::string& name : names) {
    for (const std::string& key : keys) {
      const Values found = all.counter(name, key);
      values.insert(values.end(), found.begin(), found.end());
    }
  }
  if (values.empty()) return {};
  return {*std::max_element(values.begin(), values.end())};
}

// The dearest of several in their one form against their other, repetition by repetition.
Values largest_quotients(const Measurements& all, const std::string& prefix, const std::string& over,
                         const std::string& under) {
  Values largest;
  for (const std::string& name : all.names(prefix)) {
    if (!name.ends_with(over)) continue;
    const std::string other = name.substr(0, name.size() - over.size()) + under;
    const Values ratios = quotients(all.nanoseconds(name), all.nanoseconds(other));
    if (!ratios.empty() && (largest.empty() || median(ratios) > median(largest))) largest = ratios;
  }
  return largest;
}

Values different_hashes(const Measurements& all) {
  std::set<std::string> hashes;
  const std::vector<std::string> names = all.names("result_hash/");
  for (const std::string& name : names) hashes.insert(all.text(name, "hash"));
  if (names.size() < 2) return {};
  return {static_cast<double>(hashes.size())};
}

std::vector<Goal> goals() {
  const std::string fk = "forward_kinematics/", ba = "ik_bat/", pagmo = "pagmo/";
  std::vector<Goal> goals{
      ratio("G1", "KDL's forward kinematics / ours, batch of 50", at_least(60, 30), fk + "kdl", fk + "ours", "KDL"),
      ratio("G2", "closed form with the C library's sin and cos / ours", at_least(12, 6), fk + "closed_form",
            fk + "ours"),
      ratio("G3", "IK-BA solve / its forward kinematics only", at_most(2.5, 2.5), ba + "ours", ba + "kinematics_only"),
      ratio("G5", "IK-BA, exactly sequential / synchronous", at_most(1.1, 1.1), ba + "ours", ba + "synchronous"),
      ratio("G6", "textbook IK-BA / ours", at_least(30, 18), ba + "textbook", ba + "ours")};
  for (const auto& [name, words] :
       {std::pair("differential_evolution", "differential evolution"), std::pair("particle_swarm", "particle swarm"),
        std::pair("bee_colony", "bee colony")}) {
    const std::string pair = pagmo + name;
    goals.push_back(ratio("G7", fmt::format("pagmo's {} / ours", words), at_least(15, 10), pair + "/pagmo",
                          pair + "/ours", "pagmo"));
    goals.push_back(ratio("", fmt::format("the same, with pagmo calling our chain", words), none, pair + "/our_chain",
                          pair + "/ours", "pagmo"));
  }
  const std::vector<Goal> others{
      time("G9", "whole helix study, 2400 solves, one thread", at_most(0.8, 1.1), "study/threads/1", 1e9, "s"),
      ratio("G10", "whole helix study, one thread / two", at_least(1.85, 1.85), "study/threads/1", "study/threads/2"),
      {"G11",
       "number of different results over instruction sets and 1, 2, 4 threads",
       always_at_most(1),
       different_hashes,
       {"result_hash/*"}},
      {"G12",
       "forward kinematics, error against long double",
       always_at_most(1e-13),
       [](const Measurements& all) {
         return largest_counter(all, {"accuracy/forward_kinematics"}, {"position_cm", "position_error_cm"});
       },
       {"accuracy/forward_kinematics"},
       "cm"},
      counter("G12", "sin and cos, error against long double", always_at_most(2), "accuracy/sin_cos", "ulp", "ulp"),
      {"G13",
       "heap allocations in a solve, worst solver",
       always_at_most(0),
       [](const Measurements& all) { return largest_counter(all, all.names("allocations/"), {"allocations"}); },
       {"allocations/*"}},
      time("G14", "IK-BA with 12 bats until 0.1 cm, median solve", at_most(40, 60), ba + "to_tolerance", 1e3, "us"),
      {"",
       "share of these solves that miss 0.1 cm after 1000 iterations",
       none,
       [](const Measurements& all) {
         Values shares = all.counter("ik_bat/to_tolerance", "missed_share");
         for (double& share : shares) share *= 100;
         return shares;
       },
       {ba + "to_tolerance"},
       "%"},
      ratio("G15", "pose error / position error, batch of 50", always_at_most(1.8), fk + "ours_pose", fk + "ours"),
      {"G16",
       "solve in a shared object / built in, the dearest of the paper's six solvers",
       always_at_most(1.1),
       [](const Measurements& all) { return largest_quotients(all, "shared_objects/", "/hosted", "/built_in"); },
       {"shared_objects/*"}},
      time("G17", "round trip to a program in C, ten candidates of two joints", always_at_most(40), "round_trips/c",
           1e3, "us"),
      time("G18", "the same in Python, with what its example computes", always_at_most(150), "round_trips/python", 1e3,
           "us"),
      growth("time per candidate and joint, largest / smallest for 4 to 32 joints", fk + "joints/"),
      growth("time per candidate and joint, largest / smallest for 50 to 5000 candidates", fk + "population/")};
  goals.insert(goals.end(), others.begin(), others.end());
  return goals;
}

std::string number_text(double value) {
  const double magnitude = std::abs(value);
  if (value == static_cast<double>(static_cast<long>(std::min(magnitude, 1e9)))) return fmt::format("{:.0f}", value);
  if (magnitude < 0.01) return fmt::format("{:.1e}", value);
  return magnitude < 10 ? fmt::format("{:.2f}", value) : fmt::format("{:.1f}", value);
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + ' ' + unit;
}

std::string measured_text(const Values& values, const std::string& unit) {
  const std::string middle = with_unit(number_text(median(values)), unit);
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  if (*lowest == *highest) return middle;
  return fmt::format("{} ({} to {})", middle, number_text(*lowest), number_text(*highest));
}

std::string why_not(const Goal& goal, const Measurements& measurements) {
  for (const std::string& name : goal.needs) {
    if (const std::string error = measurements.error(name); !error.empty()) return error;
  }
  const bool noted = !measurements.context("instruction_set").empty();
  if (!goal.peer.empty() && noted && measurements.context("peers").find(goal.peer) == std::string::npos) {
    return goal.peer + " is not installed";
  }
  for (const std::string& name : goal.needs) {
    if (measurements.nanoseconds(name).empty()) return "no run of " + name;
  }
  return "no run of it";
}

Row row_of(const Goal& goal, const Measurements& measurements, std::string_view instruction_set) {
  const std::optional<double> bound = goal.bound.of(instruction_set);
  Row row{goal.number, goal.words,
          bound ? with_unit(fmt::format("{} {}", goal.bound.at_least ? ">=" : "<=", number_text(*bound)), goal.unit)
                : "no goal",
          ""};
  const Values values = goal.measure(measurements);
  if (values.empty()) {
    row.why = why_not(goal, measurements);
    return row;
  }
  row.measured = measured_text(values, goal.unit);
  if (!bound) {
    row.verdict = Verdict::no_goal;
  } else {
    const double value = median(values);
    row.verdict = (goal.bound.at_least ? value >= *bound : value <= *bound) ? Verdict::met : Verdict::not_met;
  }
  return row;
}

using Cells = std::array<std::string, 5>;
const Cells header{"#", "goal", "required", "measured", ""};

Cells cells(const Row& row) {
  std::string verdict;
  switch (row.verdict) {
    case Verdict::met:
      verdict = "met";
      break;
    case Verdict::not_met:
      verdict = "NOT MET";
      break;
    case Verdict::not_measured:
      verdict = "not measured: " + row.why;
      break;
    case Verdict::no_goal:
      break;
  }
  return {row.number, row.goal, row.required, row.measured, verdict};
}

std::string time_text(double nanoseconds) {
  if (nanoseconds < 1e3) return fmt::format("{:.3g} ns", nanoseconds);
  if (nanoseconds < 1e6) return fmt::format("{:.3g} us", nanoseconds / 1e3);
  if (nanoseconds < 1e9) return fmt::format("{:.3g} ms", nanoseconds / 1e6);
  return fmt::format("{:.3g} s", nanoseconds / 1e9);
}

}  // namespace

std::vector<Row> goal_rows(const Measurements& measurements, std::string_view instruction_set) {
  std::vector<Row> rows;
  for (const Goal& goal : goals()) rows.push_back(row_of(goal, measurements, instruction_set));
  return rows;
}

std::string as_text(const std::vector<Row>& rows) {
  std::vector<Cells> lines{header};
  std::transform(rows.begin(), rows.end(), std::back_inserter(lines), cells);
  std::array<std::size_t, std::tuple_size_v<Cells>> widths{};
  for (const Cells& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const Cells& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) row += fmt::format("{:<{}}  ", line[i], widths[i]);
    text += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

std::string as_markdown(const std::vector<Row>& rows) {
  std::string text = fmt::format("| {} |\n|---|---|---|---|---|\n", fmt::join(header, " | "));
  for (const Row& row : rows) text += fmt::format("| {} |\n", fmt::join(cells(row), " | "));
  return text;
}

std::string machine(const Measurements& measurements) {
  const auto noted = [&](const char* key) {
    const std::string value = measurements.context(key);
    return value.empty() ? std::string("unknown") : value;
  };
  const std::string peers = measurements.context("peers");
  std::string load = noted("load_avg");  // a list
  std::erase_if(load, [](char c) { return c == '[' || c == ']'; });
  return fmt::format("{}, {} processors, load {}; instruction set {}; {}, {}; commit {}; {}; peers: {}.", noted("cpu"),
                     noted("num_cpus"), load, noted("instruction_set"), noted("compiler"), noted("flags"),
                     noted("commit"), noted("date"), peers.empty() ? "none" : peers);
}

std::string times_as_markdown(const Measurements& measurements) {
  std::string text = "| benchmark | median | per candidate or draw |\n|---|---|---|\n";
  for (const std::string& name : measurements.names()) {
    const Values times = measurements.nanoseconds(name);
    if (times.empty() || name.starts_with("accuracy/") || name.starts_with("allocations/")) continue;
    Values each = measurements.counter(name, "per_candidate");
    if (each.empty()) each = measurements.counter(name, "per_draw");
    text += fmt::format("| {} | {} | {} |\n", name, time_text(median(times)),
                        each.empty() ? "" : time_text(1e9 * median(each)));
  }
  return text;
}

}  // namespace ikbench::microbenchmarks
