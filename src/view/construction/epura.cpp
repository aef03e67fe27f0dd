// SPDX-License-Identifier: Apache-2.0
#include "construction/epura.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/portable_math.hpp"
#include "base/text.hpp"

namespace epura::construction {

namespace {

using scene::ConstructionKind;

constexpr double same_point = 1e-6;      // mm
constexpr std::size_t max_corners = 52;  // more names than that cover the drawing
constexpr double flat = 1e-9;            // part of a normal's length

// A ... Z, AA, AB ...
std::string letters(std::size_t number) {
  constexpr std::size_t count = 26;
  const std::string last(1, static_cast<char>('A' + number % count));
  return number < count ? last : letters(number / count - 1) + last;
}

// Position along LT, depth and height, mm.
Vec3 space_of(const Epura& epura, const EpuraPoint& p) {
  return {p.elevation.x, epura.ground - p.plan.y, p.elevation.y - epura.ground};
}

// Outwards: position, depth and height are left-handed.
Vec3 normal_of(const std::vector<Vec3>& ring) {
  Vec3 normal(0);
  for (std::size_t i = 0; i < ring.size(); ++i)
    normal -= glm::cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  return glm::normalize(normal);
}

std::vector<Vec3> in_space(const Epura& epura, std::span<const Vec3> points) {
  std::vector<Vec3> ring;
  for (const Vec3& point : points) ring.push_back(space_of(epura, epura_point(epura, point)));
  return ring;
}

/// The line in which a plane cuts a face, in space as of the drawing.
using Cut = std::array<Vec3, 2>;

// Of the triangle, if it lies on both sides of the plane n . p = c.
std::optional<Cut> cut_of(const std::array<Vec3, 3>& triangle, const Vec3& n, double c) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &p = triangle[i], &q = triangle[(i + 1) % 3];
    const double a = glm::dot(n, p) - c, b = glm::dot(n, q) - c;
    if ((a > same_point && b < -same_point) || (a < -same_point && b > same_point))
      points.push_back(p + (q - p) * (a / (a - b)));
    else if (std::abs(a) <= same_point)
      points.push_back(p);
  }
  if (points.size() != 2 || glm::length(points[1] - points[0]) <= same_point) return std::nullopt;
  return Cut{points[0], points[1]};
}

