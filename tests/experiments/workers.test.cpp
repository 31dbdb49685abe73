// Workers side by side, and the queue of their records.
#include "tests/experiments/samples.hpp"

TEST_CASE("a worker is called as often as there are jobs, one job by the calling thread", "[workers]") {
  for (const int jobs : {1, 2, 5}) {
    std::atomic<int> calls{0};
    work_together(jobs, [&] { ++calls; });
    CHECK(calls == jobs);
  }
  std::thread::id worker;
  work_together(1, [&] { worker = std::this_thread::get_id(); });
  CHECK(worker == std::this_thread::get_id());
}

TEST_CASE("workers are side by side, also where there are more than processors", "[workers]") {
  std::atomic<int> here{0};
  work_together(5, [&] {
    ++here;
    while (here < 5) std::this_thread::yield();  // endless if they ran one after the other
  });
  CHECK(here == 5);
}

TEST_CASE("what workers did is there for whoever called them, and what one throws", "[workers]") {
  for (const int jobs : {1, 3}) {
    std::atomic<int> next{0};
    std::vector<int> done(3);
    work_together(jobs, [&] {
      for (int i = next++; i < 3; i = next++) done[static_cast<std::size_t>(i)] = i + 1;
    });
    CHECK(done == std::vector<int>{1, 2, 3});
    const auto fail = [&] {
      work_together(jobs, [] { throw std::runtime_error(std::string(40, 'x') + " no space"); });
    };
    CHECK_THAT(complaint<std::runtime_error>(fail), ContainsSubstring("no space"));
  }
}

TEST_CASE("what is handed in one by one is passed on at once", "[record_queue]") {
  std::vector<int> passed;
  RecordQueue record_queue([&](const std::vector<SolveRecord>& records) {
    REQUIRE(records.size() == 1);
    passed.push_back(records.front().point);
  });
  for (const int point : {1, 2, 3}) {
    record_queue.hand_in(sample_record("key-a", 1, point));
    CHECK(passed.back() == point);
  }
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
  std::thread first([&] { record_queue.hand_in(sample_record("key-a", 1, 1)); });
  while (!is_passing) std::this_thread::yield();
  for (const int point : {2, 3, 4}) record_queue.hand_in(sample_record("key-a", 1, point));
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
  CHECK_THROWS_AS(record_queue.hand_in(sample_record()), std::runtime_error);
  CHECK_NOTHROW(record_queue.hand_in(sample_record()));
  CHECK(tries == 1);
}
