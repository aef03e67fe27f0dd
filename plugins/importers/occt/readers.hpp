// SPDX-License-Identifier: Apache-2.0
// Reads files of parts into a Model, in millimetres. Throws std::runtime_error with a sentence for unreadable files.
#pragma once

#include <epura/importer_plugin.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "model.hpp"

namespace occt {

Model read_step(const std::string& path, const Beside& beside, epura::plugin::Sink& sink);
Model read_iges(const std::string& path, const Beside& beside, epura::plugin::Sink& sink);
Model read_brep(const std::string& path, const Beside& beside, epura::plugin::Sink& sink);

/// The shape of a BREP file, in millimetres.
Model model_of(const TopoDS_Shape& shape, const Beside& beside);

/// The share of reading in the work reported by Sink::progress.
inline constexpr double share_of_reading = 0.5;

/// Checks that the file exists and that `recognises` accepts its beginning; `what` as in "no STEP file".
void expect_kind(const std::string& path, bool (*recognises)(std::string_view), const std::string& what);

/// The last 64 KiB of a file, or all of it.
std::string end_of(const std::string& path);

/// The error for a file that ends without `missing`.
std::runtime_error cut_off(const std::string& path, const std::string& missing);

bool is_step(std::string_view first_bytes);
bool is_iges(std::string_view first_bytes);
bool is_brep(std::string_view first_bytes);

}  // namespace occt
