// SPDX-License-Identifier: Apache-2.0
// Projections that are functions of the calling program. Those for all programs are plugins (projection_plugin.hpp).
#pragma once

#include <epura/projection_abi.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace epura {

/// A row of the table in which a projection declares its parameters.
struct OwnParameter {
  std::string name;                    ///< lower case, digits and '-'
  std::vector<double> initial{0};      ///< the default of each component; NaN: determined by the projection
  std::vector<std::string> choices{};  ///< then the value is an index in this list
  std::string unit{};                  ///< "deg", "1", "model units" ...
  std::string help{};
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
};

struct OwnProjection {
  std::string name;  ///< lower case, digits and '-'; comes before a plugin of this name
  std::string family{}, summary{}, reference{};
  std::string place{};  ///< as errors call its code: "class Shadow"
  std::vector<OwnParameter> parameters{};
  /// Sets the view, which is preset as projection_abi.h states, for the values of all parameters in order, and the box
  /// of everything drawn; or returns a sentence that says why the values are invalid. Called from another thread than
  /// draw(), for one view after the other. The message of an exception becomes that of a Failure{plugin}.
  std::function<std::optional<std::string>(const std::vector<double>& values, const epura_scene& box, epura_view& view)>
      project;
};

}  // namespace epura
