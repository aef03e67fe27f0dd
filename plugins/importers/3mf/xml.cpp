// SPDX-License-Identifier: Apache-2.0
#include "xml.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace epura::plugin::threemf {

namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view without_prefix(std::string_view name) { return name.substr(name.find(':') + 1); }

void append_utf8(std::string& text, std::uint32_t code) {
  const auto last = [&](int shift) { text += static_cast<char>(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xc0 | code >> 6), last(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xe0 | code >> 12), last(6), last(0);
  } else {
    text += static_cast<char>(0xf0 | code >> 18), last(12), last(6), last(0);
  }
}

// "&amp;" and "&#38;" without '&' and ';'. An unknown entity stays as it is.
bool append_entity(std::string& text, std::string_view entity) {
  constexpr std::array<std::pair<std::string_view, char>, 5> named{
      {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
  for (const auto& [name, letter] : named)
    if (entity == name) return text += letter, true;
  if (entity.substr(0, 1) != "#") return false;
  const bool is_hexadecimal = entity.substr(1, 1) == "x";
  const std::string_view digits = entity.substr(is_hexadecimal ? 2 : 1);
  std::uint32_t code = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, is_hexadecimal ? 16 : 10);
  constexpr std::uint32_t last_code = 0x10ffff;
  const bool is_surrogate = 0xd800 <= code && code < 0xe000;
  if (error != std::errc() || end != digits.data() + digits.size() || code == 0 || code > last_code || is_surrogate)
    return false;
  append_utf8(text, code);
  return true;
}

std::string decoded(std::string_view raw) {
  std::string text;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const std::size_t end = raw[i] == '&' ? raw.find(';', i) : std::string_view::npos;
    if (end != std::string_view::npos && append_entity(text, raw.substr(i + 1, end - i - 1)))
      i = end;
    else
      text += raw[i];
  }
  return text;
}

}  // namespace

std::string_view Tag::raw(std::string_view attribute) const {
  for (const auto& [key, value] : attributes)
    if (key == attribute) return value;
  return {};
}

std::string Tag::text(std::string_view attribute) const { return decoded(raw(attribute)); }

void Xml::fail(const std::string& sentence) const {
  const std::string_view before = text_.substr(0, place_);
  throw std::runtime_error("line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')) + " of it " +
                           sentence);
}

void Xml::skip_to(std::string_view end) {
  const std::size_t found = text_.find(end, place_);
  if (found == std::string_view::npos) fail("begins something that has no end");
  place_ = found + end.size();
}

bool Xml::next() {
  if (!tag_.name.empty() && !tag_.is_empty) open_.push_back(tag_.name);
  while (true) {
    place_ = std::min(text_.find('<', place_), text_.size());
    const std::string_view rest = text_.substr(place_);
    if (rest.empty()) break;
    if (rest.substr(0, 4) == "<!--")
      skip_to("-->");
    else if (rest.substr(0, 9) == "<![CDATA[")
      skip_to("]]>");
    else if (rest.substr(0, 2) == "<?")
      skip_to("?>");
    else if (rest.substr(0, 2) == "<!")
      skip_to(">");
    else if (rest.substr(0, 2) == "</")
      read_end();
    else
      return read_tag(), true;
  }
  tag_ = {};
  if (!open_.empty()) fail("ends within <" + std::string(open_.back()) + ">");
  return false;
}

void Xml::read_end() {
  const std::size_t begin = place_ + 2;
  skip_to(">");
  const std::string_view inside = text_.substr(begin, place_ - 1 - begin);
  const std::string_view name = without_prefix(inside.substr(0, inside.find_first_of(blanks)));
  if (open_.empty() || open_.back() != name) fail("ends <" + std::string(name) + ">, which is not open");
  open_.pop_back();
}

void Xml::read_tag() {
  const auto to = [&](std::size_t found) { return std::min(found, text_.size()); };
  const std::size_t begin = place_ + 1, name_end = to(text_.find_first_of(" \t\r\n/>", begin));
  tag_.name = without_prefix(text_.substr(begin, name_end - begin));
  tag_.attributes.clear();
  depth_ = open_.size();
  if (tag_.name.empty()) fail("has a tag without a name");
  std::size_t at = name_end;
  while (true) {
    at = to(text_.find_first_not_of(blanks, at));
    tag_.is_empty = text_.substr(at, 2) == "/>";
    if (tag_.is_empty || text_.substr(at, 1) == ">") break;
    const std::size_t equals = to(text_.find_first_of("=<>", at));
    const std::size_t quote = to(text_.find_first_not_of(blanks, to(equals + 1)));
    const bool is_quoted =
        quote < text_.size() && text_[equals] == '=' && (text_[quote] == '"' || text_[quote] == '\'');
    const std::size_t end = is_quoted ? text_.find(text_[quote], quote + 1) : std::string_view::npos;
    if (end == std::string_view::npos)
      fail("has a tag <" + std::string(tag_.name) + " ...> that is damaged or cut short");
    const std::string_view name = text_.substr(at, equals - at);
    tag_.attributes.emplace_back(without_prefix(name.substr(0, name.find_first_of(blanks))),
                                 text_.substr(quote + 1, end - quote - 1));
    at = end + 1;
  }
  place_ = at + (tag_.is_empty ? 2 : 1);
}

std::string Xml::content() const {
  if (tag_.is_empty) return {};
  return decoded(text_.substr(place_, std::min(text_.find('<', place_), text_.size()) - place_));
}

}  // namespace epura::plugin::threemf
