// SPDX-License-Identifier: Apache-2.0
#include "extensions.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "draco.hpp"
#include "meshopt.hpp"
#include "refuse.hpp"

namespace epura::plugin::gltf {

namespace {

// These describe the appearance of surfaces, lamps and motion: nothing that is drawn as a line.
constexpr std::array<std::string_view, 12> of_looks{
    "KHR_materials_", "KHR_texture_",   "EXT_texture_",   "MSFT_texture_",    "KHR_lights_",   "EXT_lights_",
    "KHR_xmp",        "KHR_animation_", "EXT_materials_", "ADOBE_materials_", "MSFT_packing_", "KHR_techniques_"};
constexpr std::array<std::string_view, 3> of_shape{"KHR_mesh_quantization", "EXT_mesh_gpu_instancing",
                                                   "KHR_node_visibility"};

bool is_read(std::string_view extension) {
  const auto is_family = [&](std::string_view family) { return extension.substr(0, family.size()) == family; };
  if (extension == draco_extension) return reads_draco();
  if (extension == meshopt_extension) return reads_meshopt();
  return std::find(of_shape.begin(), of_shape.end(), extension) != of_shape.end() ||
         std::any_of(of_looks.begin(), of_looks.end(), is_family);
}

// Why this importer does not read an extension that others of this version do, and what helps.
std::string reason_for(std::string_view extension) {
  if (extension == draco_extension) return ": this importer was built without libdraco-dev";
  if (extension == meshopt_extension)
    return std::string(": this importer was built without libmeshoptimizer-dev; ") + undoing_meshopt;
  return {};
}

}  // namespace

void expect_extensions(const tinygltf::Model& model) {
  for (const std::string& extension : model.extensionsRequired)
    refuse_if(!is_read(extension),
              "needs the extension " + shortened(extension) + ", which is not read" + reason_for(extension));
}

}  // namespace epura::plugin::gltf