// Pieces of one face that touch are one line.
std::vector<Cut> cuts_of(const Epura& epura, const std::vector<FaceTriangles>& faces, const Vec3& n, double c) {
  std::vector<Cut> cuts;
  for (const FaceTriangles& face : faces) {
    std::vector<Cut> pieces;
    for (const std::array<Vec3, 3>& triangle : face) {
      const std::vector<Vec3> corners = in_space(epura, triangle);
      if (const auto cut = cut_of({corners[0], corners[1], corners[2]}, n, c)) pieces.push_back(*cut);
    }
    if (pieces.empty()) continue;
    const Vec3 origin = pieces[0][0], along = glm::normalize(pieces[0][1] - pieces[0][0]);
    std::vector<std::array<double, 2>> spans;
    for (const Cut& piece : pieces) {
      const double a = glm::dot(piece[0] - origin, along), b = glm::dot(piece[1] - origin, along);
      spans.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(spans.begin(), spans.end());
    std::vector<std::array<double, 2>> joined;
    for (const std::array<double, 2>& span : spans)
      if (joined.empty() || span[0] > joined.back()[1] + same_point)
        joined.push_back(span);
      else
        joined.back()[1] = std::max(joined.back()[1], span[1]);
    for (const std::array<double, 2>& span : joined)
      cuts.push_back({origin + span[0] * along, origin + span[1] * along});
  }
  return cuts;
}

class Drafter {
 public:
  Drafter(const Epura& epura, std::span<const Request> requests, const EpuraModels& models)
      : epura_(epura), requests_(requests), models_(models) {}

  Figure made();

 private:
  struct Named {
    EpuraPoint at;
    std::string name;
  };

  std::string name_of(const Vec3& point) { return name_of(epura_point(epura_, point)); }
  std::string name_of(const EpuraPoint& at);
  void name_points();
  void add_ground_line();
  void add_correspondences();
  void add_labels(bool plan);
  void add_true_length(const Request& request);
  void add_traces(const Request& request);
  void add_true_shape(const Request& request);
  void add_auxiliary(const Request& request);
  void add_piercing(const Request& request);
  void add_section(const Request& request);
  Symbol step(const std::string& meaning);
  void add_step(const Vec2& at, const std::string& meaning);
  void add_line(const Vec2& from, const Vec2& to, const Symbol& symbol = {});
  void add_arc(const Vec2& centre, const Vec2& from, const Vec2& to, const Symbol& symbol);
  [[nodiscard]] Vec2 plan_of(const Vec3& p) const { return {p.x, epura_.ground - p.y}; }
  [[nodiscard]] Vec2 elevation_of(const Vec3& p) const { return {p.x, epura_.ground + p.z}; }

  const Epura& epura_;
  std::span<const Request> requests_;
  const EpuraModels& models_;
  std::vector<Named> named_{};
  int steps_ = 0, planes_ = 0, auxiliary_views_ = 0;
  Figure figure_{};
};

Figure Drafter::made() {
  name_points();
  for (const Request& request : requests_) {
    if (request.item.by_change_of_planes) {
      add_auxiliary(request);
      continue;
    }
    if (request.item.kind == ConstructionKind::true_length) add_true_length(request);
    if (request.item.kind == ConstructionKind::traces) add_traces(request);
    if (request.item.kind == ConstructionKind::true_shape) add_true_shape(request);
    if (request.item.kind == ConstructionKind::piercing) add_piercing(request);
    if (request.item.kind == ConstructionKind::section) add_section(request);
  }
  add_correspondences();
  add_labels(true);
  add_labels(false);
  add_ground_line();
  return std::move(figure_);
}

// Points in the same position have one name.
std::string Drafter::name_of(const EpuraPoint& at) {
  for (const Named& one : named_)
    if (glm::length(one.at.plan - at.plan) <= same_point && glm::length(one.at.elevation - at.elevation) <= same_point)
      return one.name;
  named_.push_back({at, letters(named_.size())});
  return named_.back().name;
}

void Drafter::name_points() {
  for (const Request& request : requests_) {
    if (request.item.kind == ConstructionKind::corners) {
      if (models_.corners.size() > max_corners && request.optional) continue;
      if (models_.corners.size() > max_corners)
        refuse(request,
               "would name " + std::to_string(models_.corners.size()) + " corners, and a drawing can show " +
                   std::to_string(max_corners),
               "choose corners by 'point:VERTEX'");
      for (const Vec3& corner : models_.corners) name_of(corner);
    } else if (request.item.kind == ConstructionKind::point) {
      name_of(request.elements[0]);
    }
  }
}

// LT past all points, with a short stroke below each end.
void Drafter::add_ground_line() {
  constexpr double below = 1.2, length = 5, past = 10;
  auto [left, right] = std::pair(epura_.ends.x, epura_.ends.y);
  for (const Point& point : figure_.points) {
    left = std::min(left, point.at.x);
    right = std::max(right, point.at.x);
  }
  left -= past;
  right += past;
  const double y = epura_.ground;
  figure_.lines.push_back({{left, y}, {right, y}});
  figure_.lines.push_back({{left, y - below}, {left + length, y - below}});
  figure_.lines.push_back({{right - length, y - below}, {right, y - below}});
  figure_.points.push_back({{"L"}, {left, y}, {right, y}, false, true});
  figure_.points.push_back({{"T"}, {right, y}, {left, y}, false, true});
  add_term(figure_, "LT", "ground line: where the horizontal and the vertical plane meet");
  if (!named_.empty()) add_term(figure_, "A1 A2", "plan and elevation of the point A");
}

// One line for all points that are at the same place along LT.
void Drafter::add_correspondences() {
  std::vector<Named> points = named_;
  std::stable_sort(points.begin(), points.end(),
                   [](const Named& a, const Named& b) { return a.at.elevation.x < b.at.elevation.x; });
  for (std::size_t first = 0; first < points.size();) {
    std::size_t last = first;
    Vec2 lowest = points[first].at.plan, highest = points[first].at.elevation;
    for (; last < points.size() && points[last].at.elevation.x - points[first].at.elevation.x <= same_point; ++last) {
      if (points[last].at.plan.y < lowest.y) lowest = points[last].at.plan;
      if (points[last].at.elevation.y > highest.y) highest = points[last].at.elevation;
    }
    figure_.lines.push_back({lowest, highest});
    first = last;
  }
}

// Of points in the same position, the one that is seen is named first: the highest in plan, the foremost in elevation.
void Drafter::add_labels(bool plan) {
  std::vector<Named> points = named_;
  const auto rank = [plan](const Named& one) { return plan ? one.at.elevation.y : -one.at.plan.y; };
  std::stable_sort(points.begin(), points.end(),
                   [&](const Named& a, const Named& b) { return rank(a) > rank(b) + same_point; });
  const std::size_t before = figure_.points.size();
  for (const Named& one : points) {
    const Symbol symbol{one.name, plan ? "1" : "2"};
    const Vec2& at = plan ? one.at.plan : one.at.elevation;
    const auto there = std::find_if(figure_.points.begin() + static_cast<std::ptrdiff_t>(before), figure_.points.end(),
                                    [&](const Point& p) { return glm::length(p.at - at) <= same_point; });
    if (there != figure_.points.end())
      there->also.push_back(symbol);
    else
      figure_.points.push_back({symbol, at, at, true, true});
  }
}

// The number of the next step.
Symbol Drafter::step(const std::string& meaning) {
  const std::string number = "(" + std::to_string(++steps_) + ")";
  figure_.terms.push_back({number, meaning});
  return {number};
}

void Drafter::add_step(const Vec2& at, const std::string& meaning) {
  figure_.points.push_back({step(meaning), at, at, false, true});
}

void Drafter::add_line(const Vec2& from, const Vec2& to, const Symbol& symbol) {
  figure_.lines.push_back({from, to, Extent::segment, symbol});
}

// The shorter arc between two radii of equal length.
void Drafter::add_arc(const Vec2& centre, const Vec2& from, const Vec2& to, const Symbol& symbol) {
  const Vec2 p = from - centre, q = to - centre;
  const double radius = glm::length(p), a = portable_atan2(p.y, p.x);
  const double b = a + std::remainder(portable_atan2(q.y, q.x) - a, 2 * std::numbers::pi);
  figure_.curves.push_back({centre, {radius, 0}, {0, radius}, std::min(a, b), std::max(a, b), symbol});
}

// The edge AB turns about the vertical through A until it is parallel to the vertical plane.
void Drafter::add_true_length(const Request& request) {
  const std::string a_name = name_of(request.elements[0]), b_name = name_of(request.elements[1]);
  const Vec3 a = space_of(epura_, epura_point(epura_, request.elements[0]));
  const Vec3 b = space_of(epura_, epura_point(epura_, request.elements[1]));
  const double radius = glm::length(plan_of(b) - plan_of(a));
  const Vec3 turned(a.x + (b.x >= a.x ? radius : -radius), a.y, b.z);
  if (std::abs(b.y - a.y) > same_point) {
    const std::string turned_name = b_name + "'";
    add_line(plan_of(a), plan_of(turned));
    add_arc(plan_of(a), plan_of(b), plan_of(turned),
            step(a_name + b_name + " turned about the vertical through " + a_name + " until it is parallel to LT"));
    add_line(plan_of(turned), elevation_of(turned), step("correspondence line of " + turned_name));
    add_line(elevation_of(b), elevation_of(turned), step(turned_name + " is as high as " + b_name));
    figure_.points.push_back({{turned_name, "1"}, plan_of(turned), plan_of(turned), true, true});
    figure_.points.push_back({{turned_name, "2"}, elevation_of(turned), elevation_of(turned), true, true});
  }
  const std::string length = format_rounded(glm::length(request.elements[1] - request.elements[0]), 6);
  add_line(elevation_of(a), elevation_of(turned), {"TL " + length});
  add_term(figure_, "TL", "true length");
}

// Plane N . p = c: its trace in the horizontal plane is N.x x + N.y depth = c, in the vertical plane N.x x + N.z h = c.
void Drafter::add_traces(const Request& request) {
  const std::vector<Vec3> ring = in_space(epura_, request.elements);
  const Vec3 n = normal_of(ring);
  const double c = glm::dot(n, ring[0]);
  const std::string name = plane_name(planes_++);
  const auto add = [&](double across, double sign, const std::string& index) {
    if (std::hypot(n.x, across) <= flat) return;
    // From the point on LT where both meet; traces parallel to LT from any point of them.
    const bool meets = std::abs(n.x) > flat;
    const Vec2 from = meets ? Vec2(c / n.x, epura_.ground) : Vec2(epura_.ends.x, epura_.ground + sign * c / across);
    Vec2 along(meets ? -across / n.x : 1, meets ? sign : 0);
    if (meets && std::abs(across) <= flat) along = Vec2(0, sign);
    figure_.lines.push_back({from, from + glm::normalize(along), meets ? Extent::ray : Extent::line, {name, index}});
    if (meets) add_point(figure_, {{name}, from, {(epura_.ends.x + epura_.ends.y) / 2, epura_.ground}});
  };
  add(n.y, -1, "1");
  add(n.z, 1, "2");
  add_term(figure_, name + "1 " + name + "2",
           "traces of the plane " + plane_text(request) + " in the horizontal and the vertical plane");
}

// The face turns about its lowest horizontal line, the hinge, into a horizontal plane.
void Drafter::add_true_shape(const Request& request) {
  const Rabatment turned = rabatment(epura_, request.elements);
  const std::vector<Vec3> ring = in_space(epura_, request.elements);
  std::vector<std::string> names;
  for (const Vec3& corner : request.elements) names.push_back(name_of(corner));
  std::string face;
  for (const std::string& name : names) face += name;
  if (turned.along == Vec2(0, 0)) return add_step(plan_of(ring[0]), "the plan shows " + face + " in true shape");
  const Vec2 across(-turned.along.y, turned.along.x);
  std::size_t farthest = 0;
  double low = 0, high = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double along = glm::dot(turned.shape[i] - turned.hinge, turned.along);
    low = std::min(low, along), high = std::max(high, along);
    const auto reach = [&](std::size_t j) { return std::abs(glm::dot(turned.shape[j] - turned.hinge, across)); };
    if (reach(i) > reach(farthest)) farthest = i;
  }
  constexpr double past = 8;
  add_line(turned.hinge + (low - past) * turned.along, turned.hinge + (high + past) * turned.along);
  add_step(turned.hinge + (high + past) * turned.along,
           "hinge: the horizontal line of " + face + " through its lowest corner");
  const auto foot_of = [&](std::size_t i) {
    return turned.hinge + glm::dot(turned.shape[i] - turned.hinge, turned.along) * turned.along;
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const bool moves = glm::length(plan_of(ring[i]) - turned.shape[i]) > same_point;
    if (moves) figure_.points.push_back({{"(" + names[i] + ")"}, turned.shape[i], foot_of(i), true, true});
    add_line(turned.shape[i], turned.shape[(i + 1) % ring.size()]);
    if (moves) add_line(plan_of(ring[i]), turned.shape[i]);
  }
  // The true distance from the hinge is the hypotenuse over the distance in plan and the height.
  const double lowest =
      std::min_element(ring.begin(), ring.end(), [](const Vec3& a, const Vec3& b) { return a.z < b.z; })->z;
  const Vec2 corner = plan_of(ring[farthest]), top = corner + (ring[farthest].z - lowest) * turned.along;
  add_line(corner, top, step("height of " + names[farthest] + " above the hinge, laid off from its plan"));
  add_line(foot_of(farthest), top);
  add_arc(foot_of(farthest), top, turned.shape[farthest], step("true distance from the hinge"));
  Vec2 centre(0, 0);
  for (const Vec2& p : turned.shape) centre += p / static_cast<double>(turned.shape.size());
  add_step(centre, face + " in true shape");
}

