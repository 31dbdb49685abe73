// A hash of the bits of every answer and error of the helix study, in the form of a benchmark's result:
// result_hash THREADS RUNS.
#include <fmt/format.h>

#include <bit>
#include <cstdlib>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "experiments/environment.hpp"
#include "experiments/runner.hpp"
#include "robots/instruction_set.hpp"

using namespace ikbench;

namespace {

class Hash {  // FNV-1a
 public:
  void add(double value) {
    for (auto bits = std::bit_cast<std::uint64_t>(value), byte = std::uint64_t{0}; byte < 8; ++byte, bits >>= 8) {
      hash_ = (hash_ ^ (bits & 0xff)) * 0x100000001b3u;
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "result_hash: expected the number of threads and of runs: result_hash 2 20\n";
    return 1;
  }
  const int threads = std::atoi(argv[1]);
  Study study = studies().front();
  study.runs = std::atoi(argv[2]);

  std::map<std::tuple<std::string, int, int>, Hash> hashes;  // threads hand in as they finish
  solve_study(study, threads, [&](const SolveRecord& record) {
    Hash& hash = hashes[{record.solver, record.run, record.point}];
    for (const double angle : record.answer_rad) hash.add(angle);
    hash.add(record.claimed_error_cm);
    hash.add(record.position_error_cm);
  });
  Hash all;
  for (const auto& [solve, hash] : hashes) all.add(std::bit_cast<double>(hash.value()));

  const std::string set(name_of(instruction_set()));
  std::map<std::string, std::string> context = environment();
  context["instruction_set"] = set;
  const nlohmann::json result{{"name", "result_hash/" + set + "/threads:" + std::to_string(threads)},
                              {"solves", hashes.size()},
                              {"hash", fmt::format("{:016x}", all.value())}};
  const nlohmann::json document{{"context", context}, {"benchmarks", nlohmann::json::array({result})}};
  std::cout << document.dump(2) << '\n';
  return 0;
}
