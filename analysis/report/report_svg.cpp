#include "analysis/report/report_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace ikbench::report {
namespace {

constexpr std::array<std::string_view, 13> elements{"circle",  "clipPath", "defs", "ellipse", "g",     "line", "path",
                                                    "polygon", "polyline", "rect", "text",    "tspan", "use"};
constexpr std::array<std::string_view, 33> attributes{"clip-path",
                                                      "color",
                                                      "cx",
                                                      "cy",
                                                      "d",
                                                      "dx",
                                                      "dy",
                                                      "fill",
                                                      "fill-opacity",
                                                      "fill-rule",
                                                      "font-size",
                                                      "font-style",
                                                      "font-weight",
                                                      "height",
                                                      "id",
                                                      "opacity",
                                                      "points",
                                                      "r",
                                                      "rx",
                                                      "ry",
                                                      "stroke",
                                                      "stroke-width",
                                                      "stroke-dasharray",
                                                      "stroke-linecap",
                                                      "stroke-linejoin",
                                                      "stroke-opacity",
                                                      "text-anchor",
                                                      "transform",
                                                      "width",
                                                      "x",
                                                      "xlink:href",
                                                      "y",
                                                      "viewBox"};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

struct Attribute {
  std::string_view name, value;
};

struct Tag {
  std::string_view name;
  std::vector<Attribute> attributes = {};
  bool closes = false;    // </name>
  bool is_empty = false;  // <name/>
};

// What stands between < and >.
std::optional<Tag> read_tag(std::string_view text) {
  Tag tag;
  if (text.starts_with('/')) {
    tag.closes = true;
    text.remove_prefix(1);
  } else if (text.ends_with('/')) {
    tag.is_empty = true;
    text.remove_suffix(1);
  }
  const auto take = [&](std::size_t length) {
    const std::string_view front = text.substr(0, length);
    text.remove_prefix(front.size());
    return front;
  };
  tag.name = take(std::min(text.find_first_of(" \t\r\n"), text.size()));
  while (!(text = trimmed(text)).empty()) {
    Attribute attribute{.name = trimmed(take(std::min(text.find('='), text.size()))), .value = {}};
    if (text.size() < 2) return std::nullopt;
    text = trimmed(text.substr(1));
    const char quote = text.empty() ? ' ' : text[0];
    const std::size_t end = text.find(quote, 1);
    if ((quote != '"' && quote != '\'') || end == std::string_view::npos) return std::nullopt;
    attribute.value = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    tag.attributes.push_back(attribute);
  }
  return tag;
}

// No quotes, no colour with blanks in it.
std::string plain_value(std::string_view value) {
  std::string result;
  for (const char c : value) {
    if (c == ' ' && value.starts_with("rgb(")) continue;
    if (c == '"') {
      result += "&quot;";
    } else {
      result += is_blank(c) ? ' ' : c;
    }
  }
  return result;
}

// Empty where the attribute is not to be shown.
std::string written(const Attribute& attribute, std::string_view prefix) {
  const std::string value = plain_value(attribute.value);
  const std::string_view name = attribute.name;
  if (std::ranges::find(attributes, name) == attributes.end() || value.find('<') != std::string::npos) return "";
  if (name == "id") return fmt::format(" id=\"{}{}\"", prefix, value);
  if (name == "xlink:href")
    return value.starts_with('#') ? fmt::format(" href=\"#{}{}\"", prefix, value.substr(1)) : "";
  if (value.starts_with("url(#")) return fmt::format(" {}=\"url(#{}{}\"", name, prefix, value.substr(5));
  if (value.find(':') != std::string::npos || value.find("url(") != std::string::npos) return "";
  return fmt::format(" {}=\"{}\"", name, value);
}

// Groups that hold nothing, which gnuplot writes by the dozen.
void close_group(std::string& out) {
  const std::size_t open = out.rfind('<');
  const bool holds_nothing = out.ends_with('>') && std::string_view(out).substr(open).starts_with("<g") &&
                             (out[open + 2] == ' ' || out[open + 2] == '>');
  if (holds_nothing) {
    out.resize(open);
  } else {
    out += "</g>";
  }
}

}  // namespace

std::optional<std::string> inline_svg(std::string_view file, std::string_view prefix) {
  const std::size_t begin = file.find("<svg");
  if (begin == std::string_view::npos) return std::nullopt;
  file.remove_prefix(begin);
  std::string out;
  std::vector<std::string_view> open;         // of the elements that are shown
  std::vector<std::string_view> passed_over;  // inside an element that is not
  while (!file.empty()) {
    const std::size_t start = std::min(file.find('<'), file.size());
    const std::string_view text = file.substr(0, start);
    const bool in_text = !open.empty() && (open.back() == "text" || open.back() == "tspan");
    if (passed_over.empty() && in_text) out += text;
    file.remove_prefix(start);
    if (file.empty()) break;
    for (const auto& [from, to] : {std::pair{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}}) {
      if (!file.starts_with(from)) continue;
      const std::size_t end = file.find(to);
      if (end == std::string_view::npos) return std::nullopt;
      file.remove_prefix(end);
      break;
    }
    const std::size_t end = file.find('>');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view inside = file.substr(0, end);
    file.remove_prefix(end + 1);
    if (!inside.starts_with('<') || inside.starts_with("<!")) continue;
    const std::optional<Tag> tag = read_tag(inside.substr(1));
    if (!tag) return std::nullopt;

    if (tag->closes) {
      std::vector<std::string_view>& stack = passed_over.empty() ? open : passed_over;
      if (stack.empty() || stack.back() != tag->name) return std::nullopt;
      stack.pop_back();
      if (&stack == &passed_over) continue;
      if (open.empty()) return out + "</svg>";
      if (tag->name == "g") {
        close_group(out);
      } else {
        out += fmt::format("</{}>", tag->name);
      }
      continue;
    }
    const bool is_root = open.empty();
    const bool is_paper = tag->name == "rect" && std::ranges::any_of(tag->attributes, [](const Attribute& attribute) {
                            return attribute.name == "fill" && attribute.value == "#ffffff";
                          });
    const bool shown = passed_over.empty() && !is_paper &&
                       (is_root ? tag->name == "svg" : std::ranges::find(elements, tag->name) != elements.end());
    if (!shown) {
      if (!tag->is_empty) passed_over.push_back(tag->name);
      continue;
    }
    out += fmt::format("<{}", tag->name);
    for (const Attribute& attribute : tag->attributes) out += written(attribute, prefix);
    out += tag->is_empty ? "/>" : ">";
    if (!tag->is_empty) open.push_back(tag->name);
  }
  return std::nullopt;  // it does not end
}

}  // namespace ikbench::report
