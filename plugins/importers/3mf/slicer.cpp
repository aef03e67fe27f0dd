// SPDX-License-Identifier: Apache-2.0
#include "slicer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "package.hpp"
#include "xml.hpp"

namespace epura::plugin::threemf {

namespace {

constexpr std::array<std::pair<std::string_view, Role>, 8> roles{{{"ParameterModifier", Role::modifier},
                                                                  {"NegativeVolume", Role::negative},
                                                                  {"SupportBlocker", Role::blocker},
                                                                  {"SupportEnforcer", Role::enforcer},
                                                                  {"modifier_part", Role::modifier},
                                                                  {"negative_part", Role::negative},
                                                                  {"support_blocker", Role::blocker},
                                                                  {"support_enforcer", Role::enforcer}}};

Role role_of(std::string_view word) {
  const auto found = std::find_if(roles.begin(), roles.end(), [&](const auto& row) { return row.first == word; });
  return found == roles.end() ? Role::part : found->second;
}

std::size_t number_of(std::string_view text) {
  std::size_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// Reads <config> with <object>s, in which <volume> or <part> stands.
class SettingsReader {
 public:
  void read(std::string_view text) {
    for (Xml xml(text); xml.next();) {
      const Tag& tag = xml.tag();
      if (xml.depth() == 1) object_ = tag.name == "object" ? &settings_[tag.text("id")] : nullptr;
      if (object_ == nullptr) continue;
      if (xml.depth() == 2) piece_ = Piece::none;
      if (tag.name == "volume") begin_volume(tag);
      if (tag.name == "part") begin_component(tag);
      if (tag.name == "metadata") note(tag);
    }
  }
  Settings settings_{};

 private:
  enum class Piece { none, volume, component };

  void begin_volume(const Tag& tag) {
    piece_ = Piece::volume;
    object_->volumes.push_back({number_of(tag.raw("firstid")), number_of(tag.raw("lastid")), {}, Role::part});
  }

  void begin_component(const Tag& tag) {
    piece_ = Piece::component;
    object_->components.push_back({tag.text("id"), {}, role_of(tag.raw("subtype"))});
  }

  void note(const Tag& tag) {
    const std::string_view key = tag.raw("key"), value = tag.raw("value");
    if (key == "name") name() = tag.text("value");
    if (piece_ != Piece::volume) return;
    Role& role = object_->volumes.back().role;
    // Older versions know no other kind.
    if (key == "modifier" && value == "1" && role == Role::part) role = Role::modifier;
    if (key == "volume_type") role = role_of(value);
  }

  std::string& name() {
    if (piece_ == Piece::volume) return object_->volumes.back().name;
    return piece_ == Piece::component ? object_->components.back().name : object_->name;
  }

  Told* object_ = nullptr;
  Piece piece_ = Piece::none;
};

bool is_settings(const std::string& part) {
  constexpr std::array<std::string_view, 2> endings{"_model.config", "model_settings.config"};
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view ending) {
    return part.size() > ending.size() && std::string_view(part).substr(part.size() - ending.size()) == ending;
  });
}

}  // namespace

Settings settings_of(const Package& package) {
  SettingsReader reader;
  for (const std::string& part : package.parts())
    if (is_settings(part)) reader.read(package.text_of(part));
  return std::move(reader.settings_);
}

Role role_by_cura(std::string_view key, std::string_view value) {
  constexpr std::array<std::pair<std::string_view, Role>, 4> settings{{{"infill_mesh", Role::modifier},
                                                                       {"cutting_mesh", Role::modifier},
                                                                       {"anti_overhang_mesh", Role::blocker},
                                                                       {"support_mesh", Role::support}}};
  key = key.substr(key.find(':') + 1);
  const auto found = std::find_if(settings.begin(), settings.end(), [&](const auto& row) { return row.first == key; });
  return found == settings.end() || (value != "True" && value != "true") ? Role::part : found->second;
}

}  // namespace epura::plugin::threemf
