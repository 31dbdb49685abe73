#include "results/ompl.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>

#include "numerics/number.hpp"
#include "results/files.hpp"
#include "results/orientation.hpp"

namespace ikbench::results {

using namespace numerics;

namespace {

struct Property {
  std::string name, type;
};

// Cells are texts: SQLite turns them into what the type of their column says, in our database as in OMPL's.
struct Planner {
  std::string name;
  std::vector<std::string> settings;                         // "name TEXT = value"
  std::vector<std::vector<std::string>> runs;                // a cell a property; empty: not known
  std::vector<std::vector<std::vector<std::string>>> trace;  // of each run, rows of time and error
};

struct Benchmark {
  std::string name, version, host, date, setup, cpu, seed, seconds_per_run, seconds;
  std::size_t runs = 0;                                                   // of a planner
  std::map<std::string, std::pair<std::string, std::string>> properties;  // type and value, in OMPL's order
  std::vector<Planner> planners;
};

const std::vector<Property> run_properties{{"run", "INTEGER"},
                                           {"point", "INTEGER"},
                                           {"time", "REAL"},
                                           {"cpu_time", "REAL"},
                                           {"solved", "BOOLEAN"},
                                           {"status", "ENUM"},
                                           {"stop_reason", "ENUM"},
                                           {"position_error_cm", "REAL"},
                                           {"orientation_error_deg", "REAL"},
                                           {"variation_deg", "REAL"},
                                           {"limit_violation_deg", "REAL"},
                                           {"evaluations", "INTEGER"},
                                           {"iterations", "INTEGER"}};
const std::vector<Property> trace_properties{{"time", "REAL"}, {"best_error_cm", "REAL"}};

// On one line, without what separates the parts of a line.
std::string plain(std::string text, std::string_view separators = "") {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || separators.find(c) != std::string_view::npos) c = '_';
  }
  return text;
}

std::string cell(double value) { return std::isfinite(value) ? text_of(value) : ""; }

std::vector<std::string> cells_of(const SolveRecord& solve) {
  return {std::to_string(solve.run),
          std::to_string(solve.point),
          cell(solve.seconds),
          cell(solve.cpu_seconds),
          solve.status == Status::ok ? "1" : "0",
          std::to_string(static_cast<int>(solve.status)),
          std::to_string(static_cast<int>(solve.stop_reason)),
          cell(solve.position_error_cm),
          cell(orientation_angle_deg(solve.orientation_error)),
          cell(solve.variation_deg),
          cell(solve.limit_violation_deg),
          solve.counted_by == CountedBy::nobody ? "" : std::to_string(solve.evaluations),
          std::to_string(solve.iterations)};
}

std::vector<std::vector<std::string>> trace_of(const SolveRecord& solve) {
  std::vector<std::vector<std::string>> rows;
  const auto all = static_cast<double>(solve.trace_cm.size());
  for (std::size_t k = 0; k < solve.trace_cm.size(); ++k) {
    rows.push_back({cell(solve.seconds * static_cast<double>(k + 1) / all), cell(solve.trace_cm[k])});
  }
  return rows;
}

std::string text_at(const nlohmann::json& json, const std::string& pointer) {
  const nlohmann::json::json_pointer at(pointer);
  if (!json.contains(at)) return "";
  return json[at].is_string() ? json[at].get<std::string>() : json[at].dump();
}

std::string fact(const std::vector<Session>& sessions, const std::string& name) {
  if (sessions.empty()) return "";
  const auto found = sessions.front().environment.find(name);
  return found == sessions.front().environment.end() ? "" : found->second;
}

