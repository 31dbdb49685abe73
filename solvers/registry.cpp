#include "solvers/registry.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/names.hpp"

namespace ikbench::solvers {

using namespace base;

#define SOLVER(name) SolverInfo name();
#define PEER(name, library, package) SolverInfo name();
#include "solvers/registry.inc"
#undef SOLVER
#undef PEER

namespace {

struct Registry {
  std::vector<SolverInfo> solvers;
  std::vector<MissingPeer> missing;

  // The build defines IKBENCH_HAS_library as 1 or 0; a discarded branch needs no definition of the peer.
  Registry() {
#define SOLVER(name) solvers.push_back(name());
#define PEER(name, library, package)                                                                 \
  if constexpr (IKBENCH_HAS_##library) {                                                             \
    solvers.push_back(name());                                                                       \
  } else {                                                                                           \
    missing.push_back({#name, "not built: apt-get install " #package ", then build ikbench again"}); \
  }
#include "solvers/registry.inc"
#undef SOLVER
#undef PEER
  }
};

std::string letters_of(std::string_view text) {
  std::string letters = lower_case(text);
  std::erase_if(letters, [](char c) { return (c < 'a' || c > 'z') && (c < '0' || c > '9'); });
  return letters;
}

const Registry& registry() {
  static const Registry all;
  return all;
}

}  // namespace

Settings SolverInfo::options(const Settings& settings) const {
  Settings values;
  describe([&](OptionList& list) {
    list.set(settings);
    values = list.values();
  });
  return values;
}

std::vector<SolverInfo> all_solvers() { return registry().solvers; }

std::vector<MissingPeer> missing_peers() { return registry().missing; }

const SolverInfo& solver(std::string_view name) {
  for (const MissingPeer& peer : registry().missing) {
    if (peer.name == name) throw std::invalid_argument(fmt::format("the solver {} is {}", name, peer.how));
  }
  try {
    return find_named("solver", name, registry().solvers, [](const SolverInfo& info) { return info.name; });
  } catch (const std::invalid_argument&) {  // the field's names stand in the summaries: "DLS", "TRAC-IK"
    const std::string meant = letters_of(name);
    for (const SolverInfo& info : registry().solvers) {
      if (meant.size() > 2 && letters_of(info.summary).find(meant) != std::string::npos)
        throw std::invalid_argument(
            fmt::format("unknown solver \"{}\"; did you mean \"{}\", {}?", name, info.name, info.summary));
    }
    throw;
  }
}

}  // namespace ikbench::solvers
