// SPDX-License-Identifier: Apache-2.0
#include "shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "accessors.hpp"
#include "draco.hpp"
#include "refuse.hpp"

namespace epura::plugin::gltf {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

using Wire = std::vector<std::uint32_t>;

std::vector<Wire> wires_of(int mode, std::vector<std::uint32_t> n) {
  if (n.size() < 2) return {};
  std::vector<Wire> wires;
  if (mode == TINYGLTF_MODE_LINE) {
    for (std::size_t i = 1; i < n.size(); i += 2) wires.push_back({n[i - 1], n[i]});
    return wires;
  }
  if (mode == TINYGLTF_MODE_LINE_LOOP) n.push_back(n.front());
  wires.push_back(std::move(n));
  return wires;
}

bool is_degenerate(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// Counterclockwise as seen from outside. Degenerate triangles, which connect parts of strips and fans, are omitted.
std::vector<Triangle> triangles_of(int mode, const std::vector<std::uint32_t>& n) {
  std::vector<Triangle> triangles;
  const std::size_t count = mode == TINYGLTF_MODE_TRIANGLES ? n.size() / 3 : n.size() < 3 ? 0 : n.size() - 2;
  triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
      triangles.push_back({n[3 * i], n[3 * i + 1], n[3 * i + 2]});
      continue;
    }
    const Triangle next = mode == TINYGLTF_MODE_TRIANGLE_FAN ? Triangle{n[i + 1], n[i + 2], n[0]}
                          : i % 2 == 0                       ? Triangle{n[i], n[i + 1], n[i + 2]}
                                                             : Triangle{n[i], n[i + 2], n[i + 1]};
    if (!is_degenerate(next)) triangles.push_back(next);
  }
  return triangles;
}

Corners uncompressed(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& what) {
  Corners corners;
  const int position = position_of(primitive, what);
  corners.points = positions(model, position);
  corners.step = step_of(accessor_at(model, position, TINYGLTF_TYPE_VEC3));
  if (primitive.indices >= 0) {
    corners.numbers = indices(model, primitive.indices);
  } else {
    corners.numbers.resize(corners.points.size());
    std::iota(corners.numbers.begin(), corners.numbers.end(), 0u);
  }
  return corners;
}

Corners corners_of(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& what) {
  Corners corners =
      is_compressed(primitive) ? decompressed(model, primitive, what) : uncompressed(model, primitive, what);
  for (const std::uint32_t number : corners.numbers)
    refuse_if(number >= corners.points.size(), what + " has a corner " + std::to_string(number) + ", but only " +
                                                   std::to_string(corners.points.size()) + " positions");
  return corners;
}

// Primitives often share positions: those that none of these triangles or wires uses are removed.
template <class Element>
void keep_used(std::vector<Point>& points, std::vector<Element>& elements, std::size_t first) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(points.size(), unused);
  for (const Element& element : elements)
    for (const std::uint32_t corner : element) number[corner] = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] == unused) continue;
    points[count] = points[i];
    number[i] = static_cast<std::uint32_t>(first + count++);
  }
  points.resize(count);
  for (Element& element : elements)
    for (std::uint32_t& corner : element) corner = number[corner];
}

// Of the mesh, if all its primitives have it. White is what programs write for materials without a colour.
const std::vector<double>* colour_of(const tinygltf::Model& model, const tinygltf::Mesh& mesh) {
  const std::vector<double>* common = nullptr;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (primitive.material < 0 || static_cast<std::size_t>(primitive.material) >= model.materials.size())
      return nullptr;
    const auto& material = model.materials[static_cast<std::size_t>(primitive.material)].pbrMetallicRoughness;
    const std::vector<double>& factor = material.baseColorFactor;  // linear
    if (factor.size() < 3 || std::all_of(factor.begin(), factor.begin() + 3, [](double part) { return part == 1; }) ||
        (common != nullptr && factor != *common))
      return nullptr;
    common = &factor;
  }
  return common;
}

