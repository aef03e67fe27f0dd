// SPDX-License-Identifier: Apache-2.0
#include "importer/assemble.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "importer/bounds.hpp"
#include "mesh/resolution.hpp"

namespace epura::importer {

namespace {

using surfaces::DeclaredEdge;
using surfaces::PartSurface;

Mat4 matrix_of(const std::array<double, 12>& t) {
  return rows({t[0], t[1], t[2], t[3]}, {t[4], t[5], t[6], t[7]}, {t[8], t[9], t[10], t[11]}, {0, 0, 0, 1});
}

/// Where a shape stands.
struct Occurrence {
  std::string name;  ///< of the node, or of what it is a piece of
  std::string part;  ///< name of the part, wherever it occurs
  int number;        ///< of the part in the tree
};

class Assembler {
 public:
  explicit Assembler(const Document& document) : document_(document) {
    result_.first_faces.resize(document.shapes.size());
    result_.places.resize(document.shapes.size());
  }

  Assembled assemble(const std::string& format) {
    result_.soup.format = format;
    result_.soup.notes = document_.notes;
    result_.soup.single_precision = document_.is_single_precision != 0;
    result_.soup.printed = document_.is_printed != 0;
    find_steps();
    if (document_.nodes.empty()) {
      for (const Shape& shape : document_.shapes) {
        place(shape, Mat4(1), {shape.name, shape.name, static_cast<int>(result_.tree.size())}, no_colour);
        add_to_tree({-1, shape.name}, &shape);
      }
    } else {
      place_nodes();
    }
    if (std::find(result_.part.face_of_polygon.begin(), result_.part.face_of_polygon.end(), -1) !=
        result_.part.face_of_polygon.end())
      result_.part = {};
    std::vector<std::optional<Colour>>& colours = result_.soup.body_colours;
    if (std::none_of(colours.begin(), colours.end(), [](const auto& colour) { return colour.has_value(); }))
      colours.clear();
    return std::move(result_);
  }

 private:
  // A program prints all shapes in one way, but quantises each by its own size. Surfaces of a part are exact.
  void find_steps() {
    mesh::Points all;
    for (const Shape& shape : document_.shapes)
      if (document_.is_printed != 0) all.insert(all.end(), shape.points.begin(), shape.points.end());
    const double of_all = mesh::resolution_of(all, false);
    for (const Shape& shape : document_.shapes) {
      const double told = is_fine(shape) ? shape.step : 0;
      const bool is_known = told > 0 || document_.is_printed != 0 || !shape.faces.empty();
      steps_.push_back(!is_known  ? mesh::resolution_of(shape.points, document_.is_single_precision != 0)
                       : told > 0 ? told
                                  : of_all);
    }
  }

  // Few steps are chosen ones, such as voxels; the coarsest grids of compressed meshes have a byte.
  static bool is_fine(const Shape& shape) {
    constexpr double fewest_steps = 100;
    Box box;
    for (const auto& [x, y, z] : shape.points) box.add(Vec3(x, y, z));
    if (box.empty()) return false;
    const Vec3 size = box.size();
    return std::max({size.x, size.y, size.z}) >= fewest_steps * shape.step;
  }

  void place_nodes() {
    std::vector<Mat4> to_file;  // parents come before their children
    std::vector<int> colours;
    const std::vector<int> named = named_nodes(), shapes = shapes_below_roots();
    for (std::size_t i = 0; i < document_.nodes.size(); ++i) {
      const Node& node = document_.nodes[i];
      const Mat4 own = matrix_of(node.transform);
      to_file.push_back(node.parent < 0 ? own : to_file[static_cast<std::size_t>(node.parent)] * own);
      add_to_tree({node.parent, name_of(node)}, shape_of(node));
      const int above = node.parent < 0 ? no_colour : colours[static_cast<std::size_t>(node.parent)];
      colours.push_back(above == no_colour ? node.colour : above);
      const Shape* shape = shape_of(node);
      if (shape != nullptr)
        place(*shape, to_file.back(), occurrence_of(static_cast<int>(i), named[i], shapes), colours.back());
    }
  }

  [[nodiscard]] const Shape* shape_of(const Node& node) const {
    return node.shape < 0 ? nullptr : &document_.shapes[static_cast<std::size_t>(node.shape)];
  }

  [[nodiscard]] const std::string& name_of(const Node& node) const {
    return node.name.empty() && node.shape >= 0 ? shape_of(node)->name : node.name;
  }

