// SPDX-License-Identifier: Apache-2.0
#include "model.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "../words.hpp"
#include "count_parts.hpp"
#include "package.hpp"
#include "slicer.hpp"
#include "xml.hpp"

namespace epura::plugin::threemf {

namespace {

[[noreturn]] void refuse(const std::string& sentence) {
  throw std::runtime_error("is not a valid 3MF file: " + sentence);
}

// Coordinates of 3MF are those of 32 bits in all programs that write it.
constexpr double largest = std::numeric_limits<float>::max();

// The next number of a text, with the blanks before it; nothing if there is none.
std::optional<double> next_number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.substr(0, 1) == "+") text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !(std::abs(number) <= largest)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

double coordinate_of(std::string_view text) {
  const std::optional<double> number = next_number(text);
  if (!number || text.find_first_not_of(" \t\r\n") != std::string_view::npos)
    refuse("a vertex has a coordinate that is no number, or is too large");
  return *number;
}

// "m00 m01 m02 m10 ... m32": points are rows, which stand before the matrix.
Transform transform_of(std::string_view text) {
  if (text.empty()) return identity;
  Transform transform{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const std::optional<double> number = next_number(text);
      if (!number) refuse("a transform does not have twelve numbers");
      transform[4 * column + row] = *number;
    }
  }
  return transform;
}

std::uint32_t corner_of(std::string_view text, std::size_t points) {
  std::uint32_t corner = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), corner);
  if (error != std::errc() || end != text.data() + text.size() || corner >= points)
    refuse("a triangle has a corner that is no vertex");
  return corner;
}

double millimetres_of(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, double>, 7> units{{{"", 1},
                                                                      {"micron", 0.001},
                                                                      {"millimeter", 1},
                                                                      {"centimeter", 10},
                                                                      {"inch", 25.4},
                                                                      {"foot", 304.8},
                                                                      {"meter", 1000}}};
  for (const auto& [name, millimetres] : units)
    if (unit == name) return millimetres;
  refuse("its unit '" + std::string(unit) + "' is none of 3MF");
}

// "#RRGGBB" or "#RRGGBBAA".
std::optional<std::array<double, 3>> colour_of(std::string_view text) {
  constexpr std::size_t digits = 6;
  if (text.substr(0, 1) != "#" || text.size() <= digits) return std::nullopt;
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 1 + digits, number, 16);
  if (error != std::errc() || end != text.data() + 1 + digits) return std::nullopt;
  return std::array{(number >> 16) / 255.0, (number >> 8 & 255) / 255.0, (number & 255) / 255.0};
}

Role role_of_type(std::string_view type) {
  if (type == "support" || type == "solidsupport") return Role::support;
  return type == "other" ? Role::other : Role::part;
}

// Extensions without which what is read here is not the shape of the model.
void expect_extensions(const Tag& model) {
  constexpr std::array<std::string_view, 5> known{"/production/", "/material/", "/slice/", "/beamlattice/",
                                                  "/trianglesets/"};
  std::string_view prefixes = model.raw("requiredextensions");
  while (!prefixes.empty()) {
    const std::size_t end = std::min(prefixes.find_first_of(" \t\r\n"), prefixes.size());
    const std::string_view uri = model.raw(prefixes.substr(0, end));
    const auto is_in_uri = [&](std::string_view name) { return uri.find(name) != std::string_view::npos; };
    if (end > 0 && std::none_of(known.begin(), known.end(), is_in_uri))
      throw std::runtime_error("needs the extension " + std::string(uri.empty() ? prefixes.substr(0, end) : uri) +
                               ", which is not read");
    prefixes.remove_prefix(std::min(end + 1, prefixes.size()));
  }
}

/// The part of the package, and the number in it.
using Id = std::pair<std::string, std::string>;

/// A reference to an object that may not have been read yet.
struct Reference {
  Id id;
  Placed placed;
  std::optional<std::uint32_t> owner;  ///< the object with this component; nothing: a build item
};

