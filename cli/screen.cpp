#include "cli/screen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iterator>
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

std::string with_short_words(std::string_view cell, std::size_t longest) {
  std::string text;
  for (std::size_t at = 0; at <= cell.size();) {
    const std::size_t end = std::min(cell.find(' ', at), cell.size());
    text += (at > 0 ? " " : "") + shortened(printable(cell.substr(at, end - at)), longest);
    at = end + 1;
  }
  return text;
}

std::size_t lines_in(const Part& part, std::size_t item) {
  const std::string& text = part.items[item];
  const std::string shown = part.are_warnings ? wrapped("warning: " + text) : text;
  return 1 + static_cast<std::size_t>(std::ranges::count(shown, '\n'));
}

// Says how many items of each part are shown: first the parts that are always shown, then what each gets at least,
// warnings before all, then more of each while there is room.
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
  for (const bool are_warnings : {true, false}) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].are_warnings == are_warnings) take(i, parts[i].least);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) take(i, no_limit);
  return taken;
}

// "12 rows, 1 warning and the columns max and min"; empty if all is shown.
std::string left_out(const std::vector<Part>& parts, const std::vector<std::size_t>& taken) {
  std::vector<std::pair<std::string, std::size_t>> rest;  // by noun
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (taken[i] == parts[i].items.size()) continue;
    auto found = std::ranges::find(rest, parts[i].noun, &std::pair<std::string, std::size_t>::first);
    if (found == rest.end()) found = rest.insert(found, {parts[i].noun, 0});
    found->second += parts[i].items.size() - taken[i];
  }
  std::vector<std::string> what;
  for (const auto& [noun, count] : rest) what.push_back(fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s"));
  std::vector<std::string> columns;
  for (const Part& part : parts) std::ranges::copy(part.columns, std::back_inserter(columns));
  constexpr std::size_t most_named = 5;
  if (columns.size() > most_named)
    what.push_back(fmt::format("{} columns", columns.size()));
  else if (!columns.empty())
    what.push_back(fmt::format("the column{} {}", columns.size() == 1 ? "" : "s", report::listed(columns)));
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

Part table_rows(const Table& table, const OutputArguments& output, std::size_t least, Tones tones,
                std::size_t longest) {
  Part part{.noun = "row", .least = least};
  Rows rows = readable_cells(table);
  const auto finish = [&](std::size_t width) {
    if (!tones.of_rows.empty()) tones.of_rows.insert(tones.of_rows.begin(), Tone::plain);
    part.items = aligned_rows(rows, width, tones);
    if (part.items.size() > 1) {  // the head is never alone
      part.items[1].insert(0, part.items.front() + '\n');
      part.items.erase(part.items.begin());
    }
    return std::move(part);
  };
  if (output.is_verbose) return finish(no_limit);
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      row[c] = with_short_words(row[c], longest);
      widths[c] = std::max(widths[c], std::min(character_count(row[c]), longest));
    }
  }
  constexpr std::size_t gap = 2;
  std::size_t shown = 1, used = widths.front();
  for (; shown < widths.size() && used + gap + widths[shown] <= text_width(); ++shown) used += gap + widths[shown];
  part.columns.assign(rows.front().begin() + static_cast<std::ptrdiff_t>(shown), rows.front().end());
  for (auto& row : rows) row.resize(shown);
  return finish(text_width());
}

void show_screen(const std::vector<Part>& parts, const OutputArguments& output, const std::string& where) {
  constexpr std::size_t most_said = 10;  // a screen shows its answer, whatever came before
  const std::size_t room = screen_lines - std::min(take_said_lines(), most_said);
  std::vector<std::size_t> taken = fitting(parts, output.is_verbose ? no_limit : room);
  const auto rest_words = [&] {
    const std::string rest = left_out(parts, taken);
    return rest.empty() ? "" : wrapped(fmt::format("Not shown: {}. --verbose shows all{}.", rest, where)) + '\n';
  };
  const auto lines_of_rest = [&] { return static_cast<std::size_t>(std::ranges::count(rest_words(), '\n')); };
  for (std::size_t kept = 0; lines_of_rest() > kept;) {  // the words need room, too
    kept = lines_of_rest();
    taken = fitting(parts, room - kept);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i + 1 == parts.size()) fmt::print("{}", rest_words());
    for (std::size_t item = 0; item < taken[i]; ++item) {
      if (parts[i].are_warnings)
        warn(parts[i].items[item]);
      else
        fmt::print("{}\n", parts[i].items[item]);
    }
  }
  std::fflush(stdout);
  take_said_lines();
}

void show_json(const report::Json& json) { fmt::print("{}\n", numerics::text_of(json, 2)); }

}  // namespace ikbench::cli
