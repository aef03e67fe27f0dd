// SPDX-License-Identifier: Apache-2.0
// Open CASCADE's exact hidden-line removal of the bodies of `epura study paper`, in its isometric view:
//   occ_exact MESH.off LINES.txt
// reads bodies.txt beside the mesh, and writes visible lines as text. Exit code 77: it has no such surface.
#include <BRepAlgoAPI_Fuse.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "base/file.hpp"
#include "part_geometry.hpp"
#include "rows.hpp"
#include "say.hpp"
#include "study_bodies.hpp"

namespace {

using namespace epura;

constexpr int cannot_draw = 77;
constexpr double curve_fineness = 1e7;

// Bodies that cross are one, so that there are edges where they do.
std::optional<TopoDS_Shape> make_all(const std::string& text) {
  const auto bodies = bench::bodies_of(text);
  if (!bodies) return std::nullopt;
  std::optional<TopoDS_Shape> all;
  for (const TopoDS_Shape& body : *bodies) all = all ? BRepAlgoAPI_Fuse(*all, body).Shape() : body;
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
