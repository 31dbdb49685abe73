#include "experiments/study/series_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "base/json.hpp"
#include "experiments/environment.hpp"
#include "experiments/external/answers.hpp"
#include "experiments/external/program.hpp"
#include "experiments/study/study_fields.hpp"
#include "experiments/study/written_fields.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using base::Json;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

// Returns the part of a key that names fields: "\nPREFIXname value" for each InKey::by_name field that differs from its
// default.
template <class Struct>
std::string fields_by_name(Struct fields, Struct defaults, std::string_view prefix = "") {
  const WrittenFields written = written_fields(fields);
  const WrittenFields by_default = written_fields(defaults);
  std::string text;
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written[i].in_key == InKey::by_name && written[i].text != by_default.at(i).text)
      text += fmt::format("\n{}{} {}", prefix, written[i].key, written[i].text);
  }
  return text;
}

// Returns the part of a key for the targets. Fixed targets enter as poses, whatever their kind of path. Random
// ones enter as the fields of their path; the seed stands elsewhere in the key.
std::string targets_text(const Study& study) {
  std::string text;
  if (!study.path->is_random()) {
    for (const Pose& target : targets_of_run(study, 1)) text += exact_text(target.matrix().reshaped());
    return text;
  }
  const std::vector<Path> kinds = target_sets();
  const auto defaults = std::ranges::find(kinds, study.path->name(), [](const Path& kind) { return kind->name(); });
  return fmt::format("{} {}", study.path->name(), study.path->points()) + fields_by_name(study.path, *defaults);
}

}  // namespace

std::string configuration_key(const Study& study, const SolverEntry& entry) {
  // Writes the fields marked InKey::in_text. With another word or order here, all stored solves would be solved again.
  const Robot arm = robot_of(study);
  std::string text = "numerics 2\nrobot";
  text += arm.chain.definition() + exact_text(arm.limits.lower) + exact_text(arm.limits.upper) + "\ntargets ";
  text += targets_text(study);
  text += fmt::format("\ninitial {}\nsearch {} branch {} population {} seed {} trace {}", exact_text(study.initial),
                      static_cast<int>(study.search), static_cast<int>(study.wrist_branch),
                      effective_population(study, entry), study.seed, static_cast<int>(study.trace));
  text += fmt::format("\nstop {} {} {} {}", study.stop.iterations, study.stop.tolerance, study.stop.evaluations,
                      study.stop.seconds);
  // Other fields enter only if they differ from their defaults, so that a new field leaves stored solves as they are.
  text += fields_by_name(study, Study{});
  text += fields_by_name(study.stop, StopRule{}, "stop.");
  if (study.checker) {
    const std::vector<std::string> numbers = study.check.numbers();
    text += fmt::format("\ncheck {} files {} numbers {}", fmt::join(study.check.process, " "),
                        fmt::join(study.checker->choice.files, " "),
                        fmt::join(std::set<std::string>(numbers.begin(), numbers.end()), ", "));
  }
  // This binding does not compile with a new field of SolverEntry. Options and population enter as they are in effect,
  // whether a sweep chose them or not.
  [[maybe_unused]] const auto& [label, solver, options, population, program, if_missing, custom, answers, colour,
                                sweep_base] = entry;
  text += fmt::format("\nsolver {} label {}", solver, label);
  if (program) text += fields_by_name(program->choice, ProgramSpec{}, "program.");
  Settings in_effect = effective_options(study, entry);
  if (!program) {
    solver_info(entry).describe([&](const OptionList& list) {
      // An option that was added after solves had been stored enters only if it differs from its default.
      std::erase_if(in_effect, [&](const auto& setting) {
        const auto option = std::ranges::find(list.options(), setting.first, &Option::name);
        return option->is_later && option->get() == setting.second;
      });
    });
  }
  for (const auto& [name, value] : in_effect) text += fmt::format("\n{} = {}", name, text_of(value));
  return fmt::format("{:016x}", Key(0).with(text).value());
}

std::string source_digest_of(const SolverEntry& entry) {
  if (entry.program) return entry.program->digest;
  if (entry.answers) return entry.answers->digest;
  return entry.custom ? file_digest(executable_path()) : solver_source_digest(entry.solver);
}

std::string library_name(const SolverEntry& entry) { return entry.program ? "" : solver_info(entry).library; }

std::string source_key_of(const std::string& shared, const std::string& own, const std::string& library) {
  Key source = Key(0).with(shared).with(own);
  if (!library.empty()) source = source.with(library);
  return fmt::format("{}{:016x}", source_separator, source.value());
}

std::string source_key(const SolverEntry& entry) {
  return source_key_of(shared_source_digest(), source_digest_of(entry), library_name(entry));
}

std::string series_key(const Study& study, const SolverEntry& entry) {
  const std::string& check = study.check.digest;
  return configuration_key(study, entry) + source_key(entry) +
         (check.empty() ? "" : fmt::format("{:016x}", Key(0).with(check).value()));
}

std::vector<Series> series_of(const Study& study) {
  std::vector<Series> series;
  for (const SolverEntry& entry : study.solvers) {
    Settings options = effective_options(study, entry);
    if (entry.program) {
      options["process"] = fmt::format("{}", fmt::join(entry.program->choice.process, " "));
      if (entry.program->choice.batch > 0) options["batch"] = static_cast<double>(entry.program->choice.batch);
    } else if (entry.answers) {
      options["answers"] = entry.answers->file;
    } else if (const SolverInfo& info = solver_info(entry); info.use) {
      info.use(options);
    }
    if (entry.population > 0 || (!entry.program && solver_info(entry).min_population > 0))
      options["population"] = static_cast<double>(effective_population(study, entry));
    Json values = Json::object();
    for (const auto& [name, value] : options) {
      const std::string text = text_of(value);
      const Json number = base::parsed_json(text);
      values[name] = number.is_number() ? number : Json(text);
    }
    series.push_back({.key = series_key(study, entry),
                      .label = entry.label,
                      .algorithm = entry.solver,
                      .options = base::text_of(values)});
  }
  return series;
}

}  // namespace ikbench::experiments
