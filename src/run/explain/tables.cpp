// SPDX-License-Identifier: Apache-2.0
#include "explain/tables.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "drawing/drawing.hpp"
#include "explain/reason.hpp"

namespace epura::explain {

namespace {

constexpr std::size_t rows_at_once = 64;

std::string cells(const Vec2& p) { return format_number(p.x) + "\t" + format_number(p.y); }

Vec2 position(const ExplainInput& drawn_view, const edges::FeatureEdge& edge, double s) {
  return drawn_view.drawing.shown.breaks.moved(drawing::position_on_paper(drawn_view.view, drawn_view.paper, edge, s));
}

std::string row_of_edge(const ExplainInput& drawn_view, std::size_t e) {
  const Subject subject = drawn_subject(drawn_view, e);
  const edges::FeatureEdge& edge = drawn_view.drawn.edges[e];
  const auto angle = angle_at(drawn_view, subject);
  std::string faces;
  for (const FaceName& face : faces_at(drawn_view, subject)) faces += (faces.empty() ? "" : ",") + name_of(face);
  const auto ends = ends_of(drawn_view, subject);
  return name_of(drawn_view, subject) + "\t" + std::string(edges::name_of(edge.kind)) + "\t" +
         (angle ? format_number(*angle) : "-") + "\t" + faces + "\t" + cells(position(drawn_view, edge, 0)) + "\t" +
         cells(position(drawn_view, edge, 1)) + "\t" +
         format_number((edge.t[1] - edge.t[0]) * glm::distance(ends[0], ends[1])) + "\n";
}

// Returns the number of faces that hide a span, and the nearest of those that hide its middle.
std::string hiders_of(const Span& span, const std::vector<Occlusion>& hiders) {
  const double middle = (span.from + span.to) / 2;
  int count = 0;
  const Occlusion* nearest = nullptr;
  for (const Occlusion& hider : hiders) {
    const auto meets = [&](const auto& part) { return part[0] < span.to && span.from < part[1]; };
    if (!std::any_of(hider.parts.begin(), hider.parts.end(), meets)) continue;
    ++count;
    if (nearest == nullptr && visibility::covers(hider.parts, middle, middle)) nearest = &hider;
  }
  return std::to_string(count) + "\t" +
         (nearest == nullptr ? "-\t-" : name_of(nearest->face) + "\t" + format_number(nearest->ahead));
}

std::string rows_of_spans(const ExplainInput& drawn_view, const TriangleBoxes& boxes, std::size_t e) {
  const edges::FeatureEdge& edge = drawn_view.drawn.edges[e];
  const std::vector<Span> spans = spans_of(drawn_view.hidden, e);
  const bool hidden = std::any_of(spans.begin(), spans.end(), [](const Span& span) { return !span.visible; });
  const std::vector<Occlusion> hiders = hidden ? find_hiders(drawn_view, boxes, e) : std::vector<Occlusion>{};
  const std::string name =
      name_of(drawn_view, drawn_subject(drawn_view, e)) + "\t" + std::string(edges::name_of(edge.kind));
  std::string rows;
  for (const Span& span : spans)
    rows += name + "\t" + cells(position(drawn_view, edge, span.from)) + "\t" +
            cells(position(drawn_view, edge, span.to)) + "\t" +
            format_number(drawing::parameter_in_space(drawn_view.view, edge, span.from)) + "\t" +
            format_number(drawing::parameter_in_space(drawn_view.view, edge, span.to)) + "\t" +
            (span.visible ? "visible\t0\t-\t-" : "hidden\t" + hiders_of(span, hiders)) + "\n";
  return rows;
}

template <class Rows>
std::string table(const std::string& header, std::size_t count, const Progress& progress, Rows rows) {
  std::vector<std::string> parts(count);
  progress.begin("answering", count);
  parallel_for(count, rows_at_once, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      progress.expect_time();
      parts[e] = rows(e);
    }
    progress.advance(end - begin);
  });
  std::string text = header;
  for (const std::string& part : parts) text += part;
  return text;
}

}  // namespace

std::string edge_table(const ExplainInput& drawn_view, const Progress& progress) {
  return table("edge\tkind\tangle\tfaces\tx0\ty0\tx1\ty1\tlength\n", drawn_view.drawn.edges.size(), progress,
               [&](std::size_t e) { return row_of_edge(drawn_view, e); });
}

std::string span_table(const ExplainInput& drawn_view, const TriangleBoxes& boxes, const Progress& progress) {
  return table("edge\tkind\tx0\ty0\tx1\ty1\tt0\tt1\tvisibility\thiders\tnearest\tahead\n",
               drawn_view.drawn.edges.size(), progress,
               [&](std::size_t e) { return rows_of_spans(drawn_view, boxes, e); });
}

}  // namespace epura::explain
