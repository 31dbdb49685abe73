#include "analysis/papers/paper.hpp"

#include <algorithm>
#include <utility>

#include "analysis/papers/rules.hpp"
#include "base/embedded_file.hpp"
#include "base/names.hpp"
#include "base/toml_table.hpp"

namespace ikbench::papers {

using namespace judge;
using namespace base;

namespace {

constexpr EmbeddedFile files[]{
#include "paper_files.inc"
};

using Texts = std::map<std::string, std::string>;

void read_texts(TomlReader& reader, std::string_view key, Texts& field) {
  TomlReader texts = reader.part(key);
  for (const auto& [name, value] : texts.table()) texts.text(name.str(), field[std::string(name.str())], "");
}

Claim read_claim(TomlReader reader, const std::string& papers_own) {
  Claim claim;
  if (!papers_own.empty()) claim.solvers = {papers_own};
  std::vector<std::string> metrics;
  for (const auto& [key, field] : {std::pair("id", &claim.id),
                                   {"sentence", &claim.sentence},
                                   {"decides", &claim.decides},
                                   {"section", &claim.section},
                                   {"study", &claim.study},
                                   {"note", &claim.note}})
    reader.text(key, *field, "");
  std::vector<std::string_view> names;
  for (const Rule& rule : rules()) names.push_back(rule.name);
  std::size_t rule = names.size();
  reader.choice("rule", rule, names);
  if (rule < names.size()) claim.rule = &rules()[rule];
  reader.choice("by", claim.is_ours, {"paper", "us"});
  reader.choice("of", claim.of, {"means", "spread"});
  reader.choice("from", claim.from, {"both", "solvers", "others"});
  reader.texts("solvers", claim.solvers, "");
  reader.texts("against", claim.against, "");
  reader.texts("metrics", metrics, "");
  reader.refuse_unknown_keys();
  if (claim.id.empty() || claim.sentence.empty() || claim.decides.empty())
    throw reader.mistake("", "a claim without id, sentence or decides");
  for (const std::string& metric : metrics) claim.metrics.push_back(&metric_named(metric));
  if (metrics.empty() && claim.rule != nullptr && claim.rule->is_of_metrics)
    throw reader.mistake("metrics", "a claim without metrics");
  return claim;
}

Rates read_rates(TomlReader reader) {
  Rates rates;
  read_texts(reader, "tables", rates.tables);
  std::vector<const toml::table*> numbers;
  if (reader.table().contains("numbers")) numbers = reader.tables("numbers", 100, "1 to 100 tables [[rates.numbers]]");
  for (const toml::table* const table : numbers) {
    TomlReader of_column = reader.nested(*table, "rates.numbers.");
    PrintedColumn& column = rates.numbers.emplace_back();
    std::string metric;
    for (const auto& [key, field] : {std::pair("name", &column.name),
                                     {"table", &column.table},
                                     {"column", &column.column},
                                     {"metric", &metric},
                                     {"study", &column.study}})
      of_column.text(key, *field, "");
    of_column.refuse_unknown_keys();
    column.metric = &metric_named(metric);
  }
  reader.text("note", rates.note, "");
  reader.number("level", rates.level, 1, {0.5, 0.9999}, "");
  reader.texts("picked", rates.picked, "");
  read_texts(reader, "rows", rates.rows);
  read_texts(reader, "columns", rates.columns);
  reader.text("programs", rates.programs, "");
  reader.refuse_unknown_keys();
  return rates;
}

AnswerCounts read_answer_counts(TomlReader reader) {
  AnswerCounts counts;
  reader.text("table", counts.table, "");
  reader.text("note", counts.note, "");
  read_texts(reader, "programs", counts.programs);
  read_texts(reader, "reasons", counts.reasons);
  reader.refuse_unknown_keys();
  return counts;
}

}  // namespace

const std::vector<Paper>& papers() {
  static const std::vector<Paper> all = [] {
    std::vector<Paper> read;
    for (const EmbeddedFile& file : files) read.push_back(read_paper(file.stem(), file.text, file.name));
    std::stable_partition(read.begin(), read.end(), [](const Paper& paper) { return !paper.means.empty(); });
    return read;
  }();
  return all;
}

const Paper& paper_named(std::string_view name) {
  return find_named("paper", name, papers(), [](const Paper& paper) { return paper.name; });
}

Paper read_paper(std::string_view name, std::string_view toml, std::string_view source) {
  const toml::table table = parse_toml(toml, source);
  TomlReader reader(table, source, "");
  Paper paper{.name = std::string(name)};
  for (const auto& [key, field] : {std::pair("in_short", &paper.in_short),
                                   {"citation", &paper.citation},
                                   {"not_repeated", &paper.not_repeated},
                                   {"solver", &paper.solver},
                                   {"means", &paper.means},
                                   {"means_note", &paper.means_note}})
    reader.text(key, *field, "");
  reader.texts("studies", paper.studies, "");
  reader.texts("runs", paper.runs, "");
  read_texts(reader, "readings", paper.readings);
  if (const toml::table* const rates = reader.subtable("rates"))
    paper.rates = read_rates(reader.nested(*rates, "rates."));
  if (const toml::table* const counts = reader.subtable("counts"))
    paper.counts = read_answer_counts(reader.nested(*counts, "counts."));
  const std::vector<const toml::table*> claims = reader.tables("claims", 1000, "1 to 1000 tables [[claims]]");
  reader.refuse_unknown_keys();
  for (const toml::table* const entry : claims)
    paper.claims.push_back(read_claim(reader.nested(*entry, "claims."), paper.solver));
  return paper;
}

}  // namespace ikbench::papers