class ModelReader {
 public:
  ModelReader(const Package& package, const std::function<void(double)>& tell) : package_(package), tell_(tell) {}

  Model read() {
    const std::string root = package_.model_part();
    to_read_.push_back(root);
    // Build items of other parts are not built.
    for (std::size_t i = 0; i < to_read_.size(); ++i) read_part(std::string(to_read_[i]), i == 0);
    for (const Reference& reference : references_) resolve(reference);
    apply(settings_of(package_), root);
    return std::move(model_);
  }

 private:
  void read_part(const std::string& part, bool is_root) {
    const std::string text = package_.text_of(part);
    part_ = part;
    is_root_ = is_root;
    materials_.clear();
    object_.reset();
    std::size_t tags = 0;
    try {
      for (Xml xml(text); xml.next();) {
        read_tag(xml);
        constexpr std::size_t between = 65536;
        if (++tags % between == 0) tell_(is_root ? xml.done() : 1);
      }
    } catch (const std::runtime_error& error) {
      const std::string_view sentence = error.what();
      if (sentence.substr(0, 5) != "line ") throw;
      throw std::runtime_error("'" + part + "' in it is damaged: " + std::string(sentence));
    }
  }

  void read_tag(const Xml& xml) {
    const Tag& tag = xml.tag();
    if (object_ && xml.depth() <= object_depth_) object_.reset();
    if (object_) {
      read_in_object(xml);
    } else if (tag.name == "object") {
      begin_object(xml);
    } else if (tag.name == "model") {
      expect_extensions(tag);
      if (is_root_) model_.millimetres = millimetres_of(tag.raw("unit"));
    } else if (tag.name == "metadata" && is_root_) {
      keep_words(xml, "metadata");
    } else if (tag.name == "item" && is_root_) {
      refer(tag, tag.text("partnumber"), std::nullopt);
    } else if (tag.name == "basematerials" || tag.name == "colorgroup") {
      colours_ = &materials_[tag.text("id")];
    } else if (colours_ != nullptr && (tag.name == "base" || tag.name == "color")) {
      colours_->push_back(colour_of(tag.raw(tag.name == "base" ? "displaycolor" : "color")));
    }
  }

  void begin_object(const Xml& xml) {
    const Tag& tag = xml.tag();
    object_ = static_cast<std::uint32_t>(model_.objects.size());
    object_depth_ = xml.depth();
    if (!numbers_.emplace(Id(key_of(part_), tag.text("id")), *object_).second)
      refuse("two objects have the number " + tag.text("id"));
    Object& object = model_.objects.emplace_back();
    object.name = tag.text("name").empty() ? tag.text("partnumber") : tag.text("name");
    object.role = role_of_type(tag.raw("type"));
    object.has_slices = !tag.raw("slicestackid").empty();
    const auto material = materials_.find(tag.text("pid"));
    std::size_t index = 0;
    const std::string_view place = tag.raw("pindex");
    std::from_chars(place.data(), place.data() + place.size(), index);
    if (material != materials_.end() && index < material->second.size()) object.colour = material->second[index];
  }

  void read_in_object(const Xml& xml) {
    const Tag& tag = xml.tag();
    Object& object = model_.objects[*object_];
    const std::size_t level = xml.depth() - object_depth_;
    if (level == 1) {
      is_in_mesh_ = tag.name == "mesh";
      if (!is_in_mesh_ && tag.name != "components" && tag.name != "metadatagroup") object.unread = tag.name;
    } else if (is_in_mesh_ && level == 3 && tag.name == "vertex") {
      object.points.push_back({coordinate_of(tag.raw("x")), coordinate_of(tag.raw("y")), coordinate_of(tag.raw("z"))});
    } else if (is_in_mesh_ && level == 3 && tag.name == "triangle") {
      const std::size_t points = object.points.size();
      object.triangles.push_back(
          {corner_of(tag.raw("v1"), points), corner_of(tag.raw("v2"), points), corner_of(tag.raw("v3"), points)});
    } else if (tag.name == "beam") {
      ++object.beams;
    } else if (tag.name == "component") {
      refer(tag, {}, object_);
    } else if (tag.name == "metadata") {
      keep_words(xml, "object " + std::to_string(*object_ + 1));
      if (object.role == Role::part) object.role = role_by_cura(tag.raw("name"), xml.content());
    }
  }