  /// The nearest node with a name for each: itself, or one above; -1: none.
  [[nodiscard]] std::vector<int> named_nodes() const {
    std::vector<int> named;
    for (const Node& node : document_.nodes)
      named.push_back(!name_of(node).empty() ? static_cast<int>(named.size())
                      : node.parent < 0      ? -1
                                             : named[static_cast<std::size_t>(node.parent)]);
    return named;
  }

  /// By root: the number of shapes at it and below it. 0 for other nodes.
  [[nodiscard]] std::vector<int> shapes_below_roots() const {
    std::vector<int> shapes(document_.nodes.size(), 0), roots;
    for (const Node& node : document_.nodes) {
      roots.push_back(node.parent < 0 ? static_cast<int>(roots.size()) : roots[static_cast<std::size_t>(node.parent)]);
      if (node.shape >= 0) ++shapes[static_cast<std::size_t>(roots.back())];
    }
    return shapes;
  }

  // What has no name is a piece of what is above it. What is above all is the whole file, and takes in only what is
  // alone in it.
  [[nodiscard]] Occurrence occurrence_of(int number, int named, const std::vector<int>& shapes) const {
    const Node& node = document_.nodes[static_cast<std::size_t>(number)];
    const std::string& part = shape_of(node)->name;
    if (named == number) return {name_of(node), part, number};
    const bool is_piece = named >= 0 && (document_.nodes[static_cast<std::size_t>(named)].parent >= 0 ||
                                         shapes[static_cast<std::size_t>(named)] == 1);
    if (!is_piece) return {{}, part, node.parent < 0 ? number : node.parent};
    const Node& whole = document_.nodes[static_cast<std::size_t>(named)];
    const Shape* own = shape_of(whole);
    return {name_of(whole), own != nullptr && !own->name.empty() ? own->name : name_of(whole), named};
  }

  void add_to_tree(TreePart part, const Shape* shape) {
    if (shape != nullptr) {
      part.bodies = std::max(1, static_cast<int>(shape->body_names.size()));
      part.faces = static_cast<int>(shape->faces.size());
    }
    result_.tree.push_back(std::move(part));
  }

  // Of polygons that need not be convex, as they are triangulated; lines and points count, too.
  static std::size_t triangles_of(const Shape& shape) {
    std::size_t count = shape.wire_vertices.size(), begin = 0;
    for (const int polygon_end : shape.polygon_ends) {
      const auto end = static_cast<std::size_t>(polygon_end);
      count += std::max<std::size_t>(end - begin, 3) - 2;
      begin = end;
    }
    return std::max(count, shape.points.size() / 3);
  }

  [[nodiscard]] std::size_t max_triangles() const {
    std::size_t most = max_copied_triangles;
    for (const Shape& shape : document_.shapes) most += triangles_of(shape);
    return most;
  }

  // `colour` takes precedence over those of the shape.
  void place(const Shape& shape, const Mat4& to_file, const Occurrence& occurrence, int colour) {
    placed_triangles_ += triangles_of(shape);
    if (placed_triangles_ > max_triangles_)
      throw Error(
          ErrorKind::input, "",
          "has more than " + format_number(max_copied_triangles / 1e6) + " million triangles in copies of its parts",
          "leave copies out, or export them with coarser facets");
    expect_room(result_.soup.corners.size() + shape.corners.size());
    expect_room(result_.soup.points.size() + shape.points.size());
    expect_room(result_.soup.wires.size() + shape.wire_vertices.size());
    const auto first_point = static_cast<int>(result_.soup.points.size());
    for (const auto& p : shape.points) {
      const Vec3 at(to_file * Vec4(p[0], p[1], p[2], 1));
      result_.soup.points.push_back({at.x, at.y, at.z});
    }
    const Mat3 turn(to_file);
    const double stretch = std::max({glm::length(turn[0]), glm::length(turn[1]), glm::length(turn[2])});
    const double step = steps_[static_cast<std::size_t>(&shape - document_.shapes.data())];
    result_.step = std::max(result_.step, step * stretch);
    add_polygons(shape, first_point, glm::determinant(turn) < 0);
    add_wires_and_points(shape, first_point);
    add_bodies(shape, occurrence);
    add_colours(shape, colour);
    add_part(shape, to_file, first_point);
  }

