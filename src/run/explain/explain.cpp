// SPDX-License-Identifier: Apache-2.0
#include "explain/explain.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "drawing/closed_line.hpp"
#include "drawing/drawing.hpp"
#include "drawing/ink.hpp"
#include "drawing/limits.hpp"
#include "explain/reason.hpp"

namespace epura::explain {

namespace {

constexpr std::size_t max_named = 5;
// Multiple of the tolerance for coincident lines: the line that has the ink may have replaced one that had replaced
// another.
constexpr double steps_of_coincidence = 2;

struct Storyteller {
  const ExplainInput& drawn_view;
  const edges::FeatureEdge& edge;
  Subject subject;

  // In the whole view, whose parts an interrupted view moves together.
  [[nodiscard]] Vec2 position(double s) const {
    return drawing::position_on_paper(drawn_view.view, drawn_view.paper, edge, s);
  }
  [[nodiscard]] std::string on_sheet(const Vec2& position) const {
    return format_value(drawn_view.drawing.shown.breaks.moved(position));
  }
  [[nodiscard]] std::string in_space(double s) const {
    return format_value(drawing::parameter_in_space(drawn_view.view, edge, s));
  }

  [[nodiscard]] std::string story(const Span& span, const std::vector<Occlusion>& hiders) const {
    std::string text = std::string("  ") + (span.visible ? "visible" : "hidden ") + " t " + in_space(span.from) +
                       " to " + in_space(span.to) + ", " + on_sheet(position(span.from)) + " to " +
                       on_sheet(position(span.to)) + " mm\n";
    if (!span.visible) text += hidden_by(span, hiders);
    return text + ink_of(span);
  }

  [[nodiscard]] std::string hidden_by(const Span& span, const std::vector<Occlusion>& hiders) const {
    std::string text;
    std::size_t count = 0;
    for (const Occlusion& hider : hiders) {
      std::string parts;
      for (const auto& [begin, end] : hider.parts) {
        const double from = std::max(begin, span.from);
        const double to = std::min(end, span.to);
        if (from < to) append_to_list(parts, in_space(from) + " to " + in_space(to));
      }
      if (parts.empty() || ++count > max_named) continue;
      text += "    by face " + name_of(hider.face) + " of " + owner_of(drawn_view.world, hider.face) + ", " +
              format_value(hider.ahead) + " in front, t " + parts + "\n";
    }
    if (count > max_named) text += "    and by " + std::to_string(count - max_named) + " more\n";
    return text;
  }

  [[nodiscard]] bool is_own(const drawing::Segment& segment) const {
    if (segment.model != edge.model) return false;
    const std::vector<FaceName> faces = faces_at(drawn_view, subject);
    if (subject.mesh_edge < 0)
      return segment.crossing >= 0 && std::equal(faces.begin(), faces.end(), faces_of(segment).begin());
    const mesh::Mesh& mesh = *drawn_view.world.models[edge.model].mesh;
    const mesh::EdgeOrigin origin = mesh.origin_of(mesh.edges[edge.mesh_edge]);
    // Outlines of cuts may also run along edges of the file, and without their faces.
    if (!origin.in_file)
      return segment.kind == EdgeKind::section && segment.crossing >= 0 && !faces.empty() &&
             faces_of(segment)[0] == faces[0];
    return segment.edge == origin.vertex;
  }

  // For a span without ink of its own: which edges draw that place, or why none does.
  [[nodiscard]] std::string ink_of(const Span& span) const {
    const drawing::Coincidence limits = drawing::coincidence_on_paper(drawn_view.view, drawn_view.paper);
    if (!span.visible && !drawn_view.keep_hidden) return "    no ink: hidden lines are switched off\n";
    if (!(glm::distance(position(span.from), position(span.to)) > limits.tolerance))
      return "    no ink: a point on the sheet\n";
    const drawing::Ruler line(position(span.from), position(span.to));
    visibility::Spans inked = cut_off(line, limits.min);
    if (visibility::covers(inked, limits.min, line.length - limits.min))
      return drawn_view.drawing.shown.detail ? "    no ink: outside the detail\n" : "    no ink: left out by a break\n";
    add_broken_out(inked, line, limits.min);
    if (visibility::covers(inked, limits.min, line.length - limits.min))
      return "    no ink: inside a broken-out section\n";
    std::vector<std::string> others, near;
    for (const drawing::Segment& segment : drawn_view.drawing.segments) {
      const bool own = segment.visible == span.visible && is_own(segment);
      const double tolerance = steps_of_coincidence * limits.tolerance;
      const Vec2 from = drawn_view.drawing.shown.breaks.restored(segment.from);
      const Vec2 to = drawn_view.drawing.shown.breaks.restored(segment.to);
      const auto part = drawing::covered_part(line, from, to, tolerance, own ? 0 : limits.min);
      if (!own && segment.visible >= span.visible && !(part[0] < part[1])) {
        const double reach = drawn_view.drawing.distances.joined_within;
        const auto beside = drawing::covered_part(line, from, to, reach, std::max(reach, limits.min));
        if (beside[0] < beside[1]) near.push_back(over(line, beside) + name_of(segment));
      }
      if (!(part[0] < part[1])) continue;
      if (own)
        visibility::add_span(inked, part);
      else
        others.push_back(over(line, part) + name_of(segment));
    }
    if (visibility::covers(inked, limits.min, line.length - limits.min)) return "";
    std::string text;
    for (const std::string& other : others) text += "    no ink " + other + " is drawn there\n";
    if (others.empty())
      for (const std::string& other : near) text += "    no ink " + other + " is drawn next to it\n";
    if (!text.empty()) return text;
    if (!drawn_view.hidden.folds_of(static_cast<std::size_t>(subject.drawn)).empty())
      return "    no ink: no line of its face, which goes on right behind it\n";
    return "    no ink: shorter than " + format_value(limits.min) + " mm\n";
  }

