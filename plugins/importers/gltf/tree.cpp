// SPDX-License-Identifier: Apache-2.0
#include "tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "refuse.hpp"

namespace epura::plugin::gltf {

namespace {

using tinygltf::Model;

std::size_t node_at(const Model& model, int number, const std::string& owner) {
  refuse_if(number < 0 || static_cast<std::size_t>(number) >= model.nodes.size(),
            owner + " has a node " + std::to_string(number) + ", which is not there");
  return static_cast<std::size_t>(number);
}

// The number of the scene that is drawn; nothing if there is none.
std::optional<std::size_t> scene_number(const Model& model) {
  if (model.scenes.empty()) return std::nullopt;
  if (model.defaultScene == -1) return 0;
  refuse_if(model.defaultScene < 0 || static_cast<std::size_t>(model.defaultScene) >= model.scenes.size(),
            "its default scene " + std::to_string(model.defaultScene) + " is not there");
  return static_cast<std::size_t>(model.defaultScene);
}

std::vector<std::size_t> roots_of(const Model& model) {
  std::vector<std::size_t> roots;
  std::vector<char> is_taken(model.nodes.size(), 0);
  const auto take = [&](std::size_t node) {
    if (is_taken[node] == 0) roots.push_back(node);
    is_taken[node] = 1;
  };
  if (const auto scene = scene_number(model)) {
    for (const int number : model.scenes[*scene].nodes) take(node_at(model, number, numbered("scene", *scene)));
    return roots;
  }
  std::vector<char> is_child(model.nodes.size(), 0);
  for (std::size_t n = 0; n < model.nodes.size(); ++n)
    for (const int number : model.nodes[n].children) is_child[node_at(model, number, numbered("node", n))] = 1;
  for (std::size_t n = 0; n < model.nodes.size(); ++n)
    if (is_child[n] == 0) take(n);
  refuse_if(roots.empty() && !model.nodes.empty(), "its nodes stand in a circle");
  return roots;
}

bool is_hidden(const tinygltf::Node& node) {
  const auto found = node.extensions.find("KHR_node_visibility");
  if (found == node.extensions.end() || !found->second.Has("visible")) return false;
  const tinygltf::Value& visible = found->second.Get("visible");
  return visible.IsBool() && !visible.Get<bool>();
}

/// Walks from the roots to the leaves.
class Walk {
 public:
  explicit Walk(const Model& model) : model_(model), is_placed_(model.nodes.size(), 0) {}

  std::vector<Placed> run() {
    add_all(roots_of(model_), no_parent, [](std::size_t node) { return node; });
    while (!next_.empty()) {
      const Placed one = next_.back();
      next_.pop_back();
      // A cycle also returns to one of its nodes.
      refuse_if(is_placed_[one.node] != 0, numbered("node", one.node) + " stands in two places, or below itself");
      is_placed_[one.node] = 1;
      const bool is_below_hidden = one.parent == hidden;
      if (is_below_hidden || is_hidden(model_.nodes[one.node])) {
        hidden_ += model_.nodes[one.node].mesh >= 0 ? 1 : 0;
        add_children(one.node, hidden);
        continue;
      }
      placed_.push_back(one);
      add_children(one.node, placed_.size() - 1);
    }
    return std::move(placed_);
  }

  [[nodiscard]] std::string left_out() const {
    std::size_t elsewhere = 0;
    for (std::size_t n = 0; n < model_.nodes.size(); ++n)
      elsewhere += is_placed_[n] == 0 && model_.nodes[n].mesh >= 0 ? 1 : 0;
    std::string sentence;
    if (hidden_ > 0) sentence = meshes(hidden_) + " hidden by the file left out";
    if (elsewhere == 0) return sentence;
    const std::size_t drawn = scene_number(model_).value_or(0);
    const std::string& name = model_.scenes[drawn].name;
    return sentence + (sentence.empty() ? "" : "; ") + "of " + std::to_string(model_.scenes.size()) +
           (model_.scenes.size() == 1 ? " scene" : " scenes") + ", " + numbered("scene", drawn) +
           (name.empty() ? "" : " '" + name + "'") + " is drawn: " + meshes(elsewhere) +
           " of other scenes or of none left out";
  }

 private:
  static constexpr std::size_t hidden = no_parent - 1;

  static std::string meshes(std::size_t count) { return std::to_string(count) + (count == 1 ? " mesh" : " meshes"); }

  template <class Nodes, class NumberOf>
  void add_all(const Nodes& nodes, std::size_t parent, const NumberOf& number_of) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) next_.push_back({number_of(*node), parent});
  }

  void add_children(std::size_t node, std::size_t parent) {
    add_all(model_.nodes[node].children, parent,
            [&](int number) { return node_at(model_, number, numbered("node", node)); });
  }

  const Model& model_;
  std::vector<char> is_placed_;
  std::vector<Placed> placed_, next_;
  std::size_t hidden_ = 0;
};

// By rows.
using Linear = std::array<std::array<double, 3>, 3>;

// The formula for unit quaternions, generalised to any length.
Linear rotation_of(const std::vector<double>& q, const std::string& what) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const double length = x * x + y * y + z * z + w * w;
  refuse_if(!(length > 0) || !std::isfinite(length), what + " has a rotation that is none");
  // A quaternion of length 1 within the precision of 32 bits is not normalised, which would change exact values.
  const double s = 2 / (std::abs(length - 1) < 1e-6 ? 1 : length);
  return {{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
           {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)},
           {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}}};
}

// From four columns.
Transform of_matrix(const std::vector<double>& m, const std::string& what) {
  refuse_if(m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1, what + " has a matrix that is not affine");
  Transform transform{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) transform[4 * row + column] = m[4 * column + row];
  return transform;
}

}  // namespace

Scene scene_of(const Model& model) {
  Walk walk(model);
  Scene scene{walk.run()};
  scene.left_out = walk.left_out();
  return scene;
}

Transform composed(const Motion& motion, const std::string& what) {
  const auto& [translation, rotation, scale] = motion;
  const Linear turn = rotation.empty() ? Linear{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}} : rotation_of(rotation, what);
  Transform transform{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column)
      transform[4 * row + column] = turn[row][column] * (scale.empty() ? 1 : scale[column]);
    transform[4 * row + 3] = translation.empty() ? 0 : translation[row];
  }
  refuse_if(!std::all_of(transform.begin(), transform.end(), [](double v) { return std::isfinite(v); }),
            what + " has a transform that is not finite");
  return transform;
}

Transform transform_of(const Model& model, std::size_t number) {
  const tinygltf::Node& node = model.nodes[number];
  const std::string what = numbered("node", number);
  const auto expect_count = [&](const std::vector<double>& values, std::size_t count, const char* name) {
    refuse_if(!values.empty() && values.size() != count,
              what + " has a " + name + " of " + std::to_string(values.size()) + " numbers");
  };
  expect_count(node.matrix, 16, "matrix");
  expect_count(node.rotation, 4, "rotation");
  expect_count(node.scale, 3, "scale");
  expect_count(node.translation, 3, "translation");
  if (node.matrix.empty()) return composed({node.translation, node.rotation, node.scale}, what);
  const Transform transform = of_matrix(node.matrix, what);
  refuse_if(!std::all_of(transform.begin(), transform.end(), [](double v) { return std::isfinite(v); }),
            what + " has a transform that is not finite");
  return transform;
}

}  // namespace epura::plugin::gltf
