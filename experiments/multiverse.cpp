#include "experiments/multiverse.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "base/embedded_file.hpp"
#include "base/toml_table.hpp"
#include "base/units.hpp"
#include "experiments/study/series_key.hpp"
#include "experiments/task.hpp"
#include "experiments/verifier.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace results;

namespace {

constexpr EmbeddedFile multiverse_files[]{
#include "multiverse.inc"
};

constexpr std::size_t max_tables = 100;

// Returns all settings that are possible together, one of each dimension.
std::vector<Overrides> combinations(const std::vector<Dimension>& dimensions) {
  std::vector<Overrides> combined{{}};
  for (const Dimension& dimension : dimensions) {
    std::vector<Overrides> longer;
    for (const Overrides& settings : combined) {
      for (const Alternative& alternative : dimension) {
        if (std::ranges::count(settings, alternative.except) > 0) continue;
        longer.push_back(settings);
        longer.back().push_back(alternative.set);
      }
    }
    combined = std::move(longer);
  }
  return combined;
}

// Returns a key that is equal for studies whose searches make the same solves. No search of a built-in solver depends
// on the branch of the wrist, unless limits or wraps change where a solve starts.
std::string search_key(Study study) {
  if (study.search == Search::wrist && study.limits == LimitPolicy::recorded && study.wrap == WrapPolicy::no &&
      study.start == Start::previous)
    study.wrist_branch = WristBranch::nearest;
  return series_key(study, study.solvers.front());
}

// Returns the solves of a search as they are with the wrist of this study, with its errors and joint motion.
std::vector<SolveRecord> with_wrist_of(const Study& study, std::vector<SolveRecord> solves) {
  const robots::Robot arm = robot_of(study);
  const Task task(study, arm);
  std::vector<robots::Pose> poses;
  robots::Configuration start;
  for (int run = 0; SolveRecord & solve : solves) {
    if (solve.run != run) {
      run = solve.run;
      poses = targets_of_run(study, arm, run);
      start = study.initial;
    }
    const auto place = static_cast<std::size_t>(solve.point - 1);
    const robots::Configuration answer = task.with_wrist(
        Eigen::Map<const Eigen::VectorXd>(solve.answer_rad.data(), task.arm().joints()), poses[place], start);
    const Verification verified =
        verify(arm, {.target = poses[place], .start = start, .answer = answer, .motion_joints = study.motion_joints});
    solve.position_error_cm = verified.position_error / centimetre;
    solve.variation_deg = verified.joint_motion / degree;
    if (continues_from(solve, study.start)) start = answer;
  }
  return solves;
}

// Returns the means of each run over its points.
SeriesMeans means_of(const Study& study, const std::vector<SolveRecord>& solves) {
  const auto runs = static_cast<std::size_t>(study.runs);
  SeriesMeans means{.error_cm = std::vector<double>(runs), .variation_deg = std::vector<double>(runs)};
  for (const SolveRecord& solve : solves) {
    const auto run = static_cast<std::size_t>(solve.run - 1);
    means.error_cm[run] += solve.position_error_cm;
    means.variation_deg[run] += solve.variation_deg;
  }
  for (std::vector<double>* const values : {&means.error_cm, &means.variation_deg}) {
    for (double& value : *values) value /= study.path->points();
  }
  return means;
}

}  // namespace

std::vector<Dimension> read_dimensions(std::string_view study) {
  const EmbeddedFile* const file = find_embedded(multiverse_files, study);
  if (file == nullptr) return {};
  const toml::table table = parse_toml(file->text, file->name);
  TomlReader reader(table, file->name, "");
  std::vector<Dimension> dimensions;
  for (const toml::table* dimension_table : reader.tables("dimensions", max_tables, "a list of tables")) {
    TomlReader at_dimension = reader.nested(*dimension_table, "dimensions.");
    Dimension& dimension = dimensions.emplace_back();
    for (const toml::table* alternative_table : at_dimension.tables("alternatives", max_tables, "a list of tables")) {
      TomlReader at_alternative = at_dimension.nested(*alternative_table, "dimensions.alternatives.");
      Alternative& alternative = dimension.emplace_back();
      at_alternative.text("set", alternative.set);
      at_alternative.text("where", alternative.where);
      at_alternative.text("except", alternative.except);
      at_alternative.refuse_unknown_keys();
    }
    at_dimension.refuse_unknown_keys();
  }
  reader.refuse_unknown_keys();
  return dimensions;
}

MultiversePlan plan_multiverse(const std::string& name, const std::vector<Dimension>& dimensions, int seeds,
                               const Overrides& overrides) {
  MultiversePlan plan{{.dimensions = dimensions, .solvers = labels_of(load_study(name)), .readings = {}}, {}};
  std::map<std::string, std::vector<std::size_t>> known;  // parts, by the key of the series with the study's seed
  for (const Overrides& settings : combinations(dimensions)) {
    Overrides joined = overrides;
    joined.insert(joined.end(), settings.begin(), settings.end());  // defaults, too: another setting may change one
    const Study study = load_study(name, joined);
    plan.readings.push_back({settings});
    for (const SolverEntry& entry : study.solvers) {
      std::vector<std::size_t>& parts = known[series_key(study, entry)];
      while (std::ssize(parts) < seeds) {
        parts.push_back(plan.parts.size());
        Study& part = plan.parts.emplace_back(study);
        part.seed = parts.size();
        part.solvers = {entry};
      }
      plan.readings.back().parts.push_back(parts);
    }
  }
  return plan;
}

std::vector<SeriesMeans> solve_multiverse(const std::vector<Study>& parts, const RunRequest& request) {
  std::map<std::string, std::vector<std::size_t>> by_search;
  Progress progress;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (request.cancelled != nullptr && *request.cancelled) return {};
    by_search[search_key(parts[i])].push_back(i);
    progress.total += planned_solve_count({}, parts[i]);
  }
  std::vector<std::vector<std::size_t>> searches;
  for (auto& [key, places] : by_search) searches.push_back(std::move(places));
  std::vector<SeriesMeans> means(parts.size());
  std::mutex mutex;
  parallel_for(
      searches.size(), request.jobs, request.cancelled, [&](std::size_t s, std::size_t, const StopRequested& is_over) {
        const Study& first = parts[searches[s].front()];
        std::vector<SolveRecord> solves;
        solve_without_store(
            first, 1, [&](SolveRecord record) { solves.push_back(std::move(record)); }, request.cancelled);
        if (is_over()) return;
        for (const std::size_t i : searches[s]) {
          const bool is_same = series_key(parts[i], parts[i].solvers[0]) == series_key(first, first.solvers[0]);
          means[i] = means_of(parts[i], is_same ? solves : with_wrist_of(parts[i], solves));
          const std::scoped_lock lock(mutex);
          progress.done += planned_solve_count({}, parts[i]);
          if (request.progress) request.progress(progress);
        }
      });
  if (progress.done < progress.total) means.clear();
  return means;
}

}  // namespace ikbench::experiments
