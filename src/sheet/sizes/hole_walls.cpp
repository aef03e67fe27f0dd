// SPDX-License-Identifier: Apache-2.0
#include "sizes/hole_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "definition/limits.hpp"
#include "features/part_features.hpp"
#include "features/tolerances.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::sheet {

namespace {

using surfaces::PartFace;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

bool are_about_one_axis(const PartSurface& surface, const WorldCircle& circle, double slack) {
  if (surface.kind == SurfaceKind::sphere)
    return features::distance_from_line(surface.origin, circle.centre, circle.axis) <= slack;
  return surfaces::has_axis(surface.kind) && features::are_parallel(surface.axis, circle.axis) &&
         features::distance_from_line(circle.centre, surface.origin, surface.axis) <= slack;
}

double radius_at(const PartFace& face, double at) { return face.surface.radius + face.surface.slope * at; }

bool is_straight(const PartFace& face) {
  return face.surface.kind == SurfaceKind::cylinder || face.surface.kind == SurfaceKind::cone;
}

bool is_wall(const PartFace& face) { return face.inwards && is_straight(face); }

double distance_from_triangle(const Vec3& point, const std::array<Vec3, 3>& corner) {
  const Vec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  double nearest = HUGE_VAL;
  bool is_within = glm::length(normal) > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = corner[i], &b = corner[(i + 1) % 3];
    nearest = std::min(nearest, distance_to_segment(point, a, b));
    is_within = is_within && glm::dot(glm::cross(b - a, point - a), normal) >= 0;
  }
  return is_within ? std::abs(glm::dot(point - corner[0], glm::normalize(normal))) : nearest;
}

bool is_tube(const PartFace& face, double radius) {
  return face.surface.kind == SurfaceKind::torus && radius == face.surface.minor;
}

// A tube is that of a fillet, however far it goes about its axis; of balls, nobody knows.
double sweep_of(const PartFace& face, double radius) {
  if (face.surface.kind == SurfaceKind::sphere) return least_slot_end;
  return is_tube(face, radius) ? 0 : face.sweep;
}

// Where the line through `from` along `along` meets a triangle, as a distance from there; nothing if it passes by.
std::optional<double> meeting(const std::array<Vec3, 3>& corner, const Vec3& from, const Vec3& along, double slack) {
  const auto [u, v] = surfaces::square_to(along);
  std::array<Vec2, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = {glm::dot(corner[i] - from, u), glm::dot(corner[i] - from, v)};
  const double area = cross(p[1] - p[0], p[2] - p[0]);
  if (std::abs(area) <= slack * slack) return std::nullopt;
  double height = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
    const double share = cross(a, b) / area;
    if (share * std::abs(area) < -slack * glm::distance(a, b)) return std::nullopt;
    height += share * glm::dot(corner[i] - from, along);
  }
  return height;
}

}  // namespace

bool HoleChain::ends_at(std::size_t wall, int end) const {
  const auto side = static_cast<std::size_t>(end);
  const std::array<double, 2>& own = walls[wall].radius;
  if (walls[wall].is_cone()) return own[side] < own[1 - side];
  const bool is_last = end == 0 ? wall == 0 : wall + 1 == walls.size();
  if (is_last) return is_closed[side];
  const HoleWall& next = walls[end == 0 ? wall - 1 : wall + 1];
  return next.radius[1 - side] < own[side] * (1 - definition::same_size) ||
         (next.is_cone() && next.radius[side] < next.radius[1 - side]);
}

bool NotedRound::has_centre(const Vec3& centre, double slack) const {
  const Vec3 off = centre - circle.centre;
  const double along = glm::dot(off, circle.axis), across = glm::length(off - along * circle.axis);
  return std::abs(across - ring) <= slack && (ring <= 0 || std::abs(along) <= slack);
}

HoleWalls::HoleWalls(const world::World& world)
    : world_(world), slack_(definition::drawn_in_line * glm::length(world.box.size())) {
  for (const world::Placed& placed : world.models)
    parts_.push_back(placed.part == nullptr ? std::nullopt : world::place_part(placed));
}

