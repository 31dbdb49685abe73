#include "analysis/papers.hpp"

#include <stdexcept>
#include <string>

#include "analysis/claims/paper_file.hpp"
#include "numerics/embedded_file.hpp"
#include "numerics/names.hpp"

#define PAPER(name)              \
  namespace ikbench::name {      \
  void complete(report::Paper&); \
  }
#include "analysis/papers.inc"
#undef PAPER

namespace ikbench::analysis {

using namespace numerics;
using namespace report;

namespace {

constexpr EmbeddedFile files[]{
#include "paper_files.inc"
};

std::vector<Paper> read_all() {
  std::vector<Paper> all = claims::read_papers(files);
  const auto complete = [&](std::string_view name, void (*add)(Paper&)) {
    const auto own = std::ranges::find(all, name, &Paper::name);
    add(*own);
    std::rotate(all.begin(), own, own + 1);
  };
#define PAPER(name) complete(#name, name::complete);
#include "analysis/papers.inc"
#undef PAPER
  return all;
}

}  // namespace

const std::vector<Paper>& papers() {
  static const std::vector<Paper> all = read_all();
  return all;
}

const Paper& paper(std::string_view name) {
  std::vector<std::string> names;
  for (const Paper& each : papers()) {
    if (each.name == name) return each;
    names.push_back(each.name);
  }
  throw std::invalid_argument(unknown_name("paper", name, names));
}

}  // namespace ikbench::analysis
