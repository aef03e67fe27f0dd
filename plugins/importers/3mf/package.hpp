// SPDX-License-Identifier: Apache-2.0
// The ZIP archive of a 3MF file.
#pragma once

#include <zip.h>

#include <memory>
#include <string>
#include <vector>

namespace epura::plugin::threemf {

class Package {
 public:
  /// Throws std::runtime_error with a sentence if the file is not an archive, is encrypted or damaged, or has far more
  /// content than archives of models do.
  explicit Package(const std::string& path);

  /// Parts of a package have paths from its root, whose case does not count; with or without a slash before.
  [[nodiscard]] bool has(const std::string& part) const;
  /// Unpacks a part, which must be there.
  [[nodiscard]] std::string text_of(const std::string& part) const;
  [[nodiscard]] const std::vector<std::string>& parts() const { return parts_; }
  /// The part that the package names as its model.
  [[nodiscard]] std::string model_part() const;

 private:
  struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
  };

  std::string bytes_;
  std::unique_ptr<zip_t, Discard> archive_;
  std::vector<std::string> parts_;
};

}  // namespace epura::plugin::threemf
