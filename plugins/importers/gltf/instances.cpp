// SPDX-License-Identifier: Apache-2.0
#include "instances.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "accessors.hpp"
#include "refuse.hpp"
#include "tree.hpp"

namespace epura::plugin::gltf {

namespace {

using tinygltf::Model;
using tinygltf::Value;

/// The number of an accessor; nothing if the node has no such attribute.
std::optional<int> accessor_in(const Value& attributes, const char* name, const std::string& what) {
  if (!attributes.IsObject() || !attributes.Has(name)) return std::nullopt;
  const Value& number = attributes.Get(name);
  refuse_if(!number.IsInt(), what + " has instances whose '" + name + "' is no accessor");
  return number.GetNumberAsInt();
}

}  // namespace

bool has_instances(const tinygltf::Node& node) { return node.extensions.count(instancing_extension) > 0; }

std::vector<Transform> instances_of(const Model& model, std::size_t number) {
  const std::string what = numbered("node", number);
  const Value& extension = model.nodes[number].extensions.at(instancing_extension);
  const Value attributes = extension.Has("attributes") ? extension.Get("attributes") : Value();
  const auto translation = accessor_in(attributes, "TRANSLATION", what);
  const auto rotation = accessor_in(attributes, "ROTATION", what);
  const auto scale = accessor_in(attributes, "SCALE", what);
  if (!translation && !rotation && !scale) return {identity};
  const std::vector<Point> places = translation ? positions(model, *translation) : std::vector<Point>();
  const std::vector<Point> sizes = scale ? positions(model, *scale) : std::vector<Point>();
  const auto turns = rotation ? quaternions(model, *rotation) : std::vector<std::array<double, 4>>();
  const std::size_t count = std::max({places.size(), turns.size(), sizes.size()});
  const auto is_whole = [&](bool is_given, std::size_t size) { return !is_given || size == count; };
  refuse_if(!is_whole(translation.has_value(), places.size()) || !is_whole(rotation.has_value(), turns.size()) ||
                !is_whole(scale.has_value(), sizes.size()),
            what + " has instances whose attributes differ in number");
  std::vector<Transform> transforms;
  for (std::size_t i = 0; i < count; ++i) {
    const auto numbers = [&](const auto& all) {
      return all.empty() ? std::vector<double>() : std::vector<double>(all[i].begin(), all[i].end());
    };
    transforms.push_back(
        composed({numbers(places), numbers(turns), numbers(sizes)}, what + ", " + numbered("instance", i)));
  }
  return transforms;
}

}  // namespace epura::plugin::gltf
