// Runs epura as a user does: a process of its own, and what it answers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace epura::test {

struct Outcome {
  int code;  ///< exit code; 128 + number when a signal ended it
  std::string out, err;
};

/// Runs the program with `arguments` in `folder`; the environment is that of the test, without $EPURA_PLUGIN_PATH.
/// Standard output goes into `out`, or to the file `out_path` if one is named.
Outcome epura(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
              const std::string& out_path = {});

/// The root of the repository.
inline std::filesystem::path root() { return std::filesystem::path(EPURA_TEST_SAMPLES).parent_path(); }
inline std::string sample(const std::string& name) { return EPURA_TEST_SAMPLES "/models/" + name; }

}  // namespace epura::test
