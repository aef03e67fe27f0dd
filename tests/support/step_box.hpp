// SPDX-License-Identifier: Apache-2.0
// STEP files (AP242) of a box or round solids, written statement by statement, to which tests add what the part is
// required to be.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

namespace epura::test {

/// The numbers of the faces, each by its outward normal.
enum BoxFace { left_face = 101, right_face, front_face, back_face, bottom_face, top_face, round_face };

namespace step_box_detail {

// With enough digits for an angle.
inline std::string exact(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.15f", value);
  return text.data();
}

/// Corners are numbered by bits: 1 right, 2 back, 4 top.
class Writer {
 public:
  explicit Writer(const std::array<double, 3>& size) : size_(size) {}

  std::string faces() {
    for (int corner = 0; corner < 8; ++corner) add_corner(corner);
    for (int axis = 0; axis < 3; ++axis) {
      const std::array<int, 3> along{axis == 0, axis == 1, axis == 2};
      add(360 + axis, "DIRECTION('',(" + real(along[0]) + "," + real(along[1]) + "," + real(along[2]) + "))");
      add(364 + axis, "VECTOR('',#" + std::to_string(360 + axis) + ",1.)");
      add(370 + axis, "DIRECTION('',(" + real(-along[0]) + "," + real(-along[1]) + "," + real(-along[2]) + "))");
    }
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) add_face(axis, side);
    return text_;
  }

 private:
  static std::string real(double value) {
    const std::string text = std::to_string(value);
    return text.find('.') == std::string::npos ? text + "." : text;
  }
  void add(int number, const std::string& statement) {
    text_ += "#" + std::to_string(number) + "=" + statement + ";\n";
  }
  void add_corner(int corner) {
    std::string place;
    for (int axis = 0; axis < 3; ++axis)
      place += (axis > 0 ? "," : "") + real((corner >> axis & 1) != 0 ? size_[static_cast<std::size_t>(axis)] : 0);
    add(200 + corner, "CARTESIAN_POINT('',(" + place + "))");
    add(210 + corner, "VERTEX_POINT('',#" + std::to_string(200 + corner) + ")");
  }
  int edge(int from, int to) {
    const auto ends = std::minmax(from, to);
    const auto known = edges_.find(ends);
    if (known != edges_.end()) return known->second;
    const int number = 300 + 2 * static_cast<int>(edges_.size()), bit = ends.first ^ ends.second;
    const int axis = bit == 1 ? 0 : bit == 2 ? 1 : 2;
    add(number, "LINE('',#" + std::to_string(200 + ends.first) + ",#" + std::to_string(364 + axis) + ")");
    add(number + 1, "EDGE_CURVE('',#" + std::to_string(210 + ends.first) + ",#" + std::to_string(210 + ends.second) +
                        ",#" + std::to_string(number) + ",.T.)");
    return edges_[ends] = number + 1;
  }
  void add_face(int axis, int side) {
    const int one = 1 << (axis + 1) % 3, other = 1 << (axis + 2) % 3, at = side << axis;
    // Counterclockwise as seen from outside.
    std::array<int, 4> ring{at, at | one, at | one | other, at | other};
    if (side == 0) std::swap(ring[1], ring[3]);
    const int face = left_face + 2 * axis + side, base = 400 + 20 * (2 * axis + side);
    std::string loop;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int from = ring[i], to = ring[(i + 1) % ring.size()], number = base + static_cast<int>(i);
      add(number, "ORIENTED_EDGE('',*,*,#" + std::to_string(edge(from, to)) + (from < to ? ",.T.)" : ",.F.)"));
      loop += (i > 0 ? ",#" : "#") + std::to_string(number);
    }
    add(base + 4, "EDGE_LOOP('',(" + loop + "))");
    add(base + 5, "FACE_OUTER_BOUND('',#" + std::to_string(base + 4) + ",.T.)");
    add(base + 6, "AXIS2_PLACEMENT_3D('',#" + std::to_string(200 + at) + ",#" +
                      std::to_string((side == 1 ? 360 : 370) + axis) + ",#" + std::to_string(360 + (axis + 1) % 3) +
                      ")");
    add(base + 7, "PLANE('',#" + std::to_string(base + 6) + ")");
    add(face, "ADVANCED_FACE('',(#" + std::to_string(base + 5) + "),#" + std::to_string(base + 7) + ",.T.)");
  }

  const std::array<double, 3> size_;
  std::map<std::pair<int, int>, int> edges_;
  std::string text_;
};

}  // namespace step_box_detail

