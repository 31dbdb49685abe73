#include "experiments/microbenchmarks/measurements.hpp"

#include <algorithm>
#include <stdexcept>

namespace ikbench::microbenchmarks {

namespace {

// Google Benchmark appends to a name how it was run.
std::string plain_name(const nlohmann::json& entry) {
  if (!entry.contains("run_name")) return entry.at("name");
  const std::string name = entry["run_name"];
  std::size_t end = name.size();
  for (const char* manner :
       {"/min_time:", "/iterations:", "/repeats:", "/process_time", "/real_time", "/manual_time"}) {
    end = std::min(end, name.find(manner));
  }
  return name.substr(0, end);
}

// As Google Benchmark itself does for its rates: CPU time, unless the benchmark asks for the clock's.
bool is_by_the_clock(const nlohmann::json& entry) {
  const std::string name = entry.value("run_name", "");
  return name.ends_with("/real_time") || name.ends_with("/manual_time");
}

double unit_in_nanoseconds(const std::string& unit) {
  if (unit == "us") return 1e3;
  if (unit == "ms") return 1e6;
  return unit == "s" ? 1e9 : 1;
}

}  // namespace

void Measurements::add(const nlohmann::json& document) {
  if (!document.is_object() || !document.contains("benchmarks") || !document["benchmarks"].is_array()) {
    throw std::invalid_argument("expected an object with a list `benchmarks`, as --benchmark_out writes it");
  }
  context_.update(document.value("context", nlohmann::json::object()));
  for (const nlohmann::json& entry : document["benchmarks"]) {
    if (entry.value("run_type", "iteration") != "iteration") continue;  // means and the like
    const std::string name = plain_name(entry);
    if (entry.value("error_occurred", false)) {
      errors_[name] = entry.value("error_message", "");
      continue;
    }
    std::vector<nlohmann::json>& all = repetitions_[name];
    if (all.empty()) order_.push_back(name);
    all.push_back(entry);
    std::stable_sort(all.begin(), all.end(), [](const nlohmann::json& a, const nlohmann::json& b) {
      return a.value("repetition_index", 0) < b.value("repetition_index", 0);
    });
  }
}

std::vector<double> Measurements::nanoseconds(const std::string& name) const {
  std::vector<double> values;
  if (!repetitions_.contains(name)) return values;
  for (const nlohmann::json& entry : repetitions_.at(name)) {
    const char* time = is_by_the_clock(entry) ? "real_time" : "cpu_time";
    if (entry.contains(time)) {
      values.push_back(entry[time].get<double>() * unit_in_nanoseconds(entry.value("time_unit", "ns")));
    }
  }
  return values;
}

std::vector<double> Measurements::counter(const std::string& name, const std::string& counter) const {
  std::vector<double> values;
  if (!repetitions_.contains(name)) return values;
  for (const nlohmann::json& entry : repetitions_.at(name)) {
    if (entry.contains(counter)) values.push_back(entry[counter].get<double>());
  }
  return values;
}

std::string Measurements::text(const std::string& name, const std::string& key) const {
  return repetitions_.contains(name) ? repetitions_.at(name).front().value(key, "") : "";
}

std::vector<std::string> Measurements::names(const std::string& prefix) const {
  std::vector<std::string> names;
  std::copy_if(order_.begin(), order_.end(), std::back_inserter(names),
               [&](const std::string& name) { return name.starts_with(prefix); });
  return names;
}

std::string Measurements::error(const std::string& name) const {
  return errors_.contains(name) ? errors_.at(name) : "";
}

std::string Measurements::context(const std::string& key) const {
  if (!context_.contains(key)) return "";
  const nlohmann::json& value = context_[key];
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace ikbench::microbenchmarks
