// SPDX-License-Identifier: Apache-2.0
// Kinds of values in scene files: their names for the documentation, and their readers.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/vec.hpp"
#include "scene/description.hpp"
#include "scene/toml_tree.hpp"

namespace epura::scene {

/// Throws Error{input} at the value: "scene.toml:12:9: 'at' " + reason.
[[noreturn]] void refuse(const TomlValue& value, const std::string& reason, const std::string& hint = {});

/// The source of words for shell completion, in addition to those listed in a form.
enum class Completion { words, files, folders, projection, projections };

/// The form of a value, for help, documentation and completion.
struct ValueForm {
  std::string name{};                ///< in documentation: "text", "0 to 180, degrees"
  std::string placeholder{};         ///< on the command line: "DEG"; empty: a switch, which takes no value
  std::vector<std::string> words{};  ///< permitted or suggested values
  bool is_closed = false;            ///< no other values are permitted
  bool is_list = false;              ///< of words, separated by commas
  Completion completion = Completion::words;
  std::string implied{};  ///< value of the option without "=": --arcs
};

/// A kind of values. `read` throws Error{input} for values of other kinds.
template <class Value>
struct ValueKind {
  ValueForm form;
  std::function<Value(const TomlValue&)> read;

  [[nodiscard]] ValueKind shown_as(const std::string& placeholder) const {
    ValueKind kind = *this;
    kind.form.placeholder = placeholder;
    return kind;
  }
  /// Adds words for frequent values.
  [[nodiscard]] ValueKind such_as(std::vector<std::string> words) const {
    ValueKind kind = *this;
    kind.form.words = std::move(words);
    return kind;
  }
  [[nodiscard]] ValueKind completed_by(Completion completion) const {
    ValueKind kind = *this;
    kind.form.completion = completion;
    return kind;
  }
};

TomlValue value_of_option(const std::string& flag, const std::string& text);

/// An anchor of a dimension with an unresolved model.
struct AnchorWords {
  std::string where;
  std::variant<int, std::string> model;  ///< number or name
  int vertex = -1;
  std::optional<Vec3> point;  ///< instead of a vertex
  FeatureName feature{};      ///< likewise
};

/// Where a leader ends, with an unresolved model.
using LeaderWords = std::variant<AnchorWords, Vec2>;

// Texts are single lines without control characters, and not empty unless stated.
ValueKind<std::string> any_text();
ValueKind<std::string> field_text();                ///< may be empty, or a date: 2026-11-21
ValueKind<ProjectionRequest> projection_request();  ///< from a text, or a table {name = NAME, key = value}
ValueKind<bool> truth();
ValueKind<int> whole_number(int min);
ValueKind<int> whole_number(int min, int max);
ValueKind<double> any_number(const std::string& unit);
ValueKind<double> number_between(double min, double max, const std::string& unit);
ValueKind<double> positive_number();  ///< above 0
ValueKind<Vec2> pair_of_numbers(const std::string& unit);
ValueKind<Vec3> triple_of_numbers(const std::string& unit);
ValueKind<std::vector<Vec3>> list_of_triples();
ValueKind<Vec3> direction();        ///< three numbers, not all zero
ValueKind<Mat4> transform_steps();  ///< see scene/transform.hpp
ValueKind<ColourChoice> colour();   ///< "#c00", "#cc0000" or "file"
ValueKind<ScaleChoice> scale_choice();
ValueKind<PaperChoice> paper_choice();
ValueKind<EdgeKinds> edge_kinds();
ValueKind<ConstructionChoice> construction_choice();  ///< a list of constructions
ValueKind<BreakChoice> break_choice();                ///< "auto", or a list of places
ValueKind<AnchorWords> anchor();                      ///< [model, vertex], {point = [x, y, z]} or a feature
ValueKind<std::vector<AnchorWords>> list_of_anchors();
ValueKind<LeaderWords> leader_target();            ///< an anchor, or {page = [x, y]}
ValueKind<std::vector<std::string>> text_lines();  ///< a list of texts, or a text with line breaks

ValueKind<std::vector<std::string>> list_of_texts();               ///< single lines, which may be empty
ValueKind<std::vector<std::vector<std::string>>> rows_of_texts();  ///< one row or more, of such lists

/// Returns the index of one of the words.
std::size_t read_word(const TomlValue& value, const std::vector<std::string>& words);
std::string words_as_text(const std::vector<std::string>& words);
/// The words of an enum, in the order of its enumerators. If it has other words for them, those are read, too.
template <class Enum>
ValueKind<Enum> choice() {
  const std::vector<std::string> words(Words<Enum>::list.begin(), Words<Enum>::list.end());
  ValueForm form{words_as_text(words), "WORD", words, true};
  std::vector<std::string> all = words;
  if constexpr (requires { Words<Enum>::other; }) {
    all.insert(all.end(), Words<Enum>::other.begin(), Words<Enum>::other.end());
    form.name = words_as_text(form.words = all);
  }
  const std::size_t count = words.size();
  return {std::move(form),
          [all, count](const TomlValue& value) { return static_cast<Enum>(read_word(value, all) % count); }};
}

/// "hole 3" or "face 12": what it is, and its number from 1. Throws Error{input} with `where` as the location.
std::pair<std::string, std::size_t> parse_feature(const std::string& text, const std::string& where);

/// A feature from a text, or from a list of a model and a text; nothing for other values.
std::optional<FeatureName> read_feature(const TomlValue& value);

/// Returns a text, which must not be empty.
std::string read_text(const TomlValue& value);

/// Returns the words of a list. On the command line and in a text they are separated by commas; surrounding blanks are
/// ignored.
std::vector<LocatedText> each_word(const TomlValue& value);

/// Returns a table with entries of any name.
const TomlTable& table_of(const TomlValue& value);

/// Returns several tables, or a single one.
std::vector<const TomlValue*> tables_of(const TomlValue& value);

}  // namespace epura::scene
