#include "numerics/json.hpp"

#include "tests/common.hpp"

using namespace ikbench::numerics;

namespace {

std::string nested(std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); }

}  // namespace

TEST_CASE("JSON that is nested too deep to be copied is not read", "[json]") {
  CHECK_FALSE(parsed_json(nested(deepest_json)).is_discarded());
  CHECK(parsed_json(nested(deepest_json + 1)).is_discarded());
  CHECK(parsed_json(nested(1'000'000)).is_discarded());
  CHECK(parsed_json(R"([{"a":)" + nested(1'000'000) + "}]").is_discarded());
  CHECK(text_of(parsed_ordered_json(R"({"b":1,"a":)" + nested(1'000'000) + "}")).size() < 1000);
}

TEST_CASE("a text that is not JSON is discarded, and bytes that are not UTF-8 are replaced", "[json]") {
  CHECK(parsed_json("{").is_discarded());
  CHECK(parsed_json("").is_discarded());
  CHECK(text_of(Json("a\xff")) == "\"a\xef\xbf\xbd\"");
  CHECK(text_of(OrderedJson("\u202e\u009b")) == R"("\u202e\u009b")");
}
