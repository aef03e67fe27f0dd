// SPDX-License-Identifier: Apache-2.0
#include "study_bodies.hpp"

#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <array>
#include <gp_Ax2.hxx>
#include <sstream>

#include "base/text.hpp"

namespace epura::bench {

namespace {

gp_Ax2 read_frame(std::istream& row) {
  std::array<double, 9> n{};
  for (double& number : n) row >> number;
  return {gp_Pnt(n[0], n[1], n[2]), gp_Dir(n[3], n[4], n[5]), gp_Dir(n[6], n[7], n[8])};
}

// Nothing for other kinds of bodies.
std::optional<TopoDS_Shape> make_body(const std::string& text) {
  std::istringstream row(text);
  std::string kind;
  double radius = 0, second = 0, height = 0;
  row >> kind >> radius;
  if (kind == "sphere") return BRepPrimAPI_MakeSphere(read_frame(row), radius).Shape();
  row >> second;
  if (kind == "torus") return BRepPrimAPI_MakeTorus(read_frame(row), radius, second).Shape();
  row >> height;
  if (kind != "frustum") return std::nullopt;
  const gp_Ax2 frame = read_frame(row);
  if (radius == second) return BRepPrimAPI_MakeCylinder(frame, radius, height).Shape();
  return BRepPrimAPI_MakeCone(frame, radius, second, height).Shape();
}

}  // namespace

std::optional<std::vector<TopoDS_Shape>> bodies_of(const std::string& text) {
  std::vector<TopoDS_Shape> bodies;
  for (const std::string_view row : split(text, '\n')) {
    if (row.empty()) continue;
    const auto body = make_body(std::string(row));
    if (!body) return std::nullopt;
    bodies.push_back(*body);
  }
  return bodies;
}

}  // namespace epura::bench
