// How a command line says by which methods groups are compared.
#pragma once

#include <CLI/CLI.hpp>

#include "results/analysis_plan.hpp"

namespace ikbench::cli {

// --test, --adjustment, --control, --significance, --margin, --power, --quartiles; defaults are what the plan holds.
void add_plan_options(CLI::App& command, AnalysisPlan& plan);

// --margin alone: "5%" or "0.05".
void add_margin_option(CLI::App& command, double& margin);

}  // namespace ikbench::cli
