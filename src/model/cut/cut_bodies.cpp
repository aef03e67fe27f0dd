// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "cut/cut_doubts.hpp"

namespace epura::cut {

namespace {

int body_count(const mesh::Mesh& mesh) {
  return mesh.body.empty() ? 0 : *std::max_element(mesh.body.begin(), mesh.body.end()) + 1;
}

// Whether each body's surface is inside out: its volume by the divergence theorem is negative. For an open body, whose
// volume is undefined, the sign of the area bounded by its closed outlines is used.
std::vector<bool> inside_out(const CutModel& model, const std::vector<char>& is_open) {
  const world::World& world = model.world;
  const mesh::Mesh& mesh = *world.models[model.model].mesh;
  std::vector<double> volume(is_open.size(), 0);
  for (std::size_t t = 0; t < mesh.body.size(); ++t) {
    if (is_open[mesh.body[t]] != 0) continue;
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = world.points[world.triangles[world.first_triangle[model.model] + t][i]] * model.frame.normalisation -
             model.frame.origin;
    volume[mesh.body[t]] += glm::dot(p[0], glm::cross(p[1], p[2]));
  }
  visit_bodies(model.cut.segments, [&](int body, std::span<const CutSegment> segments) {
    if (is_open[body] != 0) volume[body] = directed_area(segments, model.places, model.frame);
  });
  std::vector<bool> negative;
  for (const double v : volume) negative.push_back(v < 0);
  return negative;
}

struct BodyCut {
  mesh::Outlines outlines;
  Vec2 min{HUGE_VAL}, max{-HUGE_VAL};  ///< bounding box of the outlines
  Vec2 sample{0.0};                    ///< a point of the body's cut

  [[nodiscard]] double extent() const { return max.x - min.x + max.y - min.y; }
  [[nodiscard]] bool is_around(const BodyCut& other) const {
    const Vec2& p = other.sample;
    const bool in_box = min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y;
    return in_box && extent() > other.extent() && mesh::is_inside(outlines, p);
  }
};

BodyCut cut_of(mesh::Outlines outlines) {
  BodyCut cut{std::move(outlines)};
  for (const Vec2& p : cut.outlines.places) {
    cut.min = glm::min(cut.min, p);
    cut.max = glm::max(cut.max, p);
  }
  const auto [a, b] = cut.outlines.segments.front();
  cut.sample = (cut.outlines.places[a] + cut.outlines.places[b]) / 2.0;
  return cut;
}

std::map<int, BodyCut> cuts_of(const CutModel& model) {
  const auto& [world, number, cut, places, frame] = model;
  std::map<int, BodyCut> cuts;
  visit_bodies(cut.segments, [&cuts, &places = places, &frame = frame](int body, std::span<const CutSegment> segments) {
    cuts[body] = cut_of(flatten(segments, places, frame).outlines);
  });
  for (const int t : cut.in_plane) {
    const auto [found, made] = cuts.try_emplace(world.models[number].mesh->body[t]);
    if (!made) continue;
    const std::array<int, 3>& corners = world.triangles[world.first_triangle[number] + t];
    for (const int v : corners) found->second.sample += frame.flat(world.points[v]) / 3.0;
  }
  return cuts;
}

}  // namespace

std::vector<int> material_of(const CutModel& model, const std::vector<char>& is_open) {
  const int bodies = body_count(*model.world.models[model.model].mesh);
  std::vector<int> material(static_cast<std::size_t>(bodies));
  for (int b = 0; b < bodies; ++b) material[b] = b;
  if (bodies < 2) return material;
  const std::vector<bool> negative = inside_out(model, is_open);
  if (std::adjacent_find(negative.begin(), negative.end(), std::not_equal_to<>()) == negative.end()) return material;

  const std::map<int, BodyCut> cuts = cuts_of(model);
  for (const auto& [body, here] : cuts) {
    std::vector<std::pair<double, int>> around;  // bodies around it, innermost first
    for (const auto& [other, there] : cuts)
      if (other != body && there.is_around(here)) around.emplace_back(there.extent(), other);
    std::sort(around.begin(), around.end());
    if (around.empty() || negative[around.back().second] == negative[body]) continue;
    const auto solid = std::find_if(around.begin(), around.end(), [&, own = body](const auto& entry) {
      return negative[entry.second] != negative[own];
    });
    material[body] = solid->second;
  }
  return material;
}

std::vector<char> open_bodies(const mesh::Mesh& mesh) {
  std::vector<char> open(static_cast<std::size_t>(body_count(mesh)), 0);
  std::vector<int> bodies;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    bodies.clear();
    for (const int t : mesh.triangles_of(edge)) bodies.push_back(mesh.body[t]);
    if (bodies.size() == 2 && bodies[0] == bodies[1]) continue;
    std::sort(bodies.begin(), bodies.end());
    for (std::size_t begin = 0, end = 0; begin < bodies.size(); begin = end) {
      while (end < bodies.size() && bodies[end] == bodies[begin]) ++end;
      if ((end - begin) % 2 == 1) open[bodies[begin]] = 1;
    }
  }
  return open;
}

}  // namespace epura::cut
