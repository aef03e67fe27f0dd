// SPDX-License-Identifier: Apache-2.0
#include "verify/missing_lines.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "verify/ink.hpp"
#include "verify/surface_sight.hpp"

namespace epura::verify {

namespace {

using MeshLine = std::array<int, 2>;

// Places along an edge without ink at which it is asked how much of it lacks it.
constexpr int places_of_edge = 32;
// So many edges are divided together, for what is found at their places takes memory.
constexpr std::size_t edges_divided_at_once = 256;

class MissingLines {
 public:
  MissingLines(const OutlineScan& on, const InkOptions& options, double error)
      : on_(on), options_(options), error_(error) {}

  [[nodiscard]] std::vector<report::OutlineFault> faults(std::span<const AskedLine> needs) const {
    std::set<MeshLine> edges;
    for (const AskedLine& one : confirmed(without_ink(needs))) edges.insert(one.mark.edge);
    const std::vector<MeshLine> list(edges.begin(), edges.end());
    std::vector<Lacking> lacking;
    for (std::size_t from = 0; from < list.size(); from += edges_divided_at_once)
      for (const auto& [edge, length] :
           lengths_without_ink({list.data() + from, std::min(edges_divided_at_once, list.size() - from)}))
        lacking.push_back({edge, length});
    return joined(std::move(lacking));
  }

 private:
  /// An edge, and how much of it lacks ink, mm.
  struct Lacking {
    MeshLine edge;
    double length;
    bool is_told = false;
  };

  [[nodiscard]] std::vector<AskedLine> without_ink(std::span<const AskedLine> needs) const {
    std::vector<Expected> places;
    for (const AskedLine& need : needs) places.push_back({need.place + on_.scene.origin, true});
    const std::vector<bool> inked = find_ink(on_.input.drawing, places, error_);
    std::vector<AskedLine> without;
    for (std::size_t i = 0; i < needs.size(); ++i)
      if (!inked[i] && needs[i].mark.edge[0] >= 0 && (needs[i].mark.jump || options_.creases))
        without.push_back(needs[i]);
    return without;
  }

  // Of those, the places beside which rays see a change that has no ink, either: the contour of a surface may be as far
  // from that of its facets as the ink is from it.
  [[nodiscard]] std::vector<AskedLine> confirmed(const std::vector<AskedLine>& without) const {
    std::vector<Band> bands;
    std::vector<const AskedLine*> asked;
    for (const AskedLine& one : without) {
      const auto ends = on_.scene.line_of(one.mark.edge);
      if (!ends || !(glm::distance((*ends)[0], (*ends)[1]) > 0)) continue;
      const Vec2 way = glm::normalize((*ends)[1] - (*ends)[0]);
      bands.push_back({one.place + on_.scene.origin, {-way.y, way.x}, least_errors * error_});
      asked.push_back(&one);
    }
    const std::vector<SeenAcross> seen = see_across(on_.input, on_.options.edges, error_, bands, on_.options.progress);
    std::vector<Expected> places;
    for (std::size_t i = 0; i < asked.size(); ++i)
      places.push_back({bands[i].middle + seen[i].at * bands[i].across, true});
    const std::vector<bool> inked = find_ink(on_.input.drawing, places, error_);
    std::vector<AskedLine> found;
    for (std::size_t i = 0; i < asked.size(); ++i)
      if (seen[i].front_changes && !inked[i]) found.push_back(*asked[i]);
    return found;
  }

  [[nodiscard]] std::map<MeshLine, double> lengths_without_ink(std::span<const MeshLine> edges) const {
    std::vector<ScanLine> lines;
    for (const MeshLine& edge : edges) {
      const auto ends = on_.scene.line_of(edge);
      const Vec2 way = glm::normalize((*ends)[1] - (*ends)[0]);
      for (int i = 0; i < places_of_edge; ++i)
        lines.push_back(
            {(*ends)[0] + (i + 0.5) / places_of_edge * ((*ends)[1] - (*ends)[0]), {-way.y, way.x}, 4 * on_.reach});
    }
    const std::vector<LineFindings> findings = on_.scan.along(lines, on_.options.progress);
    std::vector<AskedLine> needs;
    for (std::size_t i = 0; i < findings.size(); ++i)
      for (const auto* list : {&findings[i].asked, &findings[i].jumps}) {
        const MeshLine& edge = edges[i / places_of_edge];
        const auto own = std::ranges::find_if(*list, [&](const AskedLine& one) { return one.mark.edge == edge; });
        if (own == list->end()) continue;
        needs.push_back(*own);
        break;
      }
    std::map<MeshLine, double> lengths;
    for (const AskedLine& one : confirmed(without_ink(needs))) {
      const auto ends = on_.scene.line_of(one.mark.edge);
      lengths[one.mark.edge] += glm::distance((*ends)[0], (*ends)[1]) / places_of_edge;
    }
    return lengths;
  }

  // Each with those that are joined to it. A fault is where the longest of them is.
  [[nodiscard]] std::vector<report::OutlineFault> joined(std::vector<Lacking> lacking) const {
    std::ranges::stable_sort(lacking, std::greater{}, &Lacking::length);
    std::map<int, std::vector<Lacking*>> at_vertex;
    for (Lacking& one : lacking)
      for (const int v : one.edge) at_vertex[v].push_back(&one);
    std::vector<report::OutlineFault> faults;
    for (Lacking& longest : lacking) {
      if (longest.is_told) continue;
      double length = 0;
      std::vector<Lacking*> open{&longest};
      longest.is_told = true;
      while (!open.empty()) {
        const Lacking& next = *open.back();
        open.pop_back();
        length += next.length;
        for (const int v : next.edge)
          for (Lacking* other : at_vertex[v])
            if (!std::exchange(other->is_told, true)) open.push_back(other);
      }
      if (length > least_errors * error_) faults.push_back(fault_of(longest.edge, length));
    }
    return faults;
  }

  // Names of the file: of the edge of which this one is a part, or of a facet inside which it lies.
  [[nodiscard]] report::OutlineFault fault_of(const MeshLine& edge, double length) const {
    const auto place = on_.scene.line_of(edge);
    const FoldRule::Sheets sheets = on_.rule.sheets_at(edge);
    const int model = on_.input.world.number_in_scene(sheets.model);
    report::OutlineFault fault{"missing", 0.5 * ((*place)[0] + (*place)[1]) + on_.scene.origin, length, model, {-1, -1},
                               {}};
    const mesh::Mesh& mesh = *on_.input.world.models[sheets.model].mesh;
    const mesh::EdgeOrigin origin = mesh.origin_of(*sheets.edge);
    if (origin.in_file) fault.edge = origin.vertex;
    if (!origin.in_file)
      for (const int triangle : mesh.triangles_of(*sheets.edge))
        fault.facets.push_back({model, mesh.polygon[triangle]});
    return fault;
  }

  const OutlineScan& on_;
  const InkOptions& options_;
  double error_;
};

}  // namespace

std::vector<report::OutlineFault> missing_lines(const OutlineScan& on, const InkOptions& options, double error,
                                                std::span<const AskedLine> needs) {
  return MissingLines(on, options, error).faults(needs);
}

}  // namespace epura::verify
