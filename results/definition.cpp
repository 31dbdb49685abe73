#include "results/definition.hpp"

#include <fmt/core.h>

#include <limits>
#include <stdexcept>

#include "numerics/json.hpp"
#include "numerics/toml_table.hpp"

namespace ikbench::results {

using namespace numerics;

Plan plan_of(std::string_view json) {
  Plan plan;
  const toml::table table = toml_of(parsed_json(json));
  TomlReader reader(table, "the plan of a session", "");
  list_fields(reader, plan);
  return plan;
}

Definition definition_of(std::string_view json) {
  const Json all = parsed_json(json);
  if (!all.is_object()) throw std::invalid_argument("the definition of a study is no JSON object");
  const toml::table table = toml_of(all), none;
  TomlReader study(table, fmt::format("study {}", table["name"].value_or("without a name")), "");
  const auto part = [&](std::string_view key) {
    const toml::table* const found = study.subtable(key);
    return study.nested(found == nullptr ? none : *found, fmt::format("{}.", key));
  };
  TomlReader path = part("path"), stop = part("stop"), reach = part("out_of_reach"), figures = part("figures"),
             analysis = part("analysis"), arm = part("arm");
  constexpr std::pair<std::int64_t, std::int64_t> counts{0, std::numeric_limits<int>::max()}, large{0, no_limit};
  constexpr std::pair<double, double> sizes{0, std::numeric_limits<double>::max()};
  Definition of;
  for (const auto& [key, member] : {std::pair("title", &of.title),
                                    {"published", &of.published},
                                    {"robot", &of.robot},
                                    {"search", &of.search},
                                    {"start", &of.start},
                                    {"bounds", &of.bounds},
                                    {"limits", &of.limits}})
    study.text(key, *member);
  study.whole("runs", of.runs, counts);
  study.whole("points", of.points, counts);
  study.whole("seed", of.seed, large);
  study.texts("departures", of.departures);
  study.texts("missing_solvers", of.missing_solvers);
  std::string targets;
  path.text("kind", of.path);
  path.text("targets", targets);
  of.draws_targets = targets == "drawn";
  stop.number("tolerance_cm", of.stop.tolerance_cm, 1, sizes);
  stop.number("tolerance_deg", of.stop.tolerance_deg, 1, sizes);
  stop.number("seconds", of.stop.seconds, 1, sizes);
  stop.whole("iterations", of.stop.iterations, large);
  stop.whole("evaluations", of.stop.evaluations, large);
  reach.whole("points", of.out_of_reach, counts);
  arm.text("base_link", of.base_link);
  arm.text("tip_link", of.tip_link);
  arm.texts("notes", of.arm_notes);
  of.arm = text_of(all.value("arm", Json()));
  for (const char* key : {"initial_deg", "near_deg", "rotation_weight_m"}) of.task += text_of(all.value(key, Json()));
  if (of.draws_targets) of.task += text_of(all.value("path", Json()));
  list_fields(figures, of.style);
  if (const toml::table* const colours = figures.subtable("colours")) {
    TomlReader colour = figures.nested(*colours, "figures.colours.");
    for (const auto& [label, node] : *colours) colour.text(label.str(), of.style.colours[std::string(label.str())]);
  }
  if (const auto mistake = mistake_in(of.style))
    throw std::invalid_argument(fmt::format("figures: {}; expected {}", mistake->first, mistake->second));
  list_fields(analysis, of.plan);
  return of;
}

}  // namespace ikbench::results
