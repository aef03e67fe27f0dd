// SPDX-License-Identifier: Apache-2.0
#include "compare/read_pictures.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"

namespace epura::compare {

namespace {

template <class Item>
int number_in(std::vector<Item>& items, const Item& item) {
  const auto found = std::find(items.begin(), items.end(), item);
  const auto number = found - items.begin();
  if (found == items.end()) items.push_back(item);
  return static_cast<int>(number);
}

}  // namespace

int number_of_name(std::vector<std::string>& names, const std::string& name) { return number_in(names, name); }

int number_of_look(std::vector<PictureLook>& looks, const PictureLook& look) { return number_in(looks, look); }

bool is_drawing(const std::filesystem::path& path) {
  const std::string extension = to_lower(path.extension().string());
  return extension == ".json" || extension == ".svg" || extension == ".pdf";
}

void expect_drawing(const std::filesystem::path& path) {
  if (!is_drawing(path))
    throw Error(ErrorKind::input, path.string(), "is not a drawing that can be compared",
                "epura compares its .json, .svg and .pdf files");
}

PictureFile read_pictures(const std::filesystem::path& path) {
  expect_drawing(path);
  return pictures_of(read_file(path), path);
}

PictureFile pictures_of(const std::string& bytes, const std::filesystem::path& path) {
  const std::string extension = to_lower(path.extension().string()), where = path.string();
  if (extension == ".json") return {true, false, {picture_of_json(bytes, where)}};
  if (extension == ".svg") return {false, false, {picture_of_svg(bytes, where)}};
  return {false, true, pictures_of_pdf(bytes, where)};
}

}  // namespace epura::compare
