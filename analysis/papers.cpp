#include "analysis/papers.hpp"

#include <stdexcept>
#include <string>

#include "numerics/names.hpp"

#define PAPER(name)         \
  namespace ikbench::name { \
  report::Paper paper();    \
  }
#include "analysis/papers.inc"
#undef PAPER

namespace ikbench::analysis {

const std::vector<report::Paper>& papers() {
  static const std::vector<report::Paper> all{
#define PAPER(name) name::paper(),
#include "analysis/papers.inc"
#undef PAPER
  };
  return all;
}

const report::Paper& paper(std::string_view name) {
  std::vector<std::string> names;
  for (const report::Paper& each : papers()) {
    if (each.name == name) return each;
    names.push_back(each.name);
  }
  throw std::invalid_argument(numerics::unknown_name("paper", name, names));
}

}  // namespace ikbench::analysis
