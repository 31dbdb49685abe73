#include "analysis/report/site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <kainjow/mustache.hpp>
#include <map>
#include <set>
#include <utility>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/json.hpp"
#include "analysis/report/page_data.hpp"
#include "numerics/embedded_file.hpp"
#include "results/files.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;

namespace {

// Returns what decides the errors of a study beside its solvers. Two studies that agree in it have comparable errors.
std::string problem_of(const StudyEntry& entry, const StudyFacts& facts) {
  const Json definition = Json::parse(entry.definition, nullptr, false);
  Json problem = Json::object();
  for (const char* key : {"arm", "robot", "path", "points", "search", "rotation_weight_m", "limits", "bounds", "start",
                          "near_deg", "initial_deg", "stop", "wrap", "wrist_branch"}) {
    if (definition.contains(key)) problem[key] = definition[key];
  }
  const std::string start = definition.value("start", "");
  if (facts.draws_targets || start == "random" || start == "near") problem["seed"] = definition.value("seed", Json());
  return numerics::text_of(problem);
}

// Pages are named by what they show; names that become the same get numbers.
class PageNames {
 public:
  std::string of(std::string_view kind, const std::string& what) {
    const auto [found, is_new] = files_.try_emplace({std::string(kind), what});
    if (!is_new) return found->second;
    const std::string plain = fmt::format("{}-{}", kind, id_of(what).substr(0, 80));
    std::string name = plain;
    for (int other = 2; !taken_.insert(name).second; ++other) name = fmt::format("{}-{}", plain, other);
    return found->second = name + ".html";
  }

 private:
  std::map<std::pair<std::string, std::string>, std::string> files_;
  std::set<std::string> taken_;
};

Json cell(std::string text, std::string href = "", std::string_view kind = "", std::string small = "",
          bool right = false) {
  return {{"text", std::move(text)},
          {"href", std::move(href)},
          {"kind", kind},
          {"small", std::move(small)},
          {"right", right}};
}

bool is_comparable(const SiteRow& a, const SiteRow& b, Metric metric) {
  const bool are_whole = a.solves == a.planned && b.solves == b.planned;
  return are_whole && a.problem == b.problem && (info_of(metric).kind != Kind::time || a.submission == b.submission);
}

const SiteValue* value_of(const SiteRow& row, Metric metric) {
  const auto found = std::ranges::find(row.values, metric, &SiteValue::metric);
  return found == row.values.end() ? nullptr : &*found;
}

// A number with its interval, bold where it is the best of those that are comparable, and with how many there are.
Json value_cell(const SiteRow& row, Metric metric, const std::vector<const SiteRow*>& all) {
  const SiteValue* const own = value_of(row, metric);
  if (!own) return cell("", "", "", "not known", true);
  int others = 0;
  bool is_best = true;
  for (const SiteRow* other : all) {
    const SiteValue* const value = other == &row ? nullptr : value_of(*other, metric);
    if (!value || !is_comparable(row, *other, metric)) continue;
    ++others;
    const bool is_smaller = value->mean.value < own->mean.value;
    if (info_of(metric).better == Better::smaller ? is_smaller : value->mean.value > own->mean.value) is_best = false;
  }
  const std::string interval = std::isfinite(own->mean.low)
                                   ? fmt::format("{} to {}; ", figures::value_words(metric, own->mean.low),
                                                 figures::value_words(metric, own->mean.high))
                                   : "";
  const std::string with = others == 0
                               ? "comparable with no other row"
                               : fmt::format("comparable with {} other {}", others, others == 1 ? "row" : "rows");
  return cell(figures::value_words(metric, own->mean.value), "", others > 0 && is_best ? "best" : "", interval + with,
              true);
}

class Site {
 public:
  Site(const std::vector<Submission>& submissions, const std::vector<SiteRow>& rows, std::filesystem::path folder)
      : submissions_(submissions), rows_(rows), folder_(std::move(folder)) {}

  std::size_t write() {
    const std::vector<std::string> studies = texts(&SiteRow::study), solvers = texts(&SiteRow::algorithm),
                                   arms = texts(&SiteRow::robot);
    Json sections = Json::array({submissions()});
    const auto add = [&](const char* kind, const char* heading, const std::vector<std::string>& names,
                         std::string SiteRow::*member) {
      sections.push_back(index(kind, heading, names, member));
      for (const std::string& name : names) write_rows(kind, name, member);
    };
    add("study", "Studies", studies, &SiteRow::study);
    add("solver", "Solvers", solvers, &SiteRow::algorithm);
    add("arm", "Arms", arms, &SiteRow::robot);
    write_page("index.html",
               {{"title", "Inverse kinematics solvers"},
                {"words",
                 {"Every answer in these stores was computed again from its joints before it is shown. Errors "
                  "are compared where arm, targets, starts, limits and stop rule are the same, on any machine. "
                  "Times are compared within one store only."}},
                {"sections", std::move(sections)}});
    return pages_;
  }

 private:
  std::vector<std::string> texts(std::string SiteRow::*member) const {
    std::set<std::string> all;
    for (const SiteRow& row : rows_) all.insert(row.*member);
    return {all.begin(), all.end()};
  }

