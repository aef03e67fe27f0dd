// SPDX-License-Identifier: Apache-2.0
#include "scene/body_styles.hpp"

#include <fnmatch.h>

#include <cstddef>
#include <filesystem>

#include "scene/part_options.hpp"

namespace epura::scene {

std::string name_of(const ModelDescription& model) {
  return model.name.value_or(std::filesystem::path(model.file.value_or("")).stem().string());
}

const std::string& name_of_body(const mesh::Mesh& mesh, int body) {
  static const std::string none;
  const std::vector<std::string>& names = mesh.report.body_names;
  return names.empty() ? none : names[static_cast<std::size_t>(body)];
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
