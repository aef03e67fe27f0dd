// SPDX-License-Identifier: Apache-2.0
// Speed of text, in millions of bytes a second on one core:  texts [TRIANGLES]
// Reading is compared with a loop that only finds the words of the same text and converts those that are numbers by
// std::from_chars; writing SVG with one that writes the same whole numbers by std::to_chars.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "generators.hpp"
#include "mesh/read.hpp"
#include "output/write.hpp"
#include "say.hpp"

namespace {

using namespace epura;

constexpr int rounds = 7;

std::string triple(const std::array<double, 3>& numbers) {
  constexpr int digits = 8;  // a float has no more
  std::string text;
  for (const double number : numbers) text += ' ' + format_rounded(number, digits);
  return text;
}

std::string corners(const std::array<int, 3>& triangle, int first) {
  std::string text;
  for (const int corner : triangle) text += ' ' + std::to_string(corner + first);
  return text + '\n';
}

std::string obj(const bench::Scene& scene) {
  std::string text;
  for (const bench::Point& point : scene.points) text += "v" + triple(point) + "\n";
  for (const auto& triangle : scene.triangles) text += "f" + corners(triangle, 1);
  return text;
}

std::string rows(const bench::Scene& scene, std::string text) {
  for (const bench::Point& point : scene.points) text += triple(point).substr(1) + "\n";
  for (const auto& triangle : scene.triangles) text += "3" + corners(triangle, 0);
  return text;
}

std::string off(const bench::Scene& scene) {
  return rows(scene,
              "OFF\n" + std::to_string(scene.points.size()) + " " + std::to_string(scene.triangles.size()) + " 0\n");
}

std::string ply(const bench::Scene& scene) {
  return rows(scene, "ply\nformat ascii 1.0\nelement vertex " + std::to_string(scene.points.size()) +
                         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                         std::to_string(scene.triangles.size()) +
                         "\nproperty list uchar int vertex_indices\nend_header\n");
}

std::string stl(const bench::Scene& scene) {
  std::string text = "solid scene\n";
  for (const auto& triangle : scene.triangles) {
    text += "  facet normal" + triple({0.57735027, -0.57735027, 0.57735027}) + "\n    outer loop\n";
    for (const int corner : triangle)
      text += "      vertex" + triple(scene.points[static_cast<std::size_t>(corner)]) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid scene\n";
}

/// Circles as a hidden-line drawing has them: `points` to a stroke, with the edges they come from.
sheet::Sheet circles(int strokes, int points) {
  sheet::Layer layer;
  layer.name = "view/visible";
  bench::Random random;
  for (int i = 0; i < strokes; ++i) {
    sheet::Stroke stroke;
    const Vec2 centre(random.between(10, 400), random.between(10, 280));
    const double radius = random.between(1, 10);
    for (int k = 0; k < points; ++k) {
      stroke.points.push_back(centre + radius * Vec2(std::cos(0.3 * k), std::sin(0.3 * k)));
      if (k > 0) stroke.edges.push_back({0, {100 * i + k, 100 * i + k + 1}});
    }
    stroke.kind = EdgeKind::crease;
    layer.strokes.push_back(std::move(stroke));
  }
  sheet::Sheet sheet{420, 297, {}, {}};
  sheet.layers.push_back(std::move(layer));
  return sheet;
}

double median_seconds(const std::function<void()>& work) {
  std::vector<double> seconds;
  for (int i = 0; i < rounds; ++i) {
    const double begin = bench::now();
    work();
    seconds.push_back(bench::now() - begin);
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[rounds / 2];
}

/// The sum keeps the compiler from leaving the conversions out.
double only_numbers(std::string_view text) {
  double sum = 0;
  const char *at = text.data(), *const end = at + text.size();
  while (at != end) {
    if (*at <= ' ') {
      ++at;
      continue;
    }
    double number = 0;
    const auto [behind, error] = std::from_chars(at, end, number);
    if (error == std::errc{}) sum += number;
    at = behind;
    while (at != end && *at > ' ') ++at;
  }
  return sum;
}

/// Writes the whole numbers in a text, separated by blanks.
std::size_t only_written(std::string_view text) {
  std::vector<long long> numbers;
  long long number = 0;
  for (const char c : text)
    if (c >= '0' && c <= '9')
      number = number % 100'000 * 10 + (c - '0');
    else if (number != 0)
      numbers.push_back(std::exchange(number, 0));
  std::string written;
  const double seconds = median_seconds([&] {
    written.clear();
    for (const long long one : numbers) {
      std::array<char, 24> buffer{};
      const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), one);
      written.append(buffer.data(), end) += ' ';
    }
  });
  std::printf("| numbers alone, by to_chars | %.1f | %.0f | |\n", double(written.size()) / 1e6,
              double(written.size()) / 1e6 / seconds);
  return written.size();
}

void row(const char* what, std::size_t bytes, double seconds, double bound) {
  const double millions = double(bytes) / 1e6;
  std::printf("| %s | %.1f | %.0f | %s |\n", what, millions, millions / seconds,
              bound > 0 ? format_fixed(millions / bound, 0).c_str() : "");
}

void measure_reading(const char* what, const std::string& text,
                     mesh::Soup (*read)(std::string_view, std::string_view, const Progress&)) {
  double sum = 0;
  const double bound = median_seconds([&] { sum += only_numbers(text); });
  std::size_t points = 0;
  const double seconds = median_seconds([&] { points = read(text, what, {}).points.size(); });
  check(points > 0 && std::isfinite(sum), "the text has points");
  row(what, text.size(), seconds, bound);
}

void measure_writing(const char* what, const sheet::Sheet& sheet, const output::VectorOptions& options) {
  std::string text;
  const double seconds = median_seconds([&] { text = output::to_svg(sheet, options); });
  row(what, text.size(), seconds, 0);
  only_written(text);
}

}  // namespace

int main(int argc, char** argv) {
  const auto triangles = argc > 1 ? parse_integer(argv[1]) : 300'000;
  if (!triangles || *triangles < 100 || *triangles > 10'000'000) {
    std::fputs("usage: texts [TRIANGLES]\n", stderr);
    return 2;
  }
  const ThreadLimit one(1);
  bench::Scene scene;
  bench::add_sphere(scene, static_cast<int>(*triangles));
  std::puts("| text | MB | MB/s | MB/s, numbers alone |\n|---|---|---|---|");
  measure_reading("OBJ", obj(scene), mesh::read_obj);
  measure_reading("OFF", off(scene), mesh::read_off);
  measure_reading("PLY", ply(scene), mesh::read_ply);
  measure_reading("STL", stl(scene), mesh::read_stl);
  const sheet::Sheet sheet = circles(static_cast<int>(*triangles) / 10, 20);
  measure_writing("SVG", sheet, {});
  measure_writing("SVG, plain", sheet, {.plain = true});
}