Planner planner_of(const Series& series, const std::vector<SolveRecord>& solves) {
  Planner planner{.name = plain(series.label), .settings = {}, .runs = {}, .trace = {}};
  const nlohmann::json options = nlohmann::json::parse(series.options);
  planner.settings.push_back("solver TEXT = " + plain(series.algorithm));
  for (const auto& [name, value] : options.items()) {
    planner.settings.push_back(fmt::format("{} TEXT = {}", plain(name), plain(text_at(options, "/" + name))));
  }
  for (const SolveRecord& solve : solves) {
    if (solve.solver != series.label) continue;
    planner.runs.push_back(cells_of(solve));
    planner.trace.push_back(trace_of(solve));
  }
  const bool is_traced = std::ranges::any_of(planner.trace, [](const auto& rows) { return !rows.empty(); });
  if (!is_traced) planner.trace.clear();
  return planner;
}

Benchmark benchmark_of(const ExportedStudy& exported) {
  const nlohmann::json definition = nlohmann::json::parse(exported.study.definition);
  const auto or_else = [](const std::string& text, const char* otherwise) { return text.empty() ? otherwise : text; };
  Benchmark benchmark{.name = plain(exported.study.name, " "),
                      .version = plain(or_else(fact(exported.sessions, "version"), "0"), " "),
                      .host = "unknown",
                      .date = plain(fact(exported.sessions, "date"), "TZ"),
                      .setup = plain(exported.study.definition) + "\n",
                      .cpu = plain(fact(exported.sessions, "cpu")) + "\n",
                      .seed = plain(or_else(text_at(definition, "/seed"), "0"), " "),
                      .seconds_per_run = or_else(text_at(definition, "/stop/seconds"), "0"),
                      .seconds = "0",
                      .properties = {},
                      .planners = {}};
  std::ranges::replace(benchmark.date, '_', ' ');
  while (!benchmark.date.empty() && benchmark.date.back() == ' ') benchmark.date.pop_back();
  for (const auto& [name, type, pointer] : {std::tuple("robot", "TEXT", "/robot"),
                                            {"search", "TEXT", "/search"},
                                            {"path", "TEXT", "/path/kind"},
                                            {"points", "INTEGER", "/points"},
                                            {"tolerance_cm", "REAL", "/stop/tolerance_cm"},
                                            {"tolerance_deg", "REAL", "/stop/tolerance_deg"},
                                            {"limits", "TEXT", "/limits"},
                                            {"start", "TEXT", "/start"}}) {
    const std::string value = plain(text_at(definition, pointer), "=");
    if (!value.empty()) benchmark.properties[name] = {type, value};
  }
  double seconds = 0;
  for (const SolveRecord& solve : exported.solves) seconds += std::isfinite(solve.seconds) ? solve.seconds : 0;
  benchmark.seconds = text_of(seconds);
  for (const Series& series : exported.study.series) {
    benchmark.planners.push_back(planner_of(series, exported.solves));
    benchmark.runs = std::max(benchmark.runs, benchmark.planners.back().runs.size());
  }
  return benchmark;
}

std::string settings_text(const Planner& planner) {
  std::string text;
  for (const std::string& line : planner.settings) text += line + "\n;";
  return text;
}

class Tables {
 public:
  explicit Tables(SQLite::Database& sqlite) : sqlite_(sqlite) {}

  // An empty text is NULL; a second row of one key is left out, as OMPL's script does.
  void insert(const std::string& table, const std::vector<std::string>& columns,
              const std::vector<std::string>& values) {
    const std::vector<std::string> marks(values.size(), "?");
    SQLite::Statement statement(sqlite_, fmt::format("INSERT OR IGNORE INTO {} ({}) VALUES ({})", table,
                                                     fmt::join(columns, ", "), fmt::join(marks, ", ")));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i].empty()) statement.bind(static_cast<int>(i) + 1, values[i]);
    }
    statement.exec();
  }
  std::string last_id() const { return std::to_string(sqlite_.getLastInsertRowid()); }

 private:
  SQLite::Database& sqlite_;
};

// As ompl_benchmark_statistics of OMPL 1.5.2 makes them; Planner Arena counts on the order of the columns.
constexpr const char* schema = R"(
CREATE TABLE experiments (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512), totaltime REAL, timelimit REAL,
  memorylimit REAL, runcount INTEGER, version VARCHAR(128), hostname VARCHAR(1024), cpuinfo TEXT, date DATETIME,
  seed VARCHAR(24), setup TEXT);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512) NOT NULL, settings TEXT);