// Each new ground line, the points behind it, and the lines of correspondence to them.
void Drafter::add_auxiliary(const Request& request) {
  const bool is_edge = request.item.kind == ConstructionKind::true_length;
  std::vector<std::string> names;
  std::string all;
  for (const Vec3& point : request.elements) all += names.emplace_back(name_of(point));
  const std::vector<Vec3> ring = in_space(epura_, request.elements);
  const std::string truth = all + (is_edge ? " in true length" : " in true shape");
  const std::vector<AuxiliaryView> views = change_of_planes(epura_, request.elements, models_.corners);
  if (views.empty()) return add_step(plan_of(ring[0]), "the plan shows " + truth);
  std::vector<Vec2> before;
  for (const Vec3& point : ring) before.push_back(plan_of(point));
  for (std::size_t i = 0; i < views.size(); ++i) {
    const AuxiliaryView& view = views[i];
    const std::string number = std::to_string(++auxiliary_views_), line = "LT" + number;
    const std::string index = std::to_string(auxiliary_views_ + 2), last = "LT" + std::to_string(auxiliary_views_ - 1);
    const bool is_last = i + 1 == views.size();
    add_line(view.ground[0], view.ground[1], {"LT", number});
    add_step(view.ground[1], line + (is_last ? ": new ground line, parallel to " + all
                                             : ": new ground line, perpendicular to the horizontal lines of " + all));
    Vec2 middle(0);
    for (std::size_t k = 0; k < names.size(); ++k) {
      add_line(before[k], view.points[k]);
      if (k > 0 || !is_edge) add_line(view.points[k], view.points[(k + 1) % names.size()]);
      const auto is_there = [&](const Point& p) { return glm::length(p.at - view.points[k]) <= same_point; };
      const auto there = std::find_if(figure_.points.begin(), figure_.points.end(), is_there);
      if (there != figure_.points.end() && there->marked)
        there->also.push_back({names[k], index});
      else
        figure_.points.push_back({{names[k], index}, view.points[k], before[k], true, true});
      middle += view.points[k] / static_cast<double>(names.size());
    }
    add_step(middle, (i == 0 ? "heights above LT, behind " : "distances from " + last + ", behind ") + line +
                         (is_last ? ": " + truth : ": " + all + " edge-on"));
    before = view.points;
  }
}