// Cylinders that something divides are one.
std::vector<HoleWall> HoleWalls::walls_about(const WorldCircle& circle, int model, int body, bool inwards) const {
  const std::vector<PartFace>& faces = parts_[static_cast<std::size_t>(model)]->faces;
  std::vector<HoleWall> walls;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const PartFace& face = faces[i];
    if (face.body != body || !is_straight(face) || face.inwards != inwards ||
        !are_about_one_axis(face.surface, circle, slack_))
      continue;
    const double sense = glm::dot(face.surface.axis, circle.axis) < 0 ? -1 : 1;
    const double origin = glm::dot(face.surface.origin - circle.centre, circle.axis);
    HoleWall wall{static_cast<int>(i),
                  {origin + sense * face.from, origin + sense * face.to},
                  {radius_at(face, face.from), radius_at(face, face.to)},
                  2 * std::atan(std::abs(face.surface.slope)) * degrees,
                  features::radius_doubt(face),
                  face.sweep};
    if (sense < 0) std::swap(wall.at[0], wall.at[1]), std::swap(wall.radius[0], wall.radius[1]);
    wall.thread = thread_on(model, wall.face, sense < 0 ? Vec2(wall.at[1], wall.at[0]) : Vec2(wall.at[0], wall.at[1]));
    const auto same = std::find_if(walls.begin(), walls.end(), [&](const HoleWall& other) {
      return std::abs(other.angle - wall.angle) <= definition::same_size &&
             std::abs(other.radius[0] - wall.radius[0]) <= slack_ + wall.doubt && other.at[0] <= wall.at[1] + slack_ &&
             wall.at[0] <= other.at[1] + slack_;
    });
    if (same == walls.end()) {
      walls.push_back(wall);
      continue;
    }
    same->at = {std::min(same->at[0], wall.at[0]), std::max(same->at[1], wall.at[1])};
    same->sweep += wall.sweep;
    if (!same->thread) same->thread = wall.thread;
  }
  for (const HoleWall& wall : walls) check(wall.at[0] <= wall.at[1], "a wall goes up along the axis");
  std::sort(walls.begin(), walls.end(), [](const HoleWall& a, const HoleWall& b) { return a.at < b.at; });
  return walls;
}

// `ends`: of the face, the lower one along the axis of its surface first.
std::optional<WallThread> HoleWalls::thread_on(int model, int face, const Vec2& ends) const {
  for (const scene::ThreadedFace& one : world_.models[static_cast<std::size_t>(model)].threads) {
    if (one.face != face) continue;
    const double from = one.from_high ? ends.y : ends.x, to = one.from_high ? ends.x : ends.y;
    const auto [low, high] = std::minmax({from, from + (to < from ? -one.length : one.length)});
    return WallThread{one.thread, {low, high}};
  }
  return std::nullopt;
}

std::optional<HoleChain> HoleWalls::chain_from(const WorldCircle& circle, int model, int face) const {
  const PartFace& first = parts_[static_cast<std::size_t>(model)]->faces[static_cast<std::size_t>(face)];
  const std::vector<HoleWall> all = walls_about(circle, model, first.body, true);
  const double sense = glm::dot(first.surface.axis, circle.axis) < 0 ? -1 : 1;
  const double middle =
      glm::dot(first.surface.origin - circle.centre, circle.axis) + sense * (first.from + first.to) / 2;
  const auto own = std::find_if(all.begin(), all.end(), [&](const HoleWall& wall) {
    return wall.at[0] <= middle && middle <= wall.at[1] &&
           std::abs(wall.widest() - std::max(radius_at(first, first.from), radius_at(first, first.to))) <=
               slack_ + wall.doubt;
  });
  if (own == all.end()) return std::nullopt;
  auto begin = own, end = own + 1;
  while (begin != all.begin() && std::prev(begin)->at[1] >= begin->at[0] - slack_) --begin;
  while (end != all.end() && end->at[0] <= std::prev(end)->at[1] + slack_) ++end;
  HoleChain chain{model, circle.centre, circle.axis, {begin, end}, static_cast<std::size_t>(own - begin), {}, {}};
  find_ends(chain);
  check(chain.own < chain.walls.size(), "a chain has the wall by which it was found");
  return chain;
}

