#include "results/merge.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "results/fingerprint.hpp"
#include "results/store_codec.hpp"

namespace ikbench::results {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& place) { return fmt::format("'{}'", place.string()); }

// Opens a store for reading. If a kill left the store half-written, opening the store for writing mends the file.
Store opened(const fs::path& place) {
  try {
    return Store(place, Store::Mode::read);
  } catch (const InterruptedWrite&) {
    return Store(place, Store::Mode::write_shared);
  }
}

// The parts of a definition that may differ between two stores: how a study is judged and drawn, which targets are
// unreachable, and how often the study is run. Some parts follow from others, and the keys of series compare the rest,
// such as how programs are started.
const std::set<std::string> decide_no_solve{
    "analysis", "departures", "figures", "grid",  "name",   "require", "unreachable_targets",
    "solvers",  "published",  "runs",    "title", "rounds", "sweep"};

// The links by which an arm was chosen. The definition's arm has the links that were taken, whether named or found.
const std::set<std::string> settled_in_arm{"urdf.base", "urdf.tip"};

std::vector<std::string> keys_of(const StoredStudy& study) {
  std::vector<std::string> keys;
  for (const Series& series : study.series) keys.push_back(series.key);
  return keys;
}

std::vector<std::string> configurations_of(const StoredStudy& study) {
  std::vector<std::string> keys = keys_of(study);
  for (std::string& key : keys) key = configuration_part(key);
  return keys;
}

// Returns the first label that was solved with other answers made elsewhere; empty if other solvers differ, too.
std::string label_of_other_answers(const StoredStudy& study, const StoredStudy& other) {
  std::string label;
  for (std::size_t i = 0; i < study.series.size(); ++i) {
    const Series& series = study.series[i];
    if (series.key == other.series[i].key) continue;
    if (!base::parsed_json(series.options).contains("answers")) return "";
    if (label.empty()) label = series.label;
  }
  return label;
}

std::string requirements_text(const std::vector<Requirement>& requirements) {
  std::vector<std::string> texts;
  for (const Requirement& requirement : requirements) texts.push_back(requirement.text());
  return texts.empty() ? "empty" : base::listed(texts);
}

// Returns why two studies of one name cannot be merged; empty if they can. Different numbers of runs are no reason,
// since the larger number counts.
std::string why_not_one(const StoredStudy& study, const StoredStudy& other) {
  const std::string difference = difference_in_solves(study.definition.json, other.definition.json);
  if (!difference.empty()) return difference;
  if (configurations_of(study) != configurations_of(other)) return "its solvers or their options differ";
  if (!std::ranges::equal(study.series, other.series, {}, &Series::label, &Series::label))
    return "the labels of its solvers differ";
  if (const std::string label = label_of_other_answers(study, other); !label.empty())
    return fmt::format("{} was solved with another file of answers; use one file for all", base::in_quotes(label));
  if (keys_of(study) != keys_of(other))
    return "the version of the solvers or of shared code differs; use one version of ikbench for all";
  const auto &required = study.definition.requirements, &other_required = other.definition.requirements;
  if (required != other_required)
    return fmt::format("its [require] is {} and {}", requirements_text(required), requirements_text(other_required));
  return "";
}

// The first study of each name, with the store that has it.
using Studies = std::map<std::string, std::pair<StoredStudy, fs::path>>;

// Throws std::invalid_argument, with the place of the store, if the check refuses a solve of the study.
void check_solves(const Store& store, StoredStudy study, const MakeCheck& check_of, const fs::path& place) {
  // Another store's definition may have more runs, with which all of these solves count.
  study.definition.runs = std::numeric_limits<int>::max();
  try {
    store.for_each_in_study(study, check_of(study));
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    if (message.starts_with(quoted(place))) throw std::invalid_argument(message);
    throw std::invalid_argument(fmt::format("{}: {}", quoted(place), message));
  }
}

// Returns the studies of a store after the check of every solve. Throws as `check_solves`.
std::vector<StoredStudy> checked_studies(const fs::path& place, const MakeCheck& check_of) {
  const Store store = opened(place);
  std::vector<StoredStudy> studies = store.studies();
  for (const StoredStudy& study : studies) check_solves(store, study, check_of, place);
  return studies;
}

void refuse_another_study(Studies& known, const std::vector<StoredStudy>& studies, const fs::path& place) {
  for (const StoredStudy& study : studies) {
    const auto& [first, first_place] = known.try_emplace(study.name, study, place).first->second;
    if (const std::string why = why_not_one(first, study); !why.empty())
      throw std::invalid_argument(fmt::format(
          "the study '{}' is not the same in {} and {}: {}; nothing was merged; solve one of them again like "
          "the other, or leave one store out",
          study.name, quoted(first_place), quoted(place), why));
  }
}

