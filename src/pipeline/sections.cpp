// SPDX-License-Identifier: Apache-2.0
#include "pipeline/sections.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace epura {

namespace {

constexpr std::size_t most_named = 8;

std::string format_point(const Vec3& p) {
  return format_rounded(p.x, 6) + "," + format_rounded(p.y, 6) + "," + format_rounded(p.z, 6);
}

// A body that should have been hatched must not look like one that is hollow.
void warn_about(const Messages& messages, const CutSection& section, const OpenBody& open) {
  const Mesh& mesh = *section.cut.world.models[open.model].mesh;
  const std::string body = mesh.report.bodies > 1 ? ": body " + std::to_string(open.body) : "";
  messages.warn(mesh.report.name + body + " is not closed, so its cut by section " + section.plane.name +
                " is not hatched; " + (open.in_outline ? "the outline is" : "its surface is") + " open at " +
                format_point(open.gap));
}

void warn_about(const Messages& messages, const CutSection& section) {
  const std::vector<OpenBody>& open = section.cut.open;
  const std::size_t named = std::min(most_named, open.size());
  for (std::size_t i = 0; i < named; ++i) warn_about(messages, section, open[i]);
  if (named < open.size())
    messages.warn("... and " + std::to_string(open.size() - named) + " more bodies are not closed and not hatched");
}

}  // namespace

CutSections cut_sections(const World& world, const SceneDescription& scene, const Messages& messages,
                         const Progress& progress) {
  progress.begin("cutting sections", scene.sections.size());
  CutSections sections;
  for (const SectionDescription& description : scene.sections) {
    const std::string& name = *description.name;
    const auto shows = [&](const ViewDescription& view) { return view.section.value == name; };
    if (std::none_of(scene.views.begin(), scene.views.end(), shows)) continue;
    const CuttingPlane plane = make_cutting_plane(description);
    const CutSection& section =
        sections.try_emplace(name, CutSection{plane, cut_world(world, plane, progress)}).first->second;
    warn_about(messages, section);
    progress.advance(1);
  }
  return sections;
}

const CutSection* section_of(const CutSections& sections, const ViewDescription& view) {
  const auto found = sections.find(view.section.value_or(""));
  return found == sections.end() ? nullptr : &found->second;
}

}  // namespace epura
