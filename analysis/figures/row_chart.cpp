#include "analysis/figures/row_chart.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace inference;

namespace {

constexpr double widest_in_one_column_cm = 2.8, widest_label_cm = 11;
constexpr std::size_t longest_row_label = 2 * longest_label + 3;  // two names in a row of a comparison
}  // namespace

double label_cm(std::string_view label) {
  constexpr std::string_view narrow = "fijlrt.,:;|!'()[] -";
  constexpr std::string_view wide = "mwMW@%";
  double cm = 0;
  for (const char c : label) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) == 0x80) continue;
    const bool capital = c >= 'A' && c <= 'Z';
    cm += narrow.find(c) != std::string_view::npos ? 0.09
          : wide.find(c) != std::string_view::npos ? 0.25
          : byte >= 0xE3                           ? 0.25
          : capital                                ? 0.17
                                                   : 0.14;
  }
  return cm;
}

void add_rows(Figure& figure, std::span<const std::string> labels, double height_cm) {
  std::string ticks;
  double widest_cm = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    std::string label = row_label(labels[i], longest_row_label);
    for (std::size_t most = longest_row_label; label_cm(label) > widest_label_cm; --most) {
      label = row_label(labels[i], most);
    }
    widest_cm = std::max(widest_cm, label_cm(label));
    ticks += fmt::format("{}{} {}", i == 0 ? "" : ", ", tick_label(label), i + 1);
  }
  if (widest_cm > widest_in_one_column_cm) figure.width_cm = two_columns_cm;
  figure.height_cm = 1.4 + height_cm * static_cast<double>(std::max<std::size_t>(labels.size(), 1));
  figure.settings += fmt::format(
      "unset key\nset yrange [{}.5:0.5]\nset ytics noenhanced ({}) font names\nset border 1\nset ytics scale 0\n"
      "set grid noytics\nset xtics enhanced\nset lmargin at screen margin({})\n",
      std::max<std::size_t>(labels.size(), 1), ticks, text_of(widest_cm + 0.35));
  if (labels.empty()) figure.settings += "unset ytics\nset label 'nothing to show' at graph 0.5, graph 0.5 center\n";
}

}  // namespace ikbench::figures
