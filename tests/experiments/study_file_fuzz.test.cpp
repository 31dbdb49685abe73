// Every text is a study, or a std::invalid_argument says why not.
#include <random>

#include "solvers/registry.hpp"
#include "tests/experiments/samples.hpp"
#include "tests/mutator.hpp"

namespace {

// True if it was read; passes on any exception except std::invalid_argument.
bool is_read(const std::string& text, const Overrides& overrides = {}) {
  try {
    const Study study = parse_study(text, "mutated.toml", overrides);
    for (const SolverEntry& entry : study.solvers) solver(entry.solver);
    return !study.solvers.empty() && study.runs >= 1;
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    CHECK((message.starts_with("mutated.toml:") || message.starts_with("--set")));
    return false;
  }
}

std::string sample_file() {
  Study study = small_study();
  study.solvers[1].options = {{"alpha", "0.25"}, {"bounds", "clamp"}};
  return to_toml(study) + "\n[[solvers]]\nsolver = \"particle_swarm\"\n";
}

}  // namespace

TEST_CASE("a study file with up to four random changes is read, or refused with its place", "[study][fuzz]") {
  const std::string file = sample_file();
  REQUIRE(is_read(file));
  Mutator mutator(2023);
  int read = 0;
  for (int i = 0; i < 2000; ++i) read += is_read(mutator.mutated(file)) ? 1 : 0;
  CHECK(read > 100);  // fewer: the changes test the TOML parser alone
  CHECK(read < 1900);
}

TEST_CASE("a file of poses with random changes is read, or refused with its place", "[study][fuzz]") {
  Study study = small_study();
  study.path = path_through(targets(study, 1));
  const std::string file = to_toml(study);
  REQUIRE(is_read(file));
  Mutator mutator(38);
  for (int i = 0; i < 500; ++i) is_read(mutator.mutated(file));
}

TEST_CASE("files of every kind of path with random changes are read, or refused with their place", "[study][fuzz]") {
  Study study = small_study();
  study.limits = Limits::enforced;
  study.start = Start::initial;
  study.solvers[0].population = 12;
  Mutator mutator(7);
  for (const Path& path : paths()) {
    study.path = path->points() > 0 ? path : path_through({Pose::Identity()});
    const std::string file = to_toml(study);
    REQUIRE(is_read(file));
    for (int i = 0; i < 500; ++i) is_read(mutator.mutated(file));
  }
}

TEST_CASE("random overrides are taken, or refused", "[study][fuzz]") {
  const std::string file = sample_file();
  Mutator mutator(12);
  for (int i = 0; i < 500; ++i) is_read(file, {mutator.mutated("IK-BA.alpha=0.9"), mutator.mutated("path.points=3")});
}

TEST_CASE("random bytes are no study", "[study][fuzz]") {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    std::string bytes(random() % 400, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    CHECK_FALSE(is_read(bytes));
  }
}
