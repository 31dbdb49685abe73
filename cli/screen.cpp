#include "cli/screen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <string_view>
#include <utility>

#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"

namespace ikbench::cli {

using namespace inference;
using namespace report;

namespace {

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
constexpr std::size_t longest_cell = 40;

std::size_t lines_in(const Part& part, std::size_t item) {
  const std::string& text = part.items[item];
  const std::string shown = part.are_warnings ? wrapped("warning: " + text) : text;
  return 1 + static_cast<std::size_t>(std::ranges::count(shown, '\n'));
}

// How many items of each part are shown: first the parts that are always shown, then what each gets at least, then more
// of each while there is room.
std::vector<std::size_t> fitting(const std::vector<Part>& parts, std::size_t room) {
  std::vector<std::size_t> taken(parts.size(), 0), lines(parts.size(), 0);
  const auto take = [&](std::size_t i, std::size_t most) {
    while (taken[i] < parts[i].items.size()) {
      const std::size_t needed = lines_in(parts[i], taken[i]);
      const bool fits = needed <= room && lines[i] + needed <= most;
      if (!fits && !parts[i].noun.empty()) return;
      room -= std::min(room, needed);
      lines[i] += needed;
      ++taken[i];
    }
  };
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].noun.empty()) take(i, no_limit);
  for (std::size_t i = 0; i < parts.size(); ++i) take(i, parts[i].least);
  for (std::size_t i = 0; i < parts.size(); ++i) take(i, no_limit);
  return taken;
}

// "12 rows, 1 warning and the columns max and min"; empty if all is shown.
std::string left_out(const std::vector<Part>& parts, const std::vector<std::size_t>& taken) {
  std::vector<std::string> what;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t rest = parts[i].items.size() - taken[i];
    if (rest > 0) what.push_back(fmt::format("{} {}{}", rest, parts[i].noun, rest == 1 ? "" : "s"));
  }
  for (const Part& part : parts) {
    if (part.columns.empty()) continue;
    what.push_back(fmt::format("the column{} {}", part.columns.size() == 1 ? "" : "s", report::listed(part.columns)));
  }
  return what.empty() ? "" : report::listed(what);
}

}  // namespace

void add_json_option(CLI::App& command, OutputArguments& arguments) {
  command.add_flag("--json", arguments.is_json, "print the answer as JSON");
}

void add_output_options(CLI::App& command, OutputArguments& arguments) {
  CLI::Option* const verbose =
      command.add_flag("--verbose", arguments.is_verbose, "print all that there is to say, not what fits on a screen");
  add_json_option(command, arguments);
  command.get_option("--json")->excludes(verbose);
}

Part sentences(const std::vector<std::string>& texts, std::size_t least) {
  Part part{.noun = "sentence", .least = least};
  for (const std::string& text : texts) part.items.push_back(wrapped(text));
  return part;
}

Part warnings(const std::vector<std::string>& texts) {
  constexpr std::size_t least = 5;
  return {.items = texts, .noun = "warning", .least = least, .are_warnings = true};
}

Part table_rows(const Table& table, const OutputArguments& output, std::size_t least, Tones tones) {
  Part part{.noun = "row", .least = least};
  Rows rows = readable_cells(table);
  const auto finish = [&](std::size_t width) {
    if (!tones.of_rows.empty()) tones.of_rows.insert(tones.of_rows.begin(), Tone::plain);
    part.items = aligned_rows(rows, width, tones);
    return std::move(part);
  };
  if (output.is_verbose) return finish(no_limit);
  for (auto& row : rows) {
    for (std::string& cell : row) cell = shortened(cell, longest_cell);
  }
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], character_count(row[c]));
  }
  std::size_t used = 0, shown = 0;
  for (; shown < widths.size(); ++shown) {
    used += widths[shown] + (shown == 0 ? 0 : 2);
    if (used > text_width()) break;
  }
  const auto first_left_out = static_cast<std::ptrdiff_t>(std::max<std::size_t>(shown, 1));
  part.columns.assign(rows.front().begin() + std::min(first_left_out, std::ssize(rows.front())), rows.front().end());
  for (auto& row : rows) row.resize(std::min(row.size(), static_cast<std::size_t>(first_left_out)));
  return finish(text_width());
}

void show_screen(const std::vector<Part>& parts, const OutputArguments& output, const std::string& where) {
  std::vector<std::size_t> taken = fitting(parts, output.is_verbose ? no_limit : screen_lines);
  if (!left_out(parts, taken).empty()) {
    constexpr std::size_t to_say_so = 2;
    taken = fitting(parts, screen_lines - to_say_so);
  }
  const std::string rest = left_out(parts, taken);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i + 1 == parts.size() && !rest.empty()) {
      fmt::print("{}\n", wrapped(fmt::format("Not shown: {}. --verbose shows all{}.", rest, where)));
    }
    for (std::size_t item = 0; item < taken[i]; ++item) {
      if (parts[i].are_warnings)
        warn(parts[i].items[item]);
      else
        fmt::print("{}\n", parts[i].items[item]);
    }
  }
  std::fflush(stdout);
}

void show_json(const report::Json& json) { fmt::print("{}\n", numerics::text_of(json, 2)); }

}  // namespace ikbench::cli
