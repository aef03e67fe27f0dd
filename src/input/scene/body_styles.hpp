// SPDX-License-Identifier: Apache-2.0
// Styles that match the names of bodies.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/description.hpp"

namespace epura::scene {

/// The name by which dimensions and styles know a model.
std::string name_of(const ModelDescription& model);

/// The name of a body; empty if its file does not name bodies.
const std::string& name_of_body(const mesh::Mesh& mesh, int body);

/// The colour of a body in its file, darkened if it would be hard to see on paper: to at least 3 : 1 of contrast with
/// white. Nothing if the file gives none.
std::optional<Colour> colour_of_body(const mesh::Mesh& mesh, int body);

/// Whether a style is for a body, by its name or by that of its model. Patterns are those of fnmatch (POSIX).
bool matches(const StyleDescription& style, const mesh::Mesh& mesh, int body, const std::string& model);

/// By body: the values that the matching styles give together. Empty if no style matches any body.
std::vector<StyleDescription> styles_of_bodies(const mesh::Mesh& mesh, const std::string& model,
                                               std::span<const StyleDescription> styles);

}  // namespace epura::scene
