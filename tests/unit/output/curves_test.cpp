// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: where curves lie in the files.
#include <cairo.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <utility>

#include "drawing/curve_part.hpp"
#include "output/curve_pieces.hpp"
#include "output/write.hpp"
#include "support.hpp"
#include "svg_reader.hpp"

namespace epura::curves_test {
namespace {

constexpr double pi = std::numbers::pi;

Vec2 turned(const Vec2& p, double angle) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

drawing::CurvePart curve(Vec2 centre, double a, double b, double slant, double from, double to) {
  return {0, 0, centre, turned({a, 0}, slant), turned({0, b}, slant), from, to};
}

const std::vector<drawing::CurvePart> curves{curve({50, 50}, 40, 40, 0, 0, 2 * pi),
                                             curve({50, 50}, 40, 12, 0.5, 0.3, 0.3 - 2 * pi),
                                             curve({60, 40}, 30, 30, 0, 1, 3.5), curve({60, 40}, 10, 25, 2.2, 1, -3),
                                             curve({-900, 50}, 950, 950, 0, -0.03, 0.03)};

// Distance of a point from a curve, by its affine image on the unit circle; near it, to first order.
double off(const drawing::CurvePart& part, const Vec2& p) {
  const Vec2 d = p - part.centre;
  const Vec2 unit(glm::dot(d, part.u) / glm::dot(part.u, part.u), glm::dot(d, part.v) / glm::dot(part.v, part.v));
  return std::abs(glm::length(unit) - 1) * std::min(glm::length(part.u), glm::length(part.v));
}

TEST(CurvePieces, BeziersLieOnTheCurve) {
  for (const drawing::CurvePart& part : curves) {
    Vec2 from = drawing::position_on_curve(part, part.from);
    for (const output::BezierPiece& piece : output::bezier_pieces(part, 1e-5)) {
      for (int i = 0; i <= 20; ++i) {
        const double t = i / 20.0, s = 1 - t;
        const Vec2 p = s * s * s * from + 3 * s * s * t * piece.controls[0] + 3 * s * t * t * piece.controls[1] +
                       t * t * t * piece.to;
        EXPECT_LT(off(part, p), 1.1e-5);
      }
      from = piece.to;
    }
    EXPECT_LT(glm::distance(from, drawing::position_on_curve(part, part.to)), 1e-9);
  }
}

// The stroke of a curve between two lines; a whole one for itself.
sheet::Stroke stroke_of(drawing::CurvePart part, int steps) {
  sheet::Stroke stroke;
  stroke.closed = std::abs(std::abs(part.to - part.from) - 2 * pi) < 1e-9;
  if (!stroke.closed) stroke.points.push_back(drawing::position_on_curve(part, part.from) + Vec2(0, 7));
  part.first = static_cast<int>(stroke.points.size());
  part.last = part.first + steps;
  for (int i = 0; i < steps + (stroke.closed ? 0 : 1); ++i)
    stroke.points.push_back(drawing::position_on_curve(part, part.from + (part.to - part.from) * i / steps));
  if (!stroke.closed) stroke.points.push_back(stroke.points.back() + Vec2(3, 8));
  stroke.curves.push_back(part);
  return stroke;
}

sheet::Sheet sheet_of(bool curved, int steps) {
  sheet::Sheet sheet{
      120, 100, "curves", {{"a/hidden", {"hidden", 0.25, {3, 0.75}}, {}}, {"a/visible", {"visible", 0.5}, {}}}};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    sheet::Stroke stroke = stroke_of(curves[i], steps);
    if (!curved) stroke.curves.clear();
    if (i % 2 == 1) stroke.dashes = {3, 0.75};
    sheet.layers[i % 2 == 1 ? 0 : 1].strokes.push_back(stroke);
  }
  return sheet;
}

// The middle of an arc of SVG: appendix B.2.4 of its specification, for arcs below half a turn; y down.
Vec2 middle_of_arc(const Vec2& from, const SvgPiece& arc) {
  const Vec2 radii(arc.others[0], arc.others[1]);
  const double angle = arc.others[2] * pi / 180;
  const Vec2 half = turned((from - arc.to) / 2.0, -angle) / radii;
  const double square = glm::dot(half, half);
  const double reach = std::sqrt(std::max(0.0, (1 - square) / square)) * (arc.others[4] == 1 ? 1 : -1);
  // From the middle of the chord, where the ellipse is a unit circle.
  const Vec2 centre = reach * Vec2(half.y, -half.x);
  const Vec2 middle = centre - centre / glm::length(centre);
  return (from + arc.to) / 2.0 + turned(middle * radii, angle);
}

TEST(Curves, AreArcsInSvg) {
  const sheet::Sheet sheet = sheet_of(true, 24);
  const auto document = parse_svg(output::to_svg(sheet, {}));
  const std::vector<pugi::xml_node> layers = layers_of(document);
  for (const std::size_t layer : {0, 1}) {
    pugi::xml_node path = layers[layer].child("path");
    for (const sheet::Stroke& stroke : sheet.layers[layer].strokes) {
      const drawing::CurvePart& part = stroke.curves[0];
      Vec2 pen(0);
      int arcs = 0;
      for (const SvgPiece& piece : SvgPathReader(path.attribute("d").value()).pieces()) {
        const Vec2 from = std::exchange(pen, piece.to);
        if (piece.command != 'A') continue;
        ++arcs;
        const Vec2 middle = middle_of_arc(from, piece);
        EXPECT_LT(off(part, {middle.x, 100 - middle.y}), 1e-4);
        EXPECT_LT(off(part, {piece.to.x, 100 - piece.to.y}), 1e-4);
      }
      EXPECT_EQ(arcs, std::ceil(std::abs(part.to - part.from) / (pi / 2) - 1e-9));
      const std::string_view data = path.attribute("d").value();
      EXPECT_EQ(data.back() == 'Z', stroke.closed);
      path = path.next_sibling();
    }
  }
}

struct Pixels {
  int width, height;
  std::vector<int> grey;