CREATE TABLE enums (name VARCHAR(512), value INTEGER, description TEXT, PRIMARY KEY (name, value));
CREATE TABLE runs (id INTEGER PRIMARY KEY AUTOINCREMENT, experimentid INTEGER, plannerid INTEGER,
  FOREIGN KEY (experimentid) REFERENCES experiments(id) ON DELETE CASCADE,
  FOREIGN KEY (plannerid) REFERENCES plannerConfigs(id) ON DELETE CASCADE);
CREATE TABLE progress (runid INTEGER, time REAL, PRIMARY KEY (runid, time),
  FOREIGN KEY (runid) REFERENCES runs(id) ON DELETE CASCADE);
)";

constexpr const char* views = R"(
CREATE VIEW bestPlannerConfigsPerExperiment AS
  SELECT plannerid, experimentid, MIN(avg_solved) AS avg_solved, avg_total_time FROM (
    SELECT plannerid, plannerName, experimentid, AVG(solved) AS avg_solved, AVG(total_time) AS avg_total_time FROM (
      SELECT plannerid, plannerConfigs.name AS plannerName, experimentid, solved, time AS total_time
      FROM plannerConfigs INNER JOIN experiments INNER JOIN runs
      ON plannerConfigs.id=runs.plannerid AND experiments.id=runs.experimentid)
    GROUP BY plannerid, experimentid)
  GROUP BY plannerName, experimentid ORDER BY avg_solved DESC, avg_total_time ASC;
CREATE VIEW bestPlannerConfigs AS
  SELECT plannerid, MIN(avg_solved) AS avg_solved, avg_total_time FROM (
    SELECT plannerid, plannerName, AVG(solved) AS avg_solved, AVG(total_time) AS avg_total_time FROM (
      SELECT plannerid, plannerConfigs.name AS plannerName, experimentid, solved, time AS total_time
      FROM plannerConfigs INNER JOIN experiments INNER JOIN runs
      ON plannerConfigs.id=runs.plannerid AND experiments.id=runs.experimentid)
    GROUP BY plannerid)
  GROUP BY plannerName ORDER BY avg_solved DESC, avg_total_time ASC;
)";

template <std::size_t count>
void insert_enum(Tables& tables, const char* name, const std::array<std::string_view, count>& names) {
  for (std::size_t i = 0; i < count; ++i) {
    tables.insert("enums", {"name", "value", "description"}, {name, std::to_string(i), std::string(names[i])});
  }
}

void insert_planner(Tables& tables, const Planner& planner, const std::string& experiment) {
  tables.insert("plannerConfigs", {"name", "settings"}, {planner.name, settings_text(planner)});
  const std::string id = tables.last_id();
  std::vector<std::string> columns{"experimentid", "plannerid"};
  for (const Property& property : run_properties) columns.push_back(property.name);
  for (std::size_t r = 0; r < planner.runs.size(); ++r) {
    std::vector<std::string> values{experiment, id};
    values.insert(values.end(), planner.runs[r].begin(), planner.runs[r].end());
    tables.insert("runs", columns, values);
    const std::string run = tables.last_id();
    if (planner.trace.empty()) continue;
    for (const std::vector<std::string>& row : planner.trace[r]) {
      tables.insert("progress", {"runid", "time", "best_error_cm"}, {run, row[0], row[1]});
    }
  }
}

}  // namespace

