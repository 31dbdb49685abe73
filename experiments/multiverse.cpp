#include "experiments/multiverse.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "base/embedded_file.hpp"
#include "base/toml_table.hpp"
#include "base/units.hpp"
#include "experiments/study_writer.hpp"
#include "experiments/task.hpp"
#include "experiments/verifier.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace results;

namespace {

constexpr EmbeddedFile multiverse_files[]{
#include "multiverse.inc"
};

constexpr std::size_t most_tables = 100;

Dimension read_dimension(TomlReader reader, const std::vector<std::string>& labels) {
  Dimension one;
  for (const toml::table* table : reader.tables("alternatives", most_tables, "a list of tables")) {
    TomlReader of_one = reader.nested(*table, "dimensions.alternatives.");
    Alternative& alternative = one.alternatives.emplace_back();
    of_one.text("set", alternative.set);
    of_one.text("where", alternative.where);
    of_one.texts("except", alternative.except);
    of_one.refuse_unknown_keys();
  }
  reader.refuse_unknown_keys();
  one.name = one.alternatives.front().set;  // "path.tool=eq27"
  one.name.resize(one.name.find('='));
  const std::string owner = one.name.substr(0, one.name.rfind('.'));
  if (std::ranges::find(labels, owner) != labels.end()) one.label = owner;
  return one;
}

const Alternative& alternative_of(const std::vector<Dimension>& dimensions, const Choice& choice) {
  return dimensions[choice.dimension].alternatives[choice.alternative];
}

bool is_excepted(const Alternative& alternative, const std::vector<Dimension>& dimensions, const Chosen& chosen) {
  return std::ranges::any_of(chosen, [&](const Choice& each) {
    return std::ranges::count(alternative.except, alternative_of(dimensions, each).set) > 0;
  });
}

// All choices in the dimensions of one owner (a solver, or "" for the study) that are possible together, given others,
// which are not repeated.
std::vector<Chosen> combinations(const std::vector<Dimension>& dimensions, std::string_view owner,
                                 const Chosen& given) {
  std::vector<Chosen> all{{}};
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    if (dimensions[d].label != owner) continue;
    std::vector<Chosen> larger;
    for (const Chosen& chosen : all) {
      Chosen known = given, possible;
      known.insert(known.end(), chosen.begin(), chosen.end());
      for (std::size_t a = 0; a < dimensions[d].alternatives.size(); ++a) {
        if (!is_excepted(dimensions[d].alternatives[a], dimensions, known)) possible.push_back({d, a});
      }
      if (possible.size() < 2) {  // nothing to choose
        larger.push_back(chosen);
        continue;
      }
      for (const Choice& each : possible) {
        larger.push_back(chosen);
        larger.back().push_back(each);
      }
    }
    all = std::move(larger);
  }
  return all;
}

// The key of the search alone: unless limits or wraps change where a solve starts, no search sees which way the wrist
// bends. A program or library may be too late.
std::string search_key(Study study) {
  const SolverEntry& entry = study.solvers.front();
  const bool is_built_in = !entry.program && info_of(entry).library.empty();
  if (is_built_in && study.search == Search::wrist && study.limits == Limits::recorded && study.wrap == Wrap::no)
    study.wrist_branch = WristBranch::nearest;
  return series_key(study, study.solvers.front());
}

// Solves of one search with the wrist of another study: its errors and joint motion.
std::vector<SolveRecord> with_wrist_of(const Study& study, std::vector<SolveRecord> solves) {
  const robots::Robot arm = arm_of(study);
  const Task task(study, arm);
  std::vector<robots::Pose> poses;
  std::vector<robots::Configuration> own_starts;
  robots::Configuration start;
  for (int run = 0; SolveRecord & solve : solves) {
    if (solve.run != run) {
      run = solve.run;
      poses = targets(study, arm, run);
      own_starts = starts(study, arm, run);
      start = study.initial;
    }
    const auto place = static_cast<std::size_t>(solve.point - 1);
    if (!own_starts.empty()) start = own_starts[place];
    const robots::Configuration answer = task.completed(
        Eigen::Map<const Eigen::VectorXd>(solve.answer_rad.data(), task.arm().joints()), poses[place], start);
    const Verification verified = verify(arm, poses[place], start, answer, false, study.motion_joints);
    solve.position_error_cm = verified.position_error / centimetre;
    solve.variation_deg = verified.variation / degree;
    if (moves_arm(solve, study.start)) start = answer;
  }
  return solves;
}

