// SPDX-License-Identifier: Apache-2.0
// One option of a drawing or command, completely described in one place. Tables of such rows feed the command line,
// scene files, help, completion, the manual and the documentation.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "scene/description.hpp"
#include "scene/scene_values.hpp"

namespace epura::scene {

/// What an option has to do with: the look of a drawing, files that are read or written, code that is loaded, or the
/// run and what it says. In the hands of third parties only the first is harmless.
enum class Nature { unsaid, drawing, file, code, run };

/// A switch of the command line that represents one word of an option: "--portrait".
struct Switch {
  std::string flag, word, help;
};

/// What is known of an option without the part that it belongs to.
struct OptionInfo {
  std::string key{};   ///< in scene files; empty: it is none there
  std::string flag{};  ///< on the command line: "-o,--output", or "models" for an argument; empty: it is none there
  ValueForm form{};
  std::string help{};
  std::string usual{};  ///< its value where none is given
  Nature nature = Nature::unsaid;
  bool required = false;
  bool repeatable = false;         ///< each time one more value; otherwise the last one counts
  std::vector<Switch> switches{};  ///< on the command line instead of a flag

  /// The help, with the words that may be chosen.
  [[nodiscard]] std::string meaning() const;
};

template <class Part>
struct Option : OptionInfo {
  std::function<void(Part&, const TomlValue&)> read;   ///< throws Error{input} for values it does not take
  std::function<void(Part&, const Part&)> overrule{};  ///< takes over what the second was given
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

/// An option whose value goes to `member` of the part, or to what `member` as a function finds in the part.
template <class Part, class Member, class Value>
Option<Part> option(OptionInfo info, Member member, const ValueKind<Value>& kind) {
  info.form = kind.form;
  return {
      std::move(info),
      [member, read = kind.read](Part& part, const TomlValue& value) {
        assign(std::invoke(member, part), read(value), value.where);
      },
      [member](Part& part, const Part& other) { take_over(std::invoke(member, part), std::invoke(member, other)); }};
}

/// The options of a part as options of the whole that has it as `member`: they are about the drawing.
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
