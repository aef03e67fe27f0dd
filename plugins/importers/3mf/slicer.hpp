// SPDX-License-Identifier: Apache-2.0
// What slicers write beside the model: names of its pieces, and which of them are no parts.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model.hpp"

namespace epura::plugin::threemf {

/// What is said of one object of the model. A piece is either a range of its triangles or one of its components.
struct Told {
  struct Component {
    std::string object;  ///< its id
    std::string name;
    Role role;
  };
  std::string name{};
  std::vector<Volume> volumes{};
  std::vector<Component> components{};
};

/// By the id of the object.
using Settings = std::map<std::string, Told>;

/// Of PrusaSlicer and its relatives (Slic3r_PE_model.config), and of Bambu Studio and its (model_settings.config).
Settings settings_of(const Package& package);

/// What a setting of Cura says of the object that has it as metadata.
Role role_by_cura(std::string_view key, std::string_view value);

}  // namespace epura::plugin::threemf
