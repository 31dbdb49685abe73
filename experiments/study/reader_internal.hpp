// The parts of the reader of studies that its sources share: reader.cpp, solver_entries.cpp, overrides.cpp and
// study_of_store.cpp. Only these sources include this file.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/toml_table.hpp"
#include "experiments/study/study.hpp"
#include "robots/robot.hpp"

namespace ikbench::experiments {

constexpr std::string_view population_key = "population";
constexpr std::string_view bounds_need_recorded_limits =
    "bounds is \"initial\", but limits is \"enforced\"; expected bounds by which answers are inside the limits";

// Sets a key of the study, or settings of its solvers, by "key=value" or "--option key=value" (overrides.cpp). A key
// "IK-BA.alpha" is of the entries with that label or solver, "sweep.alpha" of those whose solver has that setting.
// Throws std::invalid_argument, with the option, for an unknown key.
void apply_override(toml::table& study, const std::string& argument);

// Starts the program of an entry, or of the check, and returns it with its name and options (solver_entries.cpp).
std::shared_ptr<const Program> read_program(base::TomlReader& reader, bool is_of_entry);
// Reads the solvers of a study, a sweep as one entry per combination (solver_entries.cpp).
void read_solvers(base::TomlReader& reader, Study& study, const Robot& arm);

// Returns what `make` returns. An error of `make` becomes a mistake of this key.
template <class Make>
auto with_key_context(const base::TomlReader& reader, std::string_view key, Make&& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw reader.mistake(key, error.what());
  }
}

// Reads a study (reader.cpp). `arm_of_store` makes the arm of a stored study, unless --robot or --set gives another; it
// is empty for the study of a file.
using ArmOfStore = std::function<Robot(const robots::UrdfChoice&)>;
Study read_study(const toml::table& table, std::string_view source, const ArmOfStore& arm_of_store = {});

// Returns the folder of a file that a key names: the study's folder, or the current one if --set gave the key
// (reader.cpp).
std::filesystem::path base_folder(const base::TomlReader& reader, std::string_view key);

}  // namespace ikbench::experiments
