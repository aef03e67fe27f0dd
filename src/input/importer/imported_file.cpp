// SPDX-License-Identifier: Apache-2.0
#include "importer/imported_file.hpp"

#include <algorithm>
#include <cmath>

#include "base/vec.hpp"
#include "foreign/child_process.hpp"

namespace epura::importer {

namespace {

bool is_direction(const Vec3& v) { return std::isfinite(glm::dot(v, v)) && glm::dot(v, v) > 0; }

template <class Pack, class Value>
void pack_view(Pack& pack, Value& view) {
  pack(view.is_central), pack(view.name), pack(view.eye), pack(view.towards), pack(view.up), pack(view.planes);
}

}  // namespace

bool is_sound_view(const SavedView& view) {
  const auto vector = [](const std::array<double, 3>& v) { return Vec3(v[0], v[1], v[2]); };
  const Vec3 towards = vector(view.towards), up = vector(view.up), eye = vector(view.eye);
  return is_direction(towards) && is_direction(up) && is_direction(glm::cross(towards, up)) &&
         std::isfinite(glm::dot(eye, eye)) &&
         std::all_of(view.planes.begin(), view.planes.end(), [](const std::array<double, 6>& plane) {
           return std::isfinite(plane[0]) && std::isfinite(plane[1]) && std::isfinite(plane[2]) &&
                  is_direction({plane[3], plane[4], plane[5]});
         });
}

void expect_sound_file(const ImportedFile& file) {
  expect_sound(file);
  foreign::require(std::all_of(file.saved_views.begin(), file.saved_views.end(), is_sound_view),
                   "corrupts its process");
}

void pack_file(foreign::Packer& pack, const ImportedFile& file) {
  pack_document(pack, file);
  pack(file.saved_views.size());
  for (const SavedView& view : file.saved_views) pack_view(pack, view);
  pack(file.standard);
}

ImportedFile unpack_file(foreign::Unpacker& unpack) {
  ImportedFile file{unpack_document(unpack)};
  file.saved_views.resize(unpack.count(1));
  for (SavedView& view : file.saved_views) pack_view(unpack, view);
  unpack(file.standard);
  return file;
}

}  // namespace epura::importer
