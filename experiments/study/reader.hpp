// Reads a study from TOML: a file, a text, a built-in study or a store. Every command that solves begins here. Every
// mistake is one sentence with file, line, column, value and what was expected. Study files are explained in
// docs/reference/study-file.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/study/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// The overrides of a study, each "key=value": `runs=5`, `path.tool=eq27`, or an option of the solvers with that label
// or name: `IK-BA.bounds=clamp`. Messages name --set, or the option before the key: `--robot robot=ur5e`.
using Overrides = std::vector<std::string>;

// Returns the override that sweeps a setting of one solver ("IK-BA.alpha=0.5,0.9"), or of all built-in solvers that
// have the setting ("alpha=0.5,0.9"). Throws std::invalid_argument for anything else.
std::string sweep_override(const std::string& text);

// A study of a sweep over keys of the study: the place of the study in the sweep, and the overrides that make it.
struct SweptStudy {
  results::SweepPlace place = {};
  Overrides overrides = {};
};
// Returns whether --sweep TEXT is over a key of the study ("near_deg=1,10", "stop.seconds=0.001,1"). Otherwise it is
// over a setting of solvers. A name that both have is the solvers'; "study.population=20,50" means the study's.
bool is_sweep_of_study(const std::string& text);
// Returns every combination of the values of keys of a study; the last key varies fastest. Throws std::invalid_argument
// for a key that changes no result, a value that is given twice, and more than max_swept_studies.
std::vector<SweptStudy> swept_studies(const std::vector<std::string>& texts);
constexpr std::size_t max_swept_studies = 100;

// Reads a study from a text; `source` is the name of the text in messages. Throws std::invalid_argument with the place,
// the mistake and what is expected. For an unknown name, the message has the nearest known one.
Study parse_study(std::string_view toml, std::string_view source, const Overrides& overrides = {});
// Returns the built-in studies by name: the files of studies/, which the build embeds in the program
// (packaging/embed.cmake).
std::vector<Study> built_in_studies();
// Loads a built-in study by its name, otherwise a file. Throws as parse_study does.
Study load_study(const std::string& name_or_file, const Overrides& overrides = {});
// Loads the study of a store, to solve it again: the settings of its study file, with all options as they were in
// effect. The programs of the study are started in the current folder, so the caller names them to the user before
// (programs_of). Throws as parse_study does.
Study load_study(const results::Store& store, const results::StoredStudy& stored, const Overrides& overrides = {});
// Sets the path and the initial configuration [rad, m] of `study` to those of a stored study; `study` must have the
// arm. Returns false if the targets are poses of a file, which the definition does not have. Throws
// std::invalid_argument if a value is impossible.
bool read_stored_targets(const results::StoredStudy& stored, Study& study);
// Returns the programs of a stored study, each with its arguments: those of its solvers and of its check.
std::vector<std::vector<std::string>> programs_of(const results::StoredStudy& stored);
// Returns the labels of the user's own solvers: programs, and solvers that are not registered in this program.
std::vector<std::string> own_solvers_of(const results::StoredStudy& stored);
// Returns the registered name of a solver by its name or by the abbreviation that tables use, such as LM, in any case
// of letters. Returns `name` if no solver has it.
std::string solver_named(const std::string& name);
// Keeps the entries with these labels, and those that a sweep made of them; each text is a list with commas. Instead of
// a label, a list may have a label in other cases of letters, or name a solver (solver_named). Throws
// std::invalid_argument for an unknown name.
void select_solvers(Study& study, const std::vector<std::string>& lists);

}  // namespace ikbench::experiments
