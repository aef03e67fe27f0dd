// SPDX-License-Identifier: Apache-2.0
#include "svg/path.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include "base/portable_math.hpp"
#include "svg/flatten.hpp"

namespace epura::svg {

namespace {

class PathParser {
 public:
  PathParser(std::string_view data, PieceRoom& room) : data_(data), room_(room) {}

  std::optional<Path> parse() {
    char command = 0;
    for (skip(); good_ && !data_.empty(); skip()) {
      if (std::isalpha(static_cast<unsigned char>(data_[0]))) {
        command = data_[0];
        data_.remove_prefix(1);
      } else if (command == 0 || command == 'z' || command == 'Z') {
        return std::nullopt;
      }
      run(command);
      // Further pairs after M are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    if (!good_) return std::nullopt;
    return std::move(path_);
  }

 private:
  void run(char command) {
    const bool relative = command >= 'a';
    const Vec2 base = relative ? here_ : Vec2(0, 0);
    const char kind = static_cast<char>(relative ? command - 'a' + 'A' : command);
    if (kind != 'M' && path_.lines.empty()) return fail();
    if (kind == 'M') return move(base + point());
    if (kind == 'Z') return close();
    if (path_.lines.back().closed) move(here_);  // a line after Z begins where Z ended
    if (kind == 'L') return line(base + point());
    if (kind == 'H') return line({base.x + number(), here_.y});
    if (kind == 'V') return line({here_.x, base.y + number()});
    if (kind == 'Q') return quadratic(base);
    if (kind == 'C') return cubic(base);
    if (kind == 'A') return arc(base);
    fail();
  }

  void fail() { good_ = false; }

  void skip() { data_.remove_prefix(std::min(data_.find_first_not_of(" \t\r\n,"), data_.size())); }

  double number() {
    skip();
    if (data_.starts_with('+')) data_.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(data_.data(), data_.data() + data_.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) fail();
    data_.remove_prefix(static_cast<std::size_t>(end - data_.data()));
    return value;
  }

  Vec2 point() {
    const double x = number();
    return {x, number()};
  }

  // One character, which the next number may follow without a separator.
  bool flag() {
    skip();
    if (!data_.starts_with('0') && !data_.starts_with('1')) return fail(), false;
    const bool set = data_[0] == '1';
    data_.remove_prefix(1);
    return set;
  }

  void move(const Vec2& to) {
    room_.take(1);
    path_.lines.push_back({{to}});
    here_ = to;
  }

  void line(const Vec2& to) {
    room_.take(1);
    path_.lines.back().points.push_back(to);
    here_ = to;
  }

  void close() {
    Line& last = path_.lines.back();
    last.closed = true;
    here_ = last.points.front();
    if (last.points.size() > 1 && last.points.back() == here_) last.points.pop_back();
  }

  void quadratic(const Vec2& base) {
    const Vec2 from = here_, by = base + point(), to = base + point();
    path_.controls.push_back(by);
    const int parts = parts_of_curve(glm::length(from - 2.0 * by + to) / 4);
    for (int i = 1; i <= parts; ++i) {
      const double t = double(i) / parts, s = 1 - t;
      line(i == parts ? to : s * s * from + 2 * s * t * by + t * t * to);
    }
  }

  void cubic(const Vec2& base) {
    const Vec2 from = here_, a = base + point(), b = base + point(), to = base + point();
    path_.controls.insert(path_.controls.end(), {a, b});
    append_cubic(path_.lines.back().points, {from, a, b, to}, room_);
    here_ = to;
  }

  // SVG 1.1, F.6: from the ends, the radii and the flags that select one of four arcs.
  void arc(const Vec2& base) {
    Vec2 radii = glm::abs(point());
    const double turn = number() * std::numbers::pi / 180;
    const bool large = flag(), clockwise = flag();
    const Vec2 from = here_, to = base + point();
    if (!good_ || from == to) return;
    if (radii.x == 0 || radii.y == 0) return line(to);
    const Vec2 u(portable_cos(turn), portable_sin(turn)), v(-u.y, u.x);
    const Vec2 half = (from - to) / 2.0;
    Vec2 p(glm::dot(half, u), glm::dot(half, v));
    const double reach = glm::dot(p / radii, p / radii);
    if (reach > 1) radii *= std::sqrt(reach);
    const Vec2 q = p / radii;
    const double rest = std::max(1 / glm::dot(q, q) - 1, 0.0);
    const Vec2 middle = (large == clockwise ? -1.0 : 1.0) * std::sqrt(rest) * Vec2(q.y, -q.x);
    const Vec2 centre = (from + to) / 2.0 + middle.x * radii.x * u + middle.y * radii.y * v;
    const double begin = portable_atan2(q.y - middle.y, q.x - middle.x);
    double sweep = portable_atan2(-q.y - middle.y, -q.x - middle.x) - begin;
    if (clockwise && sweep < 0) sweep += 2 * std::numbers::pi;
    if (!clockwise && sweep > 0) sweep -= 2 * std::numbers::pi;
    const int parts = parts_of_curve(std::max(radii.x, radii.y) * sweep * sweep / 8);
    for (int i = 1; i <= parts; ++i) {
      const double angle = begin + sweep * i / parts;
      line(i == parts ? to : centre + radii.x * portable_cos(angle) * u + radii.y * portable_sin(angle) * v);
    }
  }

  std::string_view data_;
  PieceRoom& room_;
  Vec2 here_{0, 0};
  bool good_ = true;
  Path path_{};
};

}  // namespace

std::optional<Path> read_path(std::string_view data, PieceRoom& room) { return PathParser(data, room).parse(); }

}  // namespace epura::svg
