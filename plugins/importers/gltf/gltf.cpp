// SPDX-License-Identifier: Apache-2.0
// Reads glTF 2.0, as text or binary.
#include <epura/importer_plugin.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../words.hpp"
#include "instances.hpp"
#include "load.hpp"
#include "refuse.hpp"
#include "shapes.hpp"
#include "tree.hpp"

namespace epura::plugin::gltf {

namespace {

/// Passes meshes and nodes to the sink, each mesh once.
class Tree {
 public:
  Tree(const tinygltf::Model& model, Sink& sink) : model_(model), sink_(sink), shapes_(model.meshes.size()) {}

  void add_meshes() {
    for (std::size_t mesh = 0; mesh < model_.meshes.size(); ++mesh) shape_of(mesh);
  }

  void add_nodes() {
    const Scene scene = scene_of(model_);
    name_meshes(scene);
    std::vector<std::uint32_t> numbers;
    std::size_t skins = 0;
    for (const Placed& placed : scene.nodes) {
      skins += model_.nodes[placed.node].skin >= 0 ? 1 : 0;
      numbers.push_back(add(placed.node, placed.parent == no_parent ? EPURA_NONE : numbers[placed.parent]));
    }
    if (skins > 0) sink_.note("skins are not applied: meshes are drawn as they were modelled");
    if (!scene.left_out.empty()) sink_.note(scene.left_out);
  }

  void finish() const {
    if (!left_out_.sentence().empty()) sink_.note(left_out_.sentence());
    refuse_if(!has_shapes_, "holds no mesh to draw");
  }

 private:
  // People name nodes; the names of meshes are data blocks of programs. A mesh that occurs several times is named after
  // the first node.
  void name_meshes(const Scene& scene) {
    names_.resize(model_.meshes.size());
    for (const Placed& placed : scene.nodes) {
      const tinygltf::Node& node = model_.nodes[placed.node];
      const bool is_there = node.mesh >= 0 && static_cast<std::size_t>(node.mesh) < names_.size();
      if (is_there && names_[static_cast<std::size_t>(node.mesh)].empty())
        names_[static_cast<std::size_t>(node.mesh)] = node.name;
    }
  }

  std::uint32_t shape_of(std::size_t mesh) {
    std::optional<std::uint32_t>& shape = shapes_[mesh];
    if (shape) return *shape;
    const bool is_named = mesh < names_.size() && !names_[mesh].empty();
    shape = add_shape(model_, {mesh, is_named ? names_[mesh] : model_.meshes[mesh].name}, sink_, left_out_);
    has_shapes_ = has_shapes_ || *shape != EPURA_NONE;
    return *shape;
  }

  std::uint32_t add(std::size_t number, std::uint32_t parent) {
    const tinygltf::Node& node = model_.nodes[number];
    std::uint32_t shape = EPURA_NONE;
    if (node.mesh != -1) {
      refuse_if(node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= model_.meshes.size(),
                numbered("node", number) + " has a mesh " + std::to_string(node.mesh) + ", which is not there");
      shape = shape_of(static_cast<std::size_t>(node.mesh));
    }
    const bool is_repeated = has_instances(node) && shape != EPURA_NONE;
    const std::uint32_t own =
        sink_.node(node.name, parent, is_repeated ? EPURA_NONE : shape, transform_of(model_, number));
    if (!is_repeated) return own;
    const std::string& name = node.name.empty() ? model_.meshes[static_cast<std::size_t>(node.mesh)].name : node.name;
    for (const Transform& transform : instances_of(model_, number)) sink_.node(name, own, shape, transform);
    return own;
  }

  const tinygltf::Model& model_;
  Sink& sink_;
  std::vector<std::optional<std::uint32_t>> shapes_;  ///< of meshes
  std::vector<std::string> names_;                    ///< of meshes, by nodes
  LeftOut left_out_;
  bool has_shapes_ = false;
};

// Application-specific data of the file and of its nodes, whether drawn or not.
void tell_all_words(const tinygltf::Model& model, Sink& sink) {
  const auto tell = [&sink](const tinygltf::Value& extras, const std::string& place) {
    if (!extras.IsObject()) return;
    for (const std::string& key : extras.Keys())
      if (const tinygltf::Value& text = extras.Get(key); names_words(key) && text.IsString())
        tell_words(sink, place + ".extras." + key, text.Get<std::string>());
  };
  tell(model.extras, "file");
  tell(model.asset.extras, "asset");
  for (std::size_t i = 0; i < model.scenes.size(); ++i) tell(model.scenes[i].extras, numbered("scene", i));
  for (std::size_t i = 0; i < model.nodes.size(); ++i) tell(model.nodes[i].extras, numbered("node", i));
  for (std::size_t i = 0; i < model.meshes.size(); ++i) tell(model.meshes[i].extras, numbered("mesh", i));
}

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
    Tree tree(model, sink);
    if (model.nodes.empty())
      tree.add_meshes();
    else
      tree.add_nodes();
    tree.finish();
    tell_all_words(model, sink);
  }
};

}  // namespace

}  // namespace epura::plugin::gltf

EPURA_IMPORTER(epura::plugin::gltf::Gltf)
