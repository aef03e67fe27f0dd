// SPDX-License-Identifier: Apache-2.0
#include "pipeline/callouts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/error.hpp"
#include "base/text.hpp"
#include "sheet/fit_text.hpp"

namespace epura::pipeline {

namespace {

constexpr double on_line = 0.25;  // mm; half the width of the widest lines

/// A position on the page before parts are left out, and its depth if it comes from the world.
struct PagePoint {
  Vec2 at;
  std::optional<double> depth{};
};

PagePoint page_point(const ViewCallout& callout, const drawing::ViewDrawing& drawing) {
  if (const Vec2* page = std::get_if<Vec2>(&callout.to)) return {drawing.breaks.restored(*page)};
  const Vec4 p = drawing.world_to_page * Vec4(std::get<Vec3>(callout.to), 1);
  if (!(p.w > 0))
    throw Error(ErrorKind::input, callout.description.to.where,
                "the point of " + name_of(callout.description) + " is not in front of the viewer",
                "choose another point, or another view");
  return {Vec2(p) / p.w, p.z / p.w};
}

double distance_to(const drawing::Segment& segment, const Vec2& p) {
  const Vec2 along = segment.to - segment.from;
  const double length = glm::dot(along, along);
  const double t = length > 0 ? std::clamp(glm::dot(p - segment.from, along) / length, 0.0, 1.0) : 0;
  return glm::length(p - segment.from - t * along);
}

bool is_on_line(const drawing::ViewDrawing& drawing, const Vec2& p) {
  return std::any_of(drawing.segments.begin(), drawing.segments.end(),
                     [&p](const drawing::Segment& segment) { return distance_to(segment, p) <= on_line; });
}

// The depth of the nearest face at each point; nothing where there is none.
std::vector<std::optional<double>> depths_at(const std::vector<PagePoint>& points, const scene::World& world,
                                             const Mat4& to_page) {
  std::vector<std::optional<double>> depths(points.size());
  for (const auto& triangle : world.triangles) {
    std::array<Vec3, 3> page;
    bool is_seen = true;
    for (int i = 0; i < 3; ++i) {
      const Vec4 p = to_page * Vec4(world.points[static_cast<std::size_t>(triangle[i])], 1);
      is_seen = is_seen && p.w > 0;
      page[static_cast<std::size_t>(i)] = Vec3(p) / p.w;
    }
    const Vec2 a(page[0]), ab = Vec2(page[1]) - a, ac = Vec2(page[2]) - a;
    const double area = ab.x * ac.y - ab.y * ac.x;
    if (!is_seen || area == 0 || !std::isfinite(area)) continue;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 p = points[i].at - a;
      const double s = (p.x * ac.y - p.y * ac.x) / area, t = (ab.x * p.y - ab.y * p.x) / area;
      if (s < 0 || t < 0 || s + t > 1) continue;
      const double depth = page[0].z + s * (page[1].z - page[0].z) + t * (page[2].z - page[0].z);
      if (!depths[i] || depth > *depths[i]) depths[i] = depth;
    }
  }
  return depths;
}

// Depth in a parallel view by which a face must be nearer to hide a point: points on round faces are chosen on
// the part, not on its facets.
double slack_of(const scene::World& world, const drawing::ViewDrawing& drawing) {
  const Mat4& map = drawing.world_to_page;
  return 0.01 * glm::length(world.box.size()) * glm::length(Vec3(map[0].z, map[1].z, map[2].z));
}

}  // namespace

std::string name_of(const scene::CalloutDescription& callout) { return "note '" + callout.content.lines.front() + "'"; }

CalloutTargets find_targets(const scene::World& world, const drawing::ViewDrawing& drawing,
                            std::span<const ViewCallout> callouts) {
  CalloutTargets found;
  if (callouts.empty()) return found;
  std::vector<PagePoint> points;
  for (const ViewCallout& callout : callouts) points.push_back(page_point(callout, drawing));
  const std::vector<std::optional<double>> depths = depths_at(points, world, drawing.world_to_page);
  const double slack = slack_of(world, drawing);
  for (std::size_t i = 0; i < callouts.size(); ++i) {
    const scene::CalloutDescription& callout = callouts[i].description;
    const Vec2 at = drawing.breaks.moved(points[i].at);
    const bool line = is_on_line(drawing, at);
    const bool is_inside = at.x >= drawing.min.x && at.y >= drawing.min.y && at.x <= drawing.max.x &&
                           at.y <= drawing.max.y && drawing.breaks.keeps(points[i].at);
    if (!line && !(depths[i] && is_inside))
      throw Error(ErrorKind::input, callout.to.where,
                  "view '" + drawing.name + "' shows nothing at the end of the leader of " + name_of(callout) +
                      ", which is at " + format_rounded(at.x, 4) + ", " + format_rounded(at.y, 4) + " mm on the sheet",
                  "choose a point of the models that this view shows");
    if (!line && points[i].depth && !drawing.projection.central && *depths[i] > *points[i].depth + slack)
      found.warnings.push_back("in view '" + drawing.name + "', a face hides the point of " + name_of(callout) +
                               "\n  hint: choose a view or section that shows it");
    const scene::LeaderEnd usual = line ? scene::LeaderEnd::arrow : scene::LeaderEnd::dot;
    const scene::LeaderEnd wanted = callout.end.value_or(scene::LeaderEnd::automatic);
    found.targets.push_back({at, wanted == scene::LeaderEnd::automatic ? usual : wanted});
  }
  return found;
}

double height_of(const scene::CalloutDescription& callout, double text_height) {
  return sheet::line_spacing * static_cast<double>(callout.content.lines.size()) * text_height;
}

sheet::Callout drawn(const scene::CalloutDescription& callout, const sheet::DimensionStyle& style) {
  sheet::Callout result = sheet::note_callout(callout.content.lines, callout.to.given(), style);
  result.name = name_of(callout);
  result.at = callout.at.value;
  return result;
}

}  // namespace epura::pipeline