  [[nodiscard]] bool dark(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height && grey[std::size_t(y * width + x)] < 100;
  }
  // Whether there is ink within one pixel.
  [[nodiscard]] bool ink_near(int x, int y) const {
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        if (x + dx >= 0 && y + dy >= 0 && x + dx < width && y + dy < height &&
            grey[std::size_t((y + dy) * width + x + dx)] < 200)
          return true;
    return false;
  }
};

Pixels pixels_of(const std::string& png) {
  struct Source {
    const std::string& bytes;
    std::size_t at = 0;
  } source{png};
  const auto read = [](void* closure, unsigned char* data, unsigned length) {
    auto* from = static_cast<Source*>(closure);
    if (from->at + length > from->bytes.size()) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, from->bytes.data() + from->at, length);
    from->at += length;
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(read, &source);
  Pixels pixels{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  const unsigned char* data = cairo_image_surface_get_data(surface);
  for (int y = 0; y < pixels.height; ++y)
    for (int x = 0; x < pixels.width; ++x)
      pixels.grey.push_back(data[y * cairo_image_surface_get_stride(surface) + 4 * x]);
  cairo_surface_destroy(surface);
  return pixels;
}

// Against polylines so fine that they are the curves.
TEST(Curves, LieInPicturesWhereFinePolylinesDo) {
  sheet::Sheet curved = sheet_of(true, 24), fine = sheet_of(false, 2000);
  for (sheet::Sheet* sheet : {&curved, &fine})
    for (sheet::Stroke& stroke : sheet->layers[0].strokes) stroke.dashes = {};
  const Pixels a = pixels_of(output::to_png(curved, 200)), b = pixels_of(output::to_png(fine, 200));
  ASSERT_EQ(a.grey.size(), b.grey.size());
  int dark = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      dark += a.dark(x, y) ? 1 : 0;
      EXPECT_TRUE(!a.dark(x, y) || b.ink_near(x, y)) << x << " " << y;
      EXPECT_TRUE(!b.dark(x, y) || a.ink_near(x, y)) << x << " " << y;
    }
  EXPECT_GT(dark, 2000);
}

TEST(Curves, AreCurvesInPdfAndPostScript) {
  const sheet::Sheet sheet = sheet_of(true, 24);
  const std::string ps = output::to_ps({&sheet});
  EXPECT_NE(ps.find(" c "), std::string::npos);
  EXPECT_GT(output::to_pdf({&sheet}).size(), 1000U);
}

}  // namespace
}  // namespace epura::curves_test
