// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace samples {

namespace {

void check_faces(const Solid& solid, bool planar, std::vector<std::string>& found) {
  std::set<std::vector<int>> seen;
  for (const std::vector<int>& face : solid.faces()) {
    std::vector<int> sorted = face;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
      found.push_back(solid.name() + ": a face uses a corner twice");
    }
    if (!seen.insert(sorted).second) {
      found.push_back(solid.name() + ": a face stands there twice");
    }
    const Loop corners = solid.corners(face);
    const Point area = area_vector(corners);
    if (dot(area, area) < 1e-8) {
      found.push_back(solid.name() + ": a face has no area");
    }
    if (planar && !is_planar(corners)) {
      found.push_back(solid.name() + ": a face is not planar");
    }
  }
}

/// Closed and of one orientation: each edge is passed exactly once in either direction.
void check_edges(const Solid& solid, bool closed, std::vector<std::string>& found) {
  std::map<std::pair<int, int>, int> passed;
  for (const std::vector<int>& face : solid.faces()) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      ++passed[{face[i], face[(i + 1) % face.size()]}];
    }
  }
  for (const auto& [edge, times] : passed) {
    const bool has_twin = passed.contains({edge.second, edge.first});
    if (times > 1 || (closed && !has_twin)) {
      const std::string what = times > 1 ? " is passed twice in one direction" : " is open";
      found.push_back(solid.name() + ": edge " + std::to_string(edge.first) + "-" + std::to_string(edge.second) + what);
    }
  }
}

}  // namespace

double volume(const Solid& solid) {
  double six_volumes = 0;
  for (const std::vector<int>& face : solid.faces()) {
    const Loop p = solid.corners(face);
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
      six_volumes += dot(p[0], cross(p[i], p[i + 1]));
    }
  }
  return six_volumes / 6;
}

std::vector<std::string> faults(const Model& model, bool closed) {
  std::vector<std::string> found;
  for (const Solid& solid : model) {
    check_faces(solid, closed, found);
    check_edges(solid, closed, found);
    if (closed && volume(solid) <= 0) {
      found.push_back(solid.name() + ": is turned inside out");
    }
  }
  return found;
}

}  // namespace samples
