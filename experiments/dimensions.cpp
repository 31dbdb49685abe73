#include "experiments/dimensions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "numerics/embedded_file.hpp"
#include "numerics/names.hpp"
#include "numerics/toml_table.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace results;

namespace {

constexpr EmbeddedFile multiverse_files[]{
#include "multiverse.inc"
};

constexpr std::size_t most_dimensions = 100, most_alternatives = 20;

// "path.tool=eq27" has the key "path.tool".
std::string key_of_setting(std::string_view set) { return std::string(set.substr(0, set.find('='))); }

std::vector<const toml::table*> tables_of(TomlReader& reader, std::string_view key, std::size_t most) {
  return reader.tables(key, most, fmt::format("a list of 1 to {} tables", most));
}

Alternative read_alternative(TomlReader reader, bool is_default) {
  Alternative one;
  reader.text("set", one.set);
  reader.text("where", one.where);
  if (one.set.find('=', 1) == std::string::npos)
    throw reader.mistake("set", "set is missing or has no value; expected what --set takes");
  if (one.where.empty()) throw reader.mistake("where", "where is missing; expected a clause");
  if (!is_default) {
    reader.choice("in", one.scope, {{"small", Scope::small}, {"default", Scope::usual}});
    reader.texts("except", one.except);
  }
  reader.refuse_unknown_keys();
  return one;
}

// Says whether the choice precedes those of `owner` (a solver, or "" for the study).
bool is_set_before(const std::vector<Dimension>& earlier, const std::string& owner, const std::string& set) {
  return std::ranges::any_of(earlier, [&](const Dimension& each) {
    return (each.solver.empty() || each.solver == owner) &&
           std::ranges::find(each.alternatives, set, &Alternative::set) != each.alternatives.end();
  });
}

Dimension read_dimension(TomlReader reader, const std::vector<std::string>& labels,
                         const std::vector<Dimension>& earlier) {
  Dimension one;
  reader.text("section", one.section);
  reader.text("open", one.open);
  for (const toml::table* table : tables_of(reader, "alternatives", most_alternatives)) {
    one.alternatives.push_back(
        read_alternative(reader.nested(*table, "dimensions.alternatives."), one.alternatives.empty()));
    const std::string name = key_of_setting(one.alternatives.back().set);
    if (one.name.empty()) one.name = name;
    const std::string owner = name.substr(0, std::min(name.rfind('.'), name.size()));
    if (std::ranges::find(labels, owner) != labels.end()) one.solver = owner;
    const std::string& set = one.alternatives.back().set;
    if (name != one.name || std::ranges::count(one.alternatives, set, &Alternative::set) > 1) {
      reader.fail("alternatives", *table, fmt::format("another value of {}", one.name));
    }
    for (const std::string& excepted : one.alternatives.back().except) {
      if (is_set_before(earlier, one.solver, excepted)) continue;
      reader.fail(
          "alternatives", *table,
          fmt::format("in except what an earlier dimension of the study or of this solver sets, not \"{}\"", excepted));
    }
  }
  reader.refuse_unknown_keys();
  if (one.open.empty()) one.open = one.name;
  return one;
}

}  // namespace

std::vector<Dimension> parse_dimensions(std::string_view text, std::string_view source,
                                        const std::vector<std::string>& labels) {
  const toml::table table = parse_toml(text, source);
  TomlReader reader(table, source, "");
  std::vector<Dimension> list;
  for (const toml::table* each : tables_of(reader, "dimensions", most_dimensions)) {
    list.push_back(read_dimension(reader.nested(*each, "dimensions."), labels, list));
    if (std::ranges::count(list, list.back().name, &Dimension::name) > 1) {
      reader.fail("dimensions", *each, fmt::format("{} once", list.back().name));
    }
  }
  reader.refuse_unknown_keys();
  return list;
}

std::vector<Dimension> dimensions(std::string_view study) {
  const EmbeddedFile* const file = find_embedded(multiverse_files, study);
  if (file == nullptr) return {};
  return parse_dimensions(file->text, file->name, labels_of(load_study(std::string(study))));
}

std::vector<Dimension> within(Scope scope, std::vector<Dimension> dimensions) {
  for (Dimension& each : dimensions) {
    std::vector<Alternative> kept;
    for (Alternative& one : each.alternatives) {
      if (kept.empty() || one.scope <= scope) kept.push_back(std::move(one));
    }
    each.alternatives = std::move(kept);
  }
  std::erase_if(dimensions, [](const Dimension& each) { return each.alternatives.size() < 2; });
  return dimensions;
}

std::vector<Dimension> named(const std::vector<std::string>& names, const std::vector<Dimension>& dimensions) {
  std::vector<std::string> known;
  for (const Dimension& each : dimensions) known.push_back(each.name);
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) == known.end()) {
      throw std::invalid_argument(unknown_name("dimension", name, known));
    }
    if (std::ranges::count(names, name) > 1) {
      throw std::invalid_argument(fmt::format("the dimension {} is given twice; expected it once", name));
    }
  }
  std::vector<Dimension> chosen;
  for (const Dimension& each : dimensions) {
    if (std::ranges::find(names, each.name) != names.end()) chosen.push_back(each);
  }
  return chosen;
}

}  // namespace ikbench::experiments
