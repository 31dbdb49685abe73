// The time of drawing in a PDF. Its data are a line drawn twice by gnuplot 6.0 with Cairo 1.18 of Debian 13 ("unset
// border; unset tics; unset key; plot x", pdfcairo, 5 cm by 4 cm), at two times that are packed into different sizes.
#include "analysis/figures/pdf_date.hpp"

#include "tests/figures/drawn.hpp"

namespace {

std::string pdf_of(const std::string& name) { return text_in("tests/data/pdf/cairo-1.18-" + name); }

}  // namespace

TEST_CASE("a PDF with a packed date has the same bytes whenever it was drawn", "[figure]") {
  const std::string one = pdf_of("one"), other = pdf_of("other"), without = without_date(one);
  REQUIRE(one.size() != other.size());
  CHECK(without_date(other) == without);
  CHECK(contains(without, "/Producer (cairo 1.18"));
  CHECK_FALSE(contains(without, "CreationDate"));
}

TEST_CASE("a PDF without its date has every object where its table says", "[figure]") {
  const std::string pdf = without_date(pdf_of("one"));
  const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
  REQUIRE(pdf.substr(table).starts_with("13 0 obj\n"));
  const std::size_t rows = pdf.find("stream\n", table) + 7;
  for (std::size_t object = 0; object < 14; ++object) {
    const auto byte = [&](std::size_t i) {
      return std::size_t{static_cast<unsigned char>(pdf[rows + 7 * object + i])};
    };
    const std::size_t place = byte(1) << 24 | byte(2) << 16 | byte(3) << 8 | byte(4);
    if (byte(0) == 1) CHECK(pdf.substr(place).starts_with(fmt::format("{} 0 obj\n", object)));
    if (byte(0) == 2) CHECK((place == 7 || place == 9));  // the two streams of objects
  }
  CHECK(pdf.compare(rows + 7 * 14, 11, "\nendstream\n") == 0);
}

TEST_CASE("a plain date becomes blanks, and a PDF without one is refused", "[figure]") {
  CHECK(without_date("<< /CreationDate (D:20260101000000Z) /A 1 >>") == "<< " + std::string(33, ' ') + " /A 1 >>");
  const std::string pdf = pdf_of("one");
  for (std::size_t size = 0; size < pdf.size() - std::string("\n%%EOF\n").size(); ++size)
    CHECK_THROWS_AS(without_date(pdf.substr(0, size)), std::invalid_argument);
  for (std::size_t at = 0; at < pdf.size(); ++at) {  // broken anywhere: refused, or another picture
    std::string broken = pdf;
    broken[at] = static_cast<char>(broken[at] ^ 0x15);
    complaint<std::invalid_argument>([&] { without_date(broken); });
  }
}