void HoleWalls::find_ends(HoleChain& chain) const {
  const world::Placed& placed = world_.models[static_cast<std::size_t>(chain.model)];
  for (const std::size_t end : {0, 1}) {
    check(!chain.walls.empty(), "a chain has a wall");
    const HoleWall& wall = end == 0 ? chain.walls.front() : chain.walls.back();
    const std::optional<int> ahead = face_ahead(chain, wall, end == 0 ? -chain.axis : chain.axis);
    chain.is_closed[end] = wall.radius[end] <= slack_ || (ahead && is_floor(*ahead, chain, wall.face));
    for (const surfaces::PartBorder& border : placed.part->borders) {
      if (border.faces[0] != wall.face && border.faces[1] != wall.face) continue;
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const int edge : border.edges)
        for (const int vertex : placed.mesh->whole().edges[static_cast<std::size_t>(edge)].vertex) {
          const Vec3 point(placed.to_world * Vec4(placed.mesh->whole().point(vertex), 1));
          const double at = glm::dot(point - chain.centre, chain.axis);
          low = std::min(low, at);
          high = std::max(high, at);
        }
      // Borders along the wall reach from end to end.
      const bool is_there = end == 0 ? low <= wall.at[0] + slack_ : high >= wall.at[1] - slack_;
      const bool is_along = low <= wall.at[0] + slack_ && high >= wall.at[1] - slack_;
      if (is_there && !is_along) chain.uneven[end] = std::max(chain.uneven[end], high - low);
    }
  }
}

std::array<Vec3, 3> HoleWalls::corners_of(std::size_t model, std::size_t triangle) const {
  const auto first = static_cast<std::size_t>(world_.first_triangle[model]);
  std::array<Vec3, 3> corner;
  for (std::size_t i = 0; i < 3; ++i)
    corner[i] = world_.points[static_cast<std::size_t>(world_.triangles[first + triangle][i])];
  return corner;
}

// The first one beside a wall, where a boss in the middle is not in the way.
std::optional<int> HoleWalls::face_ahead(const HoleChain& chain, const HoleWall& wall, const Vec3& along) const {
  constexpr double inwards = 0.1;  // of its radius
  const world::PlacedPart& part = *parts_[static_cast<std::size_t>(chain.model)];
  const auto corners = [&](std::size_t t) { return corners_of(static_cast<std::size_t>(chain.model), t); };
  const auto own = std::find(part.face_of_triangle.begin(), part.face_of_triangle.end(), wall.face);
  if (own == part.face_of_triangle.end()) return std::nullopt;
  const std::array<Vec3, 3> facet = corners(static_cast<std::size_t>(own - part.face_of_triangle.begin()));
  Vec3 from = (facet[0] + facet[1] + facet[2]) / 3.0;
  const Vec3 off = from - chain.centre;
  check(glm::length(off) > 0, "a wall is beside its axis");
  from -= inwards * (off - glm::dot(off, chain.axis) * chain.axis);
  double nearest = HUGE_VAL;
  std::optional<int> ahead;
  for (std::size_t t = 0; t < part.face_of_triangle.size(); ++t) {
    const std::optional<double> at = meeting(corners(t), from, along, slack_);
    if (!at || *at <= 0 || *at >= nearest) continue;
    nearest = *at;
    ahead = part.face_of_triangle[t];
  }
  return ahead;
}

std::vector<int> HoleWalls::beside(int model, int face) const {
  std::vector<int> others;
  for (const surfaces::PartBorder& border : world_.models[static_cast<std::size_t>(model)].part->borders)
    for (const int side : {0, 1})
      if (border.faces[static_cast<std::size_t>(side)] == face && border.faces[static_cast<std::size_t>(1 - side)] >= 0)
        others.push_back(border.faces[static_cast<std::size_t>(1 - side)]);
  return others;
}

