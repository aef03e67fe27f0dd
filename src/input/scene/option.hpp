// SPDX-License-Identifier: Apache-2.0
// The complete description of one option of a drawing or command. Tables of such rows define the command line, scene
// files, help, completion, the manual and the documentation.
#pragma once

#include <functional>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

#include "scene/description.hpp"
#include "scene/scene_values.hpp"

namespace epura::scene {

/// What an option affects: the drawing, files that are read or written, code that is loaded, or the run and its
/// messages. Only the first is safe to accept from third parties.
enum class Nature { unsaid, drawing, file, code, run };

/// A command-line switch that stands for one word of an option: "--portrait".
struct Switch {
  std::string flag, word, help;
};

/// The properties of an option that do not depend on the part to which it belongs.
struct OptionInfo {
  std::string key{};   ///< in scene files; empty: not available there
  std::string flag{};  ///< on the command line: "-o,--output", or "models" for an argument; empty: not available there
  ValueForm form{};
  std::string help{};
  std::string usual{};  ///< default value
  Nature nature = Nature::unsaid;
  bool required = false;
  bool repeatable = false;                     ///< each occurrence adds a value; otherwise the last one counts
  std::vector<Switch> switches{};              ///< instead of a flag on the command line
  std::type_index type = typeid(std::string);  ///< of the value that is read

  /// Returns the help, with the permitted words.
  [[nodiscard]] std::string meaning() const;
};

template <class Part>
struct Option : OptionInfo {
  std::function<void(Part&, const TomlValue&)> read;   ///< throws Error{input} for invalid values
  std::function<void(Part&, const Part&)> overrule{};  ///< copies the value of the second part, if given
};

template <class Part>
using Options = std::vector<Option<Part>>;

template <class Value>
void assign(Value& member, Value value, const std::string&) {
  member = std::move(value);
}
template <class Value>
void assign(std::optional<Value>& member, Value value, const std::string&) {
  member = std::move(value);
}
template <class Value>
void assign(Located<Value>& member, Value value, const std::string& where) {
  member = {std::move(value), where};
}
template <class Value>
void assign(std::vector<Value>& member, Value value, const std::string&) {
  member.push_back(std::move(value));
}
template <class Value>
void assign(std::vector<Located<Value>>& member, Value value, const std::string& where) {
  member.push_back({std::move(value), where});
}

template <class Value>
void take_over(Located<Value>& member, const Located<Value>& other) {
  if (other.given()) member = other;
}
void take_over(auto&, const auto&) {}

/// Makes an option whose value is assigned to `member` of the part; `member` may be a function that returns a reference
/// into the part.
template <class Part, class Member, class Value>
Option<Part> option(OptionInfo info, Member member, const ValueKind<Value>& kind) {
  info.form = kind.form;
  info.type = typeid(Value);
  return {
      std::move(info),
      [member, read = kind.read](Part& part, const TomlValue& value) {
        assign(std::invoke(member, part), read(value), value.where);
      },
      [member](Part& part, const Part& other) { take_over(std::invoke(member, part), std::invoke(member, other)); }};
}

/// Appends the options of a part as options of the whole that has the part as `member`. They affect the drawing.
template <class Whole, class Part>
void append_options(Options<Whole>& all, const Options<Part>& options, Part Whole::*member) {
  for (const Option<Part>& one : options)
    if (!one.flag.empty() || !one.switches.empty()) {
      all.push_back(
          {one, [member, read = one.read](Whole& whole, const TomlValue& value) { read(whole.*member, value); }, {}});
      all.back().nature = Nature::drawing;
    }
}

}  // namespace epura::scene
