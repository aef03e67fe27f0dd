// SPDX-License-Identifier: Apache-2.0
#include "sizes/pictorial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sheet/marks.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/thread_notes.hpp"

namespace epura::sheet {

namespace {

using scene::DimensionDescription;

constexpr double seen_end_on = 1e-3;   // of its length: an axis has no image
constexpr double almost_along = 0.99;  // cosine of the angle between an extension line and its dimension line

/// A view as a map of directions to the page.
struct Images {
  const projection::Projection& projection;

  [[nodiscard]] Vec2 of(const Vec3& d) const {
    const Vec3 on_plane =
        d - glm::dot(d, projection.n) / glm::dot(projection.projector, projection.n) * projection.projector;
    return {glm::dot(on_plane, projection.u), glm::dot(on_plane, projection.v)};
  }
  [[nodiscard]] bool is_seen(int axis) const { return glm::length(of(Mat3(1)[axis])) > seen_end_on; }

  // The axis along which extension lines are drawn, as they are measured: the one that is most nearly perpendicular.
  [[nodiscard]] std::optional<int> extension_of(int axis) const {
    const Vec2 along = glm::normalize(of(Mat3(1)[axis]));
    std::optional<int> best;
    double least = almost_along;
    for (int other = 0; other < 3; ++other) {
      if (other == axis || !is_seen(other)) continue;
      const double lean = std::abs(glm::dot(glm::normalize(of(Mat3(1)[other])), along));
      if (lean >= least - 1e-9) continue;
      least = lean;
      best = other;
    }
    return best;
  }
};

/// Two points at the ends of the models along an axis.
struct Ends {
  Vec3 from, to;
  double outside = -HUGE_VAL;  ///< how far from the middle of the view, on its side
};

// The ends from which extension lines along `extension` begin on one side of the view: at the outermost place at which
// both ends of the models have points, since in between, lengths along the axis are shifted.
std::optional<Ends> ends_on(double side, int axis, int extension, const Images& images,
                            const std::vector<Vec3>& points) {
  check(axis != extension, "extension lines leave along another axis");
  const int third = 3 - axis - extension;
  Box box;
  for (const Vec3& p : points) box.add(p);
  const double slack = 1e-6 * glm::length(box.size()), place = 10 * slack;
  const Vec2 across = left_of(glm::normalize(images.of(Mat3(1)[axis])));
  const auto outside = [&](const Vec3& p) { return side * glm::dot(images.of(p - box.centre()), across); };
  std::array<std::map<long long, Vec3>, 2> outermost;  // of the points at either end, by their place along `third`
  for (const Vec3& p : points)
    for (const std::size_t end : {0U, 1U}) {
      if (std::abs(p[axis] - (end == 0 ? box.min : box.max)[axis]) > slack) continue;
      const auto [known, is_new] = outermost[end].try_emplace(std::llround(p[third] / place), p);
      if (!is_new && outside(p) > outside(known->second)) known->second = p;
    }
  std::optional<Ends> best;
  for (const auto& [key, p] : outermost[0]) {
    const auto q = outermost[1].find(key);
    if (q == outermost[1].end()) continue;
    const double out = std::min(outside(p), outside(q->second));
    if (best && out <= best->outside + slack) continue;
    best = Ends{p, q->second, out};
    // Side by side along the axis: where the nearer one is, the other extension line begins on the part.
    (outside(p) > out ? best->from : best->to)[extension] = (outside(p) > out ? q->second : p)[extension];
  }
  return best;
}

class PictorialPlanner {
 public:
  PictorialPlanner(const DimensionDescription& wanted, const NamedProjection& view, const DimensionSubject& subject,
                   const Notation& notation)
      : wanted_(wanted), view_(view), subject_(subject), notation_(notation) {}

  std::vector<DimensionDescription> plan() {
    add_sizes();
    add_cylinders(true);
    if (*wanted_.type == DimensionType::automatic) {
      add_holes();
      add_positions();
      add_cylinders(false);
      add_arcs();
    }
    return std::move(dimensions_);
  }

 private:
  DimensionDescription& add(DimensionType type, const std::string& text) {
    DimensionDescription& dimension = dimensions_.emplace_back();
    dimension.where = wanted_.where;
    dimension.view = {view_.name, wanted_.where};
    dimension.type = {type, wanted_.where};
    if (!text.empty()) dimension.text = {text, wanted_.where};
    return dimension;
  }