// A floor is beside the wall, perhaps behind a rounded corner. What turns about another axis is that of a hole across.
bool HoleWalls::is_floor(int floor, const HoleChain& chain, int wall) const {
  if (floor < 0) return false;
  const std::vector<PartFace>& faces = parts_[static_cast<std::size_t>(chain.model)]->faces;
  const WorldCircle about{chain.centre, chain.axis, 0, {}, true};
  const auto is_about = [&](int face) {
    return are_about_one_axis(faces[static_cast<std::size_t>(face)].surface, about, slack_);
  };
  if (faces[static_cast<std::size_t>(floor)].surface.kind != SurfaceKind::plane && !is_about(floor)) return false;
  for (const int next : beside(chain.model, wall)) {
    if (next == floor) return true;
    if (!is_about(next)) continue;
    const std::vector<int> behind = beside(chain.model, next);
    if (std::find(behind.begin(), behind.end(), floor) != behind.end()) return true;
  }
  return false;
}

// A cylinder before a cone that ends with its radius, then the nearest one.
std::optional<HoleChain> HoleWalls::chain_at(const WorldCircle& circle) const {
  std::optional<HoleChain> nearest;
  std::pair<bool, double> least{true, HUGE_VAL};
  for (std::size_t model = 0; model < parts_.size(); ++model) {
    if (!parts_[model]) continue;
    for (std::size_t i = 0; i < parts_[model]->faces.size(); ++i) {
      const PartFace& face = parts_[model]->faces[i];
      if (!is_wall(face) || !are_about_one_axis(face.surface, circle, slack_)) continue;
      const auto has = [&](double at) {
        return std::abs(radius_at(face, at) - circle.radius) <=
               slack_ + features::radius_doubt(face) + definition::same_size * circle.radius;
      };
      if (!has(face.from) && !has(face.to)) continue;
      const double level = glm::dot(circle.centre - face.surface.origin, face.surface.axis);
      const std::pair off(face.surface.kind == SurfaceKind::cone, std::max({face.from - level, level - face.to, 0.0}));
      if (off >= least) continue;
      if (auto chain = chain_from(circle, static_cast<int>(model), static_cast<int>(i))) {
        least = off;
        nearest = std::move(chain);
      }
    }
  }
  return nearest;
}

WorldCircle HoleWalls::bore_of(WorldCircle thread, double core) const {
  std::optional<double> widest;
  for (const auto& part : parts_) {
    if (!part) continue;
    for (const PartFace& face : part->faces) {
      const double radius = face.surface.radius;
      if (is_wall(face) && face.surface.kind == SurfaceKind::cylinder &&
          are_about_one_axis(face.surface, thread, slack_) && radius >= core * thread.radius &&
          radius <= thread.radius + slack_ + features::radius_doubt(face))
        widest = std::max(widest.value_or(radius), radius);
    }
  }
  if (widest) thread.radius = *widest;
  return thread;
}

std::vector<HoleChain> HoleWalls::chains_of(double radius) const {
  check(radius > 0, "a hole has a radius");
  std::vector<HoleChain> chains;
  for (std::size_t model = 0; model < parts_.size(); ++model) {
    if (!parts_[model]) continue;
    for (std::size_t i = 0; i < parts_[model]->faces.size(); ++i) {
      const PartFace& face = parts_[model]->faces[i];
      const double doubt = slack_ + features::radius_doubt(face) + definition::same_size * radius;
      if (!is_wall(face) || face.surface.kind != SurfaceKind::cylinder ||
          std::abs(face.surface.radius - radius) > doubt)
        continue;
      const WorldCircle circle{face.surface.origin, face.surface.axis, radius, {}, true};
      auto chain = chain_from(circle, static_cast<int>(model), static_cast<int>(i));
      const auto is_known = [&](const HoleChain& one) {
        return one.model == chain->model && one.walls[one.own].face == chain->walls[chain->own].face;
      };
      if (chain && std::none_of(chains.begin(), chains.end(), is_known)) chains.push_back(std::move(*chain));
    }
  }
  return chains;
}

