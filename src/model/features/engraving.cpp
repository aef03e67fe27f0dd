// SPDX-License-Identifier: Apache-2.0
#include "features/engraving.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>

#include "base/vec.hpp"
#include "features/tolerances.hpp"

namespace epura::features {

namespace {

using surfaces::PartSurface;
using surfaces::SurfaceKind;

/// Faces that only one other face connects with the rest of the part: `order[begin]` to `order[end - 1]`.
struct Pocket {
  int around;
  std::size_t begin, end;
};

/// What the removal of a face would cut off: the blocks of the graph of neighbours, by depth-first search.
class PocketFinder {
 public:
  explicit PocketFinder(std::vector<std::vector<int>> neighbours)
      : neighbours_(std::move(neighbours)), number_(neighbours_.size(), -1), low_(neighbours_.size(), 0) {}

  void search_from(int root) {
    if (number_[root] >= 0) return;
    enter(root, -1);
    while (!path_.empty()) {
      Step& step = path_.back();
      if (step.next < neighbours_[step.face].size()) {
        const int other = neighbours_[step.face][step.next++];
        if (number_[other] < 0)
          enter(other, step.face);
        else
          low_[step.face] = std::min(low_[step.face], number_[other]);
        continue;
      }
      const Step done = step;
      path_.pop_back();
      if (done.parent < 0) continue;
      low_[done.parent] = std::min(low_[done.parent], low_[done.face]);
      if (low_[done.face] >= number_[done.parent])
        pockets_.push_back({done.parent, static_cast<std::size_t>(number_[done.face]), order_.size()});
    }
  }

  [[nodiscard]] const std::vector<Pocket>& pockets() const { return pockets_; }
  [[nodiscard]] std::span<const int> faces_of(const Pocket& pocket) const {
    return std::span(order_).subspan(pocket.begin, pocket.end - pocket.begin);
  }

 private:
  struct Step {
    int face, parent;
    std::size_t next;
  };

  void enter(int face, int parent) {
    number_[face] = low_[face] = static_cast<int>(order_.size());
    order_.push_back(face);
    path_.push_back({face, parent, 0});
  }

  std::vector<std::vector<int>> neighbours_;
  std::vector<int> number_, low_, order_;
  std::vector<Step> path_;
  std::vector<Pocket> pockets_;
};

PocketFinder search_pockets(const surfaces::PartFaces& faces) {
  std::vector<std::vector<int>> neighbours(faces.faces.size());
  for (const surfaces::PartBorder& border : faces.borders) {
    const auto [a, b] = border.faces;
    if (a < 0 || a == b) continue;
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  PocketFinder finder(std::move(neighbours));
  std::vector<int> largest_first(faces.faces.size());
  std::iota(largest_first.begin(), largest_first.end(), 0);
  std::stable_sort(largest_first.begin(), largest_first.end(),
                   [&](int a, int b) { return faces.faces[a].area > faces.faces[b].area; });
  for (const int face : largest_first) finder.search_from(face);
  return finder;
}

std::vector<Box> boxes_of_faces(const world::Placed& placed, const world::PlacedPart& part) {
  const mesh::Mesh& mesh = placed.mesh->whole();
  std::vector<Box> boxes(part.faces.size());
  for (int t = 0; t < mesh.triangle_count(); ++t)
    if (const int face = placed.part->face_of_triangle[t]; face >= 0)
      for (const int v : mesh.triangle(t)) boxes[face].add(Vec3(placed.to_world * Vec4(mesh.point(v), 1)));
  return boxes;
}

/// A pocket that could be a letter.
struct Mark {
  const Pocket* pocket;
  double rise;  ///< of its floor or top above the plane
  std::size_t walls;
};

std::optional<Mark> mark_of(const Pocket& pocket, std::span<const int> faces, const world::PlacedPart& part,
                            const std::vector<Box>& boxes, double part_size) {
  const PartSurface& plane = part.faces[pocket.around].surface;
  if (plane.kind != SurfaceKind::plane) return std::nullopt;
  Box box;
  for (const int face : faces) {
    box.add(boxes[face].min);
    box.add(boxes[face].max);
  }
  const double size = glm::length(box.size()), largest = largest_letter * part_size, slack = 1e-6 * part_size;
  std::array<double, 3> sides{box.size().x, box.size().y, box.size().z};
  std::sort(sides.begin(), sides.end());
  if (sides[1] > largest) return std::nullopt;
  Mark mark{&pocket, 0, 0};
  for (const int face : faces) {
    const PartSurface& surface = part.faces[face].surface;
    const double lean = std::abs(glm::dot(surface.axis, plane.axis));
    const bool is_flat = surface.kind == SurfaceKind::plane && lean >= 1 - parallel * parallel;
    const double rise = is_flat ? glm::dot(surface.origin - plane.origin, plane.axis) : 0;
    if (is_flat && std::abs(rise) > slack) {
      if (mark.rise != 0 && std::abs(rise - mark.rise) > slack) return std::nullopt;
      mark.rise = rise;
    }
    const bool is_wall = (surface.kind == SurfaceKind::plane && lean <= parallel) ||
                         (surface.kind == SurfaceKind::cylinder && lean >= 1 - parallel * parallel) ||
                         surface.kind == SurfaceKind::free_form;
    if (!is_flat && !is_wall) return std::nullopt;
    if (is_wall) ++mark.walls;
  }
  const bool is_word = size > largest;  // of letters that touch
  if (is_word && mark.walls < usual_walls) return std::nullopt;
  if (mark.rise == 0 || std::abs(mark.rise) > deepest_letter * size) return std::nullopt;
  return mark;
}

}  // namespace

std::vector<char> walls_of_letters(const world::Placed& placed, const world::PlacedPart& part) {
  std::vector<char> walls(part.faces.size(), 0);
  const PocketFinder finder = search_pockets(*placed.part);
  if (finder.pockets().size() < fewest_letters) return walls;
  const std::vector<Box> boxes = boxes_of_faces(placed, part);
  Box whole;
  for (const Box& box : boxes) {
    if (box.empty()) continue;
    whole.add(box.min);
    whole.add(box.max);
  }
  const double size = glm::length(whole.size());
  std::vector<Mark> marks;
  for (const Pocket& pocket : finder.pockets())
    if (const auto mark = mark_of(pocket, finder.faces_of(pocket), part, boxes, size)) marks.push_back(*mark);
  for (const Mark& first : marks) {
    std::vector<const Mark*> alike;
    for (const Mark& mark : marks)
      if (mark.pocket->around == first.pocket->around && std::abs(mark.rise - first.rise) <= 1e-6 * size)
        alike.push_back(&mark);
    const std::size_t all_walls = std::accumulate(alike.begin(), alike.end(), std::size_t{0},
                                                  [](std::size_t sum, const Mark* mark) { return sum + mark->walls; });
    if (alike.size() < fewest_letters || all_walls < usual_walls * alike.size()) continue;
    for (const int face : finder.faces_of(*first.pocket)) {
      const PartSurface& surface = part.faces[face].surface;
      const bool is_flat = surface.kind == SurfaceKind::plane &&
                           std::abs(glm::dot(surface.axis, part.faces[first.pocket->around].surface.axis)) > 0.5;
      if (!is_flat) walls[face] = 1;
    }
  }
  return walls;
}

}  // namespace epura::features
