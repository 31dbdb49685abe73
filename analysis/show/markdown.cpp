#include <fmt/format.h>

#include "analysis/show/report.hpp"
#include "analysis/show/text.hpp"

namespace ikbench::show {

namespace {

struct MarkdownWriter {
  const std::filesystem::path& folder;
  bool is_first = false, is_below_heading = false;

  std::string operator()(const Heading& heading) const {
    return fmt::format("{} {}\n\n", is_first ? "#" : "##", markdown_text(heading.text));
  }
  std::string operator()(const std::string& text) const { return markdown_text(text) + "\n\n"; }
  std::string operator()(const Table& table) const {
    const std::string caption = is_below_heading ? "" : fmt::format("**{}**\n\n", markdown_text(table.caption));
    return caption + to_markdown(table) + '\n';
  }
  std::string operator()(const figures::Figure& figure) const {
    const std::string caption = markdown_text(figure.caption);
    const std::vector<std::string> types = types_of(figure, folder);
    return types.empty() ? caption + "\n\n"
                         : fmt::format("![{}](figures/{}.{})\n\n", caption, figure.name, types.front());
  }
};

}  // namespace

std::string to_markdown(const std::vector<Blocks>& sections, const std::filesystem::path& folder) {
  std::string text;
  for (const Blocks& blocks : sections) {
    bool is_below_heading = false;
    for (const Block& block : blocks) {
      text += std::visit(MarkdownWriter{folder, text.empty(), is_below_heading}, block);
      is_below_heading = std::holds_alternative<Heading>(block);
    }
  }
  text.pop_back();
  return text;
}

}  // namespace ikbench::show