  Json submissions() const {
    Json rows = Json::array();
    for (const Submission& each : submissions_) {
      std::string studies;
      for (const std::string& study : each.studies) studies += (studies.empty() ? "" : ", ") + study;
      const bool is_shown = each.refused.empty();
      rows.push_back(
          {{"cells",
            {cell(each.name), cell(studies),
             cell(is_shown ? "every answer fits" : "not shown: " + each.refused, "", is_shown ? "" : "refused")}}});
    }
    return section("Stores", {"store", "studies", "checked"}, std::move(rows));
  }

  Json index(std::string_view kind, const char* heading, const std::vector<std::string>& names,
             std::string SiteRow::*member) {
    Json rows = Json::array();
    for (const std::string& name : names) {
      const auto count = std::ranges::count(rows_, name, member);
      rows.push_back(
          {{"cells", {cell(name, pages_named_.of(kind, name)), cell(std::to_string(count), "", "", "", true)}}});
    }
    return section(heading, {"name", "rows"}, std::move(rows));
  }

  static Json section(const char* heading, const std::vector<std::string>& columns, Json rows) {
    Json heads = Json::array();
    for (const std::string& column : columns) heads.push_back({{"text", column}, {"right", column == "rows"}});
    return {{"heading", heading}, {"heads", std::move(heads)}, {"rows", std::move(rows)}};
  }

  // One table of all rows that have this name.
  void write_rows(std::string_view kind, const std::string& name, std::string SiteRow::*member) {
    std::vector<const SiteRow*> all;
    for (const SiteRow& row : rows_) {
      if (row.*member == name) all.push_back(&row);
    }
    std::ranges::stable_sort(all, {}, [](const SiteRow* row) { return std::pair(row->study, row->problem); });
    std::vector<Metric> metrics;
    for (const Metric metric : all_metrics()) {
      if (std::ranges::any_of(all, [&](const SiteRow* row) { return value_of(*row, metric) != nullptr; }))
        metrics.push_back(metric);
    }
    Json heads = Json::array();
    for (const char* head : {"study", "solver", "store", "arm", "machine"})
      heads.push_back({{"text", head}, {"right", false}});
    heads.push_back({{"text", "solves"}, {"right", true}});
    for (const Metric metric : metrics) heads.push_back({{"text", info_of(metric).name}, {"right", true}});
    Json rows = Json::array();
    for (const SiteRow* row : all) {
      Json cells = Json::array({cell(row->study, pages_named_.of("study", row->study)),
                                cell(row->solver, pages_named_.of("solver", row->algorithm)), cell(row->submission),
                                cell(row->robot, pages_named_.of("arm", row->robot)), cell(row->machine),
                                cell(row->solves == row->planned ? std::to_string(row->solves)
                                                                 : fmt::format("{} of {}", row->solves, row->planned),
                                     "", row->solves == row->planned ? "" : "refused", "", true)});
      for (const Metric metric : metrics) cells.push_back(value_cell(*row, metric, all));
      rows.push_back({{"cells", std::move(cells)}});
    }
    write_page(
        pages_named_.of(kind, name),
        {{"title", name},
         {"is_inner", true},
         {"words",
          {"Means of errors and costs, geometric means of times, with the intervals of each study's plan. In a study with a "
           "tolerance an error below it counts as the tolerance, and a solve that is not ok costs ten times the study's "
           "limit or, without one, ten times the dearest solve: so a mean may be above the limit. Bold: the best mean of those that are comparable, which no "
           "test has judged. The small print says with how many rows of this page a number is comparable: solves of the "
           "same problems, all of them made, and times within one store only."}},
         {"sections",
          {{{"heading", capitalised(fmt::format("{} {}", kind, name))},
            {"heads", std::move(heads)},
            {"rows", std::move(rows)}}}}});
  }

  void write_page(const std::string& file, const Json& page) {
    kainjow::mustache::mustache shape{std::string(template_named("site.html"))};
    kainjow::mustache::data data = page_data(page);
    data.set("style", std::string(template_named("site.css")));
    write_file(folder_ / file, shape.render(data));
    ++pages_;
  }

  const std::vector<Submission>& submissions_;
  const std::vector<SiteRow>& rows_;
  std::filesystem::path folder_;
  PageNames pages_named_;
  std::size_t pages_ = 0;
};

}  // namespace

std::vector<SiteRow> site_rows(const std::string& submission, const StudyEntry& entry, const JudgedStudy& study,
                               const std::string& machine) {
  std::vector<SiteRow> rows;
  for (const Series& series : entry.series) {
    rows.push_back({.submission = submission,
                    .study = entry.name,
                    .problem = problem_of(entry, study.facts),
                    .solver = series.label,
                    .algorithm = series.algorithm,
                    .robot = study.solve_data->robot,
                    .machine = machine,
                    .solves = static_cast<std::int64_t>(solves_of(study, series.label).size()),
                    .planned = std::int64_t{study.runs} * study.points});
  }
  for (const Metric metric : compared_metrics()) {
    if (!inference::is_comparable(study, metric)) continue;
    for (const GroupEvidence& group : study.evidence(metric).groups) {
      const auto row = std::ranges::find(rows, group.name, &SiteRow::solver);
      if (row != rows.end() && std::isfinite(group.mean.value)) row->values.push_back({metric, group.mean});
    }
  }
  return rows;
}

std::size_t write_site(const std::vector<Submission>& submissions, const std::vector<SiteRow>& rows,
                       const std::filesystem::path& folder) {
  return Site(submissions, rows, folder).write();
}

}  // namespace ikbench::report
