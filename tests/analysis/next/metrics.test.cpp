// The effect of two more lines in the table of metrics (tests/examples/analysis/inference/metrics.inc): nothing else
// changes.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/inference/make_study.hpp"
#include "analysis/inference/variant_comparison.hpp"
#include "analysis/report/report.hpp"
#include "results/store.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

void save(Store& store, const std::string& name) {
  StudyEntry entry{.name = name, .definition = R"({"path": {"kind": "line", "points": 2}, "runs": 8})", .series = {}};
  const synthetic::Shape shape{.solvers = {"one", "other"}, .runs = 8, .points = 2};
  std::vector<SolveRecord> solves = synthetic::solves(shape);
  const std::int64_t session = store.begin_session({{"cpu", "one"}});
  for (std::size_t i = 0; i < shape.solvers.size(); ++i) {
    entry.series.push_back({name + "-series-" + std::to_string(i), shape.solvers[i], "bat", "{}"});
  }
  for (SolveRecord& solve : solves) {
    solve.study = name;
    solve.series = name + "-" + solve.series;
    solve.session = session;
    solve.largest_move_deg = solve.variation_deg / 2;
    if (solve.solver == "other" && solve.run == solve.point) solve.status = Status::tolerance_missed;
  }
  store.save_study(entry);
  store.append(solves);
}

bool has_file(const std::filesystem::path& folder, const std::string& start) {
  return std::ranges::any_of(std::filesystem::directory_iterator(folder),
                             [&](const auto& entry) { return entry.path().filename().string().starts_with(start); });
}

}  // namespace

TEST_CASE("a metric is a line of the table: tables, figures, statistics, the page and the comparison have it",
          "[metrics]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, "mine");
  save(store, "beside");
  const std::filesystem::path out = folder.path / "report";
  write_report(store, {.study = "mine", .folder = out, .figures = {.render = false}});

  const auto statistics = nlohmann::json::parse(text_of_file(out / "statistics.json"));
  const std::string page = text_of_file(out / "report.html"), text = text_of_file(out / "report.md");
  struct Line {
    std::string slug, name, quantity, column;
  };
  for (const Line& line : {Line{"joint-travel", "joint travel", "joint travel [deg]", "largest_move_deg"},
                           Line{"success", "share within the tolerance", "share within the tolerance", "success"}}) {
    CAPTURE(line.slug);
    CHECK(has_file(out / "tables", "statistics-" + line.slug));
    CHECK(std::ranges::any_of(statistics, [&](const auto& found) { return found.at("quantity") == line.quantity; }));
    CHECK(contains(page, "Statistics: " + line.quantity));
    CHECK(contains(text, "Statistics: " + line.name));
    CHECK(contains(text_of_file(out / "tables" / "baselines.csv"), line.column));
    const std::vector<Variant> all = variants(store, store.study("mine"));
    const std::vector<std::string> asked{line.column};
    const std::vector<VariantStudy> studies{study_of_both(all.at(0), all.at(1), {})};
    CHECK(name_of(compare_variants(studies, asked).front().metrics.front().metric) == line.column);
    CHECK(compare_variants(studies, {}).front().metrics.size() == compared_metrics().size());
  }
  CHECK(has_file(out / "figures", "statistics-joint-travel-observations"));
}

TEST_CASE("the direction of a metric is that of its line", "[metrics]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, "mine");
  const StudyResults study = make_study(store.study("mine"), store.solves("mine"));
  const std::vector<Metric> all = reported_metrics();
  const auto find = [&](std::string_view column) {
    return *std::ranges::find(all, column, [](Metric metric) { return name_of(metric); });
  };
  CHECK(info_of(find("success")).better == Better::larger);
  CHECK(samples(study, find("success"))[1].values.front() == 0.5);  // run 1: one of two points is missed
}
