// SPDX-License-Identifier: Apache-2.0
// All that an importer tells of a file: its document, and the views that it has stored.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "foreign/packing.hpp"
#include "importer/document.hpp"

namespace epura::importer {

/// A camera, and planes that clip what it shows. See epura_saved_view.
struct SavedView {
  int is_central;
  std::string name;
  std::array<double, 3> eye, towards, up;
  std::vector<std::array<double, 6>> planes{};  ///< a point and a normal of each
};

struct ImportedFile : Document {
  std::vector<SavedView> saved_views{};
  std::string standard{};  ///< of dimensions and tolerances; empty: the file names none
};

/// Whether directions and places of a view are finite, and directions not zero or along each other.
bool is_sound_view(const SavedView& view);

/// As expect_sound, pack_document and unpack_document, with the views.
void expect_sound_file(const ImportedFile& file);
void pack_file(foreign::Packer& pack, const ImportedFile& file);
ImportedFile unpack_file(foreign::Unpacker& unpack);

}  // namespace epura::importer
