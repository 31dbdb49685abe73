// ikbench site: static pages from the stores of many people.
#include "analysis/report/site.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "analysis/inference/make_study.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

using namespace results;
using namespace report;

namespace {

// The processors of the sessions that solved the study.
std::string machine_of(const Store& store, const StudyEntry& study) {
  const std::vector<std::int64_t> of_study = store.sessions_of(study.series);
  std::set<std::string> machines;
  for (const Session& session : store.sessions()) {
    if (std::ranges::find(of_study, session.id) == of_study.end()) continue;
    const auto cpu = session.environment.find("cpu");
    machines.insert(cpu == session.environment.end() ? "unknown" : cpu->second);
  }
  return fmt::format("{}", fmt::join(machines, " and "));
}

// Takes a store's rows, or says why none of it is shown: a store with one answer that does not fit is not believed.
Submission taken(const std::string& file, std::vector<SiteRow>& rows) {
  Submission submission{.name = store_name(file)};
  std::vector<SiteRow> own;
  try {
    const Store store(file, Store::Mode::read);
    for (const StudyEntry& study : store.studies()) {
      submission.studies.push_back(study.name);
      std::string unknown;
      const std::vector<std::string> damages = damages_of(store, study.name, &unknown);
      if (!unknown.empty()) {
        submission.refused = "its digests were removed, so that a change would not show";
        return submission;
      }
      if (!damages.empty()) {
        submission.refused = fmt::format("{}", fmt::join(damages, " "));
        return submission;
      }
      const inference::JudgedStudy judged(inference::read_study(store, study));
      if (judged.solves.empty()) continue;
      std::ranges::move(site_rows(submission.name, study, judged, machine_of(store, study)), std::back_inserter(own));
    }
  } catch (const std::invalid_argument& error) {
    submission.refused = error.what();
    return submission;
  }
  std::ranges::move(own, std::back_inserter(rows));
  return submission;
}

void tell(const std::vector<Submission>& submissions, std::size_t pages, const std::filesystem::path& index,
          const OutputArguments& output) {
  std::vector<std::string> said;
  report::Json refused = report::Json::array();
  for (const Submission& each : submissions) {
    if (each.refused.empty()) continue;
    said.push_back(fmt::format("{} is not shown: {}", each.name, each.refused));
    refused.push_back({{"store", each.name}, {"why", each.refused}});
  }
  if (output.is_json) {
    for (const std::string& sentence : said) warn(sentence);
    return show_json(
        {{"page", index.string()}, {"pages", pages}, {"stores", submissions.size()}, {"refused", refused}});
  }
  const std::string answer = said.empty() ? "" : fmt::format(", and {} stores that do not fit", said.size());
  show_screen(
      {{.items = {wrapped(fmt::format("{} pages of {} stores{}", pages, submissions.size() - said.size(), answer))}},
       warnings(said),
       {.items = {printable(index.string())}}},
      output, ", and the first page has it");
}

}  // namespace

void add_site(CLI::App& app, Invocation&) {
  struct Arguments {
    std::vector<std::string> stores;
    std::string out = "public";
    OutputArguments output = {};
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("site", "Write static pages of the studies, solvers and arms in many stores");
  command->add_option("STORE", arguments->stores, "the stores; each is a submission")->required();
  command->add_option("--out", arguments->out, "folder for the pages")->capture_default_str()->check(not_empty());
  add_output_options(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench site submissions/*.sqlite --out public\n\n"
      "Every answer is computed again from its joints. A store with an answer, a time or a digest that does not fit is named\n"
      "on the first page and not shown otherwise.");
  command->callback([arguments] {
    std::vector<SiteRow> rows;
    std::vector<Submission> submissions;
    for (const std::string& file : arguments->stores) submissions.push_back(taken(file, rows));
    std::filesystem::create_directories(arguments->out);
    for (const auto& page : std::filesystem::directory_iterator(arguments->out)) {  // of stores that are gone
      const std::string file = page.path().filename().string();
      const bool is_ours = file.starts_with("study-") || file.starts_with("solver-") || file.starts_with("arm-");
      if (is_ours && file.ends_with(".html")) std::filesystem::remove(page.path());
    }
    const std::size_t pages = write_site(submissions, rows, arguments->out);
    tell(submissions, pages, std::filesystem::path(arguments->out) / "index.html", arguments->output);
  });
}

}  // namespace ikbench::cli
