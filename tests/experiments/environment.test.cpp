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

TEST_CASE("on a Raspberry Pi the processor has numbers, and no name", "[environment]") {
  std::istringstream raspberry(
      "processor\t: 0\nBogoMIPS\t: 108.00\nFeatures\t: fp asimd evtstrm crc32 cpuid\nCPU implementer\t: 0x41\n"
      "CPU architecture: 8\nCPU variant\t: 0x0\nCPU part\t: 0xd08\nCPU revision\t: 3\n\nModel\t\t: Raspberry Pi 4 Model B\n");
  CHECK(cpu_model(raspberry) == "ARM 0x41 0xd08");
  std::istringstream other("vendor_id\t: AuthenticAMD\nmodel name\t: AMD EPYC\n"), none("processor\t: 0\n");
  CHECK(cpu_model(other) == "AMD EPYC");
  CHECK(cpu_model(none) == "unknown");
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
