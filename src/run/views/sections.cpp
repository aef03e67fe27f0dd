// SPDX-License-Identifier: Apache-2.0
#include "views/sections.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/cut_faces.hpp"

namespace epura::pipeline {

namespace {

constexpr std::size_t max_named = 8;

std::string format_point(const Vec3& p) {
  return format_rounded(p.x, 6) + "," + format_rounded(p.y, 6) + "," + format_rounded(p.z, 6);
}

std::string body_name(const CutSection& section, int model, int body) {
  const mesh::Mesh& mesh = *section.cut.world.models[model].mesh;
  return mesh.report.name + (mesh.report.bodies > 1 ? ": body " + std::to_string(body) : "");
}

// An area that should have been hatched must not look hollow.
void warn_about(const Messages& messages, const CutSection& section, const cut::OpenOutline& open) {
  messages.warn(body_name(section, open.model, open.body) + " has an outline in section " + section.surface.plane.name +
                " that is open at " + format_point(open.end) + "; the area it would enclose is not hatched");
}

void warn_about(const Messages& messages, const CutSection& section, const cut::BridgedGaps& gaps) {
  const std::string where = " wide at " + format_point(gaps.place);
  messages.warn(body_name(section, gaps.model, gaps.body) + " has " +
                (gaps.count == 1 ? "a gap " + format_rounded(gaps.widest, 6) + where
                                 : std::to_string(gaps.count) + " gaps, the widest " + format_rounded(gaps.widest, 6) +
                                       where + ",") +
                " in its outline in section " + section.surface.plane.name + "; bridged for hatching");
}

void warn_about(const Messages& messages, const CutSection& section, const cut::OverlappingBodies& overlap) {
  messages.warn(body_name(section, overlap.model, overlap.body) + " and " +
                body_name(section, overlap.under_model, overlap.under_body) + " overlap in section " +
                section.surface.plane.name + " by an area of " + format_rounded(overlap.area, 4) + " at " +
                format_point(overlap.place) + "; the second one is drawn as if it ended there");
}

template <class Found>
void warn_about_some(const Messages& messages, const CutSection& section, const std::vector<Found>& found,
                     const std::string& rest) {
  const std::size_t named = std::min(max_named, found.size());
  for (std::size_t i = 0; i < named; ++i) warn_about(messages, section, found[i]);
  if (named < found.size()) messages.warn("... and " + std::to_string(found.size() - named) + rest);
}

void warn_about(const Messages& messages, const CutSection& section) {
  warn_about_some(messages, section, section.cut.open, " more bodies have open outlines");
  warn_about_some(messages, section, section.cut.bridged, " more bodies have gaps in outlines, bridged for hatching");
  warn_about_some(messages, section, section.cut.overlaps, " more pairs of bodies overlap");
}

}  // namespace

CutSection cut_section(const world::World& world, const cut::CuttingSurface& surface, const Messages& messages,
                       const Progress& progress) {
  CutSection section{surface, cut::cut_world(world, surface, progress)};
  warn_about(messages, section);
  return section;
}

CutSections cut_sections(const world::World& world, const scene::SceneDescription& scene, const Messages& messages,
                         const Progress& progress) {
  progress.begin("cutting sections", scene.sections.size());
  CutSections sections;
  for (const scene::SectionDescription& description : scene.sections) {
    const std::string& name = *description.name;
    const auto shows = [&](const scene::ViewDescription& view) { return view.section.value == name; };
    if (std::none_of(scene.views.begin(), scene.views.end(), shows)) continue;
    sections.try_emplace(name, cut_section(world, cut::make_cutting_surface(description), messages, progress));
    progress.advance(1);
  }
  return sections;
}

void add_surfaces(SectionSurfaces& surfaces, const CutSections& sections) {
  for (const auto& [name, section] : sections) surfaces.try_emplace(name, section.surface);
}

const CutSection* section_of(const CutSections& sections, const scene::ViewDescription& view) {
  const auto found = sections.find(view.section.value_or(""));
  return found == sections.end() ? nullptr : &found->second;
}

void expect_steps_edge_on(const CutSection& section, const view::ProjectedScene& seen,
                          const scene::ViewDescription& view) {
  constexpr double edge_on = 1e-9;  // radians
  const projection::Projection& projection = seen.projection;
  const bool is_edge_on =
      !projection.central && std::abs(glm::dot(glm::normalize(projection.projector), section.surface.along)) <= edge_on;
  if (section.surface.is_plane() || is_edge_on) return;
  const std::string name = section.surface.plane.name;
  throw Error(ErrorKind::input, view.section.where,
              "view '" + *view.name + "' does not " +
                  (section.surface.aligned ? "show the planes of aligned section " + name + " side by side"
                                           : "look along the steps of section " + name),
              "choose a projection that looks against the normal of the section");
}

void warn_if_unseen(const Messages& messages, const CutSection& section, const view::ProjectedScene& seen,
                    const std::string& view) {
  if (drawing::is_seen(section.surface.plane, seen.projection)) return;
  messages.warn(
      "view '" + view + "' looks at section " + section.surface.plane.name +
      " from the side that is kept and shows no cut face\n  hint: reverse its normal, or choose the opposite view");
}

}  // namespace epura::pipeline
