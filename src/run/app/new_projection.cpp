// SPDX-License-Identifier: Apache-2.0
// Creates a projection plugin: a renamed copy of the sample plugin-military.
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "app/commands.hpp"
#include "app/run_epura.hpp"
#include "app/skeleton.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/shared_library.hpp"
#include "base/text.hpp"
#include "projection/loader.hpp"

namespace epura {

namespace {

namespace fs = std::filesystem;

constexpr auto next_steps = R"(NAME/NAME.cpp
NAME/CMakeLists.txt

NAME draws a military projection, as a start. To build, test and use it:
INSTALL  cmake -S NAME -B NAME/buildPREFIX && cmake --build NAME/build
  epura plugins check NAME/build/NAME.so
  epura draw MODEL --plugin-path NAME/build --projection NAME -o drawing.pdf
)";

/// "two-point" -> "TwoPoint". An identifier must not begin with a digit.
std::string type_name(const std::string& name) {
  std::string type = std::isdigit(static_cast<unsigned char>(name[0])) != 0 ? "P" : "";
  bool begins = true;
  for (const char c : name) {
    if (c != '-') type += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '-';
  }
  return type;
}

// Where this epura is installed; empty if it runs in the folder where it was built, or without its headers.
fs::path own_prefix() {
  std::error_code error;
  const bool has_package = fs::exists(own_folder().parent_path() / "cmake/epura/epura-config.cmake", error);
  return has_package ? fs::read_symlink("/proc/self/exe", error).parent_path().parent_path() : fs::path();
}

// CMake looks into the folders of the system by itself.
std::string next_steps_for(const std::string& name) {
  const fs::path prefix = own_prefix();
  const bool is_found = prefix == "/usr" || prefix == "/usr/local";
  const std::string place = prefix.empty() ? "\"$HOME/.local\"" : for_shell(prefix.string());
  const std::string install = prefix.empty() ? "  cmake --install BUILD --prefix " + place +
                                                   "   # BUILD: where this epura was built, without its headers\n"
                                             : "";
  const std::string text = replaced(next_steps, "NAME", name);
  return replaced(replaced(text, "INSTALL", install), "PREFIX", is_found ? "" : " -DCMAKE_PREFIX_PATH=" + place);
}

std::string renamed(const char* skeleton, const std::string& name) {
  return replaced(replaced(skeleton, "MilitaryProjection", type_name(name) + "Projection"), "military", name);
}

}  // namespace

int new_projection(const NewProjectionOptions& options) {
  const std::string& name = options.name;
  if (!foreign::is_plugin_name(name))
    throw Error(ErrorKind::input, "'" + name + "'", "is not a valid projection name", "use lower case, digits and '-'");
  const fs::path folder = name;
  std::error_code error;
  if (fs::exists(fs::symlink_status(folder, error)))
    throw Error(ErrorKind::input, name, "exists already", "choose another name, or remove it");
  if (!fs::create_directory(folder, error))
    throw Error(ErrorKind::output, name, "cannot create the folder: " + error.message());
  write_file(folder / (name + ".cpp"), renamed(skeleton_source, name));
  write_file(folder / "CMakeLists.txt", renamed(skeleton_build, name));
  std::fputs(next_steps_for(name).c_str(), stdout);
  return 0;
}

}  // namespace epura