std::string to_ompl_log(const ExportedStudy& exported) {
  const Benchmark benchmark = benchmark_of(exported);
  std::string log = fmt::format("ikbench version {}\nExperiment {}\n{} experiment properties\n", benchmark.version,
                                benchmark.name, benchmark.properties.size());
  for (const auto& [name, property] : benchmark.properties) {
    log += fmt::format("{} {} = {}\n", name, property.first, property.second);
  }
  log += fmt::format("Running on {}\nStarting at {}\n<<<|\n{}|>>>\n<<<|\n{}|>>>\n{} is the random seed\n",
                     benchmark.host, benchmark.date, benchmark.setup, benchmark.cpu, benchmark.seed);
  log += fmt::format("{} seconds per run\n0 MB per run\n{} runs per planner\n{} seconds spent to collect the data\n",
                     benchmark.seconds_per_run, benchmark.runs, benchmark.seconds);
  log += fmt::format("2 enum types\nstatus|{}\nstop_reason|{}\n{} planners\n", fmt::join(status_names, "|"),
                     fmt::join(stop_reason_names, "|"), benchmark.planners.size());
  for (const Planner& planner : benchmark.planners) {
    log += fmt::format("{}\n{} common properties\n", planner.name, planner.settings.size());
    for (const std::string& line : planner.settings) log += line + '\n';
    log += fmt::format("{} properties for each run\n", run_properties.size());
    for (const Property& property : run_properties) log += fmt::format("{} {}\n", property.name, property.type);
    log += fmt::format("{} runs\n", planner.runs.size());
    for (const std::vector<std::string>& run : planner.runs) log += fmt::format("{}; \n", fmt::join(run, "; "));
    if (!planner.trace.empty()) {
      log += fmt::format("{} progress properties for each run\n", trace_properties.size());
      for (const Property& property : trace_properties) log += fmt::format("{} {}\n", property.name, property.type);
      log += fmt::format("{} runs\n", planner.trace.size());
      for (const auto& rows : planner.trace) {
        for (const std::vector<std::string>& row : rows) log += fmt::format("{},;", fmt::join(row, ","));
        log += '\n';
      }
    }
    log += ".\n";
  }
  return log;
}

void write_ompl_database(const std::filesystem::path& file, const ExportedStudy& exported) {
  const Benchmark benchmark = benchmark_of(exported);
  SQLite::Database sqlite(":memory:", SQLite::OPEN_READWRITE);
  sqlite.exec(schema);
  Tables tables(sqlite);
  std::vector<std::string> columns{"name",     "totaltime", "timelimit", "memorylimit", "runcount", "version",
                                   "hostname", "cpuinfo",   "date",      "seed",        "setup"};
  std::vector<std::string> values{benchmark.name,
                                  benchmark.seconds,
                                  benchmark.seconds_per_run,
                                  "0",
                                  std::to_string(benchmark.runs),
                                  "ikbench " + benchmark.version,
                                  benchmark.host,
                                  benchmark.cpu,
                                  benchmark.date,
                                  benchmark.seed,
                                  benchmark.setup};
  for (const auto& [name, property] : benchmark.properties) {
    sqlite.exec(fmt::format("ALTER TABLE experiments ADD {} {}", name, property.first));
    columns.push_back(name);
    values.push_back(property.second);
  }
  tables.insert("experiments", columns, values);
  const std::string experiment = tables.last_id();
  insert_enum(tables, "status", status_names);
  insert_enum(tables, "stop_reason", stop_reason_names);
  for (const Property& property : run_properties) {
    sqlite.exec(fmt::format("ALTER TABLE runs ADD {} {}", property.name, property.type));
  }
  const auto is_traced = [](const Planner& planner) { return !planner.trace.empty(); };
  if (std::ranges::any_of(benchmark.planners, is_traced)) {
    sqlite.exec("ALTER TABLE progress ADD best_error_cm REAL");
  }
  for (const Planner& planner : benchmark.planners) insert_planner(tables, planner, experiment);
  sqlite.exec(views);
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes(
      sqlite3_serialize(sqlite.getHandle(), "main", &size, 0), sqlite3_free);
  if (!bytes)
    throw std::runtime_error(
        fmt::format("cannot write '{}': the database has more than 2 GB; export a study of fewer runs", file.string()));
  write_through(file, {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)});
}

}  // namespace ikbench::results
