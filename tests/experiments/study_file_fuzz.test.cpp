// Inputs of strangers, with random changes: a study, a message, a store, a folder of results. Each is read, or a
// std::invalid_argument says why not.
#include "analysis/judge/data/study_results.hpp"
#include "analysis/show/publish.hpp"
#include "experiments/stored_checks.hpp"
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
  read_mutated(Mutator(2023), sample_file(), 2000, "mutated.toml:", read_study);
}

TEST_CASE("files of every kind of path with random changes are read, or refused with their place", "[study][fuzz]") {
  Study study = small_study();
  const Path some_poses = path_through(targets_of_run(study, 1));
  study.limits = LimitPolicy::enforced;
  study.start = Start::initial;
  study.solvers[0].population = 12;
  for (const Path& path : target_sets()) {
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

TEST_CASE("messages of a program with random changes are understood, or broke the protocol", "[fuzz]") {
  const std::vector<std::pair<std::string, std::function<void(const Message&)>>> messages{
      {R"({"message": "hello", "ikbench": 2, "name": "mine", "version": "1.5", "goals": ["pose", "axis"], "options": [)"
       R"({"name": "a", "default": 0.5, "low": 0, "high": 3, "meaning": "m"}, {"name": "b", "type": "integer", )"
       R"("default": 3}, {"name": "c", "choices": ["x", "y"], "default": "y"}]})",
       [](const Message& message) { resolved_options(message.hello(), {}); }},
      {R"({"message": "evaluate", "candidates": [[0.1, -0.2, 3.5], [1, 2e-3, 0]]})",
       [](const Message& message) { message.candidates(3); }},
      {R"({"message": "solved", "q": [0.1, 0.25, null], "error": 1e-6, "seconds": 0.002, "iterations": 12, )"
       R"("evaluations": 120, "extras": {"restarts": 3, "cost": -0.5}})",
       [](const Message& message) {
         message.joints(3);
         for (const char* key : {"iterations", "evaluations"}) message.count(key);
         for (const char* key : {"error", "seconds", "seed"}) message.number(key);
         message.extras();
       }}};
  for (const auto& each : messages) {
    read_mutated(Mutator(9), each.first, 700, "it wrote ", [&](const std::string& line) {
      try {
        each.second(Message(line));
      } catch (const ProcessFailure& trouble) {
        throw std::invalid_argument(trouble.why);
      }
    });
  }
}

TEST_CASE("studies of a store with random changes are read with all their solves, or refused", "[fuzz]") {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path / "store.sqlite";
  Study study = small_study();
  {
    Store store(file, Store::Mode::write);
    run(study, store, {});
  }
  SQLite::Database sqlite(file.string(), SQLite::OPEN_READWRITE);
  const auto read_with = [&](const char* table, const char* column, int times) {
    const std::string whole = sqlite.execAndGet(fmt::format("SELECT {} FROM {}", column, table)).getString();
    SQLite::Statement change(
        sqlite, fmt::format("UPDATE {0} SET {1} = ? WHERE rowid = (SELECT min(rowid) FROM {0})", table, column));
    const auto put = [&](const std::string& text) {
      change.reset();
      change.bind(1, text);
      change.exec();
    };
    read_mutated(Mutator(17), whole, times, "", [&](const std::string& text) {
      put(text);
      const Store store(file, Store::Mode::read);
      const StoredStudy stored = store.study("small");
      judge::read_study(store, stored);
      complaint<std::invalid_argument>(
          [&] { std::ranges::for_each(solves_of(store, "small"), stored_solve_check(stored)); });
    });
    put(whole);
  };
  read_with("studies", "definition", 400);
  read_with("series", "options", 100);
  for (const char* list : {"answer_rad", "reached_position_m", "improved_to_cm"}) read_with("solves", list, 100);
}

TEST_CASE("a results.json with random changes is one of ikbench, or another's", "[fuzz]") {
  const ScratchFolder folder;
  const std::string whole =
      "{\n \"headline\": \"A is better\",\n \"findings\": [],\n \"files\": [\n  \"report.md\",\n  "
      "\"results.json\",\n  \"tables/a.csv\"\n ]\n}\n";
  write_text(folder.path / "report.md", "ours");
  write_text(folder.path / "results.json", whole);
  show::reserve_files(folder.path, {"tables/b.csv"});  // keeps what it says besides
  const auto kept = parsed_json(text_in(folder.path / "results.json"));
  CHECK(kept["headline"] == "A is better");
  CHECK(kept["files"].size() == 4);
  read_mutated(Mutator(23), whole, 700, quoted(folder.path / "re").substr(0, 10), [&](const std::string& text) {
    write_text(folder.path / "results.json", text);
    show::reserve_files(folder.path, {"report.md"});
  });
}
