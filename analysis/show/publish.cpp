#include "analysis/show/publish.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <system_error>

#include "analysis/figures/of_study.hpp"
#include "analysis/show/article.hpp"
#include "analysis/show/moving_arm.hpp"
#include "analysis/show/page.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/result_tables.hpp"
#include "base/files.hpp"
#include "base/inputs.hpp"
#include "base/json.hpp"

namespace ikbench::show {

using Json = base::OrderedJson;
namespace fs = std::filesystem;

namespace {

// The types of files that reports have. Only reports of former versions have .dat, .md and .txt.
constexpr std::array<std::string_view, 10> types_of_files{".bib", ".csv", ".dat", ".gp",  ".md",
                                                          ".pdf", ".png", ".svg", ".tex", ".txt"};
constexpr std::array<const char*, 4> own_files{"report.html", "report.md", "results.json", "solves.csv"};
constexpr std::array<const char*, 4> article_files{"main.tex", "methods.tex", "references.bib", "results.tex"};
constexpr std::array<const char*, 4> folders{"article", "tables", "figures", "figures/source"};

// Returns whether a report can have written the file, because its folder and type are those of reports. results.json
// may list any file, and only such a file may be removed.
bool may_be_of_report(const fs::path& file) {
  return std::ranges::count(folders, file.parent_path()) > 0 &&
         std::ranges::count(types_of_files, file.extension().string()) > 0;
}

constexpr std::uintmax_t max_results_bytes = 200'000'000;  // twice what the report of 400 solvers has

// Returns true if the text begins as results.json does, whose first key is the headline, or the files of a report that
// was killed.
bool begins_as_ours(std::string_view text) {
  const std::size_t key = std::min(text.find_first_not_of("{ \n"), text.size());
  return text.starts_with('{') &&
         (text.substr(key).starts_with("\"headline\"") || text.substr(key).starts_with("\"files\""));
}

// Returns the results.json of a folder, or an empty object if there is none of ikbench. A symbolic link is not
// followed, because the link may lead to the results.json of another folder. The rest of a large file of others is not
// read.
Json earlier_results(const fs::path& folder) {
  std::error_code none;
  const fs::path file = folder / own_files[2];
  if (fs::is_symlink(file, none) || fs::file_size(file, none) > max_results_bytes) return Json::object();
  if (!begins_as_ours(base::read_file(file, 100).value_or(""))) return Json::object();
  const Json json = base::parsed_ordered_json(base::read_file(file).value_or(""));
  const bool is_ours = json.is_object() && (json.contains("headline") || (json.size() == 1 && json.contains("files")));
  return is_ours ? json : Json::object();
}

template <class Kind>
std::vector<Kind*> all_in(std::vector<Blocks>& sections) {
  std::vector<Kind*> all;
  for (Blocks& blocks : sections) {
    for (Block& block : blocks) {
      if (auto* const of_kind = std::get_if<Kind>(&block)) all.push_back(of_kind);
    }
  }
  return all;
}

// Removes the files of an earlier report that this one does not have.
void remove_earlier(const fs::path& folder, const std::vector<std::string>& earlier,
                    const std::vector<std::string>& files) {
  for (const std::string& file : earlier) {
    std::error_code error;
    if (!std::ranges::binary_search(files, file)) fs::remove(folder / file, error);
    if (error)
      throw std::invalid_argument(fmt::format("cannot remove '{}' of an earlier report: {}; choose another place",
                                              (folder / file).string(), error.message()));
  }
}

// Removes figures that were not drawn from the sections. The reasons stand where the first figures are missing.
void leave_out_undrawn(std::vector<Blocks>& sections, const fs::path& folder, std::vector<std::string> reasons) {
  const auto is_not_drawn = [&](const Block& block) {
    const auto* const figure = std::get_if<figures::Figure>(&block);
    return figure != nullptr && picture_formats_of(*figure, folder).empty();
  };
  for (Blocks& blocks : sections) {
    if (std::erase_if(blocks, is_not_drawn) == 0) continue;
    for (const std::string& reason : std::exchange(reasons, {})) blocks.push_back(fmt::format("Warning: {}.", reason));
  }
  std::erase_if(sections, [](const Blocks& blocks) { return blocks.size() < 2; });  // only a heading is left
}

}  // namespace

std::vector<std::pair<std::string, std::string>> figure_list() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const figures::KindOfFigure& kind : figures::kinds_of_figures()) all.emplace_back(kind.name, kind.meaning);
  all.emplace_back("boxes", "of a file that stats reads");
  all.emplace_back("sweep", "of a sweep over numbers: targets solved, and time, by the value");
  all.emplace_back("printed", "of beeson2015, haviland2023: shares solved minus the printed ones");
  all.emplace_back("figure", "of slim2023: figure-5 to figure-18");
  return all;
}

std::vector<std::string> picture_formats_of(const figures::Figure& figure, const fs::path& folder) {
  std::vector<std::string> types = results::picture_formats;
  std::erase_if(types, [&](const std::string& type) {
    std::error_code none;
    return !fs::is_regular_file(folder / "figures" / fmt::format("{}.{}", figure.name, type), none);
  });
  return types;
}

void write_table(const Table& table, const Table& article, const fs::path& folder, const std::string& program) {
  const std::string made = program.empty() ? "" : fmt::format("% Made by {}\n", program);
  base::write_file(folder / (table.name + ".csv"), to_csv(table));
  base::write_file(folder / (table.name + ".tex"), to_latex(article) + made);
}

