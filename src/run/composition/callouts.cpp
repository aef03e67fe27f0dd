// SPDX-License-Identifier: Apache-2.0
#include "composition/callouts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>

#include "annotations/callout_symbols.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "composition/page_triangle.hpp"
#include "dimensions/hatched_areas.hpp"
#include "drawing/drawing.hpp"
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
  if (const Vec2* page = std::get_if<Vec2>(&callout.to)) return {drawing.shown.breaks.restored(*page)};
  const Vec4 p = drawing.world_to_page * Vec4(std::get<Vec3>(callout.to), 1);
  if (!(p.w > 0))
    throw Error(ErrorKind::input, callout.description.to.where,
                "the point of " + name_of(callout.description) + " is not in front of the viewer",
                "choose another point, or another view");
  return {Vec2(p) / p.w, p.z / p.w};
}

// How much ink a view has on the line through a point. At a corner, a line ends, but may go on beyond a gap.
double ink_along(const drawing::ViewDrawing& drawing, const Vec2& p, const Vec2& along) {
  double length = 0;
  for (const drawing::Segment& segment : drawing.segments)
    if (std::abs(cross(along, segment.from - p)) <= on_line && std::abs(cross(along, segment.to - p)) <= on_line)
      length += std::abs(glm::dot(along, segment.to - segment.from));
  return length;
}

// The line at a point, by its direction: the longest one of those that do not end there, if there is one.
std::optional<Vec2> line_at(const drawing::ViewDrawing& drawing, const Vec2& p) {
  std::optional<Vec2> best;
  double most = -1;
  for (const drawing::Segment& segment : drawing.segments) {
    const Vec2 along = segment.to - segment.from;
    const double length = glm::length(along);
    if (is_link(segment) || !(length > 0)) continue;
    const double at = glm::dot(p - segment.from, along) / length, inside = std::clamp(at, 0.0, length);
    if (glm::length(p - segment.from - inside / length * along) > on_line) continue;
    const bool passes = at > on_line && at < length - on_line;
    const double worth = ink_along(drawing, p, along / length) + (passes ? 1e6 : 0);
    if (worth <= most) continue;
    most = worth;
    best = along / length;
  }
  return best;
}

// The depth of the nearest face at each point; nothing where there is none.
std::vector<std::optional<double>> depths_at(const std::vector<PagePoint>& points, const world::World& world,
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
    const PageTriangle seen(page);
    if (!is_seen || seen.is_edge_on()) continue;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto depth = seen.depth_at(points[i].at);
      if (depth && (!depths[i] || *depth > *depths[i])) depths[i] = depth;
    }
  }
  return depths;
}

// Depth in a parallel view by which a face must be nearer to hide a point: points on round faces are chosen on
// the part, not on its facets.
double slack_of(const world::World& world, const drawing::ViewDrawing& drawing) {
  const Mat4& map = drawing.world_to_page;
  return 0.01 * glm::length(world.box.size()) * glm::length(Vec3(map[0].z, map[1].z, map[2].z));
}

/// Names of kinds of callouts.
struct NameOf {
  std::string operator()(const scene::NoteText& note) const { return "note '" + note.lines.front() + "'"; }
  std::string operator()(const scene::ToleranceFrame& frame) const {
    return "the tolerance of " + std::string(scene::row_of(frame.characteristic).name);
  }
  std::string operator()(const scene::DatumFeature& datum) const { return "datum " + datum.letter; }
  std::string operator()(const scene::DatumTarget& target) const { return "datum target " + target.label; }
  std::string operator()(const scene::SurfaceTexture& texture) const {
    return "the surface texture" + (texture.lines.empty() ? "" : " '" + texture.lines.front() + "'");
  }
};

struct HeightOf {
  double operator()(const scene::NoteText& note) const {
    return sheet::line_spacing * static_cast<double>(note.lines.size());
  }
  double operator()(const auto& symbol) const { return sheet::height_of(symbol); }
};

// A point of the page on either side of each line, before parts are left out.
std::vector<PagePoint> beside(const std::vector<PagePoint>& points, const std::vector<std::optional<Vec2>>& lines) {
  constexpr double aside = 1;  // mm
  std::vector<PagePoint> both;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const double side : {-aside, aside})
      both.push_back({points[i].at + (lines[i] ? side * left_of(*lines[i]) : Vec2(0, 0))});
  return both;
}

void expect_line(const ViewCallout& callout, const std::string& view) {
  if (std::holds_alternative<scene::DatumFeature>(callout.description.content))
    throw Error(ErrorKind::input, callout.description.to.where,
                name_of(callout.description) + " does not stand on a line of view '" + view + "'",
                "choose a point of an edge or outline that the view shows");
}