  // The parts of a line that are outside the detail shown or left out by breaks, up to `slack` mm inside it.
  [[nodiscard]] visibility::Spans cut_off(const drawing::Ruler& line, double slack) const {
    visibility::Spans outside;
    const auto& detail = drawn_view.drawing.shown.detail;
    const bool is_freehand = drawn_view.drawing.shown.breaks.freehand;
    if (!detail) return left_out(line, is_freehand ? slack + drawing::freehand_wave : slack);
    const auto part = drawing::part_inside(detail->boundary, line.from, line.from + line.length * line.along);
    if (!part) return {{0, line.length}};
    const auto [first, last] = *part;
    if (first > 0) visibility::add_span(outside, {0, first * line.length + slack});
    if (last < 1) visibility::add_span(outside, {last * line.length - slack, line.length});
    return outside;
  }

  // Adds the parts of a line of the whole models that broken-out sections do not show.
  void add_broken_out(visibility::Spans& outside, const drawing::Ruler& line, double slack) const {
    for (const drawing::BrokenOut& one : drawn_view.drawing.cuts.broken_out)
      for (const auto& [from, to] :
           drawing::ClosedLine(one.ring).parts(line.from, line.from + line.length * line.along, true))
        visibility::add_span(outside, {from * line.length - slack, to * line.length + slack});
  }

  [[nodiscard]] visibility::Spans left_out(const drawing::Ruler& line, double slack) const {
    visibility::Spans outside;
    double kept = 0;
    for (const auto& [from, to] :
         drawing::kept_of_line(drawn_view.drawing.shown.breaks, line.from, line.from + line.length * line.along)) {
      if (from > kept) visibility::add_span(outside, {kept * line.length - slack, from * line.length + slack});
      kept = to;
    }
    if (kept < 1) visibility::add_span(outside, {kept * line.length - slack, line.length});
    return outside;
  }

  [[nodiscard]] std::string over(const drawing::Ruler& line, const std::array<double, 2>& part) const {
    return "from " + on_sheet(line.from + part[0] * line.along) + " to " + on_sheet(line.from + part[1] * line.along) +
           " mm: ";
  }

  [[nodiscard]] static std::string name_of(const FaceName& face) { return explain::name_of(face); }
  [[nodiscard]] const std::array<FaceName, 2>& faces_of(const drawing::Segment& segment) const {
    return drawn_view.drawing.crossings[segment.crossing].faces;
  }
  [[nodiscard]] std::string name_of(const drawing::Segment& segment) const {
    const std::string kind =
        (segment.visible ? "visible " : "hidden ") + std::string(epura::edges::name_of(segment.kind));
    if (segment.edge[0] < 0) {
      const auto& [face, other] = faces_of(segment);
      return kind + " " + name_of(face) + (other[0] < 0 ? "" : "x" + name_of(other));
    }
    return kind + " " + std::to_string(drawn_view.drawing.number_in_scene(segment.model)) + ":" +
           std::to_string(segment.edge[0]) + "-" + std::to_string(segment.edge[1]);
  }
};

}  // namespace

std::string explain(const ExplainInput& drawn_view, const TriangleBoxes& boxes, const Subject& subject) {
  const auto ends = ends_of(drawn_view, subject);
  std::string text = name_of(drawn_view, subject) + " of " + owner_of(drawn_view, subject) + ", " +
                     format_value(ends[0]) + " to " + format_value(ends[1]) +
                     (subject.away ? ", " + format_value(*subject.away) + " mm from the place" : "") + "\n  " +
                     reason_of(drawn_view, subject) + "\n";
  if (subject.drawn < 0) return text;
  const Storyteller teller{drawn_view, drawn_view.drawn.edges[subject.drawn], subject};
  const std::vector<Occlusion> hiders = find_hiders(drawn_view, boxes, subject.drawn);
  for (const Span& span : spans_of(drawn_view.hidden, subject.drawn)) text += teller.story(span, hiders);
  for (const visibility::FacetsSpan& span : drawn_view.hidden.hidden_by_facets(static_cast<std::size_t>(subject.drawn)))
    text += "  only facets of its own face, whose surface does not, hide t " + teller.in_space(span.from) + " to " +
            teller.in_space(span.to) + ": it is drawn as visible where that closes a gap, else as hidden\n";
  return text;
}

}  // namespace epura::explain
