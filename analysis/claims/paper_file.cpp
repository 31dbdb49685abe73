#include "analysis/claims/paper_file.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "analysis/claims/multiverse.hpp"
#include "analysis/claims/rules.hpp"
#include "analysis/claims/tables_of.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace results;
using namespace inference;
using namespace report;

namespace {

RatesPlan read_rates(TomlReader reader, const std::string& name) {
  RatesPlan rates{.paper = name};
  reader.number("level", rates.level, 1, {0.5, 0.9999}, "");
  reader.text("caption", rates.caption, "");
  reader.text("table", rates.table, "");
  reader.text("note", rates.note, "");
  reader.whole("iterations", rates.iterations, {1, 1'000'000}, "");
  read_texts(reader, "rows", rates.rows);
  read_texts(reader, "columns", rates.columns);
  reader.refuse_unknown_keys();
  return rates;
}

// Kinds of reproduction, with the words of Lopez-Ibanez, Branke and Paquete 2021 (ACM TELO 1(4)).
const Choices<std::string_view> kinds{{"none", ""},
                                      {"repeated", "Repeated: the authors' code and random numbers."},
                                      {"replicated", "Replicated: our code and random numbers."},
                                      {"generalised", "Generalised: our code, other arms or targets."}};

// Adds the claims' parts of a report.
void add_claims(Paper& paper, ClaimsFile file) {
  const auto shared = std::make_shared<const ClaimsFile>(std::move(file));
  paper.claims = [shared](const Reported& reported) { return judged(*shared, reported); };
  if (!shared->means.empty()) {
    paper.printed = [shared](const StudyResults& study) { return printed_summaries(*shared, study); };
  }
  const auto is_of_universes = [](const ClaimEntry& entry) { return !entry.universes.empty(); };
  if (std::ranges::none_of(shared->entries, is_of_universes)) return;
  paper.multiverse = [shared](const Multiverse& multiverse, const AnalysisPlan& plan) {
    return multiverse_report(*shared, multiverse, plan);
  };
}

Paper read_paper(const std::string& name, const EmbeddedFile& file, std::span<const EmbeddedFile> files) {
  const toml::table table = parse_toml(file.text, file.name);
  TomlReader reader(table, file.name, "");
  Paper paper{.name = name};
  std::vector<std::string> studies, with_runs;
  reader.text("in_short", paper.in_short, "");
  reader.texts("studies", studies, "");
  reader.texts("runs", with_runs, "");
  for (const std::string& study : studies) paper.studies.push_back({study, std::ranges::count(with_runs, study) > 0});
  read_prose(reader, "citation", paper.citation);
  read_prose(reader, "not_reproduced", paper.not_reproduced);
  std::string_view kind;
  reader.choice("kind", kind, kinds, "");
  paper.kind = kind;
  if (const toml::table* const rates = reader.subtable("rates")) {
    paper.rates = read_rates(reader.nested(*rates, "rates."), name);
  }
  reader.refuse_unknown_keys();
  if (const EmbeddedFile* const claims = find_embedded(files, name + "/claims")) {
    ClaimsFile claimed = read_claims(name, claims->text, claims->name);
    claimed.rates = paper.rates;
    add_claims(paper, std::move(claimed));
  }
  return paper;
}

}  // namespace

std::vector<Paper> read_papers(std::span<const EmbeddedFile> files) {
  std::vector<Paper> all;
  for (const EmbeddedFile& file : files) {
    const std::string_view stem = file.stem();
    if (!stem.ends_with("/paper")) continue;
    all.push_back(read_paper(std::string(stem.substr(0, stem.find('/'))), file, files));
  }
  return all;
}

}  // namespace ikbench::claims