void expect_shown(const ViewCallout& callout, const Vec2& at, const drawing::ViewDrawing& drawing, bool is_shown) {
  if (is_shown) return;
  throw Error(ErrorKind::input, callout.description.to.where,
              "view '" + drawing.name + "' shows nothing at the end of the leader of " + name_of(callout.description) +
                  ", which is at " + format_rounded(at.x, 4) + ", " + format_rounded(at.y, 4) + " mm on the sheet",
              "choose a point of the models that this view shows");
}

// Whether there is nothing on one side of a line because it is the rim of a hole, which leaders reach from outside.
bool is_enclosed(const drawing::ViewDrawing& drawing, const Vec2& at, const Vec2& normal) {
  constexpr double past_line = 0.5;  // mm
  const double far = glm::length(drawing.box.max - drawing.box.min), half = 0.5, rise = std::sqrt(3.0) / 2;
  const Vec2 across = left_of(normal);
  const std::array<Vec2, 3> ways{normal, half * normal + rise * across, half * normal - rise * across};
  return std::all_of(ways.begin(), ways.end(), [&](const Vec2& way) {
    return sheet::ink_in(sheet::line_box(at + past_line * way, at + far * way), drawing) > 0;
  });
}

// The side of a line on which there is no hatching, if it is on the other one: in the middle of the directions from the
// point that leave cut material.
std::optional<Vec2> out_of_material(const sheet::HatchedAreas& hatched, const Vec2& at, const Vec2& normal) {
  constexpr int directions = 16;
  constexpr double aside = 1;  // mm
  Vec2 free(0, 0);
  for (int i = 0; i < directions; ++i)
    if (const Vec2 way = sheet::turned_to(2 * std::numbers::pi * (i + 0.5) / directions);
        !hatched.contains(at + aside * way))
      free += way;
  const double out = glm::dot(free, normal);
  if (std::abs(out) < 1) return std::nullopt;
  return out > 0 ? normal : -normal;
}

