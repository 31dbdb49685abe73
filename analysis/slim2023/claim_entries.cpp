#include "analysis/slim2023/claim_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "numerics/embedded_file.hpp"
#include "numerics/names.hpp"
#include "numerics/toml_table.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace inference;
using namespace report;

namespace {

constexpr EmbeddedFile claim_files[]{
#include "claims.inc"
};

Choices<Metric> metric_choices() {
  Choices<Metric> choices;
  for (const Metric metric : reported_metrics()) choices.emplace_back(name_of(metric), metric);
  return choices;
}

[[noreturn]] void refuse(const TomlReader& reader, const std::string& what) {
  throw std::invalid_argument(reader.where(reader.table().source(), "") + what);
}

bool is_snake_case(std::string_view id) {
  const auto is_such = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return std::ranges::all_of(id, is_such);
}

bool can_be_counted(const ClaimEntry& entry) {
  const bool has_effect = entry.test == "has_effect";
  return (has_effect || entry.test == "smallest") && !entry.solver.empty() && has_effect == !entry.dimension.empty() &&
         entry.metrics.size() == 1 && is_of_universes(entry.metrics.front()) && entry.take == Take::all;
}

ClaimEntry read_claim(TomlReader reader, const std::vector<std::string>& tests) {
  ClaimEntry entry;
  const std::array<std::pair<std::string_view, std::string*>, 4> needed{
      {{"id", &entry.id}, {"sentence", &entry.sentence}, {"decides", &entry.decides}, {"test", &entry.test}}};
  for (const auto& [key, field] : needed) {
    reader.text(key, *field, "");
    if (field->empty()) refuse(reader, fmt::format("a claim without {}; expected a text", key));
  }
  reader.text("section", entry.section, "");
  reader.choice("by", entry.by, {{"paper", By::paper}, {"us", By::us}}, "");
  reader.text("solver", entry.solver, "");
  reader.text("against", entry.against, "");
  reader.chosen("metrics", entry.metrics, metric_choices(), "");
  reader.text("study", entry.study, "");
  reader.choice("take", entry.take, {{"all", Take::all}, {"solver", Take::solver}, {"others", Take::others}}, "");
  reader.chosen("universes", entry.universes, {{"mean", JudgedBy::mean}, {"typical", JudgedBy::typical}}, "");
  reader.text("dimension", entry.dimension, "");
  reader.refuse_unknown_keys();
  if (!is_snake_case(entry.id)) reader.fail("id", *reader.find("id"), "lower-case letters, digits and underscores");
  if (std::ranges::find(tests, entry.test) == tests.end())
    refuse(reader, unknown_name("test of a claim", entry.test, tests));
  if (!entry.universes.empty() && !can_be_counted(entry)) {
    reader.fail("universes", *reader.find("universes"),
                "it only for a solver with one metric of error or variation, and the test \"smallest\" or, with a "
                "dimension, \"has_effect\"");
  }
  return entry;
}

}  // namespace

std::vector<ClaimEntry> read_claims(std::string_view text, std::string_view source,
                                    const std::vector<std::string>& tests) {
  const toml::table table = parse_toml(text, source);
  TomlReader file(table, source, "");
  const toml::node* const node = file.find("claims");
  file.refuse_unknown_keys();
  if (node == nullptr || !node->is_array_of_tables()) {
    throw std::invalid_argument(fmt::format("{}: no claims; expected tables [[claims]]", source));
  }
  std::vector<ClaimEntry> entries;
  for (const toml::node& each : *node->as_array()) {
    const TomlReader reader(*each.as_table(), source, "claims.");
    ClaimEntry entry = read_claim(reader, tests);
    if (std::ranges::find(entries, entry.id, &ClaimEntry::id) != entries.end())
      refuse(reader, fmt::format("the claim {} is there twice; expected it once", entry.id));
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<ClaimEntry> claim_entries(const std::vector<std::string>& tests) {
  const EmbeddedFile& file = *find_embedded(claim_files, "claims");
  return read_claims(file.text, file.name, tests);
}

}  // namespace ikbench::slim2023
