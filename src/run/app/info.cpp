// SPDX-License-Identifier: Apache-2.0
// epura info MODEL...: describes model files.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "base/groups.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "composition/requirement_words.hpp"
#include "features/unit_guess.hpp"
#include "importer/assemble.hpp"
#include "importer/read_model.hpp"
#include "output/json_text.hpp"
#include "pipeline/targets.hpp"
#include "scene/choices.hpp"
#include "sheet/notation.hpp"
#include "surfaces/numbers.hpp"
#include "surfaces/recognise.hpp"
#include "world/mass.hpp"

namespace epura {

namespace {

using importer::TreePart;
using Lines = std::vector<std::string>;

/// Groups parts by parent: parts without a parent come first.
Groups<int> children_of(const std::vector<TreePart>& tree) {
  return {tree.size() + 1, [&](const auto& visit) {
            for (std::size_t i = 0; i < tree.size(); ++i)
              visit(static_cast<std::size_t>(tree[i].parent + 1), static_cast<int>(i));
          }};
}

std::string sizes_of(const TreePart& part) {
  std::string text;
  if (part.bodies > 1) text += ", " + std::to_string(part.bodies) + " bodies";
  if (part.faces > 0) text += ", " + std::to_string(part.faces) + (part.faces == 1 ? " face" : " faces");
  return text;
}

/// Equal parts under one parent: their number, name and sizes, and the lines below them.
struct TreeRow {
  int count;
  const TreePart* part;
  Lines below;
};

Lines lines_of_rows(const std::vector<TreeRow>& rows) {
  Lines lines;
  for (const TreeRow& row : rows) {
    lines.push_back((row.part->name.empty() ? "(no name)" : row.part->name) +
                    (row.count > 1 ? " x " + std::to_string(row.count) : "") + sizes_of(*row.part));
    for (const std::string& line : row.below) lines.push_back("  " + line);
  }
  return lines;
}

void add_row(std::vector<TreeRow>& rows, const TreePart& part, Lines below) {
  const auto same = std::find_if(rows.begin(), rows.end(), [&](const TreeRow& row) {
    return row.part->name == part.name && sizes_of(*row.part) == sizes_of(part) && row.below == below;
  });
  if (same != rows.end())
    ++same->count;
  else
    rows.push_back({1, &part, std::move(below)});
}

/// Returns lines indented by two spaces per level. Parts under one parent that are equal, including everything below
/// them, share a line: "bolt x 3, 7 faces".
std::vector<std::string> tree_lines(const std::vector<TreePart>& tree) {
  // Children follow their parents, so that in reverse order everything below a part is known.
  std::vector<Lines> below(tree.size() + 1);
  const Groups<int> children = children_of(tree);
  for (std::size_t parent = tree.size() + 1; parent-- > 0;) {
    std::vector<TreeRow> rows;
    for (const int child : children[parent])
      add_row(rows, tree[static_cast<std::size_t>(child)], std::move(below[static_cast<std::size_t>(child) + 1]));
    below[parent] = lines_of_rows(rows);
  }
  return below[0];
}

/// Returns a list of {"name", "bodies", "faces", "parts"}.
std::string tree_json(const std::vector<TreePart>& tree) {
  std::vector<std::string> parts(tree.size() + 1);
  const Groups<int> children = children_of(tree);
  for (std::size_t parent = tree.size() + 1; parent-- > 0;)
    parts[parent] = output::json_list(children[parent], [&](int child) {
      const TreePart& part = tree[static_cast<std::size_t>(child)];
      return "{\"name\": " + output::json_string(part.name) + ", \"bodies\": " + std::to_string(part.bodies) +
             ", \"faces\": " + std::to_string(part.faces) +
             ", \"parts\": " + parts[static_cast<std::size_t>(child) + 1] + "}";
    });
  return parts[0];
}

using output::json_list;
using output::json_number;
using output::json_string;
using output::json_vector;

constexpr std::size_t max_positions = 4;
constexpr std::size_t max_radii = 12;

/// Information about one model.
struct ModelInfo {
  mesh::MeshReport report;
  Box box;
  std::optional<double> unit;        ///< millimetres, as stated by the file
  std::optional<Unit> guessed_unit;  ///< most likely unit if the file does not state it
  surfaces::PartFaces part;
  int shared_borders = 0;    ///< edges of the part along which three or more faces of a body meet
  bool is_declared = false;  ///< faces are declared by the file; otherwise recognised
  std::vector<surfaces::Hole> holes;
  std::vector<importer::TreePart> tree;
  std::vector<importer::ModelRequirement> requirements;
  std::vector<importer::SavedView> saved_views;
  std::string standard;                         ///< of dimensions and tolerances, named by the file
  std::vector<world::Solid> solids;             ///< in millimetres if the unit is known, or else in that of the file
  std::optional<world::MassProperties> mass{};  ///< of all bodies, if they are closed
  std::vector<int> face_numbers{};              ///< of the faces of the part
  std::vector<Vec3> face_middles{};             ///< likewise