// The rows of solves in the database `source` that belong to studies of `source`, and so were checked. Rows of former
// keys, and of targets beyond those of a study, were not checked. CROSS JOIN keeps the order of the rows.
constexpr std::string_view checked_solves =
    "source.solves CROSS JOIN (SELECT key, max(json_extract(definition, '$.points')) AS points FROM source.series "
    "JOIN source.studies ON study = name GROUP BY key) ON key = series AND point <= points";

std::int64_t number_of(SQLite::Database& sqlite, std::string_view rows) {
  return sqlite.execAndGet(fmt::format("SELECT count(*) FROM {}", rows)).getInt64();
}

// Throws std::invalid_argument if a solve in the database `source` has other bits than the same solve in `main`.
void refuse_other_bits(SQLite::Database& sqlite, const fs::path& ours, const fs::path& theirs) {
  // An empty store differs in nothing, and needs no scan of the other store.
  if (sqlite.execAndGet("SELECT NOT EXISTS (SELECT 1 FROM main.solves)").getInt() != 0) return;
  std::vector<std::string> differ;
  const auto compare = [&](std::string_view column) {
    differ.push_back(fmt::format("iif(theirs.{0} IS NOT ours.{0}, ' {0}', '')", column));
  };
  for_each_column_of_fingerprint([&](std::string_view column, auto) {
    if (column != "study") compare(column);  // the same solve may belong to two studies
  });
  compare("all_answers_rad");
  SQLite::Statement query(sqlite,
                          fmt::format("SELECT theirs.run, theirs.point, theirs.label, {} AS others "
                                      "FROM (SELECT solves.* FROM {}) AS theirs "
                                      "JOIN main.solves AS ours USING (series, run, point) WHERE others <> '' LIMIT 1",
                                      fmt::join(differ, " || "), checked_solves));
  if (!query.executeStep()) return;
  throw std::invalid_argument(fmt::format(
      "the solve of run {}, point {} by {} has other bits in {} than in {} ({}), so nothing of this store was merged; find "
      "out which machine, compiler or edit changed them (ikbench export --format fingerprint)",
      query.getColumn(0).getInt64(), query.getColumn(1).getInt64(), base::in_quotes(query.getColumn(2).getString()),
      quoted(theirs), quoted(ours), query.getColumn(3).getString().substr(1)));
}

// Checks studies of `main` that took solves of the database `source` by their keys, although `source` has no study of
// their name. These solves were checked only for another study, which may ask for something else.
void check_taken(SQLite::Database& sqlite, const Store& ours, const MakeCheck& check_of, const fs::path& theirs) {
  SQLite::Statement query(
      sqlite,
      "SELECT name FROM main.studies WHERE name NOT IN (SELECT name FROM source.studies) AND name IN "
      "(SELECT ours.study FROM main.series AS ours JOIN source.series USING (key))");
  while (query.executeStep())
    for (const StoredStudy& study : ours.studies(query.getColumn(0).getString()))
      check_solves(ours, study, check_of, theirs);
}

// Returns whether the database `source` has a table that not every store has, and then creates it in `main`, too.
bool has_optional_table(SQLite::Database& sqlite, const std::string& name) {
  SQLite::Statement query(sqlite, "SELECT coalesce(max(sql), '') FROM source.sqlite_master WHERE name = ?");
  query.bind(1, name);
  query.executeStep();
  const std::string table = query.getColumn(0).getString();
  if (!table.empty() && !sqlite.tableExists(name)) sqlite.exec(table);
  return !table.empty();
}

// Copies what `main` lacks from the database `source`. The sessions of new solves get new numbers, and each study keeps
// the larger number of runs. Returns how many solves are new.
std::int64_t copy_missing(SQLite::Database& sqlite) {
  const std::string session = sqlite.execAndGet("SELECT coalesce(max(id), 0) FROM main.sessions").getString();
  const std::string row = sqlite.execAndGet("SELECT coalesce(max(rowid), 0) FROM main.solves").getString();
  const std::string columns = solve_columns();
  std::string values = columns;
  constexpr std::string_view numbered = " session,";
  values.replace(values.find(numbered), numbered.size(), fmt::format(" session + {},", session));
  const int added =
      sqlite.exec(fmt::format("INSERT INTO main.solves ({}) SELECT {} FROM {} WHERE true ON CONFLICT DO NOTHING",
                              columns, values, checked_solves));
  sqlite.exec(
      fmt::format("INSERT INTO main.sessions SELECT id + {0}, began FROM source.sessions "
                  "WHERE id + {0} IN (SELECT session FROM main.solves WHERE rowid > {1});"
                  "INSERT INTO main.environment SELECT session + {0}, key, value FROM source.environment "
                  "WHERE session + {0} IN (SELECT id FROM main.sessions);"
                  "INSERT INTO main.studies (name, definition, saved) "
                  "SELECT name, definition, saved FROM source.studies WHERE true ORDER BY position "
                  "ON CONFLICT (name) DO UPDATE SET definition = excluded.definition, saved = excluded.saved "
                  "WHERE json_extract(excluded.definition, '$.runs') > json_extract(definition, '$.runs');"
                  "INSERT OR IGNORE INTO main.series SELECT * FROM source.series "
                  "WHERE study IN (SELECT name FROM source.studies)",
                  session, row));
  if (has_optional_table(sqlite, "extras"))
    sqlite.exec(
        fmt::format("INSERT OR IGNORE INTO main.extras SELECT own.* FROM source.extras AS own "
                    "JOIN main.solves USING (series, run, point) WHERE main.solves.rowid > {}",
                    row));
  for (const char* const table : {"known_answers", "answer_counts"})
    if (has_optional_table(sqlite, table))
      sqlite.exec(fmt::format("INSERT OR IGNORE INTO main.{0} SELECT * FROM source.{0}", table));
  return added;
}

}  // namespace

