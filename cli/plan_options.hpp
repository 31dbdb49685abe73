// Command-line options for the methods that compare groups.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <utility>

#include "results/analysis_plan.hpp"

namespace ikbench::cli {

// Adds --test, --control, --significance, --margin, --margin-cm and --quartiles; the plan's values are the defaults.
void add_plan_options(CLI::App& command, results::AnalysisPlan& plan);

// Accepts a number in the range, with digits and point only: CLI11 accepts more texts as numbers.
CLI::Validator number_in(std::pair<double, double> range);

constexpr std::int64_t largest_whole = 999'999'999'999'999'999;
// Accepts numbers in the range, written in decimal digits only: CLI11 alone reads 010 as 8 and takes what is too large
// for the largest.
CLI::Validator whole_number(std::pair<std::int64_t, std::int64_t> range = {0, largest_whole});

// --margin takes "5%" or "0.05".
CLI::Option* add_margin_option(CLI::App& command, double& margin);
CLI::Option* add_margin_cm_option(CLI::App& command, double& margin_cm);
CLI::Option* add_significance_option(CLI::App& command, double& significance);

}  // namespace ikbench::cli