// IEC 61966-2-1.
double srgb_of(double linear) {
  const double part = std::clamp(linear, 0.0, 1.0);
  return part <= 0.0031308 ? 12.92 * part : 1.055 * std::pow(part, 1 / 2.4) - 0.055;
}

/// Builds a mesh for the sink, primitive by primitive.
class ShapeMaker {
 public:
  ShapeMaker(const tinygltf::Model& model, const NamedMesh& named, Sink& sink)
      : model_(model), mesh_(model.meshes[named.number]), named_(named), sink_(sink) {}

  void add_triangles(int mode, Corners corners) {
    std::vector<Triangle> triangles = triangles_of(mode, corners.numbers);
    add_points(corners, triangles);
    sink_.triangles(triangles);
  }

  void add_wires(int mode, Corners corners) {
    std::vector<Wire> wires = wires_of(mode, std::move(corners.numbers));
    if (wires.empty()) return;
    add_points(corners, wires);
    for (const Wire& wire : wires) sink_.wire(wire);
  }

  void add_points(Corners corners) {
    std::vector<std::array<std::uint32_t, 1>> points;
    for (const std::uint32_t number : corners.numbers) points.push_back({number});
    if (points.empty()) return;
    add_points(corners, points);
    for (const auto& [number] : points) sink_.point(number);
  }

  [[nodiscard]] std::uint32_t shape() const { return shape_; }

 private:
  template <class Element>
  void add_points(Corners& corners, std::vector<Element>& elements) {
    keep_used(corners.points, elements, points_);
    points_ += corners.points.size();
    refuse_if(points_ >= EPURA_NONE, numbered("mesh", named_.number) + " has more points than can be numbered");
    if (shape_ == EPURA_NONE) begin_shape();
    if (corners.step > 0) sink_.step(corners.step);
    sink_.points(corners.points);
  }

  void begin_shape() {
    shape_ = sink_.shape(named_.name);
    if (const std::vector<double>* colour = colour_of(model_, mesh_))
      sink_.colour(srgb_of((*colour)[0]), srgb_of((*colour)[1]), srgb_of((*colour)[2]));
  }

  const tinygltf::Model& model_;
  const tinygltf::Mesh& mesh_;
  const NamedMesh& named_;
  Sink& sink_;
  std::uint32_t shape_ = EPURA_NONE;
  std::size_t points_ = 0;
};

}  // namespace

std::string LeftOut::sentence() const {
  if (morphs == 0) return {};
  return std::to_string(morphs) + (morphs == 1 ? " morph target is not drawn" : " morph targets are not drawn");
}

std::uint32_t add_shape(const tinygltf::Model& model, const NamedMesh& named, Sink& sink, LeftOut& left_out) {
  const tinygltf::Mesh& mesh = model.meshes[named.number];
  ShapeMaker maker(model, named, sink);
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
    const tinygltf::Primitive& primitive = mesh.primitives[i];
    const std::string what = numbered("mesh", named.number) + ", " + numbered("primitive", i);
    const int mode = primitive.mode;
    refuse_if(mode < TINYGLTF_MODE_POINTS || mode > TINYGLTF_MODE_TRIANGLE_FAN,
              what + " is of unknown mode " + std::to_string(mode));
    Corners corners = corners_of(model, primitive, what);
    const auto expect_whole = [&](std::size_t of_one, const char* things) {
      refuse_if(corners.numbers.size() % of_one != 0,
                what + " has " + std::to_string(corners.numbers.size()) + " corners, which make no " + things);
    };
    left_out.morphs += primitive.targets.size();
    if (mode == TINYGLTF_MODE_LINE) expect_whole(2, "lines");
    if (mode == TINYGLTF_MODE_TRIANGLES) expect_whole(3, "triangles");
    if (mode == TINYGLTF_MODE_POINTS)
      maker.add_points(std::move(corners));
    else if (mode < TINYGLTF_MODE_TRIANGLES)
      maker.add_wires(mode, std::move(corners));
    else
      maker.add_triangles(mode, std::move(corners));
  }
  return maker.shape();
}

}  // namespace epura::plugin::gltf