PartMeans means_of(const Study& study, const std::vector<SolveRecord>& solves) {
  const auto runs = static_cast<std::size_t>(study.runs);
  PartMeans means{.error_cm = std::vector<double>(runs), .variation_deg = std::vector<double>(runs)};
  for (const SolveRecord& solve : solves) {
    const auto run = static_cast<std::size_t>(solve.run - 1);
    means.error_cm[run] += solve.position_error_cm;
    means.variation_deg[run] += solve.variation_deg;
  }
  for (std::vector<double>* all : {&means.error_cm, &means.variation_deg})
    for (double& value : *all) value /= study.path->points();
  return means;
}

}  // namespace

std::vector<Dimension> dimensions(std::string_view study) {
  const EmbeddedFile* const file = find_embedded(multiverse_files, study);
  if (file == nullptr) return {};
  const std::vector<std::string> labels = labels_of(load_study(std::string(study)));
  const toml::table table = parse_toml(file->text, file->name);
  TomlReader reader(table, file->name, "");
  std::vector<Dimension> list;
  for (const toml::table* each : reader.tables("dimensions", most_tables, "a list of tables"))
    list.push_back(read_dimension(reader.nested(*each, "dimensions."), labels));
  reader.refuse_unknown_keys();
  return list;
}

MultiversePlan plan_multiverse(const std::string& name, const std::vector<Dimension>& dimensions,
                               const MultiverseRequest& request) {
  MultiversePlan plan{{.dimensions = dimensions, .solvers = labels_of(load_study(name)), .studies = {}}, {}};
  std::map<std::string, std::size_t> places;  // in the plan's parts, by series key
  for (const Chosen& chosen : combinations(dimensions, "", {})) {
    Multiverse::OfStudy& of_study = plan.studies.emplace_back();
    of_study.chosen = chosen;
    for (std::size_t s = 0; s < plan.solvers.size(); ++s) {
      of_study.solvers.emplace_back();
      for (const Chosen& own : combinations(dimensions, plan.solvers[s], chosen)) {
        Multiverse::ChosenSolver& of_solver = of_study.solvers[s].emplace_back();
        of_solver.chosen = own;
        Overrides all = request.overrides;
        for (const Chosen& some : {chosen, own})  // defaults too: a solver's may differ from what the study's implies
          for (const Choice& each : some) all.push_back(alternative_of(dimensions, each).set);
        Study study = load_study(name, all);
        for (int seed = 1; seed <= request.seeds; ++seed) {
          if (request.cancelled != nullptr && *request.cancelled) return plan;
          study.seed = static_cast<std::uint64_t>(seed);
          const auto [place, is_new] = places.try_emplace(series_key(study, study.solvers[s]), plan.parts.size());
          of_solver.parts.push_back(place->second);
          if (!is_new) continue;
          plan.parts.push_back(study);
          plan.parts.back().solvers = {study.solvers[s]};
        }
      }
    }
  }
  return plan;
}

std::vector<PartMeans> solve_parts(const std::vector<Study>& parts, const RunRequest& request) {
  std::map<std::string, std::vector<std::size_t>> by_search;
  Progress progress;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (request.cancelled != nullptr && *request.cancelled) return {};
    by_search[search_key(parts[i])].push_back(i);
    progress.total += solves_of({}, parts[i]);
  }
  std::vector<std::vector<std::size_t>> searches;
  for (auto& [key, places] : by_search) searches.push_back(std::move(places));
  std::vector<PartMeans> means(parts.size());
  std::mutex mutex;
  share_out(searches.size(), request.jobs, request.cancelled, [&](std::size_t s, std::size_t, const IsOver& is_over) {
    const Study& first = parts[searches[s].front()];
    std::vector<SolveRecord> solves;
    solve_study(
        first, 1, [&](SolveRecord record) { solves.push_back(std::move(record)); }, request.cancelled);
    if (is_over()) return;
    for (const std::size_t i : searches[s]) {
      const bool is_same = series_key(parts[i], parts[i].solvers[0]) == series_key(first, first.solvers[0]);
      means[i] = means_of(parts[i], is_same ? solves : with_wrist_of(parts[i], solves));
      const std::scoped_lock lock(mutex);
      progress.done += solves_of({}, parts[i]);
      if (request.progress) request.progress(progress);
    }
  });
  if (progress.done < progress.total) means.clear();
  return means;
}

}  // namespace ikbench::experiments
