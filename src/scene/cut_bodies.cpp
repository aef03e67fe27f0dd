// SPDX-License-Identifier: Apache-2.0
#include "scene/cut_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace epura::scene {

namespace {

int body_count(const mesh::Mesh& mesh) {
  return mesh.body.empty() ? 0 : *std::max_element(mesh.body.begin(), mesh.body.end()) + 1;
}

// Whether each body's surface is inside out: its volume by the divergence theorem is negative.
std::vector<bool> inside_out(const World& world, int model, int bodies, const PlaneFrame& frame) {
  const mesh::Mesh& mesh = *world.models[model].mesh;
  std::vector<double> volume(static_cast<std::size_t>(bodies), 0);
  for (std::size_t t = 0; t < mesh.body.size(); ++t) {
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = world.points[world.triangles[world.first_triangle[model] + t][i]] * frame.normalisation - frame.origin;
    volume[mesh.body[t]] += glm::dot(p[0], glm::cross(p[1], p[2]));
  }
  std::vector<bool> negative;
  for (const double v : volume) negative.push_back(v < 0);
  return negative;
}

struct BodyCut {
  mesh::Outlines outlines;
  Vec2 min{HUGE_VAL}, max{-HUGE_VAL};  ///< box around them
  Vec2 sample{0.0};                    ///< a place of the body

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
  for (std::size_t begin = 0, end = 0; begin < cut.segments.size(); begin = end) {
    const int body = cut.segments[begin].body;
    while (end < cut.segments.size() && cut.segments[end].body == body) ++end;
    cuts[body] = cut_of(flatten(std::span(cut.segments).subspan(begin, end - begin), places, frame).outlines);
  }
  for (const int t : cut.in_plane) {
    const auto [found, made] = cuts.try_emplace(world.models[number].mesh->body[t]);
    if (!made) continue;
    const std::array<int, 3>& corners = world.triangles[world.first_triangle[number] + t];
    for (const int v : corners) found->second.sample += frame.flat(world.points[v]) / 3.0;
  }
  return cuts;
}

}  // namespace

std::vector<int> material_of(const CutModel& model, const std::vector<std::optional<int>>& open) {
  const int bodies = body_count(*model.world.models[model.model].mesh);
  std::vector<int> material(static_cast<std::size_t>(bodies));
  for (int b = 0; b < bodies; ++b) material[b] = b;
  if (bodies < 2) return material;
  const std::vector<bool> negative = inside_out(model.world, model.model, bodies, model.frame);
  if (std::adjacent_find(negative.begin(), negative.end(), std::not_equal_to<>()) == negative.end()) return material;

  std::map<int, BodyCut> cuts = cuts_of(model);
  std::erase_if(cuts, [&](const auto& entry) { return open[entry.first].has_value(); });
  for (const auto& [body, here] : cuts) {
    std::vector<std::pair<double, int>> around;  // bodies around it, the innermost first
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

std::vector<std::optional<int>> open_edges(const mesh::Mesh& mesh) {
  std::vector<std::optional<int>> open(static_cast<std::size_t>(body_count(mesh)));
  std::vector<int> bodies;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    bodies.clear();
    for (const int t : mesh.triangles_of(mesh.edges[e])) bodies.push_back(mesh.body[t]);
    if (bodies.size() == 2 && bodies[0] == bodies[1]) continue;
    std::sort(bodies.begin(), bodies.end());
    for (std::size_t begin = 0, end = 0; begin < bodies.size(); begin = end) {
      while (end < bodies.size() && bodies[end] == bodies[begin]) ++end;
      if ((end - begin) % 2 == 1 && !open[bodies[begin]]) open[bodies[begin]] = static_cast<int>(e);
    }
  }
  return open;
}

}  // namespace epura::scene
