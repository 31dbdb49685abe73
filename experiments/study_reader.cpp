#include "experiments/study_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/entries_reader.hpp"
#include "experiments/study_checks.hpp"
#include "experiments/study_fields.hpp"
#include "experiments/study_overrides.hpp"
#include "experiments/table_reader.hpp"
#include "numerics/embedded_file.hpp"
#include "numerics/names.hpp"
#include "numerics/toml_table.hpp"
#include "results/published.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

constexpr EmbeddedFile study_files[]{
#include "studies.inc"
};

std::string source_of(const EmbeddedFile& file) { return fmt::format("built-in study {}", file.stem()); }

// Says that there is no such study, and which one has a name like it: built in, or a file in the folder that was meant.
std::string no_study(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    return fmt::format("{} is a folder; expected a TOML file, or a name of: ikbench list studies", file.string());
  if (std::filesystem::exists(file, error)) return fmt::format("{} is not a regular file", file.string());
  std::vector<std::string> names, files;
  for (const EmbeddedFile& embedded : study_files) names.emplace_back(embedded.stem());
  std::ranges::sort(names);
  if (file.extension() != ".toml" && !file.has_parent_path())
    return "no such file, and " + unknown_name("built-in study", file.string(), names);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  for (std::filesystem::directory_iterator entry(folder, error), end; entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".toml") files.push_back(entry->path().stem().string());
  }
  std::ranges::sort(files);
  const std::string stem = file.stem().string(), near = nearest_name(stem, files), built_in = nearest_name(stem, names);
  const std::string meant = near.empty() ? built_in : (file.parent_path() / (near + ".toml")).string();
  return fmt::format("no such file: {}; {}", file.string(),
                     meant.empty() ? "expected a TOML file, or a name of: ikbench list studies"
                                   : fmt::format("did you mean \"{}\"?", meant));
}

Path read_path(TomlReader reader) {
  const std::vector<Path> kinds = paths();
  Choices<std::size_t> names;
  for (const Path& kind : kinds) names.emplace_back(kind->name(), names.size());
  std::size_t chosen = 0;
  reader.choice("kind", chosen, names, "");
  Path path = kinds[chosen];
  TableReader fields(reader);
  path->list_fields(fields);
  reader.refuse_unknown_keys();
  try {
    path->load(folder_of(reader, "file"));
  } catch (const std::invalid_argument& error) {
    throw mistake(reader, reader.table().get("file"), "file", error.what());
  }
  return path;
}

// The plan depends on `study`'s path, runs and solvers.
results::Plan read_analysis(TomlReader reader, const Study& study) {
  results::Plan plan;
  list_fields(reader, plan);
  reader.refuse_unknown_keys();
  std::vector<std::string> labels;
  for (const SolverEntry& entry : study.solvers) labels.push_back(entry.label);
  if (!plan.control.empty() && std::find(labels.begin(), labels.end(), plan.control) == labels.end()) {
    reader.fail("control", *reader.find("control"),
                fmt::format("\"\" or the label of a solver of the study: \"{}\"", fmt::join(labels, "\", \"")));
  }
  return plan;
}

FigureStyle read_figures(TomlReader reader, const Study& study) {
  FigureStyle style;
  read_style(reader, style);
  std::vector<std::string> labels;
  for (const SolverEntry& entry : study.solvers) labels.push_back(entry.label);
  for (const std::string& label : style.solvers) {
    if (std::ranges::find(labels, label) == labels.end())
      reader.fail("solvers", *reader.find("solvers"),
                  fmt::format("labels of the study: \"{}\"", fmt::join(labels, "\", \"")));
  }
  return style;
}

UrdfChoice read_urdf(TomlReader reader, const Study& study) {
  if (!is_urdf_file(study.robot)) {
    throw std::invalid_argument(
        fmt::format("{}[urdf] is about a URDF file, but robot is \"{}\"; expected one such as \"my_arm.urdf\"",
                    reader.where(reader.table().source(), "urdf"), study.robot));
  }
  UrdfChoice choice;
  TableReader fields(reader);
  list_fields(fields, choice);
  reader.refuse_unknown_keys();
  return choice;
}