  void add_sizes() {
    const Images images{view_.projection};
    const std::vector<Vec3> points = features::points_of_faces(subject_.world);
    std::vector<int> done;
    for (const int axis : {0, 1, 2}) {
      const features::Extent& extent = subject_.extents[axis];
      const bool is_done =
          std::any_of(done.begin(), done.end(), [&](int other) { return subject_.extents[other].is_same_as(extent); });
      if (is_done || !images.is_seen(axis) || !(extent.size() > 0) || is_of_cylinder(extent)) continue;
      const auto extension = images.extension_of(axis);
      if (!extension) continue;
      const double first = first_side(glm::normalize(images.of(Mat3(1)[axis])));
      const auto ends = ends_on(first, axis, *extension, images, points),
                 opposite = ends_on(-first, axis, *extension, images, points);
      if (!ends || !opposite) continue;
      done.push_back(axis);
      const std::string sign = extent.form == features::ExtentForm::length ? "" : "⌀<>";
      DimensionDescription& size =
          add(DimensionType::aligned, extent.form == features::ExtentForm::sphere ? "S" + sign : sign);
      const auto at_ends = [&](Ends of_side) {
        of_side.from[axis] = extent.from;
        of_side.to[axis] = extent.to;
        return std::vector{of_side.from, of_side.to};
      };
      const std::vector<Vec3> anchors = at_ends(*ends);
      size.anchors.assign(anchors.begin(), anchors.end());
      size.opposite = at_ends(*opposite);
    }
    check(done.size() <= 3, "an axis has one size");
  }

  // Of equal holes, at one whose mouth the view shows.
  void add_holes() {
    for (const auto& group : groups_of<features::HoleFeature>(subject_.features.holes, features::are_equal)) {
      const auto* shown = *std::max_element(group.begin(), group.end(), [&](const auto* a, const auto* b) {
        return open_end(*a).first < open_end(*b).first - 1e-9;
      });
      const std::string text = times(group.size()) + name_in_note(shown->thread) + recesses_of(*shown, notation_);
      const Vec3 end = open_end(*shown).second;
      // Below its recess, where its circle is drawn.
      add(DimensionType::diameter, text).circle = {
          end == shown->mouth ? shown->begin_of_bore() : end, shown->axis, shown->called() / 2, {}};
    }
  }

  // How far a hole opens towards the eye, and where.
  [[nodiscard]] std::pair<double, Vec3> open_end(const features::HoleFeature& hole) const {
    const double towards = glm::dot(hole.axis, view_.projection.n);
    if (!hole.through || towards >= 0) return {towards, hole.mouth};
    return {-towards, hole.mouth - hole.reach * hole.axis};
  }

  // Of bores and bosses, and of holes that are on no pitch circle, which axonometric views do not draw.
  void add_positions() {
    for (const features::HoleFeature& hole : subject_.features.holes)
      if (hole.pitch_circle < 0) add_position(open_end(hole).second, world_axis(hole.axis));
    for (const features::CylinderFeature& one : subject_.features.cylinders)
      add_position(near_end(one), world_axis(one.axis));
  }

  // Towards the eye.
  [[nodiscard]] Vec3 near_end(const features::CylinderFeature& one) const {
    return glm::dot(one.from - one.to, view_.projection.n) > 0 ? one.from : one.to;
  }

  // Along the axes of the world, from the ends of the models or the axis of round ones; each place once.
  void add_position(const Vec3& centre, int depth) {
    check(depth < 3, "a hole is along an axis of the world, or along none");
    const Images images{view_.projection};
    for (const int axis : {0, 1, 2}) {
      if (depth < 0 || axis == depth || !images.is_seen(axis)) continue;
      const features::Extent& extent = subject_.extents[axis];
      const double end = extent.form == features::ExtentForm::length ? extent.from : (extent.from + extent.to) / 2;
      const auto is_at = [&](double at) { return std::abs(at - centre[axis]) <= features::same_size * extent.size(); };
      if (is_at(end) || std::any_of(places_[axis].begin(), places_[axis].end(), is_at)) continue;
      places_[axis].push_back(centre[axis]);
      Vec3 from = centre;
      from[axis] = end;
      add(DimensionType::aligned, "").anchors = {from, centre};
    }
  }

  // Whether a size is the diameter of a shaft, which stands at its end.
  [[nodiscard]] bool is_of_cylinder(const features::Extent& extent) const {
    const auto& cylinders = subject_.features.cylinders;
    return std::any_of(cylinders.begin(), cylinders.end(),
                       [&](const features::CylinderFeature& one) { return !one.inwards && is_diameter(extent, one); });
  }
  [[nodiscard]] bool is_diameter(const features::Extent& extent, const features::CylinderFeature& cylinder) const {
    return extent.form == features::ExtentForm::diameter &&
           are_written_alike(extent.size(), 2 * cylinder.radius, notation_);
  }

  // Those with the diameters of the whole, or the others.
  void add_cylinders(bool overall) {
    const auto equal = [&](const features::CylinderFeature& a, const features::CylinderFeature& b) {
      return a.inwards == b.inwards && are_written_alike(a.called(), b.called(), notation_);
    };
    for (const auto& group : groups_of<features::CylinderFeature>(subject_.features.cylinders, equal)) {
      const features::CylinderFeature& shown = *group.front();
      const auto is_its = [&](const features::Extent& extent) { return is_diameter(extent, shown); };
      if (std::any_of(subject_.extents.begin(), subject_.extents.end(), is_its) != overall) continue;
      add(DimensionType::diameter, times(group.size()) + name_in_note(shown.thread)).circle = {
          near_end(shown), shown.axis, shown.called(), {}};
    }
  }

