// SPDX-License-Identifier: Apache-2.0
// The files that a drawing carries, and the parts of two drawings that are not the same to the byte.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/attachments.hpp"

namespace epura::compare {

/// Of the bytes of an SVG or PDF file, told apart by its name; no names are equal, all are safe
/// (output::is_safe_name). Throws Error{input} for a file that epura did not write, and for unsafe names.
std::vector<output::Attachment> attachments_in(const std::string& bytes, const std::filesystem::path& file);

/// What differs in two PDF files with lines and texts alike: "layer front/dimension", "the order of the layers", "the
/// size of page 2". Empty if these are the same. Throws Error{input}.
std::vector<std::string> differing_layers(const std::string& before, const std::string& after,
                                          const std::filesystem::path& file);

}  // namespace epura::compare
