// Turns tables, figures and claims into data for the page's template.
#pragma once

#include <filesystem>
#include <kainjow/mustache.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/json.hpp"
#include "analysis/report/report_content.hpp"

namespace ikbench::report {

using Data = kainjow::mustache::data;

Data text_data(std::string_view plain);  // the template escapes
Data list_data(const std::vector<std::string>& sentences);

// Makes a name safe as an id and in a link, even if a foreign table brings it.
std::string id_of(std::string_view name);

// The paper's claims and our own questions, as a list of the lists that are not empty.
Data verdicts_data(const ReportContent& content);

// The tables and figures of a page. Together the pictures stay below a limit; those beyond it are links.
class HtmlPieces {
 public:
  HtmlPieces(const ReportContent& content, std::filesystem::path figures)
      : content_(content), figures_(std::move(figures)) {}

  Data data(const Piece& piece);
  // The figure's SVG in base64, with colours for a dark background too. As an image source it runs no script, and its
  // ids cannot clash.
  std::optional<std::string> picture(const figures::Figure& figure);
  // Tooltips of the series, by figure id.
  const Json& told() const { return told_; }
  int left_out() const { return left_out_; }  // pictures beyond the limit so far

 private:
  Data figure_data(const ReportFigure& piece);
  std::string id_of_figure(const std::string& name) const;

  const ReportContent& content_;
  std::filesystem::path figures_;
  std::size_t sum_ = 0;  // bytes of all pictures so far
  int left_out_ = 0;
  Json told_ = Json::object();
};

}  // namespace ikbench::report
