// SPDX-License-Identifier: Apache-2.0
#include "verify/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "drawing/drawing.hpp"
#include "verify/confidence.hpp"
#include "verify/outline_faults.hpp"

namespace epura::verify {

namespace {

constexpr int directions = 16;
constexpr double min_lines = 128, max_lines = 2048;
// Limit on how many triangles the lines cut in total: this multiple of the number of triangles in the world, plus a
// constant.
constexpr double hits_per_triangle = 16, free_hits = 1 << 20;
constexpr std::size_t max_told = 10;

constexpr std::array names{"missing", "unfounded", "doubled"};

/// What lines across the page find.
struct Scanned {
  report::OutlineCheck check{};
  std::vector<AskedLine> asked{}, jumps{};
  Suspects suspects{};
};

Suspect suspect_of(const OutlineScan& on, const InkCrossing& ink) {
  const FaultKind kind = ink.verdict == InkVerdict::doubled ? FaultKind::doubled : FaultKind::unfounded;
  return {kind, ink.place, on.scan.segment(ink.segment), {-1, -1}, {-1, -1}, ink.segment};
}

Vec3 page_and_depth(const OutlineScan& on, int vertex) {
  return {on.scene.position(vertex), on.scene.depth_of(on.scene.local[vertex])};
}

// The line in which the planes of two triangles intersect, through a place on it, as long as the page is wide.
std::optional<std::array<Vec2, 2>> crossing_of(const OutlineScan& on, const Vec2& place,
                                               const std::array<int, 2>& triangles) {
  const auto gradient = [&](int triangle) {
    const auto& corner = on.input.world.triangles[triangle];
    const Vec3 a = page_and_depth(on, corner[0]), b = page_and_depth(on, corner[1]) - a,
               c = page_and_depth(on, corner[2]) - a;
    const Vec3 normal = glm::cross(b, c);
    return Vec2(normal) / -normal.z;
  };
  const Vec2 difference = gradient(triangles[0]) - gradient(triangles[1]);
  const double length = glm::length(difference);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const Vec2 half = 0.5 * glm::distance(on.window.min, on.window.max) / length * Vec2(-difference.y, difference.x);
  return std::array{place - half, place + half};
}

std::optional<Suspect> suspect_of(const OutlineScan& on, const AskedLine& asked) {
  const auto& [place, mark] = asked;
  const auto ends = mark.edge[0] >= 0 ? on.scene.line_of(mark.edge) : crossing_of(on, place, mark.triangles);
  if (!ends) return std::nullopt;
  return Suspect{FaultKind::missing, place, *ends, mark.edge, mark.triangles, -1};
}

// With what one line finds.
Scanned noted(const OutlineScan& on, const LineFindings& findings, Scanned found) {
  found.check.ink += static_cast<int>(findings.ink.size());
  for (const InkCrossing& ink : findings.ink)
    if (ink.verdict != InkVerdict::right) found.suspects.add(suspect_of(on, ink));
  if (!on.options.complete) return found;
  found.check.asked += static_cast<int>(findings.asked.size());
  found.asked.insert(found.asked.end(), findings.asked.begin(), findings.asked.end());
  found.jumps.insert(found.jumps.end(), findings.jumps.begin(), findings.jumps.end());
  return found;
}

// With the required positions that have no ink.
Scanned look_for_ink(const OutlineScan& on, Scanned found) {
  const std::vector<bool> inked = on.inked(found.asked);
  for (std::size_t i = 0; i < found.asked.size(); ++i) {
    if (inked[i]) continue;
    if (const auto missing = suspect_of(on, found.asked[i]))
      found.suspects.add(*missing);
    else
      ++found.check.undecided;
  }
  return found;
}

// Random lines across the page.
Scanned scan_page(const OutlineScan& on) {
  Scanned found;
  const double size = glm::distance(on.window.min, on.window.max);
  const double ink = std::max(on.scan.length_of_ink(), size);
  double lines = std::clamp(on.options.samples * std::numbers::pi * size / (2 * ink), min_lines,
                            std::max(max_lines, static_cast<double>(on.options.samples)));
  const double hits = on.scan.perimeter_of_triangles(3 * size) / (std::numbers::pi * size) * lines;
  const double max_hits = hits_per_triangle * static_cast<double>(on.input.world.triangles.size()) + free_hits;
  if (hits > max_hits) lines = std::max(static_cast<double>(directions), lines * max_hits / hits);
  const double distance = size / std::ceil(lines / directions);
  found.check.length = std::numbers::pi * distance / (2 * directions);
  for (int i = 0; i < directions; ++i) {
    const LineBundle bundle(on.window, (i + 0.3) * std::numbers::pi / directions, distance, i + 1);
    found.check.lines += static_cast<int>(bundle.lines().size());
    for (const LineFindings& findings : on.scan.along(bundle, on.options.progress))
      found = noted(on, findings, std::move(found));
  }
  return look_for_ink(on, std::move(found));
}

report::OutlineFault fault_of(const OutlineScan& on, const Suspect& suspect) {
  report::OutlineFault fault{
      names[static_cast<std::size_t>(suspect.kind)], suspect.place + on.scene.origin, suspect.length, -1, {-1, -1}, {}};
  if (suspect.segment >= 0) {
    fault.model = on.input.world.number_in_scene(on.input.drawing.segments[suspect.segment].model);
    fault.edge = on.input.drawing.segments[suspect.segment].edge;
    return fault;
  }
  for (const int triangle : suspect.triangles) {
    if (triangle < 0) continue;
    const int model = on.input.world.model_of_triangle(triangle);
    fault.facets.push_back(
        {on.input.world.number_in_scene(model),
         on.input.world.models[model].mesh->polygon[triangle - on.input.world.first_triangle[model]]});
    fault.model = on.input.world.number_in_scene(model);
  }
  if (const auto sheets = suspect.edge[0] >= 0 ? on.rule.sheets_at(suspect.edge) : FoldRule::Sheets{}; sheets.edge) {
    fault.model = on.input.world.number_in_scene(sheets.model);
    const mesh::EdgeOrigin origin = on.input.world.models[sheets.model].mesh->origin_of(*sheets.edge);
    if (origin.in_file) fault.edge = origin.vertex;
  }
  return fault;
}

std::vector<report::OutlineFault> worst_of(const OutlineScan& on, const std::vector<Suspect>& suspects) {
  std::vector<const Suspect*> order;
  for (const Suspect& suspect : suspects)
    if (suspect.length >= on.least) order.push_back(&suspect);
  std::ranges::stable_sort(order, [](const Suspect* a, const Suspect* b) { return a->length > b->length; });
  order.resize(std::min(order.size(), max_told));
  std::vector<report::OutlineFault> faults;
  for (const Suspect* suspect : order) faults.push_back(fault_of(on, *suspect));
  return faults;
}

}  // namespace

OutlineFindings scan_outline(const VerifyInput& input, const Tolerance& tolerance, const OutlineOptions& options) {
  if (input.world.triangles.empty() && input.world.wires.empty()) return {};
  const OutlineScan on(input, tolerance, options);
  Scanned scanned = scan_page(on);
  const std::vector<Suspect> suspects = followed(on, scanned.suspects.all());
  const std::vector<char> are_wrong = are_faults(on, suspects);
  report::OutlineCheck check = std::move(scanned.check);
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    const Suspect& suspect = suspects[i];
    if (are_wrong[i] == 0)
      check.undecided += suspect.met;
    else if (suspect.kind == FaultKind::missing)
      check.missing += suspect.met;
    else
      (suspect.kind == FaultKind::unfounded ? check.unfounded : check.doubled) += suspect.met;
  }
  if (check.asked + check.ink > 0)
    check.at_most = greatest_share(check.wrong(), check.asked + check.ink, stated_confidence);
  check.worst = worst_of(on, suspects);
  std::vector<AskedLine> needs = std::move(scanned.asked);
  needs.insert(needs.end(), scanned.jumps.begin(), scanned.jumps.end());
  return {std::move(check), std::move(needs)};
}

}  // namespace epura::verify
