// How a command line says by which methods groups are compared.
#pragma once

#include <CLI/CLI.hpp>

#include "results/analysis_plan.hpp"

namespace ikbench::cli {

// --test, --adjustment, --control, --significance, --margin, --margin-cm, --power, --quartiles; defaults are what the
// plan holds.
void add_plan_options(CLI::App& command, results::AnalysisPlan& plan);

// Each alone; --margin as "5%" or "0.05".
// A number of the range, digits and point alone: CLI11 reads more than that as numbers.
CLI::Validator number_in(std::pair<double, double> range);

// Decimal digits and nothing else: CLI11 alone reads 010 as 8 and takes what is too large for the largest.
CLI::Validator whole_number();

CLI::Option* add_margin_option(CLI::App& command, double& margin);
CLI::Option* add_margin_cm_option(CLI::App& command, double& margin_cm);
CLI::Option* add_significance_option(CLI::App& command, double& significance);

}  // namespace ikbench::cli
