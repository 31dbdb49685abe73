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
  CHECK(std::regex_match(noted.at("date"), std::regex("20[0-9]{2}(-[0-9]{2}){2}T[0-9]{2}(:[0-9]{2}){2}Z")));
  CHECK(program_name().starts_with("ikbench " + noted.at("version")));
  CHECK(contains(program_name(), noted.at("commit")));
}

TEST_CASE("a Raspberry Pi's processor has numbers, and no name", "[environment]") {
  CHECK(cpu_model(std::istringstream("CPU implementer\t: 0x41\nCPU architecture: 8\nCPU part\t: 0xd08\n\nModel\t: "
                                     "Raspberry Pi 4 Model B\n")) == "ARM 0x41 0xd08");
  CHECK(cpu_model(std::istringstream("model\t: 1\nmodel name\t: AMD EPYC\n")) == "AMD EPYC");
  CHECK(cpu_model(std::istringstream("processor\t: 0\n")) == "unknown");
}
