// SPDX-License-Identifier: Apache-2.0
#include "sizes/note_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/choices.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/note_reading.hpp"
#include "sizes/size_reader.hpp"

namespace epura::sheet {

namespace {

// With one sign for each thing, points before decimals, and without brackets around all of it.
std::string normal(std::string text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> same{
      {{"Ø", "⌀"}, {"ø", "⌀"}, {"Φ", "⌀"}, {"φ", "⌀"}, {"−", "-"}, {"–", "-"}}};
  for (const auto& [old, with] : same) text = replaced(std::move(text), old, with);
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i] == ',' && is_digit(text[i + 1])) text[i] = '.';
  const bool is_whole = (text.starts_with('(') && text.find(')') + 1 == text.size()) ||
                        (text.starts_with('[') && text.find(']') + 1 == text.size());
  return is_whole ? text.substr(1, text.size() - 2) : text;
}

class TextReader {
 public:
  TextReader(std::string_view text, double unit) : reading_{{text}, unit, {}} {}

  NotedText read() {
    take_count();
    for (skip(); !at_.rest.empty(); skip())
      if (!take_one()) reading_.leave_unread();
    if (found_.unread.empty()) found_.understood = found_.elements.size();
    return std::move(found_);
  }

 private:
  bool take_one() {
    check(!at_.rest.empty(), "there is something to read");
    return take_thread() || take_later_count() || take_words() || sizes_.take();
  }

  // Between what is said.
  void skip() {
    while (at_.take(" ") || at_.take(",") || at_.take(";") || (at_.rest.starts_with("- ") && at_.take("-")) ||
           (at_.rest.starts_with("/") && !found_.elements.empty() && found_.unread.empty() && take_slash()))
      continue;
  }

  // Between a thread and its drill: "M8 ↧15/⌀6.8 ↧18".
  bool take_slash() {
    const std::string_view before = at_.rest;
    at_.take("/");
    at_.skip_spaces();
    const std::string_view behind = at_.rest;
    const bool is_other = at_.take_sign() == NotedSign::diameter || thread_at(behind).has_value();
    at_.rest = is_other ? behind : before;
    return is_other;
  }

  void take_count() {
    const Count count = count_of(at_.rest);
    at_.rest.remove_prefix(count.end);
    found_.count = count.number;
    if (count.end == 0) take_counted();
  }

  // "4 HOLES", "4 PLACES"
  bool take_counted() {
    const std::string_view before = at_.rest;
    const std::optional<NumberText> number = at_.take_number();
    at_.skip_spaces();
    const auto use =
        at_.take_use(WordUse::holes, WordUse::places, WordUse::threads, WordUse::fillets, WordUse::chamfers);
    if (number && !number->has_decimals && use) {
      found_.count = std::max(1, static_cast<int>(number->value));
      reading_.speak_of(*use);
      return true;
    }
    at_.rest = before;
    return false;
  }

  // Behind what it counts: "R5 (4×)", "⌀8 2×", "⌀8 THRU 4 PLACES".
  bool take_later_count() {
    if (found_.elements.empty() || found_.count > 1) return false;
    if (take_counted()) return true;
    const std::string_view before = at_.rest;
    const bool is_in_brackets = at_.take("(");
    const std::optional<NumberText> number = at_.take_number();
    const bool is_count = number && !number->has_decimals && at_.take_use(WordUse::times);
    if (is_count && (is_in_brackets ? at_.take(")") : at_.rest.empty())) {
      found_.count = std::max(1, static_cast<int>(number->value));
      return true;
    }
    at_.rest = before;
    return false;
  }

  // The first word that something can be made of.
  bool take_words() {
    const std::string_view before = at_.rest;
    if (at_.take("<")) {
      const std::size_t end = at_.rest.find('>');
      at_.rest = end == std::string_view::npos ? before : at_.rest.substr(end + 1);
      has_value_ = has_value_ || end != std::string_view::npos;
      if (end != std::string_view::npos) return true;
    }
    for (const NoteWords& one : note_words()) {
      const std::size_t bytes = word_at(at_.rest, one);
      at_.rest.remove_prefix(bytes);
      if (bytes > 0 && take_behind(one.use, bytes)) return true;
      at_.rest = before;
    }
    return false;
  }

  // "CSK ⌀12 X 90°", "X 5 DEEP", "ON ⌀96 BC", "ALL FILLETS"; whether something is.
  bool take_behind(WordUse use, std::size_t bytes) {
    check(bytes > 0, "a word was taken");
    switch (use) {
      case WordUse::through:
      case WordUse::blind:
        found_.elements.push_back({role_of(use)});
        reading_.speak_of(use);
        return true;
      case WordUse::counterbore:
      case WordUse::countersink:
      case WordUse::recess:
        return take_recess(use);
      case WordUse::depth:
      case WordUse::length:
      case WordUse::thickness:
        return take_depth(use);
      case WordUse::times:
        return take_after_times();
      case WordUse::on_circle:
      case WordUse::pitch_circle:
        return take_circle(use == WordUse::pitch_circle);
      case WordUse::evenly:
        found_.elements.push_back({NotedRole::evenly});
        return true;
      case WordUse::standard:
        at_.skip_spaces();
        while (!at_.rest.empty() && (is_digit(at_.rest[0]) || (at_.rest[0] == '-' && !at_.rest.starts_with("- "))))
          at_.rest.remove_prefix(1);
        return true;
      case WordUse::diameter:
      case WordUse::drilled:
      case WordUse::radius:
      case WordUse::square:  // those before numbers are signs
        at_.skip_spaces();
        return bytes > 1 && !number_at(at_.rest);
      default:
        return take_kind(use);
    }
  }