  [[nodiscard]] bool closed() const { return report.triangles > 0 && report.open_edges == 0; }
};

// Bodies with millimetres as the unit of length if the file states its unit.
void measure(ModelInfo& info, const mesh::Mesh& mesh, std::optional<double> density) {
  const double scale = info.unit.value_or(1);
  Mat4 to_millimetres(scale);
  to_millimetres[3][3] = 1;
  info.solids = world::solids_of(mesh, to_millimetres);
  const bool closed = std::all_of(info.solids.begin(), info.solids.end(),
                                  [](const world::Solid& solid) { return solid.fault.empty(); });
  if (!closed || info.solids.empty()) return;
  info.mass = world::sum_of(info.solids, std::vector<double>(info.solids.size(), density.value_or(0)));
}

int count_borders(const surfaces::PartFaces& part, surfaces::BorderKind kind) {
  return static_cast<int>(std::count_if(part.borders.begin(), part.borders.end(),
                                        [&](const surfaces::PartBorder& b) { return b.kind == kind; }));
}

// Where three or more faces of a body meet, their border is none of two faces, but ends nothing.
int count_shared(const mesh::Mesh& mesh, const surfaces::PartFaces& part) {
  const auto is_shared = [&](const surfaces::PartBorder& border) {
    return border.kind == surfaces::BorderKind::open &&
           std::all_of(border.edges.begin(), border.edges.end(),
                       [&](int e) { return mesh.edges[static_cast<std::size_t>(e)].count > 2; });
  };
  return static_cast<int>(std::count_if(part.borders.begin(), part.borders.end(), is_shared));
}

ModelInfo info_of(const std::string& path, const InfoOptions& options) {
  const importer::ModelRequest request = importer::parse_model_request(path);
  const importer::ReadModel read =
      importer::read_model(request.path, request.parameters, {.plugin_path = options.plugin_path});
  const mesh::Mesh& mesh = read.mesh;
  ModelInfo info{mesh.report, features::box_of(mesh), read.unit,        std::nullopt,  {}, 0, false, {},
                 read.tree,   read.requirements,      read.saved_views, read.standard, {}};
  info.part = read.part != nullptr ? *read.part : surfaces::recognise_faces(mesh);
  info.shared_borders = count_shared(mesh, info.part);
  info.is_declared = read.part != nullptr;
  info.report.name = request.path;
  info.holes = surfaces::find_holes(mesh, info.part);
  info.face_middles = surfaces::middles_of_faces(mesh, info.part);
  info.face_numbers = surfaces::numbers_in(surfaces::numbered_faces(info.part, info.face_middles));
  if (!read.unit) info.guessed_unit = features::guess_unit(info.box, info.part);
  measure(info, mesh, options.density);
  return info;
}

/// Formats numbers with as many decimals as the precision of the file justifies.
class Rounded {
 public:
  explicit Rounded(double tolerance) : decimals_(std::floor(-std::log10(2 * tolerance))) {}

