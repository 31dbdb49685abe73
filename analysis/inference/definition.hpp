// What the definition of a study (JSON, as the store has it) says. Any of it may be missing or be something else.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "results/same_solves.hpp"

namespace ikbench::inference {

using results::decide_no_solve;

// Values are named by JSON pointers: "/path/kind".
class Definition {
 public:
  explicit Definition(std::string_view json) : json_(nlohmann::json::parse(json, nullptr, false)) {}

  std::string text(const std::string& pointer) const;             // empty where there is none
  double number(const std::string& pointer) const;                // not_defined where there is none
  std::vector<double> numbers(const std::string& pointer) const;  // none where not all of them are numbers
  const nlohmann::json* find(const std::string& pointer) const;   // null where there is none

  // Whether the targets were drawn anew for every run; older stores have the kind of path alone.
  bool draws_targets() const { return text("/path/targets") == "drawn" || text("/path/kind") == "random"; }

  // Whether each solve has a start of its own, the same for all solvers, and not the answer before it.
  bool starts_anew() const { return !text("/start").empty() && text("/start") != "previous"; }

 private:
  nlohmann::json json_;
};

}  // namespace ikbench::inference
