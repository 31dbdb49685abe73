// The table of all answers, and its sentence.
#include "analysis/show/answers_table.hpp"

#include "tests/show/judged.hpp"

namespace {

using namespace ikbench;
using judge::StudyResults;

// Returns a study of 20 targets with 8 known answers each, two of which have a continuum, with a solver that gives all,
// one that lacks an answer at some targets, and one that gives one answer, sometimes a wrong one beside it.
StudyResults study_with_answers() {
  StudyResults study;
  study.definition.runs = 1;
  study.definition.points = 20;
  for (const char* const label : {"all", "lacking", "single"})
    study.series.push_back(
        {.key = std::string("key of ") + label, .label = label, .algorithm = label, .options = "{}"});
  for (int point = 1; point <= 20; ++point) {
    const bool is_continuum = point > 18;
    study.answers.targets.push_back({.point = point, .known = is_continuum ? 0 : 8, .is_continuum = is_continuum});
    study.answers.counts.push_back({.series = "key of all", .point = point, .given = 8, .found = 8});
    const int found = point <= 12 ? 7 : 8;
    study.answers.counts.push_back(
        {.series = "key of lacking", .point = point, .given = 8, .found = found, .doubled = 8 - found});
    study.answers.counts.push_back({.series = "key of single",
                                    .point = point,
                                    .given = point <= 5 ? 2 : 1,
                                    .found = 1,
                                    .wrong = point <= 5 ? 1 : 0});
  }
  return study;
}

}  // namespace

TEST_CASE("complete solvers are named, and marks say which are worse", "[answers]") {
  const Table table = answers_table(study_with_answers());
  CHECK(table.caption == "all gave all known answers to all 18 targets; lacking to 6 and single to none.");
  REQUIRE(table.rows.size() == 3);
  const auto complete = [&](std::size_t row) { return std::get<ValueCell>(table.rows[row][1]); };
  CHECK(complete(0).value == 100);
  CHECK(complete(0).mark.empty());
  CHECK(complete(1).value == Approx(100.0 / 3));
  CHECK(complete(1).mark == "*");
  CHECK(complete(1).interval->low == Approx(16.3).epsilon(0.01));
  CHECK(std::get<ValueCell>(table.rows[1][2]).value == Approx(100 * (12 * 7 + 6 * 8) / (18.0 * 8)));
  CHECK(std::get<ValueCell>(table.rows[2][3]).value == 1);
  CHECK(std::get<std::int64_t>(table.rows[1][5]) == 12);
  CHECK(std::get<std::int64_t>(table.rows[2][4]) == 5);
  CHECK(std::ranges::count_if(table.notes, [](const std::string& note) {
          return contains(note, "single gave 5 wrong answers beside right ones");
        }) == 1);
  CHECK(std::ranges::count_if(
            table.notes, [](const std::string& note) { return contains(note, "2 targets are not counted"); }) == 1);
  CHECK(std::ranges::count_if(table.notes, [](const std::string& note) {
          return contains(note, "Brackets: 95 % intervals; after coverage and answers, the range.");
        }) == 1);
}

TEST_CASE("a study whose answers were not counted has no table, and says why if solvers gave several", "[answers]") {
  StudyResults study;
  CHECK(answers_table(study).rows.empty());
  CHECK(judge::why_not_counted(study).empty());
  study.has_several_answers = true;
  study.definition.search = results::Search::pose;
  study.definition.arm = R"({"links":[{},{},{},{},{},{},{}]})";
  CHECK(contains(judge::why_not_counted(study), "7 joints for 6 freedoms"));
}

TEST_CASE("where all targets have a singular answer no target counts", "[answers]") {
  StudyResults study = study_with_answers();
  for (results::KnownAnswers& target : study.answers.targets) target = {.point = target.point, .is_continuum = true};
  study.answers.targets.front().is_continuum = false;
  study.has_several_answers = true;
  CHECK(answers_table(study).rows.empty());
  CHECK(contains(judge::why_not_counted(study), "of 20 targets, 19 have a singular answer and 1 has no known one"));
}

TEST_CASE("of repeated runs the largest share is marked as the best, whatever the order, and the sentence has shares",
          "[answers]") {
  // B is complete in each first run and never in a second one, A in both runs of each fourth target.
  for (const bool is_first : {true, false}) {
    StudyResults study;
    study.definition.runs = 2;
    study.definition.points = 40;
    const std::vector<std::string> labels =
        is_first ? std::vector<std::string>{"A", "B"} : std::vector<std::string>{"B", "A"};
    for (const std::string& label : labels)
      study.series.push_back({.key = label, .label = label, .algorithm = label, .options = "{}"});
    for (int point = 1; point <= 40; ++point) {
      study.answers.targets.push_back({.point = point, .known = 2});
      for (const int run : {1, 2}) {
        study.answers.counts.push_back(
            {.series = "A", .run = run, .point = point, .given = 1, .found = point % 4 == 0 ? 2 : 1});
        study.answers.counts.push_back(
            {.series = "B", .run = run, .point = point, .given = 1, .found = run == 1 ? 2 : 1});
      }
    }
    const Table table = answers_table(study);
    CHECK(table.caption ==
          (is_first ? "No solver gave all known answers to all 40 targets in all 2 runs: A to 25 % and B to 50 %."
                    : "No solver gave all known answers to all 40 targets in all 2 runs: B to 50 % and A to 25 %."));
    CHECK(std::get<ValueCell>(table.rows[is_first ? 1 : 0][1]).mark.empty());
    CHECK(std::get<ValueCell>(table.rows[is_first ? 1 : 0][1]).value == 50);
    CHECK(std::get<ValueCell>(table.rows[is_first ? 0 : 1][1]).mark == "*");
  }
}

TEST_CASE("the notes of all answers say of how many targets each number is", "[answers]") {
  StudyResults study = study_with_answers();
  study.definition.points = 3000;
  study.answers.targets[0].known = 0;  // no answer is known
  study.answers.counts[0] = {.series = "key of all", .point = 1};
  const Table table = answers_table(study);
  const auto has_note = [&](const std::string& text) {
    return std::ranges::any_of(table.notes, [&](const std::string& note) { return contains(note, text); });
  };
  study.series.resize(1);  // nobody is worse
  const Table alone = answers_table(study);
  CHECK(std::ranges::count_if(alone.notes,
                              [](const std::string& note) { return note.starts_with("Brackets: 95 %"); }) == 1);
  CHECK(has_note("of answers to all 20 targets, other columns: of the 17 that count"));
  CHECK(has_note("1 target is not counted, because no answer"));
  CHECK(has_note("Only the first 2000 of the 3000 targets"));
}
