// SPDX-License-Identifier: Apache-2.0
#include "output/dxf_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <set>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"

namespace epura::output {

namespace {

constexpr char32_t replacement = 0xFFFD;

// The first characters, at most `max`.
std::u32string beginning(std::string_view text, std::size_t max) {
  const std::vector<char32_t> all = characters(text);
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), max))};
}

std::string hexadecimal(unsigned value) {
  std::array<char, 8> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16);
  std::string text(digits.data(), end);
  for (char& c : text)
    if (c >= 'a') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

void append_escape(std::string& text, char32_t character) {
  const std::string digits = hexadecimal(character > 0xFFFF ? replacement : character);
  text += "\\U+" + std::string(4 - digits.size(), '0') + digits;
}

bool is_control(char32_t c) { return c < U' ' || (c > '~' && c < U'\u00A0') || c == U'\u2028' || c == U'\u2029'; }

// As it is, or as an escape for version 2000, whose files are ASCII.
void append_character(std::string& text, char32_t character, DxfVersion version) {
  if (is_control(character))
    text += ' ';
  else if (version == DxfVersion::r2000 && character > '~')
    append_escape(text, character);
  else
    text += utf8(character);
}

std::string clean_name(std::string_view name, DxfVersion version) {
  constexpr std::u32string_view forbidden = U"<>/\\\":;?*|=,'`^%";
  std::u32string kept = beginning(name, 200);
  const auto first = kept.find_first_not_of(U' ');
  if (first == std::u32string::npos) return "layer";
  kept = kept.substr(first, kept.find_last_not_of(U' ') - first + 1);
  std::string clean;
  for (const char32_t c : kept)
    append_character(clean, is_control(c) || forbidden.find(c) != std::u32string_view::npos ? U'-' : c, version);
  return clean;
}

}  // namespace

void DxfWriter::add_code(int code) {
  text_ += std::to_string(code);
  text_ += '\n';
}

void DxfWriter::add(int code, std::string_view text) {
  add_code(code);
  text_.append(text);
  text_ += '\n';
}

void DxfWriter::add(int code, int value) { add(code, std::string_view(std::to_string(value))); }

void DxfWriter::add(int code, double value) {
  check(std::isfinite(value), "a line of a DXF file leads to infinity");
  add_code(code);
  append_number(text_, value);
  text_ += '\n';
}

void DxfWriter::add(int code, const Vec2& point) {
  add(code, point.x);
  add(code + 10, point.y);
}

void DxfWriter::add_point(int code, const Vec2& point) {
  add(code, point);
  add(code + 20, 0);
}

void DxfWriter::add_handle(int code, int handle) {
  add(code, std::string_view(hexadecimal(static_cast<unsigned>(handle))));
}

int DxfWriter::begin(std::string_view type, int owner, std::string_view first_class, std::string_view second_class) {
  const int handle = next_handle();
  begin_as(handle, type, owner, first_class, second_class);
  return handle;
}

void DxfWriter::begin_as(int handle, std::string_view type, int owner, std::string_view first_class,
                         std::string_view second_class) {
  add(0, type);
  add_handle(type == "DIMSTYLE" ? 105 : 5, handle);  // code 5 is the name of a block there
  add_handle(330, owner);
  add(100, first_class);
  if (!second_class.empty()) add(100, second_class);
}

std::string dxf_text(std::string_view text, DxfVersion version) {
  std::string line;
  const std::u32string all = beginning(text, 256);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::u32string_view rest = std::u32string_view(all).substr(i);
    if (rest.starts_with(U"\\U+") || rest.starts_with(U"\\M+"))
      append_escape(line, U'\\');  // as it is, it would begin such an escape
    else if (rest.front() == U'^')
      line += "^ ";
    else if (rest.front() == U'%' && i > 0 && all[i - 1] == U'%')
      line += "%%%";
    else
      append_character(line, rest.front(), version);
  }
  return line;
}

std::string dxf_paragraph(std::string_view text, DxfVersion version) {
  std::string escaped;
  const std::string line = dxf_text(text, version);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_escape = std::string_view(line).substr(i).starts_with("\\U+");
    if (line[i] == '{' || line[i] == '}' || (line[i] == '\\' && !is_escape)) escaped += '\\';
    escaped += line[i];
  }
  return escaped;
}

std::vector<std::string> dxf_names(const std::vector<std::string>& names, const std::vector<std::string>& taken,
                                   DxfVersion version) {
  std::set<std::string> used;
  for (const std::string& name : taken) used.insert(to_lower(name));
  std::vector<std::string> clean;
  for (const std::string& name : names) {
    const std::string wanted = clean_name(name, version);
    std::string unique = wanted;
    for (int number = 2; !used.insert(to_lower(unique)).second; ++number)
      unique = wanted + "-" + std::to_string(number);
    clean.push_back(unique);
  }
  return clean;
}

}  // namespace epura::output
