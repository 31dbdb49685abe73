#include "experiments/source_digest.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "build_info.hpp"

namespace ikbench::experiments {

namespace {

#include "source_digests.inc"

}  // namespace

std::map<std::string, std::string> build_facts() {
  return {{"build_type", build_info::build_type}, {"commit", build_info::commit},     {"flags", build_info::flags},
          {"sanitizers", build_info::sanitize},   {"source", shared_source_digest()}, {"version", build_info::version}};
}

std::string source_digest() { return std::string(of_all); }

std::string shared_source_digest() { return std::string(shared); }

std::string solver_source_digest(std::string_view solver) {
  const auto* found = std::ranges::find(of_solvers, solver, &std::pair<std::string_view, std::string_view>::first);
  if (found == std::end(of_solvers)) throw std::logic_error("a solver without a source");
  return std::string(found->second);
}

}  // namespace ikbench::experiments