  // Of what a note speaks.
  bool take_kind(WordUse use) {
    const bool is_through = !found_.elements.empty() && found_.elements.back().role == NotedRole::through;
    reading_.speak_of(use);
    if (use == WordUse::otherwise || (use == WordUse::all && !is_through)) found_.is_of_all = true;
    return use != WordUse::places;
  }

  // Its diameter, perhaps behind its angle: "Senkung 90° ⌀12". What may be either has an angle if it is a countersink.
  bool take_recess(WordUse use) {
    skip();
    std::optional<NumberText> angle = at_.take_degrees();
    skip();
    const NotedSign sign = at_.take_sign();
    const std::optional<NumberText> number = at_.take_number();
    if (!number) {
      if (angle) reading_.add_degrees(*angle);
      return angle.has_value();
    }
    const std::size_t own = found_.elements.size();
    reading_.add(role_of(use), sign, *number);
    reading_.take_deviations(found_.elements[own]);
    if (angle) reading_.add_degrees(*angle);
    skip();
    const std::string_view before = at_.rest;
    if (!angle) {
      at_.take_use(WordUse::times);
      at_.skip_spaces();
      angle = at_.take_degrees();
      if (angle)
        reading_.add_degrees(*angle);
      else
        at_.rest = before;
    }
    check(found_.elements.size() > own, "a recess has an element");
    if (use == WordUse::recess && angle) {
      found_.elements[own].role = NotedRole::countersink;
      found_.elements.back().of_role = NotedRole::countersink;
    }
    return true;
  }

  // Behind its sign; alone, it is the size: "t=3".
  bool take_depth(WordUse use) {
    at_.take(":");
    at_.skip_spaces();
    const std::optional<NumberText> number = at_.take_number();
    if (!number || at_.take("°")) return false;
    const bool is_alone = found_.elements.empty() && !has_value_;
    if (is_alone) reading_.speak_of(use);
    NotedElement& added = reading_.add(is_alone ? NotedRole::size : role_of(use), NotedSign::none, *number);
    if (const std::optional<double> unit = at_.take_unit()) reading_.scale(added, *unit);
    reading_.take_deviations(added);
    return true;
  }

  // "×90°", "X 5 DEEP", "×20" along the axis of a diameter, "2×2" of a chamfer, "45°×2".
  bool take_after_times() {
    at_.skip_spaces();
    if (found_.elements.empty()) return false;
    if (const std::optional<NumberText> angle = at_.take_degrees()) {
      reading_.add_degrees(*angle);
      return true;
    }
    const std::optional<NumberText> number = at_.take_number();
    if (!number) return false;
    check(number->bytes > 0, "a number is there");
    NotedElement& first = found_.elements.front();
    if (first.sign == NotedSign::degrees && found_.elements.size() == 1) {
      first.role = NotedRole::angle;
      found_.elements.insert(found_.elements.begin(), reading_.sized(NotedRole::size, NotedSign::none, *number));
      return true;
    }
    const std::optional<double> unit = at_.take_unit();
    at_.skip_spaces();
    const auto use = at_.take_use(WordUse::depth, WordUse::length, WordUse::thickness);
    if (use == WordUse::depth && reading_.diameter_before().least <= 0) return false;
    NotedElement& added =
        reading_.add(use == WordUse::depth ? NotedRole::depth : NotedRole::length, NotedSign::none, *number);
    if (unit) reading_.scale(added, *unit);
    reading_.take_deviations(added);
    return true;
  }

  // "ON ⌀96 BC", "auf LK 96", "PCD 96"; of a number alone it is one if that is before or behind it.
  bool take_circle(bool is_named) {
    at_.skip_spaces();
    if (at_.take_use(WordUse::pitch_circle)) is_named = true;
    at_.skip_spaces();
    const NotedSign sign = at_.take_sign();
    const std::optional<NumberText> number = at_.take_number();
    if (!number || (at_.take("°") || (sign != NotedSign::none && sign != NotedSign::diameter))) return false;
    const std::optional<double> unit = at_.take_unit();
    at_.skip_spaces();
    if (at_.take_use(WordUse::pitch_circle)) is_named = true;
    if (!is_named && sign == NotedSign::none) return false;
    NotedElement& added = reading_.add(NotedRole::circle, NotedSign::diameter, *number);
    if (unit) reading_.scale(added, *unit);
    return true;
  }

  bool take_thread() {
    const std::optional<ThreadText> thread = thread_at(at_.rest);
    if (!thread) return false;
    at_.rest.remove_prefix(thread->bytes);
    found_.elements.push_back({NotedRole::thread, NotedSign::diameter, thread->diameter, thread->diameter});
    found_.elements.back().pitch = thread->pitch;
    return true;
  }

  NoteReading reading_;
  NoteCursor& at_ = reading_.at;
  NotedText& found_ = reading_.found;
  SizeReader sizes_{reading_};
  bool has_value_ = false;  // "<>" stands for it
};

}  // namespace

const NotedElement* NotedText::size() const {
  const auto first = [this](NotedRole role) -> const NotedElement* {
    for (std::size_t i = 0; i < understood; ++i)
      if (elements[i].role == role) return &elements[i];
    return nullptr;
  };
  if (const NotedElement* sum = first(NotedRole::sum)) return sum;
  const NotedElement* size = first(NotedRole::size);
  const bool goes_on = size != nullptr && size == &elements[understood - 1] && !unread.empty();
  return goes_on && size->sign == NotedSign::none ? nullptr : size;
}

NotedText read_text(std::string_view text, const Notation& notation) {
  return TextReader(normal(std::string(text)), scene::millimetres(notation.unit)).read();
}

}  // namespace epura::sheet
