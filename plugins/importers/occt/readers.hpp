// SPDX-License-Identifier: Apache-2.0
// Files of parts to a Model, in millimetres. What cannot be read: std::runtime_error with a sentence.
#pragma once

#include <epura/importer_plugin.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "model.hpp"

namespace occt {

Model read_step(const std::string& path, epura::plugin::Sink& sink);
Model read_iges(const std::string& path, epura::plugin::Sink& sink);
Model read_brep(const std::string& path, epura::plugin::Sink& sink);

/// The share of the work that reading is, of the whole that Sink::progress tells.
inline constexpr double share_of_reading = 0.5;

/// Checks that the file exists and begins as `recognises` wants; `what` as in "no STEP file".
void expect_kind(const std::string& path, bool (*recognises)(std::string_view), const std::string& what);

/// Its last 64 KiB, or all of it.
std::string end_of(const std::string& path);

/// What to throw for a file that ends without `missing`.
std::runtime_error cut_off(const std::string& path, const std::string& missing);

bool is_step(std::string_view first_bytes);
bool is_iges(std::string_view first_bytes);
bool is_brep(std::string_view first_bytes);

}  // namespace occt
