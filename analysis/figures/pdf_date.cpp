// PDF: ISO 32000-1; 7.5.7 has streams of objects, 7.5.8 the table of where each object begins.
#include "analysis/figures/pdf_date.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace ikbench::figures {

namespace {

constexpr auto no_date =
    "the time of drawing is not where Cairo writes it in a PDF; draw other formats: --style, [figures] formats";

std::size_t found(std::string_view text, std::string_view part, std::size_t from) {
  const std::size_t at = text.find(part, from);
  if (at == std::string::npos) throw std::invalid_argument(no_date);
  return at;
}

void replace_first(std::string& text, std::string_view old, std::string_view by) {
  text.replace(found(text, old, 0), old.size(), by);
}

// The first whole number after a key.
std::size_t number_after(std::string_view text, std::string_view key, std::size_t from = 0) {
  const std::size_t at = text.find_first_of("0123456789", found(text, key, from));
  std::size_t number = 0;
  if (at != std::string::npos) std::from_chars(text.data() + at, text.data() + text.size(), number);
  return number;
}

// Writes blanks over the date, so that what follows stays where it is. False if there is none.
bool blank_date(std::string& text) {
  const std::size_t begin = text.find("/CreationDate ("), end = text.find(')', begin);
  if (begin == std::string::npos || end == std::string::npos) return false;
  std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end) + 1,
            ' ');
  return true;
}

// An object whose bytes are packed: a dictionary, "stream", the bytes, "endstream".
struct Stream {
  std::string dictionary, text;  // as if it were not packed
  std::size_t end, packed_size;
};

Stream stream_at(const std::string& pdf, std::size_t at) {
  const std::size_t begin = found(pdf, "stream\n", at) + 7;
  Stream stream{pdf.substr(at, begin - at), std::string(1 << 18, '\0'), 0, 0};
  uLongf size = stream.text.size();
  uLong packed = pdf.size() - begin;
  if (uncompress2(reinterpret_cast<Bytef*>(stream.text.data()), &size,
                  reinterpret_cast<const Bytef*>(pdf.data() + begin), &packed) != Z_OK)
    size = 0;  // and nothing is found in it
  stream.text.resize(size);
  stream.end = begin + packed, stream.packed_size = packed;
  replace_first(stream.dictionary, "   /Filter /FlateDecode\n", "");
  return stream;
}

}  // namespace

std::string without_date(std::string pdf) {
  if (blank_date(pdf)) return pdf;
  // Cairo 1.17.6 and newer pack the date with other objects. Only the length of that stream and the table follow. Both
  // streams become plain, since a date is packed into more or fewer bytes than another one.
  const std::size_t table_at = number_after(pdf, "startxref", pdf.rfind("startxref"));
  Stream table = stream_at(pdf, table_at);
  const std::size_t count = number_after(table.dictionary, "/Size"),
                    width = table.text.size() / std::max<std::size_t>(count, 1);
  if (width < 4 || width > 7) throw std::invalid_argument(no_date);
  const auto place =
      [&](std::size_t object) {  // where it begins, or in which stream it is: between a byte and two others
        if (object >= count) throw std::invalid_argument(no_date);
        std::size_t number = 0;
        for (std::size_t i = 1; i < width - 2; ++i)
          number = number << 8 | static_cast<unsigned char>(table.text.at(object * width + i));
        return number;
      };
  const std::size_t objects_at = place(place(number_after(table.dictionary, "/Info")));
  Stream objects = stream_at(pdf, objects_at);
  if (!blank_date(objects.text)) throw std::invalid_argument(no_date);
  std::string length = pdf.substr(objects.end, table_at - objects.end);
  replace_first(length, fmt::format(" {}\n", objects.packed_size), fmt::format(" {}\n", objects.text.size()));
  pdf.replace(objects_at, std::string::npos, objects.dictionary + objects.text + length);

  const std::size_t new_table_at = pdf.size();
  replace_first(table.dictionary, fmt::format("/Length {}\n", table.packed_size),
                fmt::format("/Length {}\n", 7 * count));
  replace_first(table.dictionary, fmt::format("/W [1 {} 2]", width - 3), "/W [1 4 2]");
  pdf += table.dictionary;
  for (std::size_t object = 0; object < count; ++object) {
    const std::string row = table.text.substr(object * width, width);
    std::size_t at = place(object);
    if (row[0] == 1 && at > objects_at) at = found(pdf, fmt::format("\n{} 0 obj\n", object), objects_at) + 1;
    pdf += row[0];
    for (const int shift : {24, 16, 8, 0}) pdf += static_cast<char>(at >> shift);
    pdf += row.substr(width - 2);
  }
  return pdf + fmt::format("\nendstream\nendobj\nstartxref\n{}\n%%EOF\n", new_table_at);
}

}  // namespace ikbench::figures