  std::string operator()(double value) const {
    constexpr int max_decimals = 9, digits = 7;
    if (std::abs(value) < std::pow(10, -decimals_) / 2) value = 0;
    const bool readable = decimals_ <= max_decimals && std::abs(value) < 1e9;
    return readable ? format_fixed(value, std::max(static_cast<int>(decimals_), 0)) : format_rounded(value, digits);
  }
  std::string operator()(const Vec3& p) const {
    return "(" + (*this)(p.x) + ", " + (*this)(p.y) + ", " + (*this)(p.z) + ")";
  }

 private:
  double decimals_;
};

std::string counted(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string percent(double share) { return format_fixed(100 * share, 1) + " %"; }

std::string line_of(std::string key, const std::string& value) {
  key.resize(std::max<std::size_t>(10, key.size() + 1), ' ');
  return "  " + key + one_line(value) + "\n";
}

// The direction of an axis, with a normalised sign, which is irrelevant for a hole.
std::string axis_text(Vec3 axis) {
  const auto names = {std::pair("x", Vec3(1, 0, 0)), std::pair("y", Vec3(0, 1, 0)), std::pair("z", Vec3(0, 0, 1))};
  for (const auto& [name, along] : names)
    if (std::abs(glm::dot(axis, along)) > 1 - 1e-9) return name;
  const double leading = std::abs(axis.z) > 1e-9 ? axis.z : std::abs(axis.y) > 1e-9 ? axis.y : axis.x;
  if (leading < 0) axis = -axis;
  return Rounded(5e-5)(axis);
}

std::string bodies_text(const ModelInfo& info) {
  const mesh::MeshReport& report = info.report;
  if (report.triangles == 0) return "none";
  std::string text = std::to_string(report.bodies) + ", ";
  if (info.closed())
    text += "closed";
  else
    text += "open: " + counted(report.open_edges, "edge with one face", "edges with one face");
  if (report.non_manifold_edges > 0)
    text +=
        ", " + counted(report.non_manifold_edges, "edge with three or more faces", "edges with three or more faces");
  return text;
}

// "R 3.5 (6), R 18": the characteristic sizes of a kind of surface, and how often each occurs.
std::string radii_text(const surfaces::PartFaces& part, surfaces::SurfaceKind kind, const Rounded& rounded) {
  std::map<std::pair<double, double>, std::pair<std::string, int>> radii;
  for (const surfaces::PartFace& face : part.faces) {
    if (face.surface.kind != kind) continue;
    const surfaces::PartSurface& s = face.surface;
    std::string text = "R " + rounded(s.radius);
    std::pair key{s.radius, s.minor};
    if (kind == surfaces::SurfaceKind::torus) text += " r " + rounded(s.minor);
    if (kind == surfaces::SurfaceKind::cone) {
      const double angle = portable_atan2(std::abs(s.slope), 1) * (360 / std::numbers::pi);
      text = format_fixed(angle, 2) + "\u00b0";
      key = {angle, 0};
    }
    const auto same = std::find_if(radii.begin(), radii.end(), [&](const auto& r) { return r.second.first == text; });
    if (same != radii.end())
      ++same->second.second;
    else
      radii[key] = {text, 1};
  }
  std::string text;
  std::size_t listed = 0;
  for (const auto& [key, radius] : radii) {
    if (++listed > max_radii) return text + ", ...";
    append_to_list(text, radius.first);
    if (radius.second > 1) text += " (" + std::to_string(radius.second) + ")";
  }
  return text;
}

// Volume, surface, centre of gravity and, with a density, mass; or why there is none.
std::string mass_lines(const ModelInfo& info, const Rounded& rounded) {
  constexpr int digits = 6;
  if (info.solids.empty()) return {};
  if (!info.mass) {
    for (const world::Solid& solid : info.solids)
      if (!solid.fault.empty())
        return line_of("volume",
                       "none, as body " + std::to_string(solid.body) + " is not a closed solid: " + solid.fault);
  }
  const std::string unit = info.unit ? " mm" : "";
  std::string text =
      line_of("volume", format_rounded(info.mass->volume, digits) + (info.unit ? " mm³" : "") + ", surface " +
                            format_rounded(info.mass->area, digits) + (info.unit ? " mm²" : ""));
  text += line_of("centre", rounded(info.mass->centre) + unit + ", of gravity");
  if (info.mass->mass)
    text += line_of("mass", sheet::mass_text(*info.mass->mass, DecimalSign::point) +
                                (info.unit ? "" : ", if the unit of the file is mm"));
  return text;
}

std::string faces_text(const ModelInfo& info, const Rounded& rounded) {
  if (info.part.faces.empty()) return line_of("faces", "no surfaces of a part recognised");
  constexpr std::array kinds{surfaces::SurfaceKind::plane, surfaces::SurfaceKind::cylinder,
                             surfaces::SurfaceKind::cone,  surfaces::SurfaceKind::sphere,
                             surfaces::SurfaceKind::torus, surfaces::SurfaceKind::free_form};
  constexpr std::array one{"plane", "cylinder", "cone", "sphere", "torus", "free form"};
  constexpr std::array many{"planes", "cylinders", "cones", "spheres", "tori", "free forms"};
  std::string text = line_of("faces", std::to_string(info.part.faces.size()) + "; " + percent(info.part.recognised) +
                                          (info.is_declared ? " of the area is plane or round, as the file says"
                                                            : " of the area is recognised"));
  int before = 0;  // faces are numbered kind by kind
  for (const surfaces::SurfaceKind kind : kinds) {
    const auto k = static_cast<std::size_t>(kind);
    const auto count = static_cast<int>(std::count_if(info.part.faces.begin(), info.part.faces.end(),
                                                      [&](const auto& f) { return f.surface.kind == kind; }));
    if (count == 0) continue;
    std::string what = counted(count, one[k], many[k]);
    if (kind != surfaces::SurfaceKind::plane && kind != surfaces::SurfaceKind::free_form)
      what += ": " + radii_text(info.part, kind, rounded);
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), before + 1);
    what += "; " + surfaces::numbers_text("face", numbers);
    before += count;
    text += line_of("", what);
  }
  return text;
}

int count_open(const ModelInfo& info) {
  return count_borders(info.part, surfaces::BorderKind::open) - info.shared_borders;
}

std::string edges_text(const ModelInfo& info) {
  std::string text = std::to_string(count_borders(info.part, surfaces::BorderKind::sharp)) + " sharp, " +
                     std::to_string(count_borders(info.part, surfaces::BorderKind::tangent)) + " tangent";
  if (const int open = count_open(info); open > 0) text += ", " + std::to_string(open) + " open";
  if (info.shared_borders > 0) text += ", " + std::to_string(info.shared_borders) + " of three or more faces";
  return text;
}

std::string hole_text(const surfaces::Hole& hole, const Rounded& rounded) {
  std::string text;
  for (const double diameter : hole.diameters) text += (text.empty() ? "\u00d8" : ", \u00d8") + rounded(diameter);
  const double length = glm::distance(hole.from, hole.to);
  text += hole.through ? ", through, " : ", blind, ";
  return text + rounded(length) + " long, along " + axis_text((hole.to - hole.from) / length);
}

// Equal holes share a line.
std::string holes_text(const std::vector<surfaces::Hole>& holes, const Rounded& rounded) {
  if (holes.empty()) return line_of("holes", "none");
  struct Equal {
    std::string text;
    std::vector<int> numbers;
    std::vector<Vec3> positions;
  };
  std::vector<Equal> groups;
  const std::vector<int> order = surfaces::numbered_holes(holes);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const surfaces::Hole& hole = holes[static_cast<std::size_t>(order[i])];
    const std::string text = hole_text(hole, rounded);
    auto same = std::find_if(groups.begin(), groups.end(), [&](const Equal& one) { return one.text == text; });
    if (same == groups.end()) same = groups.insert(groups.end(), {text, {}, {}});
    same->numbers.push_back(static_cast<int>(i) + 1);
    same->positions.push_back(surfaces::mouth_of(hole));
  }
  std::string text = line_of("holes", std::to_string(holes.size()));
  for (const auto& [what, numbers, positions] : groups) {
    std::string line = surfaces::numbers_text("hole", numbers) + ": " +
                       (positions.size() > 1 ? std::to_string(positions.size()) + " x " + what : what);
    for (std::size_t i = 0; i < std::min(positions.size(), max_positions); ++i)
      line += (i == 0 ? ", from " : ", ") + rounded(positions[i]);
    if (positions.size() > max_positions) line += ", ...";
    text += line_of("", line);
  }
  return text;
}

