// SPDX-License-Identifier: Apache-2.0
#include "pipeline/replace_helical_threads.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "features/helical_threads.hpp"
#include "features/place_threads.hpp"
#include "features/tolerances.hpp"
#include "sizes/anchors.hpp"
#include "surfaces/declared_part.hpp"
#include "surfaces/limits.hpp"
#include "world/placed_part.hpp"

namespace epura::pipeline {

namespace {

/// A thread and where its cylinder is in the world.
struct FoundThread {
  scene::Thread thread;
  Vec3 middle, axis;
  double radius, half;                        ///< of the cylinder, half of its length
  std::optional<std::array<Vec3, 2>> full{};  ///< where it begins and ends, if it runs out at one end
};

// A helix ends within a pitch of its full depth, unless its roots rise to a shaft.
std::optional<std::array<Vec3, 2>> full_part_of(const features::HelicalThread& thread, const Mat4& to_world,
                                                double pitch) {
  constexpr double least = 0.6;  // of a pitch
  const bool below = thread.full.from - thread.low > least * pitch,
             above = thread.high - thread.full.to > least * pitch;
  if (below == above) return std::nullopt;
  const auto at = [&](double height) { return Vec3(to_world * Vec4(thread.origin + height * thread.axis, 1)); };
  return above ? std::array{at(thread.low), at(thread.full.to)} : std::array{at(thread.high), at(thread.full.from)};
}

// Whether the cylinder of a thread is a face of a part, all around.
bool has_cylinder(const surfaces::PartFaces& part, const features::HelicalThread& thread) {
  return std::any_of(part.faces.begin(), part.faces.end(), [&](const surfaces::PartFace& face) {
    const surfaces::PartSurface& surface = face.surface;
    return surface.kind == surfaces::SurfaceKind::cylinder && face.sweep >= surfaces::whole_turn &&
           face.inwards == thread.internal &&
           std::abs(surface.radius - thread.crest) <= features::same_size * thread.crest &&
           features::are_parallel(surface.axis, thread.axis) &&
           glm::length(glm::cross(surface.origin - thread.origin, thread.axis)) <= features::same_size * thread.crest;
  });
}

/// A mesh and its part without helical threads.
struct Replaced {
  std::shared_ptr<const mesh::Mesh> mesh;
  std::shared_ptr<const surfaces::PartFaces> part;
  std::vector<features::HelicalThread> threads{};
  std::vector<features::OtherHelix> others{};  ///< that are no threads
};

// The faces of a part whose thread is a cylinder now. What the file declares about others remains.
surfaces::PartFaces faces_with(const features::HelicalThread& thread, const Replaced& before, const mesh::Mesh& mesh,
                               std::vector<int> face_of_triangle, const Progress& progress) {
  if (!before.part->declared) return surfaces::recognise_faces(mesh, {}, progress);
  const surfaces::PartSurface cylinder{surfaces::SurfaceKind::cylinder, thread.origin, thread.axis, thread.crest};
  return surfaces::part_with_face(*before.part, *before.mesh, {mesh, std::move(face_of_triangle), cylinder},
                                  surfaces::RecogniseOptions().tangent_angle);
}

std::ptrdiff_t open_edges_of(const mesh::Mesh& mesh) {
  return std::count_if(mesh.edges.begin(), mesh.edges.end(),
                       [](const mesh::MeshEdge& edge) { return edge.count != 2; });
}

// Replaces one of the threads; false if none can be.
bool replace_one(Replaced& model, double unit, const Progress& progress) {
  features::HelicalForms forms = features::find_helical_threads(*model.mesh, *model.part, unit);
  model.others = std::move(forms.others);
  for (features::HelicalThread& thread : forms.threads) {
    auto made = features::with_cylinder(*model.mesh, *model.part, thread);
    if (!made || open_edges_of(made->mesh) > open_edges_of(*model.mesh)) continue;
    auto part = std::make_shared<surfaces::PartFaces>(
        faces_with(thread, model, made->mesh, std::move(made->face_of_triangle), progress));
    if (!has_cylinder(*part, thread)) continue;
    model.mesh = std::make_shared<const mesh::Mesh>(std::move(made->mesh));
    model.part = std::move(part);
    model.threads.push_back(std::move(thread));
    return true;
  }
  return false;
}

Replaced replace_all(const world::Placed& placed, double unit, const Progress& progress) {
  constexpr int most = 64;  // each costs a recognition
  Replaced model{placed.mesh, placed.part};
  for (int i = 0; i < most && replace_one(model, unit, progress); ++i) continue;
  return model;
}

bool is_described(const FoundThread& found, const world::World& world, const scene::SceneDescription& scene) {
  return std::any_of(scene.threads.begin(), scene.threads.end(), [&](const scene::ThreadDescription& thread) {
    const Vec3 off = sheet::position_of(world, *thread.at, thread.at.where) - found.middle;
    const double along = glm::dot(off, found.axis);
    return std::abs(along) <= found.half * (1 + features::same_size) &&
           glm::length(off - along * found.axis) <= 1.5 * found.radius;
  });
}

// "M6, 2× M8".
std::string list_of(const std::map<std::string, int>& counts) {
  std::string list;
  for (const auto& [text, count] : counts) append_to_list(list, (count > 1 ? std::to_string(count) + "× " : "") + text);
  return list;
}

void tell(const Messages& messages, const std::vector<FoundThread>& found) {
  std::map<std::string, int> counts;
  for (const FoundThread& one : found) ++counts[one.thread.text];
  messages.warn("helical threads are drawn as in ISO 6410-1: " + list_of(counts) +
                "\n  hint: --surfaces mesh draws them as they are modelled");
}

// Each diameter and pitch once.
void tell(const Messages& messages, const std::vector<features::OtherHelix>& others) {
  std::map<std::string, int> counts;
  for (const features::OtherHelix& one : others)
    ++counts["⌀" + format_rounded(one.diameter, 4) + " with a pitch of " + format_rounded(one.pitch, 4)];
  messages.warn("helical faces are drawn as they are modelled, because ISO 261 has no such thread: " + list_of(counts) +
                " mm\n  hint: model a cylinder and give it a [[thread]] to draw it as in ISO 6410-1");
}

}  // namespace

world::World replace_helical_threads(world::World world, scene::SceneDescription& scene, const Messages& messages,
                                     const Progress& progress) {
  std::vector<FoundThread> found;
  std::vector<features::OtherHelix> others;
  std::map<std::pair<const mesh::Mesh*, double>, Replaced> known;  // several models may show one mesh
  for (world::Placed& placed : world.models) {
    const auto unit = world::similarity_scale(placed.to_world);
    if (placed.part == nullptr || !unit) continue;
    const std::pair key(placed.mesh.get(), *unit);
    auto same = known.find(key);
    if (same == known.end()) same = known.emplace(key, replace_all(placed, *unit, progress)).first;
    const Replaced& model = same->second;
    placed.mesh = model.mesh;
    placed.part = model.part;
    for (const features::HelicalThread& thread : model.threads) {
      const Vec3 middle = thread.origin + (thread.low + thread.high) / 2 * thread.axis;
      found.push_back({thread.thread, Vec3(placed.to_world * Vec4(middle, 1)),
                       glm::normalize(Vec3(placed.to_world * Vec4(thread.axis, 0))), *unit * thread.crest,
                       *unit * (thread.high - thread.low) / 2,
                       full_part_of(thread, placed.to_world, thread.thread.pitch / *unit)});
    }
    others.insert(others.end(), model.others.begin(), model.others.end());
  }
  if (!others.empty()) tell(messages, others);
  if (found.empty()) return world;
  const bool had_wires = !world.wires.empty();
  std::vector<std::vector<scene::StyleDescription>> styles = std::move(world.styles);
  world = world::make_world(std::move(world.models), had_wires);
  world.styles = std::move(styles);
  std::vector<scene::ThreadDescription> added;
  for (const FoundThread& one : found) {
    if (is_described(one, world, scene)) continue;
    const std::string where = "thread " + one.thread.text;
    scene::ThreadDescription thread{where, {one.thread.text, where}, {scene::Anchor(one.middle), where}};
    thread.callout = {false, where};
    if (one.full) {
      thread.at = {scene::Anchor((*one.full)[0]), where};
      if (const auto depth = features::depth_of_thread(world, one.radius, (*one.full)[0], (*one.full)[1]))
        thread.depth = {*depth, where};
    }
    added.push_back(std::move(thread));
  }
  for (scene::ThreadDescription& thread : added) scene.threads.push_back(std::move(thread));
  tell(messages, found);
  return world;
}

}  // namespace epura::pipeline
