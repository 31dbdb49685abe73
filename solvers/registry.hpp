// The solvers by name. Each has one line in registry.inc, and its file defines the function of that name. Solvers of
// libraries are peers; they exist only if the build found the library.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/options.hpp"
#include "solvers/solver.hpp"

namespace ikbench::solvers {

struct SolverInfo {
  std::string name;
  std::string summary;
  std::string source;        // the publication it comes from
  int least_population = 0;  // candidates that it needs at least; 0: it has no population
  std::string library = {};  // of a peer: name and version, such as "KDL 1.5.1"
  bool is_counted = true;    // we count its evaluations; false for a library with its own kinematics
  // Says in one sentence why it cannot solve for an arm; empty if it can.
  std::function<std::string(const robots::Chain& arm, GoalKind goal)> why_not;
  std::function<std::unique_ptr<Solver>(const Settings& settings)> make;
  std::function<void(const std::function<void(OptionList&)>& visit)> describe;  // passes the defaults

  // Changes settings, all of them, into what is used of them: what others replace is left out. Null: all are used.
  std::function<void(Settings& settings)> use = {};

  // The defaults with `settings` applied. Throws std::invalid_argument as OptionList::set does.
  Settings options(const Settings& settings) const;
};

std::vector<SolverInfo> all_solvers();
// Finds a solver; std::invalid_argument lists the names, or names the package that a peer lacks.
const SolverInfo& solver(std::string_view name);

// A peer that this program was built without.
struct MissingPeer {
  std::string name;
  std::string how;  // "not built: apt-get install PACKAGE, then build ikbench again"
};
std::vector<MissingPeer> missing_peers();

// For a solver's file. S has a nested Options with `void list(OptionList&)` and a constructor from it, and a static
// why_not, as in SolverInfo, if it cannot solve for every arm.
template <class S>
SolverInfo solver_info(std::string name, std::string summary, std::string source, int least_population = 0) {
  using Options = typename S::Options;
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .least_population = least_population,
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
