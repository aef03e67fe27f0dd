// SPDX-License-Identifier: Apache-2.0
#include "output/dxf_entities.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "output/dxf_tables.hpp"
#include "scene/line_roles.hpp"

namespace epura::output {

namespace {

/// How AutoCAD and LibreCAD know a pattern: its name, and the distance between its lines at scale 1, mm.
struct PatternName {
  const char* name;
  double spacing;
};

PatternName name_of(HatchPattern pattern) {
  switch (pattern) {
    case HatchPattern::steel:
      return {"ANSI32", 9.525};
    case HatchPattern::bronze:
      return {"ANSI33", 3.175};
    case HatchPattern::nonmetal:
      return {"ANSI37", 3.175};
    default:
      return {"ANSI31", 3.175};
  }
}

constexpr double angle_of_patterns = 45;  // at angle 0

// Up to what differs between solid and other patterns.
void begin_hatch(DxfWriter& dxf, const Place& place, const char* pattern, const sheet::Fill& fill) {
  begin_entity(dxf, place, "HATCH", "AcDbHatch");
  dxf.add(10, Vec2(0, 0));
  dxf.add(30, 0);
  dxf.add(210, Vec2(0, 0));
  dxf.add(230, 1);
  dxf.add(2, pattern);
  dxf.add(70, std::string_view(pattern) == "SOLID" ? 1 : 0);
  dxf.add(71, 0);
  dxf.add(91, static_cast<int>(fill.rings.size()));
  for (const auto& ring : fill.rings) {
    dxf.add(92, 3);  // a polyline, and external
    dxf.add(72, 0);  // without bulges
    dxf.add(73, 1);  // closed
    dxf.add(93, static_cast<int>(ring.size()));
    for (const Vec2& p : ring) dxf.add(10, p);
    dxf.add(97, 0);
  }
  dxf.add(75, 0);  // even-odd
  dxf.add(76, 1);
}

void add_lines(DxfWriter& dxf, const sheet::HatchLines& lines) {
  const double angle = lines.angle * std::numbers::pi / 180;
  const Vec2 across(-portable_sin(angle), portable_cos(angle));
  dxf.add(53, lines.angle);
  dxf.add(43, lines.start * across.x);
  dxf.add(44, lines.start * across.y);
  dxf.add(45, lines.spacing * across.x);
  dxf.add(46, lines.spacing * across.y);
  dxf.add(79, lines.is_dashed ? 2 : 0);
  constexpr double width = 0.25;  // mm, of narrow lines
  if (!lines.is_dashed) return;
  dxf.add(49, scene::dashed.dash * width);
  dxf.add(49, -scene::dashed.gap * width);
}

/// What a shape is called: its number, and its classes.
struct ShapeInFile {
  int type;
  const char* entity_class;
};

ShapeInFile shape_in_file(sheet::DimensionShape shape) {
  switch (shape) {
    case sheet::DimensionShape::linear:
      return {0, "AcDbAlignedDimension"};
    case sheet::DimensionShape::angular:
      return {5, "AcDb3PointAngularDimension"};
    case sheet::DimensionShape::radius:
      return {4, "AcDbRadialDimension"};
    case sheet::DimensionShape::ordinate:
      return {6, "AcDbOrdinateDimension"};
    case sheet::DimensionShape::diameter:
      break;
  }
  return {3, "AcDbDiametricDimension"};
}

// The point that all dimensions have: where the dimension line is, or the origin; of radii, the centre; of diameters,
// the point opposite to the leader.
Vec2 line_point(const sheet::DimensionObject& dimension) {
  switch (dimension.shape) {
    case sheet::DimensionShape::linear:
      return dimension.points[2];
    case sheet::DimensionShape::angular:
      return dimension.points[3];
    case sheet::DimensionShape::diameter:
    case sheet::DimensionShape::radius:
    case sheet::DimensionShape::ordinate:
      break;
  }
  return dimension.points[0];
}

void add_points(DxfWriter& dxf, const sheet::DimensionObject& dimension) {
  const std::vector<Vec2>& points = dimension.points;
  if (dimension.shape == sheet::DimensionShape::diameter || dimension.shape == sheet::DimensionShape::radius) {
    dxf.add_point(15, points[1]);
    dxf.add(40, dimension.leader);
    return;
  }
  if (dimension.shape == sheet::DimensionShape::ordinate) {
    dxf.add_point(13, points[1]);
    return dxf.add_point(14, points[2]);
  }
  const std::size_t first = dimension.shape == sheet::DimensionShape::angular ? 1 : 0;
  dxf.add_point(13, points[first]);
  dxf.add_point(14, points[first + 1]);
  if (first == 1) return dxf.add_point(15, points[0]);
  dxf.add(50, dimension.angle);
  if (dimension.oblique != 0) dxf.add(52, dimension.oblique);
  dxf.add(100, "AcDbRotatedDimension");
}

// As CAD programs measure it.
double length_in_file(const sheet::DimensionObject& dimension) {
  const std::vector<Vec2>& points = dimension.points;
  const bool along_line =
      dimension.shape == sheet::DimensionShape::linear || dimension.shape == sheet::DimensionShape::ordinate;
  if (!along_line) return glm::length(points[1] - points[0]);
  const double angle = dimension.angle * std::numbers::pi / 180;
  return std::abs(glm::dot(points[1] - points[0], Vec2(portable_cos(angle), portable_sin(angle))));
}

}  // namespace

double factor_of(const sheet::DimensionObject& dimension) {
  if (dimension.shape == sheet::DimensionShape::angular || !(dimension.value > 0)) return 1;
  const double length = length_in_file(dimension);
  if (!(length > 0)) return 1;
  // What is left of the rounding of positions on paper must not make styles of their own.
  return parse_number(format_rounded(dimension.value / length, 9)).value();
}

void begin_entity(DxfWriter& dxf, const Place& place, std::string_view type, std::string_view entity_class) {
  dxf.begin(type, place.owner, "AcDbEntity");
  dxf.add(8, place.layer);
  if (place.dashed && place.continuous) dxf.add(6, "CONTINUOUS");
  dxf.add(100, entity_class);
}

void add_solid(DxfWriter& dxf, const Place& place, const sheet::Fill& fill) {
  begin_hatch(dxf, place, "SOLID", fill);
  dxf.add(98, 0);
}

void add_hatch(DxfWriter& dxf, const Place& place, const sheet::HatchedFace& face) {
  const PatternName pattern = name_of(face.pattern);
  begin_hatch(dxf, place, pattern.name, face.face);
  dxf.add(52, face.angle - angle_of_patterns);
  dxf.add(41, face.spacing / pattern.spacing);
  dxf.add(77, 0);
  dxf.add(78, static_cast<int>(face.lines.size()));
  for (const sheet::HatchLines& lines : face.lines) add_lines(dxf, lines);
  dxf.add(98, 0);
}

void add_dimension(DxfWriter& dxf, const Place& place, const sheet::DimensionObject& dimension,
                   const std::string& block) {
  constexpr int own_block = 32, along_x = 64, text_has_place = 128, middle = 5;
  const bool is_abscissa = dimension.shape == sheet::DimensionShape::ordinate && dimension.angle == 0;
  const ShapeInFile shape = shape_in_file(dimension.shape);
  begin_entity(dxf, place, "DIMENSION", "AcDbDimension");
  dxf.add(2, block);
  dxf.add_point(10, line_point(dimension));
  dxf.add_point(11, dimension.text_middle);
  dxf.add(70, shape.type + own_block + text_has_place + (is_abscissa ? along_x : 0));
  dxf.add(71, middle);
  dxf.add(1, dxf_paragraph(dimension.text, dxf.version()));
  if (dimension.value > 0) dxf.add(42, dimension.value);
  dxf.add(3, dxf_dimension_style(factor_of(dimension)));
  dxf.add(100, shape.entity_class);
  add_points(dxf, dimension);
}

}  // namespace epura::output