  static void expect_room(std::size_t items) {
    if (items > INT_MAX / 6)
      throw Error(ErrorKind::input, "", "puts down more corners than can be numbered", "split the model");
  }

  // A reflection turns faces inside out, so the order of their corners is reversed.
  void add_polygons(const Shape& shape, int first_point, bool is_mirrored) {
    std::vector<int>& corners = result_.soup.corners;
    const auto first_corner = static_cast<int>(corners.size());
    for (const int corner : shape.corners) corners.push_back(first_point + corner);
    int begin = first_corner;
    for (const int polygon_end : shape.polygon_ends) {
      const int end = first_corner + polygon_end;
      if (is_mirrored) std::reverse(corners.begin() + begin, corners.begin() + end);
      result_.soup.face_ends.push_back(end);
      begin = end;
    }
  }

  void add_wires_and_points(const Shape& shape, int first_point) {
    for (const int point : shape.marked_points) result_.soup.marked_points.push_back(first_point + point);
    int begin = 0;
    for (const int end : shape.wire_ends) {
      std::vector<int> vertices(shape.wire_vertices.begin() + begin, shape.wire_vertices.begin() + end);
      for (int& vertex : vertices) vertex += first_point;
      result_.soup.add_wire(vertices);
      begin = end;
    }
  }

  void add_bodies(const Shape& shape, const Occurrence& occurrence) {
    std::vector<std::string>& names = result_.soup.body_names;
    const auto first = static_cast<int>(names.size());
    const auto named = [&shape](const std::string& whole, const std::string& body) {
      if (whole.empty() || body.empty()) return whole + body;
      return body == whole || shape.body_names.size() == 1 ? whole : whole + "/" + body;
    };
    const auto add = [&](const std::string& body) {
      names.push_back(named(occurrence.name, body));
      result_.body_parts.push_back({named(occurrence.part, body), occurrence.number});
    };
    const auto is_whole = [](int body) { return body < 0; };
    for (const std::string& body : shape.body_names) add(body);
    if (std::any_of(shape.body_of_polygon.begin(), shape.body_of_polygon.end(), is_whole)) add("");
    for (const int body : shape.body_of_polygon)
      result_.soup.face_body.push_back(body < 0 ? static_cast<int>(names.size()) - 1 : first + body);
  }

  // Must follow add_bodies.
  void add_colours(const Shape& shape, int colour) {
    const auto first_of = [](int one, int other) { return one == no_colour ? other : one; };
    std::vector<std::optional<Colour>>& colours = result_.soup.body_colours;
    for (const int own : shape.body_colours)
      colours.push_back(colour_of(first_of(colour, first_of(own, shape.colour))));
    colours.resize(result_.soup.body_names.size(), colour_of(first_of(colour, shape.colour)));
  }

  static std::optional<Colour> colour_of(int number) {
    if (number == no_colour) return std::nullopt;
    return Colour{number >> 16, (number >> 8) & 255, number & 255};
  }

  void add_part(const Shape& shape, const Mat4& to_file, int first_point) {
    surfaces::DeclaredPart& part = result_.part;
    const auto first_face = static_cast<int>(part.faces.size());
    result_.first_faces[static_cast<std::size_t>(&shape - document_.shapes.data())].push_back(first_face);
    result_.places[static_cast<std::size_t>(&shape - document_.shapes.data())].push_back(to_file);
    const std::optional<double> scale = surfaces::similarity_scale(to_file);
    for (const PartSurface& surface : shape.faces)
      part.faces.push_back(scale ? surfaces::moved(surface, to_file, *scale) : PartSurface{});
    for (const int face : shape.face_of_polygon) part.face_of_polygon.push_back(face < 0 ? -1 : first_face + face);
    const auto first_vertex = static_cast<int>(part.edge_vertices.size());
    for (const int vertex : shape.edge_vertices) part.edge_vertices.push_back(first_point + vertex);
    for (const DeclaredEdge& edge : shape.edges)
      part.edges.push_back({scale ? edge.angle : std::nan(""), edge.is_tangent, first_vertex + edge.end});
  }

  const Document& document_;
  std::vector<double> steps_;  ///< of the coordinates of each shape
  const std::size_t max_triangles_ = max_triangles();
  std::size_t placed_triangles_ = 0;
  Assembled result_;
};

}  // namespace

Assembled assemble(const Document& document, const std::string& format) { return Assembler(document).assemble(format); }

}  // namespace epura::importer