std::vector<std::string> report_files(const std::vector<std::string>& tables,
                                      const std::vector<figures::Figure>& figures) {
  std::vector<std::string> files;
  for (const std::string& table : tables)
    for (const char* type : {"csv", "tex"}) files.push_back(fmt::format("tables/{}.{}", table, type));
  if (!figures.empty()) files.emplace_back("figures/source/style.gp");
  for (const figures::Figure& figure : figures) {
    files.push_back(fmt::format("figures/source/{}.gp", figure.name));
    for (const std::string& type : results::picture_formats)
      files.push_back(fmt::format("figures/{}.{}", figure.name, type));
  }
  return files;
}

std::vector<std::string> reserve_files(const fs::path& folder, std::vector<std::string> files) {
  for (const char* name : folders) {  // a link may lead to foreign files
    std::error_code none;
    if (const fs::path place = folder / name; fs::is_symlink(place, none))
      throw std::invalid_argument(fmt::format("'{}' is a link; remove it, or choose another folder", place.string()));
  }
  files.emplace_back(own_files[2]);
  Json results = earlier_results(folder);
  std::set<std::string> all;
  if (results.contains("files") && results["files"].is_array())
    for (const Json& file : results["files"])
      if (file.is_string()) all.insert(file);
  const std::vector<std::string> earlier(all.begin(), all.end());
  for (const std::string& file : files) {
    std::error_code none;
    const fs::file_type type = fs::symlink_status(folder / file, none).type();
    const bool is_new = all.insert(file).second;
    if (is_new && (type == fs::file_type::regular || type == fs::file_type::symlink))
      throw std::invalid_argument(
          fmt::format("'{}' is there, but in no results.json of ikbench; remove it, or choose another folder",
                      (folder / file).string()));
  }
  results["files"] = all;
  base::write_file(folder / own_files[2], base::text_of(results, 1) + '\n');
  return earlier;
}

WrittenReport publish(Publication publication, const fs::path& folder, const figures::RenderOptions& options,
                      const std::string& program) {
  for (const char* name : own_files) base::refuse_input(folder / name);
  std::vector<Blocks>& sections = publication.sections;
  const Report* const report = publication.report;
  std::vector<std::string> late_warnings = figures::reword(all_in<figures::Figure>(sections), options.style);
  const auto is_left_out = [&](const Block& block) {
    const auto* const figure = std::get_if<figures::Figure>(&block);
    const auto is_named = [&](const std::string& name) { return figures::is_meant(figure->name, name); };
    return figure != nullptr && !options.only.empty() && std::ranges::none_of(options.only, is_named);
  };
  for (Blocks& blocks : sections) std::erase_if(blocks, is_left_out);
  std::vector<Table*> tables = all_in<Table>(sections);
  std::erase_if(tables, [](const Table* table) { return table->name.empty(); });
  std::vector<figures::Figure> figures;
  std::vector<std::string> names;
  names.reserve(tables.size());
  for (const Table* table : tables) names.push_back(table->name);
  for (const figures::Figure* figure : all_in<figures::Figure>(sections)) figures.push_back(*figure);
  WrittenReport written{.page = folder / own_files[0]};
  std::vector<std::string>& files = written.files = report_files(names, figures);
  for (const std::string file : article_files)
    if (report != nullptr && (file != "references.bib" || !report->citation_keys.empty()))
      files.push_back("article/" + file);
  files.insert(files.end(), own_files.begin(), own_files.end() - 1);
  std::vector<std::string> earlier = reserve_files(folder, files);
  const bool had_solves = std::ranges::count(earlier, own_files[3]) > 0;
  std::erase_if(earlier, [](const std::string& file) { return !may_be_of_report(file); });
  for (const std::string& file : earlier) base::refuse_input(folder / file);
  written.warnings = figures::write_figures(figures, folder / "figures", options);
  for (const Table* table : tables)
    write_table(*table, report == nullptr ? *table : article_table(*table, *report), folder / "tables", program);
  if (report != nullptr) write_article(*report, names, figures, folder, program);
  // Pictures that were not drawn are not listed. is_regular_file throws if the system cannot say whether a file exists.
  std::erase_if(files, [&](const fs::path& file) {
    return file.parent_path() == "figures" && !fs::is_regular_file(folder / file);
  });
  // A report of several studies writes no solves, but those of an earlier report of one study stay.
  const bool has_solves = report != nullptr ? !report->study.series.empty() : had_solves;
  if (has_solves && fs::is_regular_file(folder / own_files[3])) files.emplace_back(own_files[3]);
  std::ranges::sort(files);
  remove_earlier(folder, earlier, files);
  publication.json["files"] = files;
  base::write_file(folder / own_files[2], base::text_of(publication.json, 1) + '\n');
  leave_out_undrawn(sections, folder, written.warnings);
  std::ranges::move(late_warnings, std::back_inserter(written.warnings));
  std::ranges::move(publication.warnings, std::back_inserter(written.warnings));
  base::write_file(folder / "report.md", to_markdown(sections, folder));
  base::write_file(written.page, to_html_page(publication.title, sections, publication.arm, folder, program));
  return written;
}

WrittenReport write_report(const Report& report, const fs::path& folder, const figures::RenderOptions& options,
                           const std::string& program) {
  Publication publication{.title = title_of(report.study),
                          .sections = report_sections(report),
                          .json = to_json(report.model),
                          .report = &report,
                          .arm = animation_json(report.study, report.model.solvers())};
  if (publication.arm && threejs_source().empty()) {
    publication.warnings.emplace_back("the page has no moving arm: this ikbench was built without three.js");
    publication.arm.reset();
  }
  return publish(std::move(publication), folder, options, program);
}

}  // namespace ikbench::show
