// Every text is a study, or a std::invalid_argument says why not.
#include "tests/experiments/samples.hpp"
#include "tests/mutator.hpp"

namespace {

void read_study(const std::string& text) {
  const Study study = parse_study(text, "mutated.toml");
  for (const SolverEntry& entry : study.solvers) solver(entry.solver);
  CHECK((!study.solvers.empty() && study.runs >= 1));
}

std::string sample_file() {
  Study study = small_study();
  study.solvers[1].options = {{"alpha", 0.25}, {"bounds", "clamp"}};
  return to_toml(study) + "\n[[solvers]]\nsolver = \"particle_swarm\"\n";
}

}  // namespace

TEST_CASE("a study file with up to four random changes is read, or refused with its place", "[study][fuzz]") {
  const int read = read_mutated(Mutator(2023), sample_file(), 2000, "mutated.toml:", read_study);
  CHECK(read > 100);
  CHECK(read < 1900);
}

TEST_CASE("files of every kind of path with random changes are read, or refused with their place", "[study][fuzz]") {
  Study study = small_study();
  const Path some_poses = path_through(targets(study, 1));
  study.limits = Limits::enforced;
  study.start = Start::initial;
  study.solvers[0].population = 12;
  for (const Path& path : paths()) {
    study.path = path->points() > 0 ? path : some_poses;
    read_mutated(Mutator(7), to_toml(study), 500, "mutated.toml:", read_study);
  }
}

TEST_CASE("random overrides are taken, or refused", "[study][fuzz]") {
  const std::string file = sample_file();
  for (const char* override : {"IK-BA.alpha=0.9", "path.points=3"}) {
    read_mutated(Mutator(12), override, 300, "--set", [&](std::string changed) {
      std::ranges::replace(changed, '\n', ' ');  // a key is told as it was typed
      parse_study(file, "mutated.toml", {changed});
    });
  }
}
