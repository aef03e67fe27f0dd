// SPDX-License-Identifier: Apache-2.0
// Reads glTF 2.0, as text or binary.
#include <epura/importer_plugin.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "load.hpp"
#include "refuse.hpp"
#include "shapes.hpp"
#include "tree.hpp"

namespace epura::plugin::gltf {

namespace {

struct Gltf {
  static constexpr auto name = "gltf", summary = "glTF 2.0, text or binary", extensions = "gltf|glb";

  static bool recognises(std::string_view first_bytes) { return is_gltf(first_bytes); }

  static void read(const Source& source, Sink& sink) {
    std::string warning;
    const tinygltf::Model model = load(source, warning);
    constexpr double metre = 1000;
    sink.unit(metre);
    sink.up('y');
    sink.rounding(EPURA_SINGLE);
    if (!warning.empty()) sink.note(warning);
    constexpr double is_loaded = 0.5;
    sink.progress(is_loaded);
    LeftOut left_out;
    if (model.nodes.empty())
      for (std::size_t mesh = 0; mesh < model.meshes.size(); ++mesh) add_shape(model, mesh, sink, left_out);
    else
      add_nodes(model, sink, left_out);
    if (!left_out.sentence().empty()) sink.note(left_out.sentence());
  }

 private:
  static void add_nodes(const tinygltf::Model& model, Sink& sink, LeftOut& left_out) {
    const std::vector<Placed> nodes = placed_nodes(model);
    std::map<int, std::uint32_t> shape_of_mesh;
    std::size_t skins = 0, sets = 0;
    for (const Placed& placed : nodes) {
      const tinygltf::Node& node = model.nodes[placed.node];
      skins += node.skin >= 0 ? 1 : 0;
      sets += node.extensions.count("EXT_mesh_gpu_instancing");
      std::uint32_t shape = EPURA_NONE;
      if (node.mesh != -1) {
        refuse_if(node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= model.meshes.size(),
                  numbered("node", placed.node) + " has a mesh " + std::to_string(node.mesh) + ", which is not there");
        const auto found = shape_of_mesh.find(node.mesh);
        shape = found != shape_of_mesh.end() ? found->second
                                             : add_shape(model, static_cast<std::size_t>(node.mesh), sink, left_out);
        shape_of_mesh.emplace(node.mesh, shape);
      }
      const std::uint32_t parent = placed.parent == no_parent ? EPURA_NONE : static_cast<std::uint32_t>(placed.parent);
      sink.node(node.name, parent, shape, transform_of(model, placed.node));
    }
    if (skins > 0) sink.note("skins are not applied: meshes are drawn as they were modelled");
    if (sets > 0) sink.note("instances of EXT_mesh_gpu_instancing are not read: their meshes are drawn once");
  }
};

}  // namespace

}  // namespace epura::plugin::gltf

EPURA_IMPORTER(epura::plugin::gltf::Gltf)
