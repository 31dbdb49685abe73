// What benchmark programs have written (Google Benchmark's JSON), by the name of the benchmark.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ikbench::microbenchmarks {

class Measurements {
 public:
  // std::invalid_argument where it is not such a document.
  void add(const nlohmann::json& document);

  // One number a repetition, in their order; empty where it was not measured. CPU time, or the clock's where a
  // benchmark asks for it.
  std::vector<double> nanoseconds(const std::string& name) const;
  std::vector<double> counter(const std::string& name, const std::string& counter) const;
  // A value that is text, of the only repetition; or empty.
  std::string text(const std::string& name, const std::string& key) const;

  // Of all benchmarks measured, in the order of their first appearance.
  std::vector<std::string> names(const std::string& prefix = "") const;
  // Why a benchmark gave up; empty where it did not.
  std::string error(const std::string& name) const;
  // What is noted of the machine and the build; empty where it is not.
  std::string context(const std::string& key) const;

 private:
  std::vector<std::string> order_;
  std::map<std::string, std::vector<nlohmann::json>> repetitions_;
  std::map<std::string, std::string> errors_;
  nlohmann::json context_ = nlohmann::json::object();
};

}  // namespace ikbench::microbenchmarks