std::vector<HoleWall> HoleWalls::shafts_at(const WorldCircle& circle) const {
  std::vector<HoleWall> shafts;
  for (std::size_t model = 0; model < parts_.size(); ++model) {
    if (!parts_[model]) continue;
    std::vector<int> bodies;
    for (const PartFace& face : parts_[model]->faces)
      if (is_straight(face) && !face.inwards && are_about_one_axis(face.surface, circle, slack_) &&
          std::find(bodies.begin(), bodies.end(), face.body) == bodies.end())
        bodies.push_back(face.body);
    for (const int body : bodies)
      for (const HoleWall& wall : walls_about(circle, static_cast<int>(model), body, false))
        if (std::abs(wall.widest() - circle.radius) <= slack_ + wall.doubt + definition::same_size * circle.radius)
          shafts.push_back(wall);
  }
  return shafts;
}

// Those about one axis that overlap along it are one.
std::vector<NotedRound> HoleWalls::rounds(std::optional<double> radius) const {
  std::vector<NotedRound> found;
  const auto add = [&](std::size_t model, std::size_t number, double own, const Vec3& centre) {
    const PartFace& face = parts_[model]->faces[number];
    const double doubt = slack_ + features::radius_doubt(face) + definition::same_size * own;
    if (radius && std::abs(own - *radius) > doubt) return;
    const bool is_along = face.surface.kind == SurfaceKind::cylinder;  // a rim is at one place
    NotedRound one{static_cast<int>(model),
                   static_cast<int>(number),
                   {centre, face.surface.axis, own, {}, true},
                   sweep_of(face, own),
                   face.inwards,
                   {is_along ? face.from : 0, is_along ? face.to : 0},
                   is_tube(face, own) ? face.surface.radius : 0};
    const auto same = std::find_if(found.begin(), found.end(), [&](const NotedRound& other) {
      const double off = glm::dot(other.circle.centre - centre, one.circle.axis);
      const bool is_same_way = glm::dot(other.circle.axis, one.circle.axis) > 0;
      const double low = off + (is_same_way ? other.at[0] : -other.at[1]);
      const double high = off + (is_same_way ? other.at[1] : -other.at[0]);
      return other.model == one.model && std::abs(other.circle.radius - own) <= doubt &&
             are_about_one_axis(face.surface, other.circle, slack_) && low <= one.at[1] + slack_ &&
             one.at[0] <= high + slack_ && std::abs(other.ring - one.ring) <= doubt;
    });
    if (same == found.end())
      found.push_back(one);
    else
      same->sweep += one.sweep;
  };
  for (std::size_t model = 0; model < parts_.size(); ++model) {
    if (!parts_[model]) continue;
    for (std::size_t i = 0; i < parts_[model]->faces.size(); ++i) {
      const PartFace& face = parts_[model]->faces[i];
      const PartSurface& one = face.surface;
      if (one.kind == SurfaceKind::plane || one.kind == SurfaceKind::free_form) continue;
      if (one.kind == SurfaceKind::torus) add(model, i, one.minor, one.origin);
      if (one.kind != SurfaceKind::cone && (radius || one.kind != SurfaceKind::torus))
        add(model, i, one.radius, one.origin);
      if (one.kind != SurfaceKind::cone) continue;
      check(face.from <= face.to, "a cone goes up along its axis");
      for (const double at : {face.from, face.to}) add(model, i, radius_at(face, at), one.origin + at * one.axis);
    }
  }
  return found;
}

bool HoleWalls::has_round(const WorldCircle& circle) const {
  for (const auto& part : parts_)
    if (part && std::ranges::any_of(part->faces, [&](const PartFace& face) {
          return are_about_one_axis(face.surface, circle, slack_);
        }))
      return true;
  return false;
}

bool HoleWalls::is_between(const Vec3& from, const Vec3& to, double radius, const Vec3& along) const {
  const Vec3 middle = (from + to) / 2.0;
  const auto is_it = [&](const PartFace& face) {
    const PartSurface& one = face.surface;
    const double doubt = slack_ + features::radius_doubt(face) + definition::same_size * radius;
    const auto has = [&](double own) { return std::abs(own - radius) <= doubt; };
    if (one.kind == SurfaceKind::plane || one.kind == SurfaceKind::free_form) return false;
    if (one.kind != SurfaceKind::sphere && std::abs(glm::dot(one.axis, along)) > features::parallel) return false;
    const bool has_radius =
        one.kind == SurfaceKind::cone    ? has(radius_at(face, face.from)) || has(radius_at(face, face.to))
        : one.kind == SurfaceKind::torus ? has(one.radius + one.minor) || has(one.radius - one.minor)
                                         : has(one.radius);
    return has_radius && std::abs(glm::dot(one.origin - middle, along)) <= doubt;
  };
  for (const auto& part : parts_)
    if (part && std::ranges::any_of(part->faces, is_it)) return true;
  return false;
}