std::vector<std::string> repairs_of(const mesh::MeshReport& report) {
  std::vector<std::string> repairs;
  const auto add = [&](int count, const std::string& one, const std::string& many) {
    if (count > 0) repairs.push_back(counted(count, one, many));
  };
  // Triangles of an STL file have separate corners: merging these is part of reading, not a repair.
  if (report.format != "stl") add(report.welded_vertices, "vertex joined", "vertices joined");
  add(report.dropped_degenerate, "face without area left out", "faces without area left out");
  add(report.dropped_duplicates, "duplicate face left out", "duplicate faces left out");
  add(report.dropped_non_finite, "face with non-finite coordinates left out",
      "faces with non-finite coordinates left out");
  add(report.misoriented_edges, "edge between inconsistently oriented faces",
      "edges between inconsistently oriented faces");
  repairs.insert(repairs.end(), report.notes.begin(), report.notes.end());
  repairs.insert(repairs.end(), report.remarks.begin(), report.remarks.end());
  return repairs;
}

std::string saved_views_text(const std::vector<importer::SavedView>& views) {
  std::string names;
  for (const importer::SavedView& view : views) append_to_list(names, view.name);
  return counted(static_cast<int>(views.size()), "view", "views") + ": " + names;
}

std::string text_of(const ModelInfo& info) {
  const mesh::MeshReport& report = info.report;
  const Rounded rounded(info.part.tolerance);
  std::string format = report.format;
  std::transform(format.begin(), format.end(), format.begin(),
                 [](char c) { return 'a' <= c && c <= 'z' ? char(c - 32) : c; });
  std::string text = one_line(report.name) + "\n";
  const int pieces = report.wires - report.point_arms;
  text += line_of("file", format + (report.single_precision ? ", 32-bit coordinates" : "") +
                              (report.resolution > 0 ? ", rounded to " + format_rounded(report.resolution, 3) : "") +
                              ", " + counted(report.vertices, "vertex", "vertices") + ", " +
                              counted(report.faces, "face", "faces") + ", " +
                              counted(report.triangles, "triangle", "triangles") +
                              (pieces > 0 ? ", " + counted(pieces, "piece", "pieces") + " of lines" : "") +
                              (report.points > 0 ? ", " + counted(report.points, "point", "points") : ""));
  if (!info.box.empty()) {
    const Vec3 size = info.box.size();
    text += line_of("box", rounded(size.x) + " x " + rounded(size.y) + " x " + rounded(size.z) + ", from " +
                               rounded(info.box.min) + " to " + rounded(info.box.max));
  }
  text += line_of("unit", info.unit ? format_number(*info.unit) + " mm, known from the file"
                          : info.guessed_unit
                              ? "not in the file; probably " + std::string(scene::word_of(*info.guessed_unit))
                              : "not in the file");
  text += line_of("bodies", bodies_text(info));
  text += mass_lines(info, rounded);
  if (info.tree.size() > 1) {
    const std::vector<std::string> lines = tree_lines(info.tree);
    for (std::size_t i = 0; i < lines.size(); ++i) text += line_of(i == 0 ? "parts" : "", lines[i]);
  }
  text += faces_text(info, rounded);
  if (!info.part.faces.empty()) {
    text += line_of("edges", edges_text(info));
    text += holes_text(info.holes, rounded);
  }
  for (const auto& [kind, line] : pipeline::requirement_lines(info.requirements)) text += line_of(kind, line);
  if (!info.standard.empty()) text += line_of("standard", info.standard);
  if (!info.saved_views.empty()) text += line_of("saved", saved_views_text(info.saved_views));
  std::vector<std::string> repairs = repairs_of(report);
  for (const world::Solid& solid : info.solids)
    if (solid.turned)
      repairs.push_back("body " + std::to_string(solid.body) +
                        " is turned inside out; its volume is that of the body turned back");
  text += line_of("repairs", repairs.empty() ? "none" : repairs.front());
  for (std::size_t i = 1; i < repairs.size(); ++i) text += line_of("", repairs[i]);
  return text;
}

