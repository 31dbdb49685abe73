#include "experiments/path.hpp"

namespace ikbench::experiments {

#define PATH(name) std::unique_ptr<PathKind> name##_path();
#include "experiments/paths.inc"
#undef PATH

namespace {

using MakePath = std::unique_ptr<PathKind> (*)();

constexpr MakePath kinds[]{
#define PATH(name) name##_path,
#include "experiments/paths.inc"
#undef PATH
};

}  // namespace

Path::Path() : Path(kinds[0]()) {}

std::vector<Path> paths() {
  std::vector<Path> all;
  for (const MakePath make : kinds) all.emplace_back(make());
  return all;
}

}  // namespace ikbench::experiments