// The vertical plane through the line cuts the faces in lines, which meet it in elevation.
void Drafter::add_piercing(const Request& request) {
  const std::vector<Vec3> ends = in_space(epura_, request.elements);
  std::string line;
  for (const Vec3& end : request.elements) line += name_of(end);
  const Vec3 along = ends[1] - ends[0];
  const double level = std::hypot(along.x, along.y);
  const Vec3 normal = level > same_point ? Vec3(along.y, -along.x, 0) / level : Vec3(0, 1, 0);
  const std::vector<Cut> cuts = cuts_of(epura_, models_.faces, normal, glm::dot(normal, ends[0]));
  // Along the line, in units of its length.
  std::vector<double> at;
  std::optional<Vec2> on_cut;
  for (const Cut& cut : cuts) {
    const Vec3 cross = glm::cross(normal, along);  // in the plane, across the line
    const double a = glm::dot(cut[0] - ends[0], cross), b = glm::dot(cut[1] - ends[0], cross);
    if ((a > 0) == (b > 0) || a == b) continue;
    const Vec3 point = cut[0] + (cut[1] - cut[0]) * (a / (a - b));
    at.push_back(glm::dot(point - ends[0], along) / glm::dot(along, along));
    add_line(elevation_of(cut[0]), elevation_of(cut[1]));
    if (!on_cut) on_cut = elevation_of((cut[0] + 3.0 * cut[1]) / 4.0);
  }
  if (at.empty())
    refuse(request, "is a line that meets no face", "choose an edge whose line passes through the models");
  const auto [first, last] = std::minmax_element(at.begin(), at.end());
  const Vec3 from = ends[0] + std::min(*first, 0.0) * along, to = ends[0] + std::max(*last, 1.0) * along;
  add_line(plan_of(from), plan_of(to), step("plan of " + line + ", the trace of a vertical plane through it"));
  add_line(elevation_of(from), elevation_of(to));
  add_step(*on_cut, "lines in which this plane cuts the faces");
  std::sort(at.begin(), at.end());
  std::string names;
  for (const double t : at) {
    const Vec3 p = ends[0] + t * along;
    append_to_list(names, name_of(EpuraPoint{plan_of(p), elevation_of(p)}));
  }
  figure_.terms.push_back({names, "where they meet " + line});
}

