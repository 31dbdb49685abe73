// Shards divide a study, and together solve what one machine solves.
#include "tests/experiments/samples.hpp"

TEST_CASE("every part of a study is in one shard, and all solvers with it", "[shard]") {
  for (const bool is_chained : {true, false}) {
    Study study = small_study();
    study.runs = 5;
    study.path = path_through(std::vector(3, Pose::Identity()));
    study.start = is_chained ? Start::previous : Start::initial;
    for (const int count : {1, 2, 7, 40}) {
      std::int64_t solves = 0;
      for (int index = 1; index <= count; ++index) solves += planned_solve_count({index, count}, study);
      CHECK(solves == 5 * 3 * std::ssize(study.solvers));
      for (int run = 1; run <= 5; ++run) {
        for (int point = 1; point <= 3; ++point) {
          int shards = 0;
          for (int index = 1; index <= count; ++index) {
            if (!is_in_shard({index, count}, study, run, point)) continue;
            ++shards;
            if (is_chained) CHECK(is_in_shard({index, count}, study, run, 1));  // a chain is never cut
          }
          CHECK(shards == 1);
        }
      }
    }
  }
}

TEST_CASE("a shard is written I/N", "[shard]") {
  CHECK(parse_shard("3/12").index == 3);
  CHECK(parse_shard("3/12").count == 12);
  CHECK(parse_shard("3/12").text() == "3/12");
  for (const char* wrong :
       {"", "/", "3", "3/", "/12", "0/12", "13/12", "-1/12", "3/12/1", "3 /12", "1/100001", "1/9999999999"})
    CHECK_THROWS_AS(parse_shard(wrong), std::invalid_argument);
}

TEST_CASE("what shards solve is what one machine solves, where points are divided too", "[shard][runner]") {
  for (const Start start : {Start::previous, Start::initial, Start::random}) {
    Study study = small_study();
    study.start = start;
    ScratchStore store;
    std::int64_t solved = 0;
    for (const int index : {3, 1, 2}) {
      const Progress progress = run(study, store, {.shard = {index, 3}});
      CHECK(progress.done == progress.total);
      CHECK(store.solve_count(store.study(study.name)) == (solved += progress.total));
    }
    CHECK(run(study, store, {}).reused == 24);
    CHECK(same_numbers(solves_of(store, study.name), solve_all(study)));
  }
}
