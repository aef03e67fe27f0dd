// SPDX-License-Identifier: Apache-2.0
#include "tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "refuse.hpp"

namespace epura::plugin::gltf {

namespace {

using tinygltf::Model;

std::size_t node_at(const Model& model, int number, const std::string& owner) {
  refuse_if(number < 0 || static_cast<std::size_t>(number) >= model.nodes.size(),
            owner + " has a node " + std::to_string(number) + ", which is not there");
  return static_cast<std::size_t>(number);
}

std::vector<std::size_t> roots_of(const Model& model) {
  std::vector<std::size_t> roots;
  std::vector<char> is_taken(model.nodes.size(), 0);
  const auto take = [&](std::size_t node) {
    if (is_taken[node] == 0) roots.push_back(node);
    is_taken[node] = 1;
  };
  const bool has_default = model.defaultScene != -1;
  refuse_if(
      has_default && (model.defaultScene < 0 || static_cast<std::size_t>(model.defaultScene) >= model.scenes.size()),
      "its default scene " + std::to_string(model.defaultScene) + " is not there");
  for (std::size_t s = 0; s < model.scenes.size(); ++s) {
    if (has_default && static_cast<std::size_t>(model.defaultScene) != s) continue;
    for (const int number : model.scenes[s].nodes) take(node_at(model, number, numbered("scene", s)));
  }
  if (!model.scenes.empty()) return roots;
  std::vector<char> is_child(model.nodes.size(), 0);
  for (std::size_t n = 0; n < model.nodes.size(); ++n)
    for (const int number : model.nodes[n].children) is_child[node_at(model, number, numbered("node", n))] = 1;
  for (std::size_t n = 0; n < model.nodes.size(); ++n)
    if (is_child[n] == 0) take(n);
  refuse_if(roots.empty() && !model.nodes.empty(), "its nodes stand in a circle");
  return roots;
}

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

std::vector<Placed> placed_nodes(const Model& model) {
  std::vector<Placed> placed;
  std::vector<char> is_placed(model.nodes.size(), 0);
  std::vector<Placed> next;
  const auto add_all = [&](const auto& nodes, std::size_t parent, const auto& number_of) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) next.push_back({number_of(*node), parent});
  };
  add_all(roots_of(model), no_parent, [](std::size_t node) { return node; });
  while (!next.empty()) {
    const Placed one = next.back();
    next.pop_back();
    // A cycle also returns to one of its nodes.
    refuse_if(is_placed[one.node] != 0, numbered("node", one.node) + " stands in two places, or below itself");
    is_placed[one.node] = 1;
    placed.push_back(one);
    const std::string owner = numbered("node", one.node);
    add_all(model.nodes[one.node].children, placed.size() - 1,
            [&](int number) { return node_at(model, number, owner); });
  }
  return placed;
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
  Transform transform = identity;
  if (!node.matrix.empty()) {
    transform = of_matrix(node.matrix, what);
  } else {
    const Linear turn =
        node.rotation.empty() ? Linear{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}} : rotation_of(node.rotation, what);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        transform[4 * row + column] = turn[row][column] * (node.scale.empty() ? 1 : node.scale[column]);
      transform[4 * row + 3] = node.translation.empty() ? 0 : node.translation[row];
    }
  }
  refuse_if(!std::all_of(transform.begin(), transform.end(), [](double v) { return std::isfinite(v); }),
            what + " has a transform that is not finite");
  return transform;
}

}  // namespace epura::plugin::gltf
