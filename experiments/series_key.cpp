#include "experiments/series_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "experiments/foreign/program.hpp"
#include "experiments/source_digest.hpp"
#include "experiments/study_fields.hpp"
#include "results/record.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

template <class Values>
std::string exact(const Values& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{} ", value);
  return text;
}

// Collects names and values, to the bit, of the fields that a key names.
class FieldTexts final : public Fields {
 public:
  std::vector<std::pair<std::string, std::string>> texts;

 private:
  bool visits(InKey in_key) const override { return in_key == InKey::by_name; }

  void on_text(Name name, std::string& field) override { add(name, field); }
  void on_texts(Name name, std::vector<std::string>& field) override {
    add(name, field.empty() ? "" : fmt::format("{} {:?}", field.size(), fmt::join(field, "\n")));
  }
  void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) override {
    add(name, choices[chosen]);
  }
  void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t>) override {
    add(name, fmt::format("{}", field));
  }
  void on_number(Name name, double& field, double, std::pair<double, double>) override {
    add(name, fmt::format("{}", field));
  }
  void on_numbers(Name name, Eigen::VectorXd& field, double, int) override { add(name, exact(field)); }
  void on_poses(Name name, std::vector<Pose>& field) override {
    std::string text;
    for (const Pose& pose : field) text += exact(pose.matrix().reshaped());
    add(name, text);
  }

  void add(Name name, std::string text) { texts.emplace_back(name.key, std::move(text)); }
};

std::vector<std::pair<std::string, std::string>> texts_of(const FieldList& fields) {
  FieldTexts found;
  fields(found);
  return found.texts;
}

template <class Struct>
FieldList fields_of(Struct fields) {
  return [fields](Fields& io) mutable { list_fields(io, fields); };
}

// Fixed targets enter as poses, whatever their kind of path; drawn ones enter as the fields of the path, the seed and
// the run.
std::string targets_text(const Study& study) {
  std::string text;
  if (study.path->is_drawn()) {
    const auto fields_of_path = [](Path path) { return [path](Fields& io) mutable { path->list_fields(io); }; };
    const std::vector<Path> kinds = paths();
    const Path& defaults = *std::ranges::find(kinds, study.path->name(), [](const Path& kind) { return kind->name(); });
    text += fmt::format("{} {}", study.path->name(), study.path->points());
    text += said_by_name(fields_of_path(study.path), fields_of_path(defaults));
  } else {
    for (const Pose& target : targets(study, 1)) text += exact(target.matrix().reshaped());
  }
  return text;
}

}  // namespace

std::string said_by_name(const FieldList& fields, const FieldList& defaults, std::string_view prefix) {
  const auto ours = texts_of(fields), theirs = texts_of(defaults);
  std::string text;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (ours[i] != theirs.at(i)) text += fmt::format("\n{}{} {}", prefix, ours[i].first, ours[i].second);
  }
  return text;
}

std::string configuration_key(const Study& study, const SolverEntry& entry) {
  // The fields marked InKey::in_text, as in the first stores, whose keys are this hash alone.
  const Robot arm = arm_of(study);
  std::string text = "numerics 2\nrobot";
  text += arm.chain.definition() + exact(arm.limits.lower) + exact(arm.limits.upper) + "\ntargets ";
  text += targets_text(study);
  text += fmt::format("\ninitial {}\nsearch {} branch {} population {} seed {} trace {}", exact(study.initial),
                      static_cast<int>(study.search), static_cast<int>(study.wrist_branch),
                      effective_population(study, entry), study.seed, static_cast<int>(study.trace));
  text += fmt::format("\nstop {} {} {} {}", study.stop.iterations, study.stop.tolerance, study.stop.evaluations,
                      study.stop.seconds);
  // Later fields enter only if they differ from their defaults, so that old stores keep their solves.
  text += said_by_name(fields_of(study), fields_of(Study{}));
  text += said_by_name(fields_of(study.stop), fields_of(StopRule{}), "stop.");
  // Does not compile with a further field of SolverEntry. Options and population enter as they are in effect, whether
  // a sweep chose them or not.
  [[maybe_unused]] const auto& [label, algorithm, options, population, program, if_missing, own, colour, family,
                                swept] = entry;
  text += fmt::format("\nsolver {} label {}", algorithm, label);
  if (program) text += said_by_name(fields_of(program->choice), fields_of(ProgramChoice{}), "program.");
  for (const auto& [name, value] : effective_options(study, entry)) text += fmt::format("\n{} = {}", name, value);
  return fmt::format("{:016x}", Key(0).with(text).value());
}

std::string source_digest_of(const SolverEntry& entry) {
  if (entry.program) return entry.program->digest;
  return entry.own ? digest_of_file("/proc/self/exe") : solver_source_digest(entry.solver);
}

std::string library_of(const SolverEntry& entry) { return entry.program ? "" : info_of(entry).library; }

std::string series_key(const Study& study, const SolverEntry& entry) {
  Key source = Key(0).with(shared_source_digest()).with(source_digest_of(entry));
  if (const std::string library = library_of(entry); !library.empty()) source = source.with(library);
  return fmt::format("{}{}{:016x}", configuration_key(study, entry), before_source, source.value());
}

}  // namespace ikbench::experiments
