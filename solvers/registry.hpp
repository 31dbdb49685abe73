// Solvers by name. Each has one line in registry.inc, and a file that defines the function of that name. Library
// solvers (peers) exist only if the build found their library.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/options.hpp"
#include "solvers/solver.hpp"

namespace ikbench::solvers {

// A solver's description and its factory.
struct SolverInfo {
  std::string name;
  std::string summary;
  std::string source;        // publication of the method
  int min_population = 0;    // 0: no population
  std::string library = {};  // name and version of a peer's library, such as "KDL 1.5.1"
  bool is_counted = true;    // evaluations are counted here; false: the library has its own kinematics
  // Returns one sentence on why the solver cannot solve for an arm; empty if it can.
  std::function<std::string(const robots::Chain& arm, GoalKind goal)> why_not;
  std::function<std::unique_ptr<Solver>(const Settings& settings)> make;
  std::function<void(const std::function<void(OptionList&)>& visit)> describe;  // passes the defaults

  // Removes settings that other settings replace from a complete set. Null: all settings are used.
  std::function<void(Settings& settings)> use = {};

  // Returns the defaults with `settings` applied. Throws std::invalid_argument as OptionList::set does.
  Settings options(const Settings& settings) const;
};

std::vector<SolverInfo> all_solvers();
// Returns the solver of this name. Throws std::invalid_argument, which lists the names, or names the package that a
// peer lacks.
const SolverInfo& solver(std::string_view name);

// A peer that this program was built without.
struct MissingPeer {
  std::string name;
  std::string how;  // "not built: apt-get install PACKAGE, then build ikbench again"
};
std::vector<MissingPeer> missing_peers();

// Makes the description in a solver's file. S has a nested type Options, with `void list(OptionList&)`, and a
// constructor from Options. If S cannot solve for every arm, it has a static why_not, as in SolverInfo.
template <class S>
SolverInfo solver_info(std::string name, std::string summary, std::string source, int min_population = 0) {
  using Options = typename S::Options;
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .min_population = min_population,
          .why_not = []([[maybe_unused]] const robots::Chain& arm, [[maybe_unused]] GoalKind goal) -> std::string {
            if constexpr (requires { S::why_not(arm, goal); }) return S::why_not(arm, goal);
            return {};
          },
          .make = [](const Settings& settings) -> std::unique_ptr<Solver> {
            Options options;
            OptionList list;
            options.list(list);
            list.set(settings);
            return std::make_unique<S>(options);
          },
          .describe =
              [](const std::function<void(OptionList&)>& visit) {
                Options options;
                OptionList list;
                options.list(list);
                visit(list);
              },
          .use =
              []([[maybe_unused]] Settings& settings) {
                if constexpr (requires { Options::use(settings); }) Options::use(settings);
              }};
}

}  // namespace ikbench::solvers
