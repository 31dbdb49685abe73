#include "analysis/report/json.hpp"

#include <cstdint>
#include <variant>

namespace ikbench::report {

namespace {

struct AsJson {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(const std::string& text) const { return text; }
  Json operator()(std::int64_t count) const { return count; }
  Json operator()(double value) const { return json_number(value); }
  Json operator()(PValue p) const { return json_number(p.value); }
  Json operator()(Range range) const { return {{"low", json_number(range.low)}, {"high", json_number(range.high)}}; }
  Json operator()(const OursAndPrinted& beside) const {
    return {{"ours", json_number(beside.ours)}, {"printed", beside.printed}};
  }
  Json operator()(const Id& id) const { return id.id; }
};

}  // namespace

Json rows_json(const Table& table) {
  Json rows = Json::array();
  for (const std::vector<Cell>& row : table.rows) {
    Json object = Json::object();
    for (std::size_t c = 0; c < row.size(); ++c) object[table.columns[c]] = std::visit(AsJson{}, row[c]);
    rows.push_back(std::move(object));
  }
  return rows;
}

}  // namespace ikbench::report