std::vector<FaceOfModel> HoleWalls::faces_at(const Vec3& point, double within) const {
  check(within >= 0, "a distance is not negative");
  std::vector<FaceOfModel> found;
  for (std::size_t model = 0; model < parts_.size(); ++model) {
    if (!parts_[model]) continue;
    const world::PlacedPart& part = *parts_[model];
    std::vector<char> is_known(part.faces.size(), 0);
    for (std::size_t t = 0; t < part.face_of_triangle.size(); ++t) {
      const int number = part.face_of_triangle[t];
      if (number < 0 || is_known[static_cast<std::size_t>(number)] != 0) continue;
      const PartFace& face = part.faces[static_cast<std::size_t>(number)];
      const double doubt = within + features::radius_doubt(face) + 2 * face.sagitta;
      if (distance_from_triangle(point, corners_of(model, t)) > doubt) continue;
      is_known[static_cast<std::size_t>(number)] = 1;
      found.push_back({model, number});
    }
  }
  return found;
}

std::optional<WorldCircle> HoleWalls::circle_of(const LeaderNote& note) const {
  if (note.rim || !note.at) return note.rim;
  auto circle = circle_through(*note.at);
  return circle ? circle : circle_about(*note.at);
}

// The narrowest cylinder of a hole about a point of its axis.
std::optional<WorldCircle> HoleWalls::circle_about(const Vec3& point) const {
  std::optional<WorldCircle> found;
  for (const auto& part : parts_) {
    if (!part) continue;
    for (const PartFace& face : part->faces) {
      const PartSurface& one = face.surface;
      const WorldCircle circle{point, one.axis, one.radius, {}, true};
      const double at = glm::dot(point - one.origin, one.axis);
      const bool is_there = at >= face.from - slack_ && at <= face.to + slack_;
      if (is_wall(face) && one.kind == SurfaceKind::cylinder && is_there && are_about_one_axis(one, circle, slack_) &&
          (!found || circle.radius < found->radius))
        found = circle;
    }
  }
  return found;
}

std::optional<WorldCircle> HoleWalls::circle_through(const Vec3& point) const {
  std::optional<WorldCircle> found;
  const auto slacks = written_slacks();
  std::vector<FaceOfModel> faces = faces_at(point, slacks.front());
  const auto is_round = [this](const FaceOfModel& at) {
    return world::is_round(parts_[at.model]->faces[static_cast<std::size_t>(at.face)].surface.kind);
  };
  if (std::ranges::none_of(faces, is_round)) faces = faces_at(point, slacks.back());
  for (const FaceOfModel& at : faces) {
    const PartFace& face = parts_[at.model]->faces[static_cast<std::size_t>(at.face)];
    const PartSurface& one = face.surface;
    if (one.kind == SurfaceKind::plane || one.kind == SurfaceKind::free_form) continue;
    WorldCircle circle{one.origin, one.axis, one.radius, {}, true};
    if (one.kind == SurfaceKind::cylinder) circle.centre += glm::dot(point - one.origin, one.axis) * one.axis;
    if (one.kind == SurfaceKind::torus) circle.radius = one.minor;
    if (one.kind == SurfaceKind::cone) {
      const double end = radius_at(face, face.from) > radius_at(face, face.to) ? face.from : face.to;
      circle.centre += end * one.axis;
      circle.radius = radius_at(face, end);
    }
    check(circle.radius > 0, "a round face has a radius");
    if (!found || circle.radius < found->radius) found = circle;
  }
  return found;
}

}  // namespace epura::sheet