/// A solid whose shell has these faces. `statements` have numbers from 1000, and may refer to the shape #10, its
/// representation #50 in the context #30, the unit of length #20 and degrees #26.
inline std::string step_solid(const std::string& shell, const std::string& faces, const std::string& statements,
                              bool in_inches) {
  const std::string millimetre = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n";
  const std::string inch =
      "(CONVERSION_BASED_UNIT('INCH',#23)LENGTH_UNIT()NAMED_UNIT(#24));\n"
      "#23=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#25);\n"
      "#24=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n#25=" +
      millimetre;
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
         "FILE_SCHEMA(('AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }'));\nENDSEC;\nDATA;\n"
         "#1=APPLICATION_CONTEXT('managed model based 3d engineering');\n"
         "#2=PRODUCT_CONTEXT('',#1,'mechanical');\n#3=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');\n"
         "#4=PRODUCT('box','box','',(#2));\n#5=PRODUCT_DEFINITION_FORMATION('','',#4);\n"
         "#6=PRODUCT_DEFINITION('design','',#5,#3);\n#10=PRODUCT_DEFINITION_SHAPE('','',#6);\n"
         "#11=SHAPE_DEFINITION_REPRESENTATION(#10,#50);\n#20=" +
         (in_inches ? inch : millimetre) +
         "#21=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
         "#22=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n"
         "#26=(CONVERSION_BASED_UNIT('DEGREE',#27)NAMED_UNIT(#28)PLANE_ANGLE_UNIT());\n"
         "#27=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295),#21);\n"
         "#28=DIMENSIONAL_EXPONENTS(0.,0.,0.,0.,0.,0.,0.);\n"
         "#29=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-5),#20,'distance_accuracy_value','');\n"
         "#30=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#29))"
         "GLOBAL_UNIT_ASSIGNED_CONTEXT((#20,#21,#22))REPRESENTATION_CONTEXT('',''));\n"
         "#50=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#52),#30);\n"
         "#52=MANIFOLD_SOLID_BREP('',#53);\n#53=CLOSED_SHELL('',(" +
         shell + "));\n" + faces + statements + "ENDSEC;\nEND-ISO-10303-21;\n";
}

/// A box with its least corner at the origin.
inline std::string step_box(const std::array<double, 3>& size, const std::string& statements, bool in_inches = false) {
  return step_solid("#101,#102,#103,#104,#105,#106", step_box_detail::Writer(size).faces(), statements, in_inches);
}

/// A cylinder, or a cone that becomes narrower, from the origin along z.
inline std::string step_frustum(double radius, double top, double height, const std::string& statements) {
  const std::string r = std::to_string(radius), t = std::to_string(top), h = std::to_string(height);
  const std::string surface = top == radius ? "CYLINDRICAL_SURFACE('',#220," + r + ")"
                                            : "CONICAL_SURFACE('',#222," + r + "," +
                                                  step_box_detail::exact(std::atan((radius - top) / height)) + ")";
  return step_solid(
      "#105,#106,#107",
      "#200=CARTESIAN_POINT('',(0.,0.,0.));\n#201=CARTESIAN_POINT('',(0.,0.," + h + "));\n#202=CARTESIAN_POINT('',(" +
          r + ",0.,0.));\n#203=CARTESIAN_POINT('',(" + t + ",0.," + h +
          "));\n#204=DIRECTION('',(0.,0.,1.));\n#205=DIRECTION('',(1.,0.,0.));\n#206=DIRECTION('',(0.,0.,-1.));\n"
          "#210=VERTEX_POINT('',#202);\n#211=VERTEX_POINT('',#203);\n"
          "#220=AXIS2_PLACEMENT_3D('',#200,#204,#205);\n#221=AXIS2_PLACEMENT_3D('',#201,#204,#205);\n"
          "#222=AXIS2_PLACEMENT_3D('',#200,#206,#205);\n#230=CIRCLE('',#220," +
          r + ");\n#231=CIRCLE('',#221," + t + ");\n#207=DIRECTION('',(" + std::to_string(top - radius) + ",0.," + h +
          "));\n#232=VECTOR('',#207,1.);\n#233=LINE('',#202,#232);\n#240=EDGE_CURVE('',#210,#210,#230,.T.);\n"
          "#241=EDGE_CURVE('',#211,#211,#231,.T.);\n#242=EDGE_CURVE('',#210,#211,#233,.T.);\n"
          "#250=ORIENTED_EDGE('',*,*,#240,.T.);\n#251=ORIENTED_EDGE('',*,*,#242,.T.);\n"
          "#252=ORIENTED_EDGE('',*,*,#241,.F.);\n#253=ORIENTED_EDGE('',*,*,#242,.F.);\n"
          "#254=ORIENTED_EDGE('',*,*,#240,.F.);\n#255=ORIENTED_EDGE('',*,*,#241,.T.);\n"
          "#260=EDGE_LOOP('',(#250,#251,#252,#253));\n#261=EDGE_LOOP('',(#254));\n#262=EDGE_LOOP('',(#255));\n"
          "#270=FACE_OUTER_BOUND('',#260,.T.);\n#271=FACE_OUTER_BOUND('',#261,.T.);\n"
          "#272=FACE_OUTER_BOUND('',#262,.T.);\n#280=" +
          surface +
          ";\n#281=PLANE('',#222);\n#282=PLANE('',#221);\n#107=ADVANCED_FACE('',(#270),#280,.T.);\n"
          "#105=ADVANCED_FACE('',(#271),#281,.T.);\n#106=ADVANCED_FACE('',(#272),#282,.T.);\n",
      statements, false);
}

