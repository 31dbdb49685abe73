#include "analysis/show/publish.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "analysis/figures/of_study.hpp"
#include "analysis/show/article.hpp"
#include "analysis/show/moving_arm.hpp"
#include "analysis/show/page.hpp"
#include "analysis/show/text.hpp"
#include "base/files.hpp"
#include "base/inputs.hpp"
#include "base/json.hpp"

namespace ikbench::show {

using Json = base::OrderedJson;
namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 10> types_of_files{".bib", ".csv", ".dat", ".gp",  ".md",
                                                          ".pdf", ".png", ".svg", ".tex", ".txt"};
constexpr std::array<const char*, 4> own_files{"report.html", "report.md", "results.json", "solves.csv"};

// A table or figure of reports, without its number. One that is not here outlives its report.
bool is_own(const fs::path& folder, std::string_view name) {
  if (folder == "article") return name == "main" || name == "references" || name == "methods" || name == "results";
  if (folder == "tables") return std::ranges::find(names_of_tables, name) != names_of_tables.end();
  const auto is_of_kind = [&](const auto& kind) { return name == kind.first || name.starts_with(kind.first + "-"); };
  return folder == "figures" && (name == "style" || std::ranges::any_of(all_figures(), is_of_kind));
}

// What the report of a folder says that it has written.
std::vector<std::string> files_of_earlier(const fs::path& folder) {
  const auto text = base::read_file(folder / own_files[2]);
  const Json json = text ? base::parsed_ordered_json(*text) : Json();
  std::vector<std::string> files;
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) return files;
  for (const Json& entry : json["files"]) {
    if (entry.is_string()) files.push_back(entry);
  }
  return files;
}

void refuse_others(const fs::path& folder, const std::vector<std::string>& earlier) {
  for (const char* name : {own_files[0], own_files[1], own_files[2]}) {  // solves are there before the list
    std::error_code none;
    if (std::ranges::count(earlier, name) == 0 &&
        fs::symlink_status(folder / name, none).type() == fs::file_type::regular)
      throw std::invalid_argument(fmt::format("'{}' is of no report of ikbench; remove it, or choose another folder",
                                              (folder / name).string()));
  }
}

// Whether a report can have written it, in a folder of its own.
bool may_be_of_report(const fs::path& file) {
  const std::string stem = file.stem();
  const std::string_view name(stem.data(), stem.find_last_not_of("0123456789") + 1);
  return is_own(file.parent_path(), name) && std::ranges::count(types_of_files, file.extension().string()) > 0;
}

// Files of these figures. Throws std::system_error where it cannot be told whether one is there.
std::vector<std::string> files_of(const std::vector<figures::Figure>& figures, const fs::path& folder) {
  std::vector<std::string> files;
  if (!figures.empty()) files.emplace_back("figures/style.gp");
  for (const figures::Figure& figure : figures) {
    for (const char* type : {"dat", "gp", "pdf", "png", "svg"}) {
      const std::string file = fmt::format("figures/{}.{}", figure.name, type);
      if (fs::is_regular_file(folder / file)) files.push_back(file);
    }
  }
  return files;
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

}  // namespace

std::vector<std::pair<std::string, std::string>> all_figures() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const figures::KindOfFigure& kind : figures::kinds_of_figures()) all.emplace_back(kind.name, kind.meaning);
  all.emplace_back("boxes", "of a file that stats reads");
  all.emplace_back("printed", "of beeson2015, haviland2023: shares solved minus the printed ones");
  all.emplace_back("figure", "of slim2023: figure-5 to figure-18");
  return all;
}

std::vector<std::string> types_of(const figures::Figure& figure, const fs::path& folder) {
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
  base::write_file(folder / (table.name + ".md"), to_markdown(table));
  base::write_file(folder / (table.name + ".tex"), to_latex(article) + made);
}

void refuse_others(const fs::path& folder) { refuse_others(folder, files_of_earlier(folder)); }

Written publish(const Report& report, const fs::path& folder, const figures::RenderOptions& options,
                const std::string& program) {
  base::refuse_links(folder);
  for (const char* name : own_files) base::refuse_input(folder / name);
  std::vector<std::string> earlier = files_of_earlier(folder);
  refuse_others(folder, earlier);
  std::erase_if(earlier, [](const std::string& file) { return !may_be_of_report(file); });
  for (const std::string& file : earlier) base::refuse_input(folder / file);
  std::vector<Blocks> sections = sections_of(report);
  const std::vector<Table*> tables = all_in<Table>(sections);
  std::vector<figures::Figure> figures;
  for (const figures::Figure* figure : all_in<figures::Figure>(sections)) figures.push_back(*figure);
  Written written{.page = folder / own_files[0]};
  written.warnings = figures::write_figures(figures, folder / "figures", options);

  std::vector<std::string>& files = written.files;
  std::ranges::copy(own_files, std::back_inserter(files));
  const bool is_of_study = !report.study.series.empty();
  if (!is_of_study || !fs::is_regular_file(folder / own_files[3])) files.pop_back();
  std::vector<std::string> names;
  for (const Table* table : tables) {
    if (table->name.empty()) continue;
    write_table(*table, for_article(*table, report), folder / "tables", program);
    names.push_back(table->name);
    for (const char* type : {"csv", "md", "tex"}) files.push_back(fmt::format("tables/{}.{}", table->name, type));
  }
  std::ranges::move(write_article(report, names, figures, folder, program), std::back_inserter(files));
  std::ranges::move(files_of(figures, folder), std::back_inserter(files));
  std::ranges::sort(files);
  for (const std::string& file : earlier) {
    std::error_code error;
    if (!std::ranges::binary_search(files, file)) fs::remove(folder / file, error);
    if (error)
      throw std::invalid_argument(fmt::format("cannot remove '{}' of an earlier report: {}; choose another place",
                                              (folder / file).string(), error.message()));
  }

  Json json = to_json(report.answer);
  json["files"] = files;
  base::write_file(folder / "results.json", base::text_of(json, 1) + '\n');
  for (Table* table : tables) {
    if (!table->on_page.empty()) *table = Table(table->on_page.front());
  }
  const auto is_not_drawn = [&](const Block& block) {
    const auto* const figure = std::get_if<figures::Figure>(&block);
    return figure != nullptr && types_of(*figure, folder).empty();
  };
  auto reasons = written.warnings;  // stand where the first picture is missing
  for (Blocks& blocks : sections) {
    const auto first = std::ranges::find_if(blocks, is_not_drawn);
    if (first == blocks.end()) continue;
    for (std::string& reason : reasons) reason = fmt::format("Warning: {}.", reason);
    blocks.insert(first, reasons.begin(), reasons.end());
    reasons.clear();
    std::erase_if(blocks, is_not_drawn);
  }
  std::erase_if(sections, [](const Blocks& blocks) { return blocks.size() < 2; });  // that had nothing else
  base::write_file(folder / "report.md", to_markdown(sections, folder));
  std::vector<std::string> order;
  for (const std::size_t i : report.answer.order) order.push_back(report.answer.decisive().observations.groups[i].name);
  const auto control = std::ranges::find(order, report.answer.decisive().plan.control);  // beside the first
  if (control != order.end() && control != order.begin()) std::rotate(order.begin() + 1, control, control + 1);
  std::optional<std::string> arm = moving_arm(report.study, order);
  if (arm && drawing_library().empty()) {
    written.warnings.emplace_back("the page has no moving arm: this ikbench was built without three.js");
    arm.reset();
  }
  base::write_file(written.page, to_page(title_of(report.study), sections, arm, folder, program));
  return written;
}

}  // namespace ikbench::show
