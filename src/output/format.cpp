// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/text.hpp"
#include "output/write.hpp"

namespace epura {

const std::vector<std::string>& format_names() {
  static const std::vector<std::string> names = {"svg", "pdf", "ps", "eps", "png", "dxf", "json"};
  return names;
}

std::optional<Format> format_of(std::string_view extension) {
  if (extension.starts_with('.')) extension.remove_prefix(1);
  const std::vector<std::string>& names = format_names();
  const auto found = std::find(names.begin(), names.end(), to_lower(extension));
  if (found == names.end()) return std::nullopt;
  return static_cast<Format>(found - names.begin());
}

std::string format_hint(std::string_view extension) {
  // What people mean by formats that are not written.
  static const std::vector<std::pair<std::string, std::string>> meant = {
      {"dwg", "dxf"},  {"jpg", "png"},  {"jpeg", "png"}, {"gif", "png"}, {"bmp", "png"},  {"tif", "png"},
      {"tiff", "png"}, {"webp", "png"}, {"emf", "svg"},  {"wmf", "svg"}, {"svgz", "svg"}, {"ai", "pdf"}};
  for (const auto& [other, name] : meant)
    if (to_lower(extension) == other) return "write " + name + " instead, which programs for " + other + " read";
  return did_you_mean(extension, format_names());
}

}  // namespace epura
