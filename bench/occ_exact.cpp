// SPDX-License-Identifier: Apache-2.0
// Open CASCADE's exact hidden-line removal of the bodies of `epura study paper`, in its isometric view:
//   occ_exact MESH.off LINES.txt
// reads bodies.txt beside the mesh, and writes visible lines as text. Exit code 77: it has no such surface.
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdio>
#include <filesystem>
#include <gp_Ax2.hxx>
#include <optional>
#include <sstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "part_geometry.hpp"
#include "rows.hpp"
#include "say.hpp"

namespace {

using namespace epura;

constexpr int cannot_draw = 77;
constexpr double curve_fineness = 1e7;

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

// Bodies that cross are one, so that there are edges where they do.
std::optional<TopoDS_Shape> make_all(const std::string& text) {
  std::optional<TopoDS_Shape> all;
  for (const std::string_view row : split(text, '\n')) {
    if (row.empty()) continue;
    const auto body = make_body(std::string(row));
    if (!body) return std::nullopt;
    all = all ? BRepAlgoAPI_Fuse(*all, *body).Shape() : *body;
  }
  return all;
}

int draw(const std::filesystem::path& mesh, const char* file) {
  const std::string bodies = read_file(mesh.parent_path() / "bodies.txt");
  const double start = bench::now();
  const auto all = make_all(bodies);
  if (!all) return cannot_draw;
  const double made = bench::now();
  const bench::ExactView view = bench::exact_view(*all, {1, -1, 1}, curve_fineness);
  bench::say_seconds("read", made - start);
  bench::say_seconds("hlr", bench::now() - made);
  write_file(file, bench::rows_of(view.visible));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: occ_exact MESH.off LINES.txt\n", stderr);
    return static_cast<int>(ErrorKind::input);
  }
  try {
    return draw(argv[1], argv[2]);
  } catch (const Error& error) {
    std::fprintf(stderr, "occ_exact: %s\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "occ_exact: %s\n", failure.GetMessageString());
    return static_cast<int>(ErrorKind::input);
  }
}
