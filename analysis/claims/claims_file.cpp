#include "analysis/claims/claims_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "analysis/claims/rules.hpp"
#include "analysis/claims/tables_of.hpp"
#include "numerics/names.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace inference;
using namespace report;

namespace {

Choices<Metric> metric_choices() {
  Choices<Metric> choices;
  for (const Metric metric : all_metrics()) choices.emplace_back(name_of(metric), metric);
  return choices;
}

[[noreturn]] void refuse(const TomlReader& reader, const std::string& what) {
  throw std::invalid_argument(reader.where(reader.table().source(), "") + what);
}

bool can_be_counted(const ClaimEntry& entry) {
  return entry.rule == "smallest" && !entry.solver.empty() && entry.metrics.size() == 1 &&
         is_of_universes(entry.metrics.front()) && entry.take == FromCompanion::all;
}

ClaimEntry read_claim(TomlReader reader, const std::string& papers_own) {
  ClaimEntry entry{.solver = papers_own};
  const std::array<std::pair<std::string_view, std::string*>, 4> needed{
      {{"id", &entry.id}, {"sentence", &entry.sentence}, {"decides", &entry.decides}, {"rule", &entry.rule}}};
  for (const auto& [key, field] : needed) {
    reader.text(key, *field, "");
    if (field->empty()) refuse(reader, fmt::format("a claim without {}; expected a text", key));
  }
  for (const auto& [key, field] :
       {std::pair("section", &entry.section), std::pair("solver", &entry.solver), std::pair("against", &entry.against),
        std::pair("study", &entry.study), std::pair("table", &entry.table), std::pair("note", &entry.note),
        std::pair("row", &entry.row), std::pair("path", &entry.path)}) {
    reader.text(key, *field, "");
  }
  reader.choice("by", entry.by, {{"paper", Claimant::paper}, {"us", Claimant::us}}, "");
  reader.chosen("metrics", entry.metrics, metric_choices(), "");
  reader.choice("take", entry.take,
                {{"all", FromCompanion::all}, {"solver", FromCompanion::solver}, {"others", FromCompanion::others}},
                "");
  reader.chosen("universes", entry.universes,
                {{"mean", results::Estimand::mean}, {"typical", results::Estimand::typical}}, "");
  reader.texts("solvers", entry.solvers, "");
  reader.number("limit_ms", entry.limit_ms, 1, {0, 1e9}, "");
  read_texts(reader, "reasons", entry.reasons);
  reader.refuse_unknown_keys();
  if (entry.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos)
    reader.fail("id", *reader.find("id"), "lower-case letters, digits and underscores");
  const NamedRule* const rule = rule_named(entry.rule);
  if (rule == nullptr) refuse(reader, unknown_name("rule of a claim", entry.rule, rule_names()));
  if (rule->needs_metrics && entry.metrics.empty())
    refuse(reader, fmt::format("the rule {} without metrics; expected one at least", entry.rule));
  if (!entry.universes.empty() && !can_be_counted(entry)) {
    reader.fail("universes", *reader.find("universes"),
                "it only for a solver with one metric of error or variation, and the rule \"smallest\"");
  }
  return entry;
}

}  // namespace

ClaimsFile read_claims(std::string_view paper, std::string_view text, std::string_view source) {
  const toml::table table = parse_toml(text, source);
  TomlReader reader(table, source, "");
  ClaimsFile file{.paper = std::string(paper)};
  reader.text("solver", file.solver, "");
  reader.text("means", file.means, "");
  reader.texts("not_on", file.not_on, "");
  reader.text("implementation", file.implementation, "");
  read_texts(reader, "anovas", file.anovas);
  reader.whole("fitting", file.fitting, {0, 1000}, "");
  reader.find("claims");
  reader.refuse_unknown_keys();
  for (const TomlReader& each : tables_of(reader, "claims")) {
    ClaimEntry entry = read_claim(each, file.solver);
    if (std::ranges::find(file.entries, entry.id, &ClaimEntry::id) != file.entries.end())
      refuse(each, fmt::format("the claim {} is there twice; expected it once", entry.id));
    file.entries.push_back(std::move(entry));
  }
  return file;
}

}  // namespace ikbench::claims
