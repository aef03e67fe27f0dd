// SPDX-License-Identifier: Apache-2.0
#include "output/svg_path_text.hpp"

#include <cmath>
#include <cstddef>

#include "base/decimal_text.hpp"
#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::output {

SvgPathText::SvgPathText(std::string& text, int decimals) : text_(text), decimals_(decimals) {
  for (int i = 0; i < decimals; ++i) parts_ *= 10;
}

void SvgPathText::move(const Vec2& point) {
  here_ = round(point);
  command_ = 0;
  command('M');
  number(here_[0]);
  number(here_[1]);
}

void SvgPathText::line(const Vec2& point) {
  const Rounded next = round(point);
  const Rounded way = {next[0] - here_[0], next[1] - here_[1]};
  here_ = next;
  command(way[1] == 0 ? 'h' : way[0] == 0 ? 'v' : 'l');
  if (command_ != 'v') number(way[0]);
  if (command_ != 'h') number(way[1]);
}

void SvgPathText::curve(const Vec2& control, const Vec2& end) {
  const Rounded by = round(control), next = round(end);
  command('q');
  number(by[0] - here_[0]);
  number(by[1] - here_[1]);
  number(next[0] - here_[0]);
  number(next[1] - here_[1]);
  here_ = next;
}

void SvgPathText::arc(const Vec2& radii, double turn, bool clockwise, const Vec2& end) {
  // Angles are written with more decimals than lengths, because they act at the end of a radius.
  constexpr int decimals_of_degree = 6;
  command('A');
  for (const long long radius : round(radii)) number(radius);
  append_written();
  append_short(text_ += ' ', turn, decimals_of_degree);
  text_ += clockwise ? " 0 1" : " 0 0";
  here_ = round(end);
  for (const long long place : here_) number(place);
}

void SvgPathText::close() { command('Z'); }

SvgPathText::Rounded SvgPathText::round(const Vec2& point) const {
  return {parts_of(point.x, parts_), parts_of(point.y, parts_)};
}

void SvgPathText::command(char letter) {
  if (letter == command_) return;
  make_room();
  *end_++ = letter;
  command_ = letter;
  after_number_ = false;
}

// A sign separates numbers as well as a space does.
void SvgPathText::number(long long rounded) {
  make_room();
  if (after_number_ && rounded >= 0) *end_++ = ' ';
  after_number_ = true;
  constexpr long long largest_exact = 100'000'000'000;
  if (std::abs(rounded) < largest_exact) {
    end_ = write_scaled(end_, rounded, decimals_, LeadingZero::omitted);
    return;
  }
  append_written();
  append_short(text_, static_cast<double>(rounded) / parts_, decimals_);
}

void SvgPathText::make_room() {
  if (static_cast<std::size_t>(written_.data() + written_.size() - end_) <= longest_decimal) append_written();
}

void SvgPathText::append_written() {
  text_.append(written_.data(), end_);
  end_ = written_.data();
}

long long parts_of(double millimetres, double parts) {
  constexpr double farthest = 1e12;
  if (!(std::abs(millimetres) < farthest)) check(false, "ink lies at infinity");
  // Like std::llround, which is a call of a function: halves are rounded away from zero.
  const double exact = millimetres * parts;
  const auto whole = static_cast<long long>(exact);
  const double rest = exact - static_cast<double>(whole);
  return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}

void append_short(std::string& text, double value, int decimals) {
  const std::size_t begin = text.size();
  append_fixed(text, value, decimals);
  const std::size_t first = begin + (text[begin] == '-' ? 1 : 0);
  if (text.compare(first, 2, "0.") == 0) text.erase(first, 1);
}

void append_millimetres(std::string& text, double value) { append_short(text, value, 4); }

}  // namespace epura::output