// JSON. Areas of huge models may exceed the range of doubles: null.

std::string json_of(const surfaces::PartFace& face, int face_number, const Vec3& middle) {
  const surfaces::PartSurface& s = face.surface;
  std::string text = "{\"number\": " + std::to_string(face_number) + ", \"middle\": " + json_vector(middle) +
                     ", \"kind\": " + json_string(surfaces::surface_kind_names[static_cast<std::size_t>(s.kind)]) +
                     ", \"body\": " + std::to_string(face.body) + ", \"triangles\": " + std::to_string(face.triangles) +
                     ", \"area\": " + json_number(face.area);
  if (s.kind == surfaces::SurfaceKind::free_form) return text + "}";
  text += ", \"origin\": " + json_vector(s.origin);
  if (s.kind != surfaces::SurfaceKind::sphere) text += ", \"axis\": " + json_vector(s.axis);
  if (s.kind != surfaces::SurfaceKind::plane) text += ", \"radius\": " + json_number(s.radius);
  if (s.kind == surfaces::SurfaceKind::torus) text += ", \"tube_radius\": " + json_number(s.minor);
  if (s.kind == surfaces::SurfaceKind::cone) text += ", \"slope\": " + json_number(s.slope);
  if (face.sweep > 0)
    text += ", \"along\": [" + json_number(face.from) + ", " + json_number(face.to) +
            "], \"sweep\": " + json_number(face.sweep);
  if (s.kind != surfaces::SurfaceKind::plane)
    text += std::string(", \"inwards\": ") + (face.inwards ? "true" : "false");
  return text + ", \"residual\": " + json_number(face.residual) + ", \"sagitta\": " + json_number(face.sagitta) + "}";
}

