// Reads a study from TOML: a file, a text, a built-in study or a store. Every mistake is one sentence with file, line,
// column, value and what was expected.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/study/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Overrides of a study, "key=value": `runs=5`, `path.tool=eq27`, or an option of the solvers with that label or name:
// `IK-BA.bounds=clamp`. Messages name --set, or another option that stands before: `--robot robot=ur5e`.
using Overrides = std::vector<std::string>;

// Returns the override that sweeps a setting of one solver ("IK-BA.alpha=0.5,0.9"), or of all built-in ones that have
// it ("alpha=0.5,0.9"). Throws std::invalid_argument, which says what is wrong with it.
std::string sweep_override(const std::string& text);

// Reads a study from a text; `source` is its name in messages. Throws std::invalid_argument with place, mistake and
// what is expected; for an unknown name, with the nearest known one.
Study parse_study(std::string_view toml, std::string_view source, const Overrides& overrides = {});
// Returns the built-in studies by name: the files of studies/, which the build embeds in the program
// (packaging/embed.cmake).
std::vector<Study> built_in_studies();
// Loads a built-in study by its name, otherwise a file. Throws as parse_study does.
Study load_study(const std::string& name_or_file, const Overrides& overrides = {});
// Loads the study of a store, to solve it again: what its study file said, with all options as they were in effect. Its
// programs are started in the current folder, so the caller names them before (programs_of). Throws as parse_study
// does.
Study load_study(const results::Store& store, const results::StoredStudy& stored, const Overrides& overrides = {});
// Sets the path and the initial configuration [rad, m] of `study` to those of a stored study; `study` must have the
// arm. Returns false if the targets are poses of a file, which the definition does not have. Throws
// std::invalid_argument if a value is impossible.
bool read_stored_targets(const results::StoredStudy& stored, Study& study);
// Returns the programs of a stored study, each with its arguments: those of its solvers and of its check.
std::vector<std::vector<std::string>> programs_of(const results::StoredStudy& stored);
// The registered name of a solver by its name or by the abbreviation that tables use, such as LM, in any case of
// letters; the name itself if it is neither.
std::string solver_named(const std::string& name);
// Keeps the entries with these labels, or that a sweep made of these: lists with commas. What is no label may be one in
// other cases of letters, or name a solver (solver_named). Throws std::invalid_argument for an unknown one.
void select_solvers(Study& study, const std::vector<std::string>& lists);

}  // namespace ikbench::experiments
