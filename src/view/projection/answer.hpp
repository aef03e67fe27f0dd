// SPDX-License-Identifier: Apache-2.0
// A plugin's answer to values, what may be wrong with it, and the projection that it describes.
#pragma once

#include <epura/projection_abi.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "projection/catalogue.hpp"

namespace epura::projection {

/// A plugin's answer to values.
struct PluginAnswer {
  epura_view view;
  std::optional<std::string> refusal;  ///< the sentence with which the plugin rejects the values; then `view` is empty
};

/// A function that makes a view of values, or returns why it rejects them. The view is preset.
using MakeView =
    std::function<std::optional<std::string>(const std::vector<double>& values, const epura_scene&, epura_view&)>;

/// Calls a function of this process. Changed floating-point arithmetic is an error.
PluginAnswer call_function(const MakeView& make, const std::vector<double>& values, const Box& scene);

/// Calls the plugin directly: an AskProjection for libraries that this process has loaded. Exceptions that leave the
/// plugin and changed floating-point arithmetic are errors.
PluginAnswer call_plugin(const epura_projection& definition, const std::vector<double>& values, const Box& scene);

/// Requests a projection. `scene` is the bounding box of everything. Throws Error{plugin} with the name of the library.
PluginAnswer ask_plugin(const ProjectionEntry& entry, const ParameterValues& values, const Box& scene);

/// Each returns a sentence that says why an answer is not a projection, or an empty string. Call them in this order:
/// the second and third assume that numbers are finite.
std::string fault_of_numbers(const epura_view& view);  ///< some number is not finite
std::string fault_of_plane(const epura_view& view);    ///< plane, up and projectors are not independent
std::string fault_of_picture(const epura_view& view);  ///< scale, window and limits leave nothing to draw

/// The first fault of the three.
std::string fault_of(const epura_view& view);

/// For an answer without faults: everything but its name and values.
Projection projection_of(const epura_view& view);

}  // namespace epura::projection
