#include "cli/studies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "analysis/figures/map.hpp"
#include "analysis/figures/sweep.hpp"
#include "analysis/judge/judge.hpp"
#include "analysis/show/studies.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "cli/console.hpp"
#include "experiments/environment.hpp"

namespace ikbench::cli {

namespace {

// Returns a study's name as a part of a file's name: '_' replaces each byte that is not an ASCII letter, a digit, '-',
// '_' or '.'.
std::string for_file_name(std::string_view study) {
  constexpr std::size_t max_length = 60;  // bytes
  std::string name(study.substr(0, max_length));
  std::ranges::replace_if(
      name,
      [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0x80 || (std::isalnum(byte) == 0 && c != '-' && c != '_' && c != '.');
      },
      '_');
  return name;
}

// Returns the maps of all studies whose targets are a grid: "map-ur5e", "map-long".
std::vector<figures::Figure> maps_of(const std::vector<show::StudyColumn>& columns,
                                     const std::vector<judge::JudgedStudy>& judged, const FigureStyle& style) {
  std::vector<figures::Figure> maps;
  std::set<std::string> names;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    std::optional<figures::Figure> map = figures::map_of(judged[i], figures::look_of(judged[i], style));
    if (!map) continue;
    const std::string name = fmt::format("map-{}", for_file_name(columns[i].name));
    map->name = name;
    // Names of studies may be the same but for odd characters.
    for (int number = 2; !names.insert(map->name).second; ++number) map->name = fmt::format("{}-{}", name, number);
    map->caption = fmt::format("{}: {}", columns[i].name, map->caption);
    maps.push_back(std::move(*map));
  }
  return maps;
}

// Returns the figures of a sweep over a single key whose values are all numbers; otherwise none.
std::vector<figures::Figure> sweep_figures_of(const StudiesToReport& studies,
                                              const std::vector<show::StudyColumn>& columns,
                                              const std::vector<judge::JudgedStudy>& judged,
                                              const figures::Look& look) {
  if (studies.keys.size() != 1) return {};
  std::vector<figures::SweptValue> values;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    const std::optional<double> value = base::number_from(columns[i].name);
    if (!value || !std::isfinite(*value)) return {};
    values.push_back({*value, &judged[i]});
  }
  std::ranges::sort(values, {}, &figures::SweptValue::value);
  return figures::of_sweep(values, studies.keys.front(), look);
}

// Returns the code that a command ends with: a failed requirement counts more than an inconclusive one.
int worse_of(int first, int second) {
  for (const int code : {3, 4})
    if (first == code || second == code) return code;
  return 0;
}

}  // namespace

StudiesToReport studies_of_sweep(const Store& store, const std::vector<StoredStudy>& sweep) {
  const results::SweepPlace& place = sweep.front().definition.sweep;
  StudiesToReport studies{.title = place.name, .keys = {}, .studies = {}};
  for (const auto& [key, value] : place.values) studies.keys.push_back(key);
  for (const StoredStudy& study : sweep)
    studies.studies.push_back({.store = store, .study = study, .name = study.definition.sweep.label()});
  return studies;
}

int report_studies(const StudiesToReport& studies, const std::filesystem::path& folder,
                   const ReportArguments& arguments, bool has_report) {
  if (!arguments.beside.empty())
    throw std::invalid_argument("--beside is for one study, but this report has several; leave it out");
  const StoredStudy& first = studies.studies.front().study;
  const FigureStyle style = apply_style(first.definition.figures, labels_of(first), arguments);
  show::StudiesReport report{.title = studies.title, .keys = studies.keys, .columns = {}};
  std::vector<judge::JudgedStudy> judged;
  int code = 0;
  for (const auto& [store, study, name] : studies.studies) {
    refuse_wrong_requirements(arguments, study.definition, labels_of(study));
    const bool is_last = &name == &studies.studies.back().name;
    if (store.solve_count(study) == 0 && !(is_last && judged.empty())) {  // if none has solves, the last one says why
      warn(fmt::format("{} has no solves yet; the same run again continues", study.name));
      continue;
    }
    judge::StudyResults results = read_checked(store, study);
    if (print_never_answering(results, arguments.is_json)) code = 3;
    judged.push_back(judge_with_requirements(std::move(results), study, arguments));
    code = worse_of(code, exit_code(judged.back().requirements));
    report.columns.push_back({.name = name, .study = study.name, .model = show::make_report_model(judged.back())});
  }
  if (!has_report && arguments.is_json) show_json(show::to_json(report));
  if (!has_report && !arguments.is_json)
    for (const std::string& sentence : show::requirement_sentences(report))
      fmt::print("{}\n", wrapped(printable(sentence)));
  if (!has_report) return code;
  const figures::Look look = figures::look_of(judged.front(), style);
  report.figures = maps_of(report.columns, judged, style);
  std::ranges::move(sweep_figures_of(studies, report.columns, judged, look), std::back_inserter(report.figures));
  const show::WrittenReport written =
      write_with_progress(arguments, look.style, [&](const figures::RenderOptions& options) {
        return show::write_report(report, folder, options, program_name());
      });
  if (arguments.is_json) {
    base::OrderedJson json = show::to_json(report);
    json["files"] = written.files;
    show_json(json);
  } else {
    fmt::print("{}", printable(show::terminal_report(report, written.page.string())));
  }
  return code;
}

}  // namespace ikbench::cli
