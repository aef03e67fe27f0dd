// SPDX-License-Identifier: Apache-2.0
// A file of this process, for functions that want a path.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace epura::fuzz {

class OwnFile {
 public:
  explicit OwnFile(const std::string& bytes, const std::string& extension = "")
      : path_(std::filesystem::temp_directory_path() / ("epura-fuzz-" + std::to_string(::getpid()) + extension)) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  OwnFile(const OwnFile&) = delete;
  OwnFile& operator=(const OwnFile&) = delete;
  ~OwnFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace epura::fuzz
