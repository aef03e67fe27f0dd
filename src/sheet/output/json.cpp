// SPDX-License-Identifier: Apache-2.0
// Drawing JSON, schema 1 (docs/formats.md). RFC 8259.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "construction/figure.hpp"
#include "drawing/drawing.hpp"
#include "output/format.hpp"
#include "output/in_order.hpp"
#include "output/json_annotations.hpp"
#include "output/json_text.hpp"
#include "report/format.hpp"
#include "report/report.hpp"

namespace epura::output {

namespace {

void append(std::string& text, double value) {
  check(std::isfinite(value), "a number in the drawing is not finite");
  append_number(text, value);
}

void append(std::string& text, int value) { text += std::to_string(value); }

std::string number(double value) {
  std::string text;
  append(text, value);
  return text;
}

std::string number(int value) { return std::to_string(value); }

std::string number(long long value) { return std::to_string(value); }

std::string boolean(bool value) { return value ? "true" : "false"; }

template <class Items>
void append_numbers(std::string& text, const Items& items) {
  text += '[';
  bool first = true;
  for (const auto item : items) {
    if (!std::exchange(first, false)) text += ", ";
    append(text, item);
  }
  text += ']';
}

template <class Items>
std::string numbers(const Items& items) {
  std::string text;
  append_numbers(text, items);
  return text;
}

std::array<double, 2> coordinates(const Vec2& p) { return {p.x, p.y}; }

std::array<double, 3> coordinates(const Vec3& p) { return {p.x, p.y, p.z}; }

std::string point(const Vec2& p) { return numbers(coordinates(p)); }

std::string point(const Vec3& p) { return numbers(coordinates(p)); }

void append_segment(std::string& text, const drawing::ViewDrawing& drawing, const drawing::Segment& segment) {
  append_numbers(text += "{\"from\": ", coordinates(segment.from));
  append_numbers(text += ", \"to\": ", coordinates(segment.to));
  text += segment.visible ? ", \"visible\": true" : ", \"visible\": false";
  text.append(", \"kind\": \"").append(edges::name_of(segment.kind));
  append(text += "\", \"model\": ", drawing.number_in_scene(segment.model));
  if (segment.body >= 0) append(text += ", \"body\": ", segment.body);
  if (segment.edge[0] >= 0) {
    append_numbers(text += ", \"edge\": ", segment.edge);
    append_numbers(text += ", \"t\": ", segment.t);
  } else {
    // An edge and t give the position in the world; an intersection line or a cut has its own coordinates.
    append_numbers(text += ", \"edge\": null, \"t\": ", segment.t);
    const drawing::CrossingSegment& crossing = drawing.crossings[segment.crossing];
    text += ", \"faces\": [";
    if (crossing.faces[0][1] >= 0) append_numbers(text, crossing.faces[0]);
    if (crossing.faces[1][0] >= 0) append_numbers(text += ", ", crossing.faces[1]);
    append_numbers(text += "], \"world\": [", coordinates(crossing.world[0]));
    append_numbers(text += ", ", coordinates(crossing.world[1]));
    text += ']';
  }
  text += '}';
}

void append_segments(std::string& text, const drawing::ViewDrawing& drawing, const Progress& progress) {
  const std::vector<drawing::Segment>& segments = drawing.segments;
  constexpr std::size_t at_once = 4096, max_bytes = 512;
  text.reserve(text.size() + max_bytes * segments.size());  // untouched memory costs nothing
  text += '[';
  append_in_order(text, (segments.size() + at_once - 1) / at_once, progress, [&](std::size_t part, std::string& lines) {
    for (std::size_t i = part * at_once; i < std::min((part + 1) * at_once, segments.size()); ++i) {
      lines += i > 0 ? ",\n    " : "\n    ";
      append_segment(lines, drawing, segments[i]);
    }
  });
  text += ']';
}

// Appends nothing for a drawing without curves.
void append_curves(std::string& text, const drawing::ViewDrawing& drawing) {
  std::string lines;
  for (const drawing::Chain& chain : drawing.chains) {
    for (const drawing::CurvePart& curve : chain.curves) {
      lines += lines.empty() ? "\n    {\"centre\": " : ",\n    {\"centre\": ";
      append_numbers(lines, coordinates(curve.centre));
      append_numbers(lines += ", \"u\": ", coordinates(curve.u));
      append_numbers(lines += ", \"v\": ", coordinates(curve.v));
      append_numbers(lines += ", \"angles\": ", std::array{curve.from, curve.to});
      lines += chain.visible ? ", \"visible\": true" : ", \"visible\": false";
      lines.append(", \"kind\": \"").append(edges::name_of(chain.kind)).append("\"}");
    }
  }
  if (!lines.empty()) text += ",\n   \"curves\": [" + lines + "]";
}

std::string parameters_of(const projection::Projection& projection) {
  std::string text;
  for (const auto& [name, values] : projection.values) {
    append_to_list(text, json_string(name) + ": " + (values.size() == 1 ? number(values[0]) : numbers(values)));
  }
  return "{" + text + "}";
}

std::string matrix(const Mat4& m) {
  std::array<double, 16> by_rows{};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) by_rows[static_cast<std::size_t>(4 * row + column)] = m[column][row];
  return numbers(by_rows);
}

std::string detail_of(const drawing::DetailFrame& detail) {
  const drawing::Boundary& boundary = detail.boundary;
  return "{\"name\": " + json_string(detail.name) + ", \"of\": " + json_string(detail.parent) +
         ", \"centre\": " + point(boundary.centre) +
         (boundary.round ? ", \"radius\": " + number(boundary.half.x) : ", \"size\": " + point(2.0 * boundary.half)) +
         "}";
}

// One entry for each part left out. JSON has no infinity.
std::string breaks_of(const drawing::Breaks& breaks) {
  std::vector<std::string> parts;
  const auto place = [](double at) { return std::isinf(at) ? "null" : number(at); };
  for (const std::size_t axis : {0, 1})
    for (const drawing::LeftOut& strip : breaks.along[axis])
      parts.push_back(std::string("{\"along\": \"") + (axis == 0 ? "x" : "y") + "\", \"from\": " + place(strip.from) +
                      ", \"to\": " + place(strip.to) + (strip.symmetric ? ", \"symmetric\": true}" : "}"));
  return "{\"gap\": " + number(breaks.gap) +
         ", \"parts\": " + json_list(parts, [](const std::string& part) { return part; }) + "}";
}

std::string cut_face_of(const drawing::CutFace& face) {
  const auto ring_of = [](const std::vector<Vec2>& ring) {
    return json_list(ring, [](const Vec2& p) { return point(p); });
  };
  return "{\"model\": " + number(face.model) + ", \"body\": " + number(face.body) +
         ", \"rings\": " + json_list(face.rings, ring_of) + "}";
}

std::string broken_out_of(const drawing::BrokenOut& one) {
  const auto line_of = [](const std::vector<Vec2>& line) {
    return json_list(line, [](const Vec2& p) { return point(p); });
  };
  return "{\"ring\": " + line_of(one.ring) + ", \"lines\": " + json_list(one.lines, line_of) + "}";
}

std::string symbol_of(const construction::Symbol& symbol) { return json_string(symbol.text()); }

std::string point_of_construction(const construction::Point& one) {
  return "{\"symbol\": " + symbol_of(one.symbol) + ", \"at\": " + point(one.at) +
         (one.also.empty() ? "" : ", \"also\": " + json_list(one.also, symbol_of)) + "}";
}

std::string line_of_construction(const construction::Line& line) {
  constexpr std::array extents{"segment", "ray", "line"};
  return "{\"from\": " + point(line.from) + ", \"to\": " + point(line.to) + ", \"extent\": \"" +
         extents[static_cast<std::size_t>(line.extent)] + "\"" +
         (line.symbol.empty() ? "" : ", \"symbol\": " + symbol_of(line.symbol)) + "}";
}

std::string curve_of_construction(const construction::Curve& curve) {
  return "{\"centre\": " + point(curve.centre) + ", \"u\": " + point(curve.u) + ", \"v\": " + point(curve.v) +
         ", \"angles\": " + numbers(std::array{curve.from, curve.to}) +
         (curve.symbol.empty() ? "" : ", \"symbol\": " + symbol_of(curve.symbol)) + "}";
}

// On paper, whether it is on the sheet or beyond; "figures" stand beside the view, in positions of their own.
std::string construction_of(const construction::Figure& figure) {
  return "{\"points\": " + json_lines(figure.points, point_of_construction, "\n     ") +
         ",\n    \"lines\": " + json_lines(figure.lines, line_of_construction, "\n     ") +
         ",\n    \"curves\": " + json_lines(figure.curves, curve_of_construction, "\n     ") +
         (figure.keys.empty() ? "" : ",\n    \"figures\": " + json_list(figure.keys, construction_of)) + "}";
}

void append_view(std::string& text, const drawing::ViewDrawing& drawing, double main_scale, const Progress& progress) {
  const projection::Projection& projection = drawing.projection;
  const auto vanishing_point = [](const std::optional<Vec2>& p) { return p ? point(*p) : "null"; };
  text +=
      "{\"name\": " + json_string(drawing.name) + ", \"projection\": " + json_string(projection.name) +
      ", \"parameters\": " + parameters_of(projection) +
      (drawing.scale == main_scale ? "" : ", \"scale\": " + number(drawing.scale)) +
      (drawing.shown.detail ? ",\n   \"detail\": " + detail_of(*drawing.shown.detail) : "") +
      (drawing.shown.breaks.any() ? ",\n   \"breaks\": " + breaks_of(drawing.shown.breaks) : "") +
      ",\n   \"world_to_page\": " + matrix(drawing.world_to_page) + ",\n   \"viewer\": {\"" +
      (projection.central ? "centre" : "direction") + "\": " + point(projection.projector) +
      "},\n   \"vanishing_points\": " + json_list(drawing.aids.vanishing_points, vanishing_point) +
      (drawing.distances.contours_moved > 0 ? ",\n   \"contours_moved\": " + number(drawing.distances.contours_moved)
                                            : "") +
      (drawing.distances.outlines_moved > 0 ? ",\n   \"outlines_moved\": " + number(drawing.distances.outlines_moved)
                                            : "") +
      ",\n   \"segments\": ";
  append_segments(text, drawing, progress);
  append_curves(text, drawing);
  if (!drawing.cuts.broken_out.empty())
    text += ",\n   \"broken_out\": " + json_lines(drawing.cuts.broken_out, broken_out_of, "\n    ");
  if (!drawing.cuts.faces.empty())
    text += ",\n   \"cut_faces\": " + json_lines(drawing.cuts.faces, cut_face_of, "\n    ");
  if (drawing.aids.construction) text += ",\n   \"construction\": " + construction_of(*drawing.aids.construction);
  text += '}';
}

std::string mesh_of(const mesh::MeshReport& mesh) {
  std::string text = "{\"name\": " + json_string(mesh.name) + ", \"format\": " + json_string(mesh.format);
  const auto add = [&text](std::string_view key, const std::string& value) {
    text.append(", \"").append(key).append("\": ").append(value);
  };
  add("vertices", number(mesh.vertices));
  add("faces", number(mesh.faces));
  add("triangles", number(mesh.triangles));
  if (mesh.wires > mesh.point_arms) add("wires", number(mesh.wires - mesh.point_arms));
  if (mesh.points > 0) add("points", number(mesh.points));
  add("bodies", number(mesh.bodies));
  if (!mesh.body_names.empty()) add("body_names", json_list(mesh.body_names, json_string));
  add("open_edges", number(mesh.open_edges));
  add("non_manifold_edges", number(mesh.non_manifold_edges));
  add("misoriented_edges", number(mesh.misoriented_edges));
  add("welded_vertices", number(mesh.welded_vertices));
  add("dropped_degenerate", number(mesh.dropped_degenerate));
  add("dropped_duplicates", number(mesh.dropped_duplicates));
  add("non_finite_vertices", number(mesh.non_finite_vertices));
  add("dropped_non_finite", number(mesh.dropped_non_finite));
  add("weld_distance", number(mesh.weld_distance));
  add("single_precision", boolean(mesh.single_precision));
  add("resolution", number(mesh.resolution));
  std::vector<std::string> notes = mesh.notes;
  notes.insert(notes.end(), mesh.remarks.begin(), mesh.remarks.end());
  add("notes", json_list(notes, json_string));
  return text + "}";
}

std::string step_of(const report::PlanStep& step) {
  std::string text = "{\"stage\": " + json_string(step.stage);
  if (!step.view.empty()) text += ", \"view\": " + json_string(step.view);
  text += ", \"run\": " + boolean(step.run) + ", \"why\": " + json_string(step.why) +
          ", \"in\": " + number(step.items_in) + ", \"out\": " + number(step.items_out);
  const auto add = [&text](std::string_view key, const std::optional<double>& seconds) {
    if (seconds) text.append(", \"").append(key).append("\": ").append(number(*seconds));
  };
  add("certificate", step.times.certificate);
  add("seconds", step.times.stage);
  add("saved_estimated", step.times.estimated);
  add("saved_measured", step.times.measured);
  return text + "}";
}

std::string partial_of(const report::Partial& partial) {
  return std::string("{\"reason\": \"") + (partial.too_many_crossings ? "too many crossings" : "time limit") +
         "\", \"stages\": " + json_list(partial.stages, json_string) + ", \"edges\": " + number(partial.edges) +
         ", \"undecided\": " + number(partial.undecided) + ", \"searched\": " + number(partial.searched) +
         ", \"undrawn\": " + number(partial.undrawn) + "}";
}

std::string facet_of(const report::FacetName& facet) { return numbers(std::array{facet.model, facet.face}); }

std::string stratum_of(const report::Stratum& stratum) {
  return "{\"visible\": " + boolean(stratum.visible) + ", \"kind\": " + json_string(edges::name_of(stratum.kind)) +
         ", \"least\": " + number(stratum.min) + ", \"length\": " + number(stratum.length) +
         ", \"samples\": " + number(stratum.samples) + ", \"undecided\": " + number(stratum.undecided) +
         ", \"wrong\": " + number(stratum.wrong) + "}";
}

std::string offence_of(const report::Mismatch& offence) {
  const bool has_edge = offence.edge[0] >= 0;
  return "{\"what\": " + json_string(offence.what) + ", \"model\": " + number(offence.model) +
         ", \"edge\": " + (has_edge ? numbers(offence.edge) : "null") + ", \"t\": " + number(offence.t) +
         (has_edge ? "" : ", \"faces\": " + json_list(offence.facets, facet_of)) +
         ", \"page\": " + point(offence.page) + ", \"hider\": " + (offence.hider ? facet_of(*offence.hider) : "null") +
         "}";
}

std::string fault_of(const report::OutlineFault& fault) {
  return "{\"what\": " + json_string(fault.what) + ", \"page\": " + point(fault.page) +
         ", \"length\": " + number(fault.length) + ", \"model\": " + number(fault.model) +
         ", \"edge\": " + (fault.edge[0] >= 0 ? numbers(fault.edge) : "null") +
         ", \"facets\": " + json_list(fault.facets, facet_of) + "}";
}

std::string outline_of(const report::OutlineCheck& outline) {
  return "{\"lines\": " + number(outline.lines) + ", \"asked\": " + number(outline.asked) +
         ", \"missing\": " + number(outline.missing) + ", \"ink\": " + number(outline.ink) +
         ", \"unfounded\": " + number(outline.unfounded) + ", \"doubled\": " + number(outline.doubled) +
         ", \"undecided\": " + number(outline.undecided) + ", \"length\": " + number(outline.length) +
         ", \"at_most\": " + number(outline.at_most) +
         ",\n    \"worst\": " + json_lines(outline.worst, fault_of, "\n     ") + "}";
}

std::string unjudged_of(const report::Unjudged& one) {
  return "{\"reason\": " + json_string(one.reason) + ", \"length\": " + number(one.length) + "}";
}

std::string ink_of(const report::InkCheck& ink) {
  return "{\"error\": " + number(ink.error) + ", \"length\": " + number(ink.length) +
         ", \"judged\": " + number(ink.judged) + ", \"by_surfaces\": " + number(ink.by_surfaces) +
         ", \"unjudged\": " + json_list(ink.unjudged, unjudged_of) + ", \"unfounded\": " + number(ink.unfounded) +
         ", \"missing\": " + number(ink.missing) + ", \"faults\": " + number(ink.faults) +
         ",\n    \"worst\": " + json_lines(ink.worst, fault_of, "\n     ") + "}";
}

std::string verification_of(const report::Verification& found) {
  return "{\"points\": " + number(found.points) + ", \"decided\": " + number(found.decided) +
         ", \"either_way\": " + number(found.either_way) + ", \"wrong\": " + number(found.wrong) +
         ", \"samples\": " + number(found.samples) + ", \"length\": " + number(found.length) +
         ", \"misclassified\": " + number(found.misclassified) + ", \"at_most\": " + number(found.at_most) +
         ", \"undecided\": " + number(found.undecided) + ", \"untested\": " + number(found.untested) +
         ",\n   \"strata\": " + json_lines(found.strata, stratum_of, "\n    ") +
         ",\n   \"worst\": " + json_lines(found.worst, offence_of, "\n    ") +
         ",\n   \"outline\": " + outline_of(found.outline) + ",\n   \"ink\": " + ink_of(found.ink) + "}";
}

std::string condition_of_view(const report::ViewCondition& view) {
  return "{\"view\": " + json_string(view.name) + ", \"number\": " + number(view.condition.number) +
         ", \"digits_left\": " + number(view.condition.digits_left()) +
         ", \"why\": " + json_string(view.condition.why) + "}";
}

// This file is written with all digits.
std::string error_of_view(report::ViewError error) {
  error[report::ErrorTerm::writing] = 0;
  std::string text = "{\"view\": " + json_string(error.view) + ", \"total\": " + report::rounded_up(error.total()) +
                     ", \"dominant\": " + json_string(row_of(error.dominant()).name) + ", \"terms\": [";
  bool first = true;
  for (std::size_t i = 0; i < report::error_terms.size(); ++i) {
    const auto term = static_cast<report::ErrorTerm>(i);
    if (error[term] == 0) continue;
    text += std::string(first ? "" : ", ") + "{\"term\": " + json_string(row_of(term).name) +
            ", \"mm\": " + report::rounded_up(error[term]) +
            ", \"by\": " + json_string(report::evidence_names[static_cast<std::size_t>(error.evidence(term))]) + "}";
    first = false;
  }
  return text + "]}";
}

std::string requirement_of(const report::RequirementRow& row) {
  const auto or_null = [](const std::string& text) { return text.empty() ? std::string("null") : json_string(text); };
  return "{\"model\": " + json_string(row.model) + ", \"id\": " + json_string(row.id) +
         ", \"kind\": " + json_string(row.kind) + ", \"what\": " + json_string(row.what) +
         ", \"wanted\": " + (row.wanted ? "true" : "false") + ", \"view\": " + or_null(row.view) +
         ", \"sheet\": " + (row.sheet > 0 ? std::to_string(row.sheet) : "null") +
         ", \"sheet_zone\": " + or_null(row.zone) +
         ", \"characteristic\": " + (row.characteristic > 0 ? std::to_string(row.characteristic) : "null") +
         ", \"reason\": " + or_null(row.why) + "}";
}

std::string report_of(const report::Report& report) {
  std::string text = "{\"meshes\": " + json_lines(report.meshes, mesh_of, "\n   ") +
                     ",\n  \"plan\": " + json_lines(report.plan, step_of, "\n   ");
  if (report.tessellation)
    text += ",\n  \"tessellation\": {\"error\": " + number(report.tessellation->error) +
            ", \"on_paper\": " + number(report.tessellation->on_paper) + "}";
  if (!report.errors.empty()) text += ",\n  \"error\": " + json_lines(report.errors, error_of_view, "\n   ");
  std::string times;
  for (const auto& [stage, seconds] : report.seconds)
    append_to_list(times, json_string(stage) + ": " + number(seconds));
  if (!times.empty()) text += ",\n  \"time\": {" + times + "}";
  if (report.verification) text += ",\n  \"verify\": " + verification_of(*report.verification);
  if (!report.conditions.empty())
    text += ",\n  \"condition\": " + json_lines(report.conditions, condition_of_view, "\n   ");
  if (!report.requirements.empty())
    text += ",\n  \"requirements\": " + json_lines(report.requirements, requirement_of, "\n   ");
  return text + "}";
}

}  // namespace

std::string to_json(const sheet::Sheet& sheet, double scale, std::span<const drawing::ViewDrawing> drawings,
                    const report::Report& report, const Progress& progress) {
  std::string text =
      "{\"epura\": 1, \"unit\": \"mm\", \"sheet\": {\"size\": " + point(Vec2(sheet.width, sheet.height)) +
      ", \"scale\": " + number(scale) + "},";
  if (!report.partial.stages.empty()) text += "\n \"partial\": " + partial_of(report.partial) + ",";
  text += "\n \"views\": [";
  for (const drawing::ViewDrawing& drawing : drawings) {
    text += &drawing == drawings.data() ? "\n  " : ",\n  ";
    append_view(text, drawing, scale, progress);
  }
  text += "],";
  if (const std::string annotations = json_of_annotations(sheet); !annotations.empty())
    text += "\n \"annotations\": " + annotations + ",";
  text += "\n \"report\": " + report_of(report) + "}\n";
  return text;
}

}  // namespace epura::output