std::string json_of(const surfaces::Hole& hole, int hole_number) {
  return "{\"number\": " + std::to_string(hole_number) + ", \"diameters\": " + json_list(hole.diameters, json_number) +
         ", \"from\": " + json_vector(hole.from) + ", \"to\": " + json_vector(hole.to) +
         ", \"through\": " + (hole.through ? "true" : "false") +
         ", \"faces\": " + json_list(hole.faces, [](int f) { return std::to_string(f); }) + "}";
}

std::string json_of(const ModelInfo& info) {
  const mesh::MeshReport& report = info.report;
  const auto number = [](const char* key, int value) {
    return std::string(", \"") + key + "\": " + std::to_string(value);
  };
  const auto truth = [](bool value) { return value ? "true" : "false"; };
  std::string text = "{\"name\": " + json_string(report.name) + ", \"format\": " + json_string(report.format);
  text += number("vertices", report.vertices) + number("faces", report.faces) + number("triangles", report.triangles);
  if (report.wires > report.point_arms) text += number("wires", report.wires - report.point_arms);
  if (report.points > 0) text += number("points", report.points);
  text += std::string(", \"single_precision\": ") + truth(report.single_precision);
  text += ", \"resolution\": " + json_number(report.resolution);
  if (!info.box.empty())
    text += ",\n   \"box\": {\"min\": " + json_vector(info.box.min) + ", \"max\": " + json_vector(info.box.max) + "}";
  text += ",\n   \"unit\": " + (info.guessed_unit ? json_string(scene::word_of(*info.guessed_unit)) : "null");
  text += ", \"millimetres\": " + (info.unit ? json_number(*info.unit) : "null");
  text += number("bodies", report.bodies) + ", \"closed\": " + truth(info.closed()) +
          number("open_edges", report.open_edges) + number("non_manifold_edges", report.non_manifold_edges) +
          number("misoriented_edges", report.misoriented_edges);
  if (info.mass)
    text += ",\n   \"volume\": " + json_number(info.mass->volume) + ", \"area\": " + json_number(info.mass->area) +
            ", \"mass\": " + (info.mass->mass ? json_number(*info.mass->mass) : "null") +
            ", \"centre_of_gravity\": " + json_vector(info.mass->centre);
  text += ",\n   \"body_names\": " + json_list(info.report.body_names, json_string);
  if (!report.body_colours.empty()) {
    const auto colour = [](const std::optional<Colour>& c) { return c ? json_string(hexadecimal(*c)) : "null"; };
    text += ",\n   \"body_colours\": " + json_list(report.body_colours, colour);
  }
  text += ",\n   \"parts\": " + tree_json(info.tree);
  text += ",\n   \"tolerance\": " + json_number(info.part.tolerance) +
          ", \"recognised\": " + json_number(info.part.recognised);
  const auto as_it_is = [](const std::string& item) { return item; };
  std::vector<std::string> faces, holes;
  for (std::size_t i = 0; i < info.part.faces.size(); ++i)
    faces.push_back(json_of(info.part.faces[i], info.face_numbers[i], info.face_middles[i]));
  text += ",\n   \"part_faces\": " + json_list(faces, as_it_is, ",\n    ");
  text += ",\n   \"part_edges\": {\"sharp\": " + std::to_string(count_borders(info.part, surfaces::BorderKind::sharp)) +
          number("tangent", count_borders(info.part, surfaces::BorderKind::tangent)) +
          number("open", count_open(info)) + number("shared", info.shared_borders) + "}";
  const std::vector<int> hole_numbers = surfaces::numbers_in(surfaces::numbered_holes(info.holes));
  for (std::size_t i = 0; i < info.holes.size(); ++i) holes.push_back(json_of(info.holes[i], hole_numbers[i]));
  text += ",\n   \"holes\": " + json_list(holes, as_it_is, ",\n    ");
  if (!info.requirements.empty()) {
    text += ",\n   \"requirements\": {";
    for (std::size_t kind = 0; kind < importer::requirement_kind_names.size(); ++kind)
      text += (kind == 0 ? "" : ", ") + json_string(importer::requirement_kind_names[kind]) + ": " +
              std::to_string(count_of(info.requirements, static_cast<importer::RequirementKind>(kind)));
    text += "}";
    if (!info.standard.empty()) text += ", \"standard\": " + json_string(info.standard);
  }
  if (!info.saved_views.empty())
    text += ",\n   \"saved_views\": " +
            json_list(info.saved_views, [](const importer::SavedView& view) { return json_string(view.name); });
  return text + ",\n   \"repairs\": " + json_list(repairs_of(report), json_string) + "}";
}

}  // namespace

int info(const InfoOptions& options) {
  if (!options.json.empty()) pipeline::refuse_overwriting({options.json}, options.models);
  std::vector<ModelInfo> models;
  for (const std::string& model : options.models) models.push_back(info_of(model, options));
  if (!options.json.empty()) {
    const std::string list = json_list(
        models, [](const auto& m) { return json_of(m); }, ",\n  ");
    pipeline::write({options.json, "{\"epura_info\": 1, \"models\": " + list + "}\n"}, {});
  }
  if (options.json == "-") return 0;
  for (std::size_t i = 0; i < models.size(); ++i)
    std::fputs(((i > 0 ? "\n" : "") + text_of(models[i])).c_str(), stdout);
  return 0;
}

}  // namespace epura
