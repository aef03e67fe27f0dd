// Projections and their parameters as people read them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura {

/// All projections of the folders; each library is first loaded in a process of its own, since one that hangs or
/// crashes must not hide the others.
Catalogue load_watched(const std::vector<std::filesystem::path>& folders);

/// The value by default, as it may be given: "45", "0,0,1" or a word; empty if it is found from the model.
std::string usual_value(const Parameter& parameter);

/// "default 45; 0..90 [deg]"
std::string values_text(const Parameter& parameter);

}  // namespace epura
