// SPDX-License-Identifier: Apache-2.0
// What tests of importers share: reading by those that were built and those that are made for tests, and what is true
// of the meshes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "importer/read_model.hpp"

namespace epura::test {

/// Of an importer that is made for tests.
inline std::filesystem::path folder_of(const std::string& importer) {
  return std::filesystem::path(EPURA_TEST_BAD_PLUGINS) / "importers" / importer;
}

inline importer::ReadModel read_by(const std::string& importer, const std::filesystem::path& file,
                                   const foreign::Assignments& parameters = {}) {
  return importer::read_model(file, parameters, {.plugin_path = {folder_of(importer)}});
}

inline importer::ReadModel read_by_importer(const std::string& path) {
  importer::ReadOptions options;
  options.plugin_path = {EPURA_TEST_IMPORTERS};
  return importer::read_model(path, {}, options);
}

/// What is said about a file that cannot be read, behind its name.
inline std::string refusal_of(const std::string& path) {
  const Error error = error_of([&] { read_by_importer(path); });
  EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
  const std::string text = error.what(), place = path + ": ";
  EXPECT_EQ(text.substr(0, place.size()), place);
  return text.substr(std::min(place.size(), text.size()));
}

/// Of what closed surfaces enclose, in units of the file; negative where they are inside out.
inline double volume_of(const mesh::Mesh& mesh) {
  double six_times = 0;
  for (int t = 0; t < mesh.report.triangles; ++t) {
    const auto [a, b, c] = mesh.triangle(t);
    six_times += glm::dot(mesh.point(a), glm::cross(mesh.point(b), mesh.point(c)));
  }
  return six_times / 6;
}

struct Extent {
  Vec3 least = Vec3(std::numeric_limits<double>::infinity()), most = -least;
};

inline Extent extent_of(const mesh::Mesh& mesh) {
  Extent extent;
  for (const int corner : mesh.corners) {
    extent.least = glm::min(extent.least, mesh.point(corner));
    extent.most = glm::max(extent.most, mesh.point(corner));
  }
  return extent;
}

inline void expect_extent(const mesh::Mesh& mesh, Vec3 least, Vec3 most, double tolerance = 0) {
  const Extent extent = extent_of(mesh);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(extent.least[k], least[k], tolerance) << "axis " << k;
    EXPECT_NEAR(extent.most[k], most[k], tolerance) << "axis " << k;
  }
}

}  // namespace epura::test
