#include "analysis/collections.hpp"

#include <stdexcept>
#include <string>

#include "analysis/claims/collection_file.hpp"
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
#include "collections.inc"
};

std::vector<Collection> read_all() {
  std::vector<Collection> all = claims::read_collections(files);
  const auto complete = [&](std::string_view name, void (*add)(Paper&)) {
    const auto own = std::ranges::find(all, name, &Collection::name);
    add(own->paper);
    std::rotate(all.begin(), own, own + 1);
  };
#define PAPER(name) complete(#name, name::complete);
#include "analysis/papers.inc"
#undef PAPER
  return all;
}

}  // namespace

const std::vector<Collection>& collections() {
  static const std::vector<Collection> all = read_all();
  return all;
}

const Collection& collection(std::string_view name) {
  std::vector<std::string> names;
  for (const Collection& each : collections()) {
    if (each.name == name) return each;
    names.push_back(each.name);
  }
  throw std::invalid_argument(unknown_name("paper", name, names));
}

const Paper& paper(std::string_view name) { return collection(name).paper; }

}  // namespace ikbench::analysis