// Reads the study's arm: a built-in one, or a file in the study's folder (for --set in the current one).
Robot read_arm(const TomlReader& reader, Study& study) {
  const toml::node* const node = reader.table().get("robot");
  if (!is_arm_file(study.robot)) {
    try {
      return robot(study.robot);
    } catch (const std::invalid_argument& error) {
      throw mistake(reader, node, "robot", error.what());
    }
  }
  const std::filesystem::path file = folder_of(reader, "robot") / study.robot;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw mistake(reader, node, "robot",
                  fmt::format("there is no file {}; expected one, or an arm of: ikbench list robots", file.string()));
  }
  study.robot_of_file = std::make_shared<const Robot>(load_robot(file, study.urdf));
  return *study.robot_of_file;
}

Study read_study(toml::table& table, std::string_view source) {
  Study study;
  study.left_out = leave_out(table);
  TomlReader reader(table, source, "");
  TableReader fields(reader);
  list_fields(fields, study);
  if (study.name.empty()) reader.fail("name", *table.get("name"), "a non-empty name");
  if (const toml::table* path = reader.subtable("path")) study.path = read_path(reader.nested(*path, "path."));
  if (const toml::table* urdf = reader.subtable("urdf")) study.urdf = read_urdf(reader.nested(*urdf, "urdf."), study);
  if (const toml::table* stop = reader.subtable("stop")) {
    TomlReader stop_reader = reader.nested(*stop, "stop.");
    TableReader stop_fields(stop_reader);
    list_fields(stop_fields, study.stop);
    stop_reader.refuse_unknown_keys();
  }
  study.solvers = read_solvers(reader, study.left_out);
  if (const toml::table* analysis = reader.subtable("analysis")) {
    study.analysis = read_analysis(reader.nested(*analysis, "analysis."), study);
  }
  if (const toml::table* figures = reader.subtable("figures"))
    study.figures = read_figures(reader.nested(*figures, "figures."), study);
  reader.refuse_unknown_keys();

  const auto at = [&](std::string_view key, std::string_view message) {
    return mistake(reader, table.get(key), key, message);
  };
  const auto papers = published::papers();
  if (!study.published.empty() && std::find(papers.begin(), papers.end(), study.published) == papers.end()) {
    throw at("published", unknown_name("paper", study.published, {papers.begin(), papers.end()}));
  }
  const Robot arm = read_arm(reader, study);
  const Configuration units = joint_units(arm.chain);
  if (study.initial.size() == 0) {  // zeros, or the nearest that the limits allow
    study.initial = arm.limits.lower.cwiseMax(Eigen::VectorXd::Zero(arm.joints())).cwiseMin(arm.limits.upper);
  } else if (study.initial.size() == arm.joints()) {
    study.initial = study.initial.cwiseProduct(units).eval();
  } else {
    throw at("initial_deg", fmt::format("initial_deg has {} values; expected {}, one for each joint of {}",
                                        study.initial.size(), arm.joints(), arm.name));
  }
  check_fields(reader, study, arm);
  return study;
}

}  // namespace

Study parse_study(std::string_view toml_text, std::string_view source, const Overrides& overrides) {
  toml::table table = parse_toml(toml_text, source);
  for (const std::string& text : overrides) override_one(table, text);
  return read_study(table, source);
}

std::vector<Study> studies() {
  std::vector<Study> all;
  for (const EmbeddedFile& file : study_files) all.push_back(parse_study(file.text, source_of(file)));
  std::ranges::sort(all, {}, &Study::name);
  return all;
}

Study load_study(const std::string& name_or_file, const Overrides& overrides) {
  if (const EmbeddedFile* const file = find_embedded(study_files, name_or_file))
    return parse_study(file->text, source_of(*file), overrides);
  std::error_code error;
  const std::filesystem::path file = name_or_file;
  if (!std::filesystem::is_regular_file(file, error)) throw std::invalid_argument(no_study(file));
  Study study = parse_study(text_of_file(file), name_or_file, overrides);
  if (study.name == Study().name) study.name = file.stem().string();  // so that two files are two studies
  return study;
}

}  // namespace ikbench::experiments