// Where a plane cuts the faces, but for that of which it is.
void Drafter::add_section(const Request& request) {
  const std::vector<Vec3> ring = in_space(epura_, request.elements);
  const Vec3 normal = normal_of(ring);
  const std::vector<Cut> cuts = cuts_of(epura_, models_.faces, normal, glm::dot(normal, ring[0]));
  for (const Cut& cut : cuts) {
    for (const Vec3& end : cut) name_of(EpuraPoint{plan_of(end), elevation_of(end)});
    figure_.lines.push_back({plan_of(cut[0]), plan_of(cut[1])});
    figure_.lines.push_back({elevation_of(cut[0]), elevation_of(cut[1])});
  }
  if (cuts.empty()) refuse(request, "is a plane that cuts no face", "choose another plane");
  add_step(plan_of((cuts.front()[0] + cuts.front()[1]) / 2.0),
           "lines in which the plane " + plane_text(request) + " cuts the " +
               (request.item.has_element ? "other " : "") + "faces");
}

}  // namespace

EpuraPoint epura_point(const Epura& epura, const Vec3& point) {
  return {image_of(epura.plan, point).value_or(Vec2(0)), image_of(epura.elevation, point).value_or(Vec2(0))};
}

Rabatment rabatment(const Epura& epura, std::span<const Vec3> face) {
  const std::vector<Vec3> ring = in_space(epura, face);
  const Vec3 n = normal_of(ring);
  const Vec3 lowest =
      *std::min_element(ring.begin(), ring.end(), [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
  const auto plan_of = [&](const Vec3& p) { return Vec2(p.x, epura.ground - p.y); };
  Rabatment turned{plan_of(lowest), Vec2(0, 0), {}};
  const double steep = std::hypot(n.x, n.y);
  if (steep <= flat) {
    for (const Vec3& p : ring) turned.shape.push_back(plan_of(p));
    return turned;
  }
  // In plan, depths count downwards. The face falls to the side of its normal: outwards.
  turned.along = Vec2(n.y, n.x) / steep;
  const Vec2 m = Vec2(n.x, -n.y) / steep;
  for (const Vec3& p : ring) {
    const Vec2 q = plan_of(p) - turned.hinge;
    turned.shape.push_back(turned.hinge + glm::dot(q, turned.along) * turned.along +
                           std::hypot(glm::dot(q, m), p.z - lowest.z) * m);
  }
  return turned;
}

namespace {

// On a plane whose trace has the direction `along`, on the side `away`, at least at `from` in that direction; `before`
// are the points in the view that is kept, `distances` those from the ground line in the view that is replaced.
AuxiliaryView view_behind(const std::vector<Vec2>& before, const std::vector<double>& distances, const Vec2& along,
                          const Vec2& away, double from) {
  constexpr double clear = 12, past = 8;  // mm
  AuxiliaryView view{};
  for (const Vec2& p : before) from = std::max(from, glm::dot(p, away));
  const double ground = from + clear;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double at = glm::dot(before[i], along);
    view.points.push_back(at * along + (ground + distances[i]) * away);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  view.ground = {(low - past) * along + ground * away, (high + past) * along + ground * away};
  return view;
}

// Of both directions across a line, the one down the page, or to the right.
Vec2 down_the_page(const Vec2& across) {
  const bool is_up = std::abs(across.y) > flat ? across.y > 0 : across.x < 0;
  return is_up ? -across : across;
}

}  // namespace

std::vector<AuxiliaryView> change_of_planes(const Epura& epura, std::span<const Vec3> element,
                                            std::span<const Vec3> clear_of) {
  const std::vector<Vec3> ring = in_space(epura, element);
  std::vector<Vec2> plans;
  std::vector<double> heights;
  for (const Vec3& p : ring) {
    plans.emplace_back(p.x, epura.ground - p.y);
    heights.push_back(p.z);
  }
  const bool is_edge = ring.size() == 2;
  const Vec3 normal = is_edge ? Vec3(0) : normal_of(ring);
  // Of an edge, its plan; of a face, its horizontal lines in plan, where depths count downwards.
  const Vec2 level = is_edge ? plans[1] - plans[0] : Vec2(normal.y, normal.x);
  if (glm::length(level) <= (is_edge ? same_point : flat)) return {};
  const Vec2 along = glm::normalize(level), across(-along.y, along.x);
  const bool is_upright = is_edge || std::abs(normal.z) <= flat;
  const Vec2 away = down_the_page(is_upright ? across : along);
  double from = -HUGE_VAL;
  for (const Vec3& p : clear_of) from = std::max(from, glm::dot(epura_point(epura, p).plan, away));
  std::vector<AuxiliaryView> views{view_behind(plans, heights, is_upright ? along : across, away, from)};
  if (is_upright) return views;
  const std::vector<Vec2>& edge_on = views[0].points;
  const double ground = glm::dot(views[0].ground[0], away);
  std::vector<double> distances;
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    distances.push_back(ground - glm::dot(plans[i], away));
    if (glm::length(edge_on[i] - edge_on[0]) > glm::length(edge_on[farthest] - edge_on[0])) farthest = i;
  }
  const Vec2 line = glm::normalize(edge_on[farthest] - edge_on[0]), beside(-line.y, line.x);
  const bool is_away = glm::dot(beside, away) > 0;
  views.push_back(view_behind(edge_on, distances, line, is_away ? beside : -beside, -HUGE_VAL));
  return views;
}

Figure epura_figure(const Epura& epura, std::span<const Request> requests, const EpuraModels& models) {
  return Drafter(epura, requests, models).made();
}

}  // namespace epura::construction