// As an orthographic view shows it where nothing is left out; nothing if that looks across its axis.
std::optional<sheet::RimOnPaper> rim_in(const drawing::ViewDrawing& drawing, const scene::FeatureCircle& rim) {
  constexpr double flat = 0.05;  // of its width
  if (drawing.projection.central || drawing.shown.breaks.any()) return std::nullopt;
  const Vec3 one = glm::normalize(glm::cross(rim.axis, std::abs(rim.axis.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  const auto on_page = [&](const Vec4& p) { return Vec2(drawing.world_to_page * p) / drawing.world_to_page[3].w; };
  const Vec2 u = on_page(Vec4(rim.radius * one, 0)), v = on_page(Vec4(rim.radius * glm::cross(rim.axis, one), 0));
  if (std::abs(cross(u, v)) < flat * (glm::dot(u, u) + glm::dot(v, v))) return std::nullopt;
  return sheet::RimOnPaper{on_page(Vec4(rim.centre, 1)), u, v};
}

LeaderEnd end_of(const scene::CalloutDescription& callout, bool on_a_line) {
  const LeaderEnd wanted = callout.end.value_or(LeaderEnd::automatic);
  if (wanted != LeaderEnd::automatic) return wanted;
  return on_a_line ? LeaderEnd::arrow : LeaderEnd::dot;
}

}  // namespace

std::string name_of(const scene::CalloutDescription& callout) { return std::visit(NameOf(), callout.content); }

CalloutTargets find_targets(const world::World& world, const drawing::ViewDrawing& drawing,
                            std::span<const ViewCallout> callouts, bool is_partial) {
  CalloutTargets found;
  if (callouts.empty()) return found;
  std::vector<PagePoint> points;
  std::vector<std::optional<Vec2>> lines;
  for (const ViewCallout& callout : callouts) {
    points.push_back(page_point(callout, drawing));
    lines.push_back(line_at(drawing, drawing.shown.breaks.moved(points.back().at)));
  }
  const std::vector<std::optional<double>> depths = depths_at(points, world, drawing.world_to_page);
  const std::vector<std::optional<double>> sides = depths_at(beside(points, lines), world, drawing.world_to_page);
  const double slack = slack_of(world, drawing);
  const sheet::HatchedAreas hatched(drawing);
  for (std::size_t i = 0; i < callouts.size(); ++i) {
    const Vec2 at = drawing.shown.breaks.moved(points[i].at);
    const bool is_inside = at.x >= drawing.box.min.x && at.y >= drawing.box.min.y && at.x <= drawing.box.max.x &&
                           at.y <= drawing.box.max.y && drawing.shown.breaks.keeps(points[i].at);
    const bool is_shown = lines[i] || (depths[i] && is_inside);
    const bool needs_line = std::holds_alternative<scene::DatumFeature>(callouts[i].description.content);
    if (!callouts[i].description.requirement.empty() && !(needs_line ? lines[i].has_value() : is_shown)) {
      found.targets.emplace_back();
      continue;
    }
    if (!is_partial) expect_shown(callouts[i], at, drawing, is_shown);
    sheet::CalloutTarget target{at, end_of(callouts[i].description, lines[i].has_value())};
    if (lines[i]) {
      const bool right = sides[2 * i].has_value(), left = sides[2 * i + 1].has_value();
      const Vec2 normal = (left && !right ? -1.0 : 1.0) * left_of(*lines[i]);
      target.is_border = left != right;
      target.normal = target.is_border && is_enclosed(drawing, at, normal) ? -normal : normal;
      if (const auto out = out_of_material(hatched, at, normal)) {
        target.is_border = true;
        target.normal = out;
      }
      if (const auto& rim = callouts[i].description.rim; rim && !callouts[i].is_moved)
        target.rim = rim_in(drawing, *rim);
      if (target.rim) target.normal.reset();
    } else {
      if (!is_partial) expect_line(callouts[i], drawing.name);
      if (points[i].depth && !drawing.projection.central && depths[i] && *depths[i] > *points[i].depth + slack)
        found.warnings.push_back("in view '" + drawing.name + "', a face hides the point of " +
                                 name_of(callouts[i].description) + "\n  hint: choose a view or section that shows it");
    }
    found.targets.push_back(target);
  }
  return found;
}

double height_of(const scene::CalloutDescription& callout, double text_height) {
  return text_height * std::visit(HeightOf(), callout.content);
}

sheet::Callout drawn(const scene::CalloutDescription& callout, const sheet::DimensionStyle& style) {
  struct Draw {
    const sheet::DimensionStyle& style;
    bool has_leader;

    sheet::Callout operator()(const scene::NoteText& note) const {
      std::vector<std::string> lines = note.lines;
      if (note.has_values)
        for (std::string& line : lines) line = sheet::with_own_signs(std::move(line), style);
      return sheet::note_callout(lines, has_leader, style);
    }
    sheet::Callout operator()(const scene::ToleranceFrame& frame) const { return sheet::tolerance_frame(frame, style); }
    sheet::Callout operator()(const scene::DatumFeature& datum) const { return sheet::datum_frame(datum, style); }
    sheet::Callout operator()(const scene::DatumTarget& target) const { return sheet::target_symbol(target, style); }
    sheet::Callout operator()(const scene::SurfaceTexture& texture) const {
      return sheet::texture_symbol(texture, style);
    }
  };
  sheet::Callout result = std::visit(Draw{style, callout.to.given()}, callout.content);
  result.name = name_of(callout);
  result.requirement = callout.requirement;
  result.at = callout.at.value;
  return result;
}

const std::string& view_of_callout(const scene::CalloutDescription& callout, const scene::SceneDescription& scene) {
  if (callout.view.given()) return *callout.view;
  for (const scene::DimensionDescription& dimension : scene.dimensions)
    if (callout.dimension.given() && dimension.name.value == callout.dimension.value && dimension.view.given())
      return *dimension.view;
  return *scene.views.front().name;
}

void expect_datums(const scene::SceneDescription& scene) {
  const auto sheet_of = [&scene](const scene::CalloutDescription& callout) {
    const std::string& name = view_of_callout(callout, scene);
    const auto is_it = [&name](const scene::ViewDescription& view) { return *view.name == name; };
    return std::find_if(scene.views.begin(), scene.views.end(), is_it)->sheet.value_or(1);
  };
  std::map<int, std::vector<std::string>> letters;  // by sheet
  for (const scene::CalloutDescription& callout : scene.callouts)
    if (const auto* datum = std::get_if<scene::DatumFeature>(&callout.content)) {
      std::vector<std::string>& here = letters[sheet_of(callout)];
      if (std::find(here.begin(), here.end(), datum->letter) != here.end())
        throw Error(ErrorKind::input, callout.where, "datum " + datum->letter + " is on the sheet twice",
                    "use another letter");
      here.push_back(datum->letter);
    }
  for (const scene::CalloutDescription& callout : scene.callouts) {
    const auto* frame = std::get_if<scene::ToleranceFrame>(&callout.content);
    if (frame == nullptr) continue;
    const std::vector<std::string>& here = letters[sheet_of(callout)];
    for (const std::string& letter : frame->letters)
      if (std::find(here.begin(), here.end(), letter) == here.end())
        throw Error(ErrorKind::input, callout.where,
                    "the sheet has no datum " + letter + ", to which " + name_of(callout) + " refers",
                    here.empty() ? "add a [[datum]]" : did_you_mean(letter, here));
  }
}

}  // namespace epura::pipeline
