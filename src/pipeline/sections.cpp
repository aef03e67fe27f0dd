// SPDX-License-Identifier: Apache-2.0
#include "pipeline/sections.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace epura::pipeline {

namespace {

constexpr std::size_t most_named = 8;

std::string format_point(const Vec3& p) {
  return format_rounded(p.x, 6) + "," + format_rounded(p.y, 6) + "," + format_rounded(p.z, 6);
}

// A body that should have been hatched must not look like one that is hollow.
void warn_about(const Messages& messages, const CutSection& section, const scene::OpenBody& open) {
  const mesh::Mesh& mesh = *section.cut.world.models[open.model].mesh;
  const std::string body = mesh.report.bodies > 1 ? ": body " + std::to_string(open.body) : "";
  messages.warn(mesh.report.name + body + " is not closed, so its cut by section " + section.plane.name +
                " is not hatched; " + (open.in_outline ? "the outline is" : "its surface is") + " open at " +
                format_point(open.gap));
}

void warn_about(const Messages& messages, const CutSection& section) {
  const std::vector<scene::OpenBody>& open = section.cut.open;
  const std::size_t named = std::min(most_named, open.size());
  for (std::size_t i = 0; i < named; ++i) warn_about(messages, section, open[i]);
  if (named < open.size())
    messages.warn("... and " + std::to_string(open.size() - named) + " more bodies are not closed and not hatched");
}

}  // namespace

CutSections cut_sections(const scene::World& world, const scene::SceneDescription& scene, const Messages& messages,
                         const Progress& progress) {
  progress.begin("cutting sections", scene.sections.size());
  CutSections sections;
  for (const scene::SectionDescription& description : scene.sections) {
    const std::string& name = *description.name;
    const auto shows = [&](const scene::ViewDescription& view) { return view.section.value == name; };
    if (std::none_of(scene.views.begin(), scene.views.end(), shows)) continue;
    const scene::CuttingPlane plane = scene::make_cutting_plane(description);
    const CutSection& section =
        sections.try_emplace(name, CutSection{plane, scene::cut_world(world, plane, progress)}).first->second;
    warn_about(messages, section);
    progress.advance(1);
  }
  return sections;
}

const CutSection* section_of(const CutSections& sections, const scene::ViewDescription& view) {
  const auto found = sections.find(view.section.value_or(""));
  return found == sections.end() ? nullptr : &found->second;
}

}  // namespace epura::pipeline