  void add_arcs() {
    const auto equal = [&](const features::ArcFeature& a, const features::ArcFeature& b) {
      return are_written_alike(a.radius, b.radius, notation_);
    };
    for (const auto& group : groups_of<features::ArcFeature>(subject_.features.arcs, equal)) {
      const features::ArcFeature& shown =
          **std::max_element(group.begin(), group.end(), [&](const auto* a, const auto* b) {
            return glm::dot(a->centre, view_.projection.n) < glm::dot(b->centre, view_.projection.n) - 1e-9;
          });
      add(DimensionType::radius, times(group.size()) + "<>").circle = {shown.centre, shown.axis, shown.radius,
                                                                       shown.points};
    }
  }

  const DimensionDescription& wanted_;
  const NamedProjection& view_;
  const DimensionSubject& subject_;
  const Notation& notation_;
  std::array<std::vector<double>, 3> places_{};  ///< along each axis, that have their dimensions
  std::vector<DimensionDescription> dimensions_{};
};

}  // namespace

const NamedProjection* only_pictorial(std::span<const NamedProjection> views, const std::string& name) {
  const NamedProjection* pictorial = nullptr;
  for (const NamedProjection& view : views) {
    if (!name.empty() && view.name != name) continue;
    const Vec3 size = glm::abs(view.projection.n);
    if (is_orthographic(view.projection) && std::max({size.x, size.y, size.z}) > 1 - parallel_sine) return nullptr;
    if (pictorial == nullptr && !view.projection.central && view.section == nullptr) pictorial = &view;
  }
  return pictorial;
}

namespace {

// At both ends of a hole, and above its recesses.
std::vector<scene::FeatureCircle> rims_of(const features::HoleFeature& hole) {
  const auto at = [&hole](const Vec3& centre, double diameter) {
    return scene::FeatureCircle{centre, hole.axis, diameter / 2, {}};
  };
  std::vector<scene::FeatureCircle> rims{at(hole.begin_of_bore(), hole.called())};
  for (const auto* recess : {&hole.counterbore, &hole.countersink})
    if (*recess) rims.push_back(at(hole.mouth, (*recess)->diameter));
  if (hole.through) rims.push_back(at(hole.mouth - hole.reach * hole.axis, hole.called()));
  return rims;
}

}  // namespace

std::vector<scene::FeatureCircle> rims_of(const DimensionDescription& dimension,
                                          const features::PartFeatures& features) {
  const bool is_round = dimension.circle.has_value();
  std::vector<scene::FeatureCircle> rims;
  if (!is_round && *dimension.type != DimensionType::aligned) return rims;
  const auto* place = is_round || dimension.anchors.size() != 2 ? nullptr : std::get_if<Vec3>(&dimension.anchors[1]);
  if (!is_round && place == nullptr) return rims;
  const Vec3 centre = is_round ? dimension.circle->centre : *place;
  const auto is_its = [&](const Vec3& point, const Vec3& axis, double radius) {
    return features::distance_from_line(centre, point, axis) <= features::same_size * radius &&
           (!is_round || features::are_parallel(axis, dimension.circle->axis));
  };
  for (const features::HoleFeature& hole : features.holes)
    if (is_its(hole.mouth, hole.axis, hole.called()) &&
        (!is_round || features::are_same(hole.called() / 2, dimension.circle->radius)))
      for (scene::FeatureCircle& rim : rims_of(hole)) rims.push_back(std::move(rim));
  for (const features::CylinderFeature& one : features.cylinders)
    if (is_its(one.from, one.axis, one.called()) &&
        (!is_round || features::are_same(one.called(), dimension.circle->radius)))
      for (const Vec3& end : {one.from, one.to}) rims.push_back({end, one.axis, one.called(), {}});
  for (const features::ArcFeature& arc : features.arcs)
    if (is_round && is_its(arc.centre, arc.axis, arc.radius) &&
        features::are_same(arc.radius, dimension.circle->radius)) {
      rims.push_back({arc.centre, arc.axis, arc.radius, arc.points});
      rims.push_back({arc.other_end, arc.axis, arc.radius, arc.points});
      for (Vec3& point : rims.back().arc) point += arc.other_end - arc.centre;
    }
  check(!is_round || dimension.circle->radius > 0, "a circle has a radius");
  return rims;
}

std::vector<DimensionDescription> pictorial_dimensions(const DimensionDescription& wanted, const NamedProjection& view,
                                                       const DimensionSubject& subject, const Notation& notation) {
  return PictorialPlanner(wanted, view, subject, notation).plan();
}

}  // namespace epura::sheet