  // Names of others have a prefix.
  void keep_words(const Xml& xml, const std::string& place) {
    const std::string name = xml.tag().text("name");
    const std::string own = name.substr(name.rfind(':') + 1), text = xml.content();
    if (!names_words(own) || text.find_first_not_of(" \t\r\n") == std::string::npos) return;
    const auto count = std::count_if(model_.words.begin(), model_.words.end(),
                                     [&](const auto& other) { return other.first.rfind(place, 0) == 0; });
    model_.words.emplace_back(place + (count > 0 ? ", " + std::to_string(count + 1) : ""), text);
  }

  void refer(const Tag& tag, std::string name, std::optional<std::uint32_t> owner) {
    const std::string path = tag.text("path");
    if (!path.empty() && std::none_of(to_read_.begin(), to_read_.end(),
                                      [&](const std::string& one) { return key_of(one) == key_of(path); }))
      to_read_.push_back(path);
    references_.push_back({{key_of(path.empty() ? part_ : path), tag.text("objectid")},
                           {0, transform_of(tag.raw("transform")), std::move(name)},
                           owner});
  }

  /// Names of parts are equal whatever their case.
  static std::string key_of(std::string_view path) {
    std::string key(path.substr(std::min(path.find_first_not_of('/'), path.size())));
    for (char& c : key) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return key;
  }

  void resolve(Reference reference) {
    const auto found = numbers_.find(reference.id);
    if (found == numbers_.end())
      refuse(reference.owner ? "a component is of an object that is missing"
                             : "an object that is to be built is missing");
    reference.placed.object = found->second;
    if (reference.owner) {
      component_ids_[*reference.owner].push_back(reference.id.second);
      model_.objects[*reference.owner].components.push_back(std::move(reference.placed));
    } else {
      model_.items.push_back(std::move(reference.placed));
    }
  }

  void apply(Settings settings, const std::string& root) {
    for (auto& [id, told] : settings) {
      const auto found = numbers_.find({key_of(root), id});
      if (found == numbers_.end()) continue;
      Object& object = model_.objects[found->second];
      if (object.name.empty()) object.name = std::move(told.name);
      const std::vector<std::string>& ids = component_ids_[found->second];
      for (const Told::Component& piece : told.components) {
        const auto place = std::find(ids.begin(), ids.end(), piece.object);
        if (place == ids.end()) continue;
        Placed& component = object.components[static_cast<std::size_t>(place - ids.begin())];
        component.name = piece.name;
        component.role = piece.role;
      }
      if (!object.triangles.empty()) object.volumes = std::move(told.volumes);
    }
  }

  const Package& package_;
  const std::function<void(double)>& tell_;
  Model model_;
  std::vector<std::string> to_read_;  ///< parts of the package
  std::vector<Reference> references_;
  std::map<Id, std::uint32_t> numbers_;
  std::map<std::uint32_t, std::vector<std::string>> component_ids_;  ///< of the components of objects

  // While a part is read:
  std::string part_;
  bool is_root_ = false, is_in_mesh_ = false;
  std::optional<std::uint32_t> object_;  ///< that contains the tag
  std::size_t object_depth_ = 0;
  using Colours = std::vector<std::optional<std::array<double, 3>>>;
  std::map<std::string, Colours> materials_;
  Colours* colours_ = nullptr;
};

}  // namespace

Model read_model(const Package& package, const std::function<void(double)>& tell) {
  Model model = ModelReader(package, tell).read();
  if (model.objects.empty()) refuse("it has no object");
  expect_few_parts(model);
  return model;
}

}  // namespace epura::plugin::threemf