std::string difference_in_solves(const std::string& first, const std::string& second) {
  const auto left = base::parsed_json(first).flatten(), right = base::parsed_json(second).flatten();
  const auto text_of = [](const nlohmann::json& json, const std::string& key) {
    constexpr std::size_t most = 60;
    if (!json.contains(key)) return std::string("missing");
    const std::string text = base::text_of(json[key]);
    return text.size() <= most ? text : "another";
  };
  std::set<std::string> keys;
  for (const auto* json : {&left, &right})
    for (const auto& [key, value] : json->items()) keys.insert(key);
  keys.erase("");                        // the key of an empty definition
  for (const std::string& key : keys) {  // such as "/stop/tolerance_cm"
    const std::string name = boost::replace_all_copy(key.substr(1), "/", ".");
    const bool is_name_of_joint = name.starts_with("arm.links.") && name.ends_with(".name");
    if (decide_no_solve.contains(name.substr(0, name.find('.'))) || settled_in_arm.contains(name) || is_name_of_joint)
      continue;
    if (left.contains(key) && right.contains(key) && left[key] == right[key]) continue;
    const std::string before = text_of(left, key), after = text_of(right, key);
    return before == after ? fmt::format("{} differs", name) : fmt::format("{} is {} and {}", name, before, after);
  }
  return "";
}

std::string missing_solves_text(const Store& store, const StoredStudy& study) {
  const std::int64_t asked = std::int64_t{study.definition.runs} * study.definition.points * std::ssize(study.series);
  const std::int64_t there = store.solve_count(study);
  return there < asked ? fmt::format("lacks {} of {} solves", asked - there, asked) : "";
}

MergeResult merge(const fs::path& out, std::vector<fs::path> stores, const MakeCheck& check_of,
                  const MergeProgress& progress) {
  Studies studies;
  MergeResult merged;
  std::error_code none;
  const auto is_empty = [&](const fs::path& place) { return fs::file_size(place, none) == 0 && !none; };
  if (std::ranges::all_of(stores, is_empty))
    for (const fs::path& place : stores) static_cast<void>(Store(place, Store::Mode::read));  // throws, and says why
  std::erase_if(stores, is_empty);
  if (fs::exists(out, none)) refuse_another_study(studies, checked_studies(out, check_of), out);
  std::erase_if(stores, [&](const fs::path& place) {
    std::vector<StoredStudy> of_store;
    try {
      of_store = checked_studies(place, check_of);
    } catch (const std::invalid_argument& error) {
      merged.skipped.push_back(error.what());
      return true;
    }
    refuse_another_study(studies, of_store, place);
    return false;
  });
  if (stores.empty()) throw std::invalid_argument(fmt::format("{}", fmt::join(merged.skipped, "; ")));
  Store all(out, Store::Mode::write_shared);
  for (const fs::path& place : stores) {
    if (progress) progress(merged.stores, std::ssize(stores));
    if (fs::equivalent(place, out, none)) continue;
    ++merged.stores;
    all.merge_from(place, [&](SQLite::Database& sqlite) {
      refuse_other_bits(sqlite, out, place);
      const std::int64_t added = copy_missing(sqlite);
      check_taken(sqlite, all, check_of, place);
      const std::int64_t checked = number_of(sqlite, checked_solves), there = number_of(sqlite, "source.solves");
      merged.added += added;
      merged.duplicates += checked - added;
      if (checked < there)
        merged.skipped.push_back(fmt::format("{} of {} solves in {}, because none of its studies has them",
                                             there - checked, there, quoted(place)));
    });
  }
  for (const StoredStudy& study : all.studies())
    if (const std::string lack = missing_solves_text(all, study); !lack.empty())
      merged.incomplete.push_back(study.name + ' ' + lack);
  return merged;
}

}  // namespace ikbench::results
