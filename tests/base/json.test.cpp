#include "base/json.hpp"

#include "tests/common.hpp"

using namespace ikbench::base;

namespace {

std::string nested(std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); }

}  // namespace

TEST_CASE("JSON that is nested too deep to be copied is not read", "[json]") {
  CHECK_FALSE(parsed_json(nested(max_json_depth)).is_discarded());
  CHECK(parsed_json(nested(max_json_depth + 1)).is_discarded());
  CHECK(parsed_json(nested(1'000'000)).is_discarded());
  CHECK(parsed_json(R"([{"a":)" + nested(1'000'000) + "}]").is_discarded());
  CHECK(parsed_ordered_json(R"({"b":1,"a":)" + nested(1'000'000) + "}").is_discarded());
  CHECK(parsed_json(R"(["\"[", ")" + std::string(1000, '[') + "\"]").size() == 2);
  std::string wide = "[{}";  // takes minutes where an end of an object looks at all before it
  for (int i = 0; i < 1'000'000; ++i) wide += ",{}";
  CHECK(parsed_ordered_json(wide + ']').size() == 1'000'001);
}

TEST_CASE("a text that is not JSON is discarded, and bytes that are not UTF-8 are replaced", "[json]") {
  CHECK(parsed_json("{").is_discarded());
  CHECK(parsed_json("").is_discarded());
  CHECK(text_of(Json("a\xff")) == "\"a\xef\xbf\xbd\"");
  CHECK(text_of(OrderedJson("\u202e\u009b")) == R"("\u202e\u009b")");
}