inline std::string step_shaft(double radius, double height, const std::string& statements) {
  return step_frustum(radius, radius, height, statements);
}

/// A ball about the origin, or a ring about z, of one face.
inline std::string step_ball(double radius, const std::string& statements, double ring = 0) {
  const std::string r = std::to_string(radius), wide = std::to_string(ring + radius);
  return step_solid("#107",
                    "#200=CARTESIAN_POINT('',(0.,0.,0.));\n#204=DIRECTION('',(0.,0.,1.));\n"
                    "#205=DIRECTION('',(1.,0.,0.));\n#220=AXIS2_PLACEMENT_3D('',#200,#204,#205);\n"
                    "#202=CARTESIAN_POINT('',(" +
                        wide +
                        ",0.,0.));\n#210=VERTEX_POINT('',#202);\n#260=VERTEX_LOOP('',#210);\n"
                        "#270=FACE_OUTER_BOUND('',#260,.T.);\n#280=" +
                        (ring > 0 ? "TOROIDAL_SURFACE('',#220," + std::to_string(ring) + "," + r + ")"
                                  : "SPHERICAL_SURFACE('',#220," + r + ")") +
                        ";\n#107=ADVANCED_FACE('',(#270),#280,.T.);\n",
                    statements, false);
}

/// A shape aspect with this number that is a face of the box; takes the next number, too.
inline std::string step_aspect(int number, int face, const std::string& keyword = "SHAPE_ASPECT") {
  const std::string own = std::to_string(number);
  return "#" + own + "=" + keyword + "('','',#10,.T.);\n#" + std::to_string(number + 1) +
         "=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#" + own + ",#50,#" + std::to_string(face) + ");\n";
}

/// A length in the unit of the file, as an item of a representation.
inline std::string step_length(int number, const std::string& value, const std::string& name,
                               const std::string& more = "") {
  return "#" + std::to_string(number) +
         "=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(LENGTH_MEASURE(" + value +
         "),#20)" + more + "REPRESENTATION_ITEM('" + name + "'));\n";
}

/// The number of the edge between two corners of the box. Corners are numbered by bits: 1 right, 2 back, 4 top.
inline int step_box_edge(int from, int to) {
  const std::string text = step_box_detail::Writer({1, 1, 1}).faces();
  const std::size_t at =
      text.find("=EDGE_CURVE('',#" + std::to_string(210 + from) + ",#" + std::to_string(210 + to) + ",");
  return std::stoi(text.substr(text.rfind('#', at) + 1));
}

/// A datum target that is a circle of 4 about a place, in the unit of the file; takes ten numbers.
inline std::string step_target(int number, const std::string& name, const std::array<double, 3>& place) {
  const auto n = [number](int more) { return "#" + std::to_string(number + more); };
  std::string at;
  for (const double x : place) at += (at.empty() ? "" : ",") + std::to_string(x);
  return n(0) + "=PLACED_DATUM_TARGET_FEATURE('','circle',#10,.T.,'" + name + "');\n" + n(1) +
         "=PROPERTY_DEFINITION('',''," + n(0) + ");\n" + n(2) + "=SHAPE_DEFINITION_REPRESENTATION(" + n(1) + "," +
         n(3) + ");\n" + n(3) + "=SHAPE_REPRESENTATION_WITH_PARAMETERS('',(" + n(4) + "," + n(5) + "),#30);\n" +
         step_length(number + 4, "4.", "target diameter") + n(5) + "=AXIS2_PLACEMENT_3D('orientation'," + n(6) + "," +
         n(7) + "," + n(8) + ");\n" + n(6) + "=CARTESIAN_POINT('',(" + at + "));\n" + n(7) +
         "=DIRECTION('',(0.,0.,1.));\n" + n(8) + "=DIRECTION('',(1.,0.,0.));\n";
}

/// The values of a dimension, which are statements of these numbers, separated by commas; takes two numbers.
inline std::string step_values(int number, int dimension, const std::string& items) {
  const std::string own = std::to_string(number);
  return "#" + own + "=SHAPE_DIMENSION_REPRESENTATION('',(" + items + "),#30);\n#" + std::to_string(number + 1) +
         "=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#" + std::to_string(dimension) + ",#" + own + ");\n";
}

}  // namespace epura::test
