// The facts about the machine and the build.
#include "tests/experiments/samples.hpp"

TEST_CASE("the environment says something for each of its keys", "[environment]") {
  const std::map<std::string, std::string> noted = environment();
  for (const char* key : {"boot", "build_type", "commit", "compiler", "cpu", "cpus", "date", "eigen", "flags", "host",
                          "instruction_set", "os", "sanitizers", "source", "version"}) {
    INFO(key);
    CHECK(noted.contains(key));
  }
  for (const auto& [key, value] : noted) {
    INFO(key);
    CHECK(value.find_first_not_of(' ') != std::string::npos);
    CHECK(value.find('\n') == std::string::npos);
  }
}

TEST_CASE("the date is that of ISO 8601 in UTC", "[environment]") {
  const std::string date = environment().at("date");
  REQUIRE(date.size() == std::string("2026-01-31T23:59:59Z").size());
  CHECK(date.substr(0, 2) == "20");
  CHECK(date[10] == 'T');
  CHECK(date.back() == 'Z');
}

TEST_CASE("the version names the commit and the source", "[environment]") {
  CHECK(program_name().starts_with("ikbench " + environment().at("version")));
  CHECK(program_name().find(environment().at("commit")) != std::string::npos);
}
