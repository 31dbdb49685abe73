// The goals of performance, and whether measurements meet them. Every goal is a number inside one run of one program:
// mostly a ratio, so that it says the same of a fast and of a slow machine.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/microbenchmarks/measurements.hpp"

namespace ikbench::microbenchmarks {

enum class Verdict { met, not_met, not_measured, no_goal };

struct Row {
  std::string number;
  std::string goal;      // in words
  std::string required;  // for the instruction set in use
  std::string measured;  // the median of the repetitions, and the range they have
  Verdict verdict = Verdict::not_measured;
  std::string why = {};  // it was not measured
};

std::vector<Row> goal_rows(const Measurements& measurements, std::string_view instruction_set);

std::string as_text(const std::vector<Row>& rows);
std::string as_markdown(const std::vector<Row>& rows);

// The machine, the build and the load, in a sentence.
std::string machine(const Measurements& measurements);
// The median time of every benchmark.
std::string times_as_markdown(const Measurements& measurements);

}  // namespace ikbench::microbenchmarks
