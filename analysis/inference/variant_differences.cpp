#include "analysis/inference/variant_differences.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/json.hpp"

namespace ikbench::inference {

using namespace results;

namespace {

using Json = nlohmann::json;
using Facts = std::map<std::string, std::string>;

constexpr std::size_t longest_value = 60;
constexpr std::size_t most_named = 20;

// Returns whether a key decides or describes numbers. A name does neither; the arm, departures and points out of reach
// follow from other keys.
bool counts(std::string_view key) {
  constexpr std::array<std::string_view, 7> others{"name",       "title",           "published", "trace",
                                                   "departures", "missing_solvers", "arm"};
  const std::string_view part = key.substr(0, key.find('.'));
  return std::ranges::find(others, part) == others.end() &&
         std::ranges::find(decide_no_solve, part) == decide_no_solve.end();
}

// {"stop": {"iterations": 200}} as stop.iterations: 200. An option that is named like a key of the study is told apart.
void add_values(Facts& facts, const std::string& json) {
  const Json parsed = numerics::parsed_json(json);
  if (!parsed.is_object() || parsed.empty()) return;  // flat, an empty one would be a value without a name
  const Json flat = parsed.flatten();                 // named: it has to outlive the loop
  for (const auto& [pointer, value] : flat.items()) {
    std::string key = pointer.empty() ? pointer : pointer.substr(1);
    std::ranges::replace(key, '/', '.');
    if (!counts(key)) continue;
    if (facts.contains(key)) key = "option " + key;
    facts[key] = value.is_string() ? value.get<std::string>() : numerics::text_of(value);
  }
}

std::set<std::string> values_of(const std::vector<Session>& sessions, const std::string& fact) {
  std::set<std::string> values;
  for (const Session& session : sessions) {
    const auto found = session.environment.find(fact);
    values.insert(found == session.environment.end() ? "unknown" : found->second);
  }
  return values;
}

Facts known_of(const Variant& of, const std::vector<Session>& sessions) {
  Facts facts{{"solver", of.series.algorithm}};
  add_values(facts, of.study.definition);
  add_values(facts, of.series.options);
  facts["source of the solver"] =
      fmt::format("{}", fmt::join(values_of(sessions, "source." + of.series.algorithm), " and "));
  for (const char* fact :
       {"version", "commit", "source", "compiler", "flags", "build_type", "instruction_set", "cpu"}) {
    facts[fact] = fmt::format("{}", fmt::join(values_of(sessions, fact), " and "));
  }
  return facts;
}

}  // namespace

Doubts why_times_differ(const std::vector<Session>& a, const std::vector<Session>& b) {
  std::set<std::string> cpus = values_of(a, "cpu");
  cpus.merge(values_of(b, "cpu"));
  if (a.empty() || b.empty() || cpus.contains("unknown")) {
    return {{.kind = DoubtKind::unknown_machine, .is_of_all = true}};
  }
  std::vector<Session> sessions = a;
  std::ranges::copy(b, std::back_inserter(sessions));
  if (Doubts doubts = cpu_doubts(machines_of(sessions)); !doubts.empty()) return doubts;
  const auto is_same = [](const Session& one, const Session& other) {
    return one.id == other.id && one.environment == other.environment;
  };
  if (std::ranges::equal(a, b, is_same)) return {};
  return {{.kind = DoubtKind::separate_sessions, .is_of_all = true}};
}

std::string differences(const Variant& a, const std::vector<Session>& of_a, const Variant& b,
                        const std::vector<Session>& of_b) {
  const Facts facts_of_a = known_of(a, of_a), facts_of_b = known_of(b, of_b);
  std::set<std::string> keys;
  for (const Facts* facts : {&facts_of_a, &facts_of_b}) {
    for (const auto& [key, value] : *facts) keys.insert(key);
  }
  const auto value_in = [](const Facts& facts, const std::string& key) {
    const auto found = facts.find(key);
    return found == facts.end() || found->second.empty() ? std::string("none")
                                                         : shortened(found->second, longest_value);
  };
  std::vector<std::string> found;
  for (const std::string& key : keys) {
    const std::string one = value_in(facts_of_a, key), other = value_in(facts_of_b, key);
    if (one != other) found.push_back(fmt::format("{} ({}, {})", key, one, other));
  }
  if (found.empty()) return "The stores show no difference between A and B except their sessions.";
  const std::size_t named = std::min(found.size(), most_named);
  const std::string more = found.size() == named ? "" : fmt::format(" and {} more", found.size() - named);
  return fmt::format("B differs from A in {}{}.",
                     fmt::join(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(named), ", "), more);
}

}  // namespace ikbench::inference
