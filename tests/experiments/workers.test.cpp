// Workers side by side, and the queue of their records.
#include "tests/experiments/samples.hpp"

TEST_CASE("work is shared out once each, side by side, and one job is done by the calling thread", "[workers]") {
  for (const std::size_t jobs : {1U, 3U}) {
    const std::thread::id caller = std::this_thread::get_id();
    std::vector<int> done(7);
    std::atomic<std::size_t> here{0};
    std::atomic<bool> is_right{true};
    parallel_for(done.size(), static_cast<int>(jobs), nullptr,
                 [&](std::size_t i, std::size_t worker, const StopRequested&) {
                   is_right = is_right && worker < jobs && (jobs > 1 || std::this_thread::get_id() == caller);
                   ++here;
                   while (here < jobs) std::this_thread::yield();  // endless if they worked one after the other
                   ++done[i];
                 });
    CHECK(done == std::vector<int>(7, 1));
    CHECK(is_right);
  }
}

TEST_CASE("workers stop once one throws, which is rethrown, or the user cancels", "[workers]") {
  for (const int jobs : {1, 3}) {
    std::atomic<int> calls{0};
    const auto fail = [&](std::size_t, std::size_t, const StopRequested& is_over) {
      if (++calls == 1) throw std::runtime_error("no space");
      while (!is_over()) std::this_thread::yield();
    };
    CHECK(complaint<std::runtime_error>([&] { parallel_for(100, jobs, nullptr, fail); }) == "no space");
    CHECK(calls <= jobs);
    const std::atomic<bool> cancelled{true};
    CHECK_NOTHROW(parallel_for(100, jobs, &cancelled, fail));
    CHECK(calls <= jobs);
  }
}

TEST_CASE("what is handed in one by one is passed on at once", "[record_queue]") {
  std::vector<int> passed;
  RecordQueue record_queue([&](const std::vector<SolveRecord>& records) {
    REQUIRE(records.size() == 1);
    passed.push_back(records.front().point);
  });
  for (const int point : {1, 2, 3}) {
    record_queue.push(sample_record("key-a", 1, point));
    CHECK(passed.back() == point);
  }
  std::size_t together = 0;  // but for patience
  RecordQueue patient([&](const auto& records) { together = records.size(); }, std::chrono::hours(1));
  for (const int point : {1, 2}) patient.push(sample_record("key-a", 1, point));
  CHECK(together == 0);
  patient.flush();
  CHECK(together == 2);
}

TEST_CASE("nobody waits for what another is passing on, and what came meanwhile goes on together", "[record_queue]") {
  std::atomic<bool> is_passing{false}, others_are_back{false};
  std::vector<std::vector<int>> passed;
  RecordQueue record_queue([&](const std::vector<SolveRecord>& records) {
    passed.emplace_back();
    for (const SolveRecord& record : records) passed.back().push_back(record.point);
    is_passing = true;
    while (!others_are_back) std::this_thread::yield();
  });
  std::thread first([&] { record_queue.push(sample_record("key-a", 1, 1)); });
  while (!is_passing) std::this_thread::yield();
  for (const int point : {2, 3, 4}) record_queue.push(sample_record("key-a", 1, point));
  others_are_back = true;
  first.join();
  CHECK(passed == std::vector<std::vector<int>>{{1}, {2, 3, 4}});
}

TEST_CASE("what could not be passed on is told to whoever tried, and not tried again", "[record_queue]") {
  int tries = 0;
  RecordQueue record_queue([&](const std::vector<SolveRecord>&) {
    ++tries;
    throw std::runtime_error("no space");
  });
  CHECK_THROWS_AS(record_queue.push(sample_record()), std::runtime_error);
  CHECK_NOTHROW(record_queue.push(sample_record()));
  CHECK(tries == 1);
}
