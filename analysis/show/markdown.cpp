#include <fmt/core.h>

#include "analysis/show/report.hpp"
#include "analysis/show/text.hpp"

namespace ikbench::show {

namespace {

struct MarkdownWriter {
  const std::filesystem::path& folder;
  bool is_first = false;

  std::string operator()(const Heading& heading) const {
    return fmt::format("{} {}\n\n", is_first ? "#" : "##", markdown_text(heading.text));
  }
  std::string operator()(const std::string& text) const { return markdown_text(text) + "\n\n"; }
  std::string operator()(const Table& table) const {
    return fmt::format("**{}**\n\n{}\n", markdown_text(table.caption), to_markdown(table));
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
    for (const Block& block : blocks) text += std::visit(MarkdownWriter{folder, text.empty()}, block);
  }
  text.pop_back();
  return text;
}

}  // namespace ikbench::show
