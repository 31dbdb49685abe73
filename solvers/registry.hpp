// The solvers by name. One line a solver in registry.inc; its file defines the function of that name. Those of
// libraries are peers: they are there if the build found the library.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/options.hpp"
#include "solvers/solver.hpp"

namespace ikbench::solvers {

// What a study asks solvers for: the tool's position, or its pose.
enum class Asked { position, pose };

struct SolverInfo {
  std::string name;
  std::string summary;
  std::string source;        // the publication it comes from
  int least_population = 1;  // candidates that it cannot do without
  std::string library = {};  // of a peer: name and version, such as "KDL 1.5.1"
  bool is_counted = true;    // its evaluations are; not those of a library with a kinematics of its own
  // Why it cannot solve for an arm, one sentence; empty where it can.
  std::function<std::string(const robots::Chain& arm, Asked asked)> why_not;
  // The defaults, or with `settings` applied (std::invalid_argument as OptionList::set says).
  std::function<Settings(const Settings& settings)> options;
  std::function<std::unique_ptr<Solver>(const Settings& settings)> make;
  std::function<void(const std::function<void(const OptionList&)>& visit)> describe;
};

std::vector<SolverInfo> all_solvers();
// Those that can solve for this arm.
std::vector<SolverInfo> solvers_for(const robots::Chain& arm, Asked asked);
// std::invalid_argument names those there are, or the package that a peer lacks.
SolverInfo solver(std::string_view name);

// A peer that this program was built without.
struct MissingPeer {
  std::string name;
  std::string how;  // "not built: apt-get install PACKAGE, then build ikbench again"
};
std::vector<MissingPeer> missing_peers();

// For a solver's file: its class has a nested Options with `void list(OptionList&)` and a constructor from it; and a
// static why_not, as SolverInfo has it, where there are arms that it cannot solve for.
template <class S>
SolverInfo solver_info(std::string name, std::string summary, std::string source, int least_population = 1) {
  using Options = typename S::Options;
  const auto configured = [](const Settings& settings) {
    Options options;
    OptionList list;
    options.list(list);
    list.set(settings);
    return options;
  };
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .least_population = least_population,
          .why_not = []([[maybe_unused]] const robots::Chain& arm, [[maybe_unused]] Asked asked) -> std::string {
            if constexpr (requires { S::why_not(arm, asked); }) return S::why_not(arm, asked);
            return {};
          },
          .options =
              [configured](const Settings& settings) {
                Options options = configured(settings);
                OptionList list;
                options.list(list);
                return list.values();
              },
          .make = [configured](const Settings& settings) -> std::unique_ptr<Solver> {
            return std::make_unique<S>(configured(settings));
          },
          .describe =
              [](const std::function<void(const OptionList&)>& visit) {
                Options options;
                OptionList list;
                options.list(list);
                visit(list);
              }};
}

}  // namespace ikbench::solvers
