// Prints the fingerprints of the built-in studies without a time budget, as `ikbench export --format fingerprint` makes
// them, in the form of a benchmark's result: result_hash THREADS RUNS.
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "experiments/environment.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"
#include "results/fingerprint.hpp"

using namespace ikbench::results;
using namespace ikbench::experiments;

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "result_hash: expected the number of threads and of runs: result_hash 2 20\n";
    return 1;
  }
  const int threads = std::atoi(argv[1]);

  std::string hash;
  std::size_t solves = 0;
  for (Study study : studies()) {
    if (study.stop.seconds > 0) continue;  // a solve that ends by the clock has other bits each time
    study.runs = std::atoi(argv[2]);
    std::vector<SolveRecord> records;
    solve_study(study, threads, [&](SolveRecord record) { records.push_back(std::move(record)); });
    solves += records.size();
    if (!hash.empty()) hash += ' ';
    hash += fingerprint(std::move(records));
  }

  const auto context = environment();
  const nlohmann::json result{
      {"name", "result_hash/" + context.at("instruction_set") + "/threads:" + std::to_string(threads)},
      {"solves", solves},
      {"hash", hash}};
  const nlohmann::json document{{"context", context}, {"benchmarks", nlohmann::json::array({result})}};
  std::cout << document.dump(2) << '\n';
  return 0;
}
