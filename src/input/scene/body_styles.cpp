// SPDX-License-Identifier: Apache-2.0
#include "scene/body_styles.hpp"

#include <fnmatch.h>

#include <cmath>
#include <cstddef>
#include <filesystem>

#include "scene/part_options.hpp"

namespace epura::scene {

namespace {

// WCAG 2.2, relative luminance, with a gamma of 2, whose root is exact on every machine.
Colour darkened(const Colour& colour) {
  constexpr double most = 1.05 / 3 - 0.05;
  const auto squared = [](int part) { return part / 255.0 * (part / 255.0); };
  const double luminance =
      0.2126 * squared(colour.red) + 0.7152 * squared(colour.green) + 0.0722 * squared(colour.blue);
  if (luminance <= most) return colour;
  const double factor = std::sqrt(most / luminance);
  const auto part = [&](int value) { return static_cast<int>(factor * value); };
  return {part(colour.red), part(colour.green), part(colour.blue)};
}

}  // namespace

std::string name_of(const ModelDescription& model) {
  return model.name.value_or(std::filesystem::path(model.file.value_or("")).stem().string());
}

const std::string& name_of_body(const mesh::Mesh& mesh, int body) {
  const std::vector<std::string>& names = mesh.report.body_names;
  return names.empty() ? mesh.report.only_body : names[static_cast<std::size_t>(body)];
}

std::optional<Colour> colour_of_body(const mesh::Mesh& mesh, int body) {
  const std::vector<std::optional<Colour>>& colours = mesh.report.body_colours;
  if (colours.empty()) return std::nullopt;
  const std::optional<Colour>& colour =
      mesh.report.body_names.empty() ? colours.front() : colours[static_cast<std::size_t>(body)];
  return colour ? std::optional(darkened(*colour)) : std::nullopt;
}

bool matches(const StyleDescription& style, const mesh::Mesh& mesh, int body, const std::string& model) {
  const auto is = [&](const std::string& name) {
    return !name.empty() && ::fnmatch(style.match->c_str(), name.c_str(), 0) == 0;
  };
  return is(name_of_body(mesh, body)) || is(model);
}

std::vector<StyleDescription> styles_of_bodies(const mesh::Mesh& mesh, const std::string& model,
                                               std::span<const StyleDescription> styles) {
  const Options<StyleDescription> options = style_options();
  std::vector<StyleDescription> of_bodies(static_cast<std::size_t>(mesh.report.bodies));
  bool any = false;
  for (int body = 0; body < mesh.report.bodies; ++body)
    for (const StyleDescription& style : styles) {
      if (!matches(style, mesh, body, model)) continue;
      any = true;
      for (const auto& option : options) option.overrule(of_bodies[static_cast<std::size_t>(body)], style);
    }
  return any ? of_bodies : std::vector<StyleDescription>();
}

}  // namespace epura::scene
