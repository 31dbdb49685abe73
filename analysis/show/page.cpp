// Writes a report as a page of HTML that loads nothing, and as Markdown.
#include "analysis/show/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <span>

#include "analysis/show/moving_arm.hpp"
#include "analysis/show/publish.hpp"
#include "analysis/show/text.hpp"
#include "base/embedded_file.hpp"
#include "base/files.hpp"

namespace ikbench::show {

namespace {

constexpr base::EmbeddedFile templates[]{
#include "templates.inc"
};

std::string_view template_named(std::string_view name) {
  return std::ranges::find(templates, name, &base::EmbeddedFile::name)->text;
}

std::string base64(std::string_view bytes) {
  using namespace boost::archive::iterators;
  using Encoded = base64_from_binary<transform_width<std::string_view::iterator, 6, 8>>;
  std::string text(Encoded(bytes.begin()), Encoded(bytes.end()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

Table told_of(Table table) {
  if (table.visible_rows < table.rows.size()) table.rows.resize(table.visible_rows);
  return table;
}

struct PageWriter {
  const std::filesystem::path& folder;

  std::string operator()(const Heading& heading) const {
    const std::string id = anchor_id(heading.text);
    return fmt::format("<h2 id=\"{0}\"><a href=\"#{0}\">{1}</a></h2>\n", id, html_text(heading.text));
  }
  std::string operator()(const std::string& text) const { return fmt::format("<p>{}</p>\n", html_text(text)); }
  std::string operator()(const Table& table) const {
    const std::string id = anchor_id(table.name);
    std::string text = fmt::format("<div class=\"card\"{}>\n", id.empty() ? "" : fmt::format(" id=\"table-{}\"", id));
    const Table open = told_of(table);
    const auto rows = [](const Table& part) {
      return fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n{}</div>\n",
                         html_text(part.caption), to_html(part));
    };
    if (!open.rows.empty()) text += rows(open);
    if (open.rows.size() < table.rows.size()) {
      Table rest = table;
      rest.rows.erase(rest.rows.begin(), rest.rows.begin() + std::ssize(open.rows));
      text += fmt::format("<details class=\"more\"><summary>{}</summary>\n{}</details>\n",
                          open.rows.empty() ? html_text(table.caption) : fmt::format("{} more", rest.rows.size()),
                          rows(rest));
    }
    for (const std::string& note : table.notes) text += fmt::format("<p class=\"note\">{}</p>\n", html_text(note));
    return text + "</div>\n";
  }
  std::string operator()(const figures::Figure& figure) const {
    constexpr std::size_t largest = 4'000'000;  // picture within the page [bytes]; a larger one is only linked
    const std::string caption = html_text(figure.caption);
    std::string picture;
    for (const auto& [type, media] : {std::pair("svg", "svg+xml"), std::pair("png", "png")}) {
      const auto drawn = base::read_file(folder / "figures" / fmt::format("{}.{}", figure.name, type));
      if (!drawn || drawn->size() > largest || !picture.empty()) continue;
      picture = fmt::format("<div class=\"scroll\"><img alt=\"{}\" src=\"data:image/{};base64,{}\"></div>\n", caption,
                            media, base64(*drawn));
    }
    if (!figure.pointer.empty() && !picture.empty())
      picture += fmt::format(
          "<p class=\"note pointer\" hidden></p>\n<script type=\"application/json\" class=\"pointer\">{}</script>\n",
          boost::replace_all_copy(figure.pointer, "<", "\\u003c"));  // no text ends the element
    return fmt::format("<figure id=\"figure-{}\"{}>\n{}<figcaption>{}</figcaption>\n</figure>\n",
                       anchor_id(figure.name), figure.width_cm > 12 ? " class=\"wide\"" : "", picture, caption);
  }
};

// Returns the first section: the headline, the text of the study, and the table and the arm side by side.
std::string lead_section(const std::string& title, const Blocks& blocks, const PageWriter& write,
                         const std::string& contents, std::string_view stage) {
  std::string head, body;
  bool has_headline = false;
  for (const Block& block : blocks) {
    if (const auto* heading = std::get_if<Heading>(&block); heading && !has_headline) {
      head += fmt::format("<p class=\"note\">{}</p>\n<h1>{}</h1>\n", html_text(title), html_text(heading->text));
      has_headline = true;
    } else {
      (std::holds_alternative<std::string>(block) && body.empty() ? head : body) += std::visit(write, block);
    }
  }
  return fmt::format("<header>\n{}{}<div class=\"answer\">\n<div>\n{}</div>\n{}</div>\n</header>\n", head, contents,
                     body, stage);
}

std::string section(const Blocks& blocks, const PageWriter& write) {
  std::string text = "<section>\n";
  bool is_among_figures = false;
  for (const Block& block : blocks) {
    const bool is_figure = std::holds_alternative<figures::Figure>(block);
    if (is_figure != is_among_figures) text += is_figure ? "<div class=\"figures\">\n" : "</div>\n";
    is_among_figures = is_figure;
    text += std::visit(write, block);
  }
  return text + (is_among_figures ? "</div>\n</section>\n" : "</section>\n");
}

std::string contents_of(std::span<const Blocks> sections) {
  std::string text = "<nav aria-label=\"Contents\">";
  for (const Blocks& blocks : sections) {
    if (const auto* heading = std::get_if<Heading>(&blocks.front()))
      text += fmt::format("<a href=\"#{}\">{}</a>\n", anchor_id(heading->text), html_text(heading->text));
  }
  return text + "</nav>\n";
}

struct MarkdownWriter {
  const std::filesystem::path& folder;
  bool is_first = false;

  std::string operator()(const Heading& heading) const {
    return fmt::format("{} {}\n\n", is_first ? "#" : "##", markdown_text(heading.text));
  }
  std::string operator()(const std::string& text) const { return markdown_text(text) + "\n\n"; }
  std::string operator()(const Table& table) const {
    const Table open = told_of(table);
    std::string more;  // the file with the other rows
    if (open.rows.size() < table.rows.size())
      more = table.name.empty() ? "report.html" : fmt::format("tables/{}.csv", table.name);
    if (open.rows.empty() && !more.empty()) return fmt::format("{}: {}\n\n", markdown_text(table.caption), more);
    return fmt::format("**{}**\n\n{}\n{}", markdown_text(table.caption), to_markdown(open),
                       more.empty() ? "" : fmt::format("{} more: {}\n\n", table.rows.size() - open.rows.size(), more));
  }
  std::string operator()(const figures::Figure& figure) const {
    const std::string caption = markdown_text(figure.caption);
    const std::vector<std::string> types =
        picture_formats_of(figure, folder);  // another report may just have removed them
    return types.empty() ? caption + "\n\n"
                         : fmt::format("![{}](figures/{}.{})\n\n", caption, figure.name, types.front());
  }
};

}  // namespace

// The replaced text is not searched again, so that a value may hold "{{".
std::string fill_template(std::string_view name, const std::map<std::string, std::string, std::less<>>& values) {
  const std::string_view page = template_named(name);
  std::string text;
  for (std::size_t at = 0, open = 0; open != std::string_view::npos;) {
    open = page.find("{{", at);
    text += page.substr(at, open - at);
    if (open == std::string_view::npos) break;
    const std::size_t close = page.find("}}", open);
    text += values.find(page.substr(open + 2, close - open - 2))->second;
    at = close + 2;
  }
  return text;
}

std::string to_html_page(const std::string& title, const std::vector<Blocks>& sections,
                         const std::optional<std::string>& arm, const std::filesystem::path& folder,
                         const std::string& program) {
  const PageWriter write{folder};
  const auto script = [](std::string_view code) { return fmt::format("<script>{}</script>\n", code); };
  std::string scripts;
  if (arm)
    scripts = std::string(template_named("licence.html")) + script(threejs_source()) +
              fmt::format("<script type=\"application/json\" id=\"motion-data\">{}</script>\n", *arm) +
              script(template_named("moving_arm.js"));
  const auto has_pointer = [](const Block& block) {
    const auto* const figure = std::get_if<figures::Figure>(&block);
    return figure != nullptr && !figure->pointer.empty();
  };
  if (std::ranges::any_of(sections, [&](const Blocks& blocks) { return std::ranges::any_of(blocks, has_pointer); }))
    scripts += script(template_named("map_pointer.js"));
  const std::span rest(sections.begin() + 1, sections.end());
  std::string text = lead_section(title, sections.front(), write, contents_of(rest),
                                  arm ? template_named("stage.html") : std::string_view());
  for (const Blocks& blocks : rest) text += section(blocks, write);
  return fill_template("page.html", {{"title", html_text(title)},
                                     {"style", std::string(template_named("page.css"))},
                                     {"sections", std::move(text)},
                                     {"program", html_text(program.empty() ? "ikbench" : program)},
                                     {"scripts", std::move(scripts)}});
}

std::string to_markdown(const std::vector<Blocks>& sections, const std::filesystem::path& folder) {
  std::string text;
  for (const Blocks& blocks : sections) {
    for (const Block& block : blocks) text += std::visit(MarkdownWriter{folder, text.empty()}, block);
  }
  text.pop_back();
  return text;
}

}  // namespace ikbench::show
