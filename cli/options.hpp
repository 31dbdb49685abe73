// Checks of options, options that commands share, and JSON as an answer.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <utility>

#include "base/json.hpp"

namespace ikbench::cli {

// Accepts a decimal number in the range: CLI11 accepts more texts as numbers.
CLI::Validator number_in(std::pair<double, double> range);

constexpr std::int64_t largest_whole = 999'999'999'999'999'999;
// Accepts numbers in the range, written in decimal digits only: CLI11 alone reads 010 as 8 and takes what is too large
// for the largest.
CLI::Validator whole_number(std::pair<std::int64_t, std::int64_t> range = {0, largest_whole});

// Refuses an empty folder name: it comes from an unset variable of a script.
CLI::Validator not_empty();

void add_json_option(CLI::App& command, bool& is_json);
void show_json(const base::OrderedJson& json);

// Adds --study, the name of one of a store.
void add_study_option(CLI::App& command, std::string& study);
// Adds PAPER, the name of a paper; the first by default.
void add_paper_option(CLI::App& command, std::string& paper);

}  // namespace ikbench::cli
