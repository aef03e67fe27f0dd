// SPDX-License-Identifier: Apache-2.0
// The order of vertices and faces in a file decides nothing that is seen.
#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/file.hpp"
#include "base/text.hpp"
#include "program.hpp"

namespace epura::test::renumbered_test {
namespace {

struct Obj {
  std::vector<std::string> vertices;
  std::vector<std::vector<std::size_t>> faces;  ///< vertices, from 0
};

// Without names, which go with the order of faces.
Obj read(const std::string& file) {
  Obj obj;
  const std::string text = read_file(file);
  for (const std::string_view line : split(text, '\n')) {
    if (line.starts_with("v ")) obj.vertices.emplace_back(line);
    if (!line.starts_with("f ")) continue;
    obj.faces.emplace_back();
    for (const std::string_view corner : split(line.substr(2), ' '))
      obj.faces.back().push_back(static_cast<std::size_t>(std::stoul(std::string(corner))) - 1);
  }
  return obj;
}

std::string text_of(const Obj& obj) {
  std::string text;
  for (const std::string& vertex : obj.vertices) text += vertex + "\n";
  for (const std::vector<std::size_t>& face : obj.faces) {
    text += "f";
    for (const std::size_t vertex : face) text += " " + std::to_string(vertex + 1);
    text += "\n";
  }
  return text;
}

// The standard fixes the numbers of the engine, but not std::shuffle.
template <class Items, class Swap>
void shuffle(const Items& items, std::mt19937& random, const Swap& swap) {
  for (std::size_t i = items.size(); i > 1; --i) swap(i - 1, random() % i);
}

Obj renumbered(Obj obj, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::size_t> old(obj.vertices.size()), number(old.size());  // vertices there, and where they are now
  for (std::size_t i = 0; i < old.size(); ++i) old[i] = i;
  shuffle(old, random, [&](std::size_t a, std::size_t b) {
    std::swap(old[a], old[b]);
    std::swap(obj.vertices[a], obj.vertices[b]);
  });
  for (std::size_t i = 0; i < old.size(); ++i) number[old[i]] = i;
  for (std::vector<std::size_t>& face : obj.faces)
    for (std::size_t& vertex : face) vertex = number[vertex];
  shuffle(obj.faces, random, [&](std::size_t a, std::size_t b) { std::swap(obj.faces[a], obj.faces[b]); });
  return obj;
}

class Renumbered : public testing::TestWithParam<const char*> {};

// Where many lines lie near each other.
TEST_P(Renumbered, StairsLookTheSame) {
  const Folder folder;
  const Obj stairs = read(sample("stairs.obj"));
  const auto draw = [&](const Obj& obj, const std::string& name) {
    folder.file(name + ".obj", text_of(obj));
    const Outcome run = epura({"draw", name + ".obj", "--projection", GetParam(), "-o", name + ".svg"}, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
  };
  draw(stairs, "as-filed");
  for (const unsigned seed : {1U, 2U, 3U}) {
    draw(renumbered(stairs, seed), "renumbered");
    const Outcome compared = epura({"compare", "as-filed.svg", "renumbered.svg"}, folder / "");
    EXPECT_EQ(compared.code, 0) << seed << ": " << compared.out;
  }
}

INSTANTIATE_TEST_SUITE_P(Views, Renumbered, testing::Values("front", "isometric"));

}  // namespace
}  // namespace epura::test::renumbered_test
