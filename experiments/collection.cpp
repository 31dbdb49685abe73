#include "experiments/collection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "experiments/series_key.hpp"
#include "experiments/study_writer.hpp"
#include "numerics/toml_table.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace results;

namespace {

constexpr std::size_t most_studies = 50;

// The table of a file that lists studies; nothing if there is no such file, or it does not.
std::optional<toml::table> list_of_studies(const std::filesystem::path& file) {
  std::error_code error;
  if (file.extension() != ".toml" || !std::filesystem::is_regular_file(file, error)) return std::nullopt;
  toml::table table = parse_toml(text_of_file(file), file.string());
  return table.contains("studies") ? std::optional(std::move(table)) : std::nullopt;
}

// "significance is 0.05 and 0.01", the first field that differs; empty if none does.
std::string difference(const AnalysisPlan& one, const AnalysisPlan& other) {
  const auto ours = nlohmann::ordered_json::parse(to_json(one)), theirs = nlohmann::ordered_json::parse(to_json(other));
  for (const auto& [key, value] : ours.items()) {
    if (value != theirs.at(key)) return fmt::format("{} is {} and {}", key, value.dump(), theirs.at(key).dump());
  }
  return "";
}

std::vector<std::string> solvers_of_all(const std::vector<Study>& studies) {
  std::vector<std::string> labels;
  for (const SolverEntry& entry : studies.front().solvers) {
    const bool is_in_all = std::ranges::all_of(studies, [&](const Study& study) {
      return std::ranges::count(study.solvers, entry.label, &SolverEntry::label) > 0;
    });
    if (is_in_all) labels.push_back(entry.label);
  }
  return labels;
}

// Says why another study cannot be judged with the first; empty if it can.
std::string why_not_with(const Study& first, const Study& other, bool have_blocks) {
  if (const std::string found = difference(first.analysis, other.analysis); !found.empty())
    return fmt::format("their plans differ: {} in [analysis]; expected the same in both", found);
  for (const SolverEntry& entry : other.solvers) {
    const auto same = std::ranges::find(first.solvers, entry.label, &SolverEntry::label);
    if (same != first.solvers.end() && same->solver != entry.solver)
      return fmt::format("the label {} is the solver {} in one and {} in the other; expected one solver", entry.label,
                         same->solver, entry.solver);
  }
  if (!have_blocks && first.runs != other.runs)
    return fmt::format(
        "they have {} and {} runs, and runs are what is compared; expected the same number, for example by --set "
        "runs={}",
        first.runs, other.runs, std::min(first.runs, other.runs));
  return "";
}

void check_together(const StudyCollection& collection, const std::string& where) {
  const Study& first = collection.studies.front();
  if (first.analysis.unit == Unit::point)
    throw std::invalid_argument(where + "unit is \"point\" in [analysis]; expected \"run\" in a collection");
  const bool have_blocks =
      std::ranges::all_of(collection.studies, [](const Study& study) { return why_no_blocks(study).empty(); });
  std::set<std::string> names;
  for (const Study& other : collection.studies) {
    if (!names.insert(other.name).second)
      throw std::invalid_argument(
          fmt::format("{}two studies have the name {}; expected another for one of them", where, other.name));
    if (const std::string why = why_not_with(first, other, have_blocks); !why.empty())
      throw std::invalid_argument(
          fmt::format("{}{} and {} cannot be judged together: {}", where, first.name, other.name, why));
  }
  if (solvers_of_all(collection.studies).size() < 2)
    throw std::invalid_argument(where + "no two solvers are in all studies; expected two labels that all have");
}

// Equal keys have equal labels too. `names` are those in the list, one of each study.
void refuse_shared_solves(const std::vector<Study>& studies, const std::vector<std::string>& names,
                          const std::string& where) {
  std::map<std::string, std::size_t> study_of;
  for (std::size_t i = 0; i < studies.size(); ++i) {
    for (const SolverEntry& entry : studies[i].solvers) {
      const std::size_t earlier = study_of.emplace(series_key(studies[i], entry), i).first->second;
      if (earlier == i) continue;
      throw std::invalid_argument(
          fmt::format("{}{} and {} ask for the same solves; a collection judges each study as a sample of its own",
                      where, names[earlier], names[i]));
    }
  }
}

// The values of the key `seeds`; none without it.
std::vector<std::int64_t> seeds_in(TomlReader& reader) {
  const std::string expected = fmt::format("a list of 2 to {} whole numbers, each once", most_studies);
  const toml::node* const node = reader.find("seeds");
  if (!node) return {};
  const toml::array* const array = node->as_array();
  if (!array || array->size() < 2 || array->size() > most_studies) reader.fail("seeds", *node, expected);
  std::vector<std::int64_t> seeds;
  for (const toml::node& element : *array) {
    const std::optional<std::int64_t> seed = element.value_exact<std::int64_t>();
    if (!seed || *seed < 0 || std::ranges::count(seeds, *seed) > 0) reader.fail("seeds", element, expected);
    seeds.push_back(*seed);
  }
  return seeds;
}

Study with_seed(const std::string& study, Overrides overrides, std::int64_t seed) {
  overrides.push_back(fmt::format("seed={}", seed));
  Study copy = load_study(study, overrides);
  copy.name += fmt::format("-seed-{}", seed);
  return copy;
}

}  // namespace

std::optional<StudyCollection> load_collection(const std::string& file, const Overrides& overrides) {
  const std::filesystem::path path = file;
  const std::optional<toml::table> table = list_of_studies(path);
  if (!table) return std::nullopt;
  TomlReader reader(*table, file, "");
  StudyCollection collection{.name = path.stem().string(), .title = "", .studies = {}};
  std::vector<std::string> names;
  reader.text("name", collection.name, "");
  reader.text("title", collection.title, "");
  reader.texts("studies", names, "");
  const std::vector<std::int64_t> seeds = seeds_in(reader);
  collection.are_seeds = !seeds.empty();
  reader.refuse_unknown_keys();
  if (collection.name.empty()) reader.fail("name", *table->get("name"), "a non-empty name");
  const std::string where = reader.where(table->get("studies")->source(), "studies");
  if (collection.are_seeds && names.size() != 1)
    throw std::invalid_argument(fmt::format("{}the list has {}; expected one study with seeds", where, names.size()));
  if (!collection.are_seeds && (names.size() < 2 || names.size() > most_studies))
    throw std::invalid_argument(
        fmt::format("{}the list has {}; expected 2 to {} studies", where, names.size(), most_studies));
  for (const std::string& name : names) {
    const bool is_file = std::filesystem::path(name).extension() == ".toml";
    const std::string beside = is_file ? (path.parent_path() / name).string() : name;
    if (is_file && list_of_studies(beside))
      throw std::invalid_argument(fmt::format("{}{} is a collection itself; expected studies", where, name));
    for (const std::int64_t seed : seeds) collection.studies.push_back(with_seed(beside, overrides, seed));
    if (seeds.empty()) collection.studies.push_back(load_study(beside, overrides));
  }
  if (collection.are_seeds) names.assign(seeds.size(), names.front());
  check_together(collection, where);
  refuse_shared_solves(collection.studies, names, where);
  return collection;
}

}  // namespace ikbench::experiments
