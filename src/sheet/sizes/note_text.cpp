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
#include "sizes/note_cursor.hpp"

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

// Of what a text speaks that has a word.
NotedKind kind_of(WordUse use) {
  switch (use) {
    case WordUse::holes:
    case WordUse::blind:
      return NotedKind::holes;
    case WordUse::threads:
      return NotedKind::threads;
    case WordUse::fillets:
      return NotedKind::fillets;
    case WordUse::chamfers:
      return NotedKind::chamfers;
    case WordUse::others:
      return NotedKind::others;
    case WordUse::length:
      return NotedKind::lengths;
    case WordUse::thickness:
      return NotedKind::thickness;
    default:
      return NotedKind::none;
  }
}

NotedRole role_of(WordUse use) {
  switch (use) {
    case WordUse::counterbore:
    case WordUse::recess:
      return NotedRole::counterbore;
    case WordUse::countersink:
      return NotedRole::countersink;
    case WordUse::depth:
      return NotedRole::depth;
    case WordUse::length:
    case WordUse::thickness:
      return NotedRole::length;
    case WordUse::through:
      return NotedRole::through;
    case WordUse::blind:
      return NotedRole::blind;
    default:
      return NotedRole::unread;
  }
}

class TextReader {
 public:
  TextReader(std::string_view text, double unit) : at_{text}, unit_(unit) {}

  NotedText read() {
    take_count();
    for (skip(); !at_.rest.empty(); skip())
      if (!take_one()) leave_unread();
    if (found_.unread.empty()) found_.understood = found_.elements.size();
    return std::move(found_);
  }

 private:
  bool take_one() {
    check(!at_.rest.empty(), "there is something to read");
    return take_thread() || take_later_count() || take_words() || take_fit() || take_bracket() || take_size();
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
      speak_of(*use);
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
        speak_of(use);
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
    speak_of(use);
    if (use == WordUse::otherwise || (use == WordUse::all && !is_through)) found_.is_of_all = true;
    return use != WordUse::places;
  }

  // What has a word of its own is not what its holes, or its sizes, are called by.
  void speak_of(WordUse use) {
    const NotedKind kind = kind_of(use);
    const bool is_size = kind == NotedKind::lengths || kind == NotedKind::thickness;
    if (found_.kind == NotedKind::none || (kind != NotedKind::none && kind != NotedKind::holes && !is_size))
      found_.kind = kind;
  }

  // Its diameter, perhaps behind its angle: "Senkung 90° ⌀12". What may be either has an angle if it is a countersink.
  bool take_recess(WordUse use) {
    skip();
    std::optional<NumberText> angle = at_.take_degrees();
    skip();
    const NotedSign sign = at_.take_sign();
    const std::optional<NumberText> number = at_.take_number();
    if (!number) {
      if (angle) add_degrees(*angle);
      return angle.has_value();
    }
    const std::size_t own = found_.elements.size();
    add(role_of(use), sign, *number);
    take_deviations(found_.elements[own]);
    if (angle) add_degrees(*angle);
    skip();
    const std::string_view before = at_.rest;
    if (!angle) {
      at_.take_use(WordUse::times);
      at_.skip_spaces();
      angle = at_.take_degrees();
      if (angle)
        add_degrees(*angle);
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
    if (is_alone) speak_of(use);
    NotedElement& added = add(is_alone ? NotedRole::size : role_of(use), NotedSign::none, *number);
    if (const std::optional<double> unit = at_.take_unit()) scale(added, *unit);
    take_deviations(added);
    return true;
  }

  // "×90°", "X 5 DEEP", "×20" along the axis of a diameter, "2×2" of a chamfer, "45°×2".
  bool take_after_times() {
    at_.skip_spaces();
    if (found_.elements.empty()) return false;
    if (const std::optional<NumberText> angle = at_.take_degrees()) {
      add_degrees(*angle);
      return true;
    }
    const std::optional<NumberText> number = at_.take_number();
    if (!number) return false;
    check(number->bytes > 0, "a number is there");
    NotedElement& first = found_.elements.front();
    if (first.sign == NotedSign::degrees && found_.elements.size() == 1) {
      first.role = NotedRole::angle;
      found_.elements.insert(found_.elements.begin(), sized(NotedRole::size, NotedSign::none, *number));
      return true;
    }
    const std::optional<double> unit = at_.take_unit();
    at_.skip_spaces();
    const auto use = at_.take_use(WordUse::depth, WordUse::length, WordUse::thickness);
    if (use == WordUse::depth && diameter_before().least <= 0) return false;
    NotedElement& added = add(use == WordUse::depth ? NotedRole::depth : NotedRole::length, NotedSign::none, *number);
    if (unit) scale(added, *unit);
    take_deviations(added);
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
    NotedElement& added = add(NotedRole::circle, NotedSign::diameter, *number);
    if (unit) scale(added, *unit);
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

  // Behind a size, with what it allows: "H7", "H7/g6", "H7 (8.015/8)", "H7 +0.015 0".
  bool take_fit() {
    const std::size_t bytes = found_.elements.empty() ? 0 : fit_at(at_.rest);
    if (bytes == 0) return false;
    if (found_.fit.empty()) found_.fit = at_.rest.substr(0, std::min(bytes, at_.rest.find('/')));
    at_.rest.remove_prefix(bytes);
    if (found_.elements.back().role == NotedRole::size) {
      NotedElement zone = found_.elements.back();
      zone.role = NotedRole::limits;
      at_.skip_spaces();
      if (take_deviations(zone) && zone.most > zone.least) found_.elements.push_back(zone);
    }
    return true;
  }

  // "(=60)", "(2.36 in)", "[2.36]", "(45°)", "(8.015/8)"
  bool take_bracket() {
    const std::string_view before = at_.rest;
    check(!before.empty(), "there is something to read");
    const bool is_square = at_.rest.starts_with("[");
    if (!at_.take("(") && !at_.take("[")) return false;
    const std::string_view end = is_square ? "]" : ")";
    if (!found_.elements.empty() && found_.elements.back().role == NotedRole::size) {
      NotedElement zone = found_.elements.back();
      zone.role = NotedRole::limits;
      if (take_deviations(zone) && at_.take(end)) {
        if (zone.most > zone.least) found_.elements.push_back(zone);
        return true;
      }
      at_.rest = before.substr(1);
    }
    const bool is_sum = at_.take("=");
    const NotedSign sign = at_.take_sign();
    const std::optional<NumberText> number = at_.take_number();
    if (number && !is_sum && at_.take("°") && at_.take(end)) {
      found_.elements.push_back({NotedRole::evenly, NotedSign::degrees, number->value, number->value, number->slack});
      return true;
    }
    if (number && take_limits(sized(NotedRole::limits, sign, *number), end)) return true;
    const std::optional<double> unit = number ? at_.take_unit() : std::nullopt;
    if (!number || !at_.take(end)) {
      at_.rest = before;
      return false;
    }
    NotedElement& added = add(is_sum ? NotedRole::sum : NotedRole::other_unit, sign, *number);
    if (unit) scale(added, *unit);
    if (!unit && !is_sum) added.unit = 0;
    return true;
  }

  // "8.015/8)", behind the first of them.
  bool take_limits(NotedElement limits, std::string_view end) {
    const std::string_view before = at_.rest;
    const bool is_joined = at_.take("/") || at_.take("-");
    at_.skip_spaces();
    const std::optional<NumberText> other = is_joined ? at_.take_number() : std::nullopt;
    if (!other || !at_.take(end)) {
      at_.rest = before;
      return false;
    }
    limits.most = std::max(limits.least, other->value * unit_);
    limits.least = std::min(limits.least, other->value * unit_);
    limits.slack = std::min(limits.slack, other->slack * unit_);
    found_.elements.push_back(limits);
    return true;
  }

  // With tolerances or limits, and perhaps its unit; "=" before it is a sum. "C2" is "2×45°", as in JIS B 0001.
  bool take_size() {
    const std::string_view before = at_.rest;
    check(!before.empty(), "there is something to read");
    const bool is_sum = at_.take("=");
    at_.skip_spaces();
    const bool is_chamfer =
        found_.elements.empty() && at_.rest.size() > 1 && at_.rest[0] == 'C' && is_digit(at_.rest[1]);
    if (is_chamfer) at_.take("C");
    const NotedSign sign = at_.take_sign();
    if (const std::optional<NumberText> angle = at_.take_degrees()) {
      add_degrees(*angle);
      take_deviations(found_.elements.back());
      return true;
    }
    const std::optional<NumberText> number = at_.take_number();
    if (!number) {
      at_.rest = before;
      return false;
    }
    if (is_depth_behind(*number, sign)) return true;
    const auto is_one_of = [this](NotedRole role) {
      return std::ranges::any_of(found_.elements, [role](const NotedElement& one) { return one.role == role; });
    };
    const bool is_drill = sign == NotedSign::diameter && is_one_of(NotedRole::thread) && !is_one_of(NotedRole::drill) &&
                          !is_one_of(NotedRole::size);
    const bool is_first = is_sum || is_drill || (!is_one_of(NotedRole::size) && !is_one_of(NotedRole::thread));
    if (!is_first || !found_.unread.empty()) {
      at_.rest = before;
      return false;
    }
    const NotedRole role = is_sum ? NotedRole::sum : is_drill ? NotedRole::drill : NotedRole::size;
    finish_size(add(role, sign, *number), *number);
    if (is_chamfer) found_.elements.push_back({NotedRole::angle, NotedSign::degrees, 45, 45});
    return true;
  }

  // Its tolerances, unit and what may stand behind it instead of before it: "8 DIA", "40 DEEP".
  void finish_size(NotedElement& added, const NumberText& number) {
    if (!take_limit(added, number)) take_deviations(added);
    if (const std::optional<double> unit = at_.take_unit()) scale(added, *unit);
    if (added.sign != NotedSign::none) return;
    const std::string_view before = at_.rest;
    at_.skip_spaces();
    const auto use =
        at_.take_use(WordUse::diameter, WordUse::square, WordUse::depth, WordUse::length, WordUse::thickness);
    at_.skip_spaces();
    if (!use || number_at(at_.rest) || at_.take_sign() != NotedSign::none) {
      at_.rest = before;
      return;
    }
    if (*use == WordUse::diameter) added.sign = NotedSign::diameter;
    if (*use == WordUse::square) added.sign = NotedSign::square;
    if (*use == WordUse::depth && found_.kind == NotedKind::holes) added.role = NotedRole::depth;
    speak_of(*use);
  }

  // "⌀10, 12 tief"
  bool is_depth_behind(const NumberText& number, NotedSign sign) {
    if (sign != NotedSign::none || diameter_before().least <= 0) return false;
    const std::string_view before = at_.rest;
    const std::optional<double> unit = at_.take_unit();
    at_.skip_spaces();
    const auto use = at_.take_use(WordUse::depth, WordUse::length, WordUse::thickness);
    if (!use) {
      at_.rest = before;
      return false;
    }
    NotedElement& added = add(role_of(*use), NotedSign::none, number);
    if (unit) scale(added, *unit);
    return true;
  }

  // "60.2-60.1"; whole numbers may be something else, and what is far less is a deviation.
  bool take_limit(NotedElement& size, const NumberText& one) {
    const std::string_view before = at_.rest;
    at_.skip_spaces();
    if (at_.take("-") || at_.take("/")) {
      at_.skip_spaces();
      const std::optional<NumberText> other = at_.take_number();
      if (other && one.has_decimals && other->has_decimals && other->value >= one.value / 2) {
        size.least = std::min(one.value, other->value) * unit_;
        size.most = std::max(one.value, other->value) * unit_;
        size.slack = std::max(one.slack, other->slack) * unit_;
        return true;
      }
      if (other && other->value >= one.value / 2) {
        size.role = NotedRole::unread;
        unread_from(before, 1);
        return true;
      }
    }
    at_.rest = before;
    return false;
  }

  // Whether there are some. They have a middle, and make limits a zone.
  bool take_deviations(NotedElement& size) {
    const DeviationsText found = deviations_at(at_.rest);
    at_.rest.remove_prefix(found.bytes);
    if (found.values.size() == 2 && size.unit > 0) {
      const auto [low, high] = std::minmax(found.values[0], found.values[1]);
      size.middle = size.least + (low + high) / 2 * size.unit;
      if (size.role == NotedRole::limits) size.most = size.least + high * size.unit, size.least += low * size.unit;
    }
    return !found.values.empty();
  }

  void add_degrees(const NumberText& angle) {
    const bool is_size = found_.elements.empty();
    const NotedElement of = diameter_before();
    found_.elements.push_back({is_size ? NotedRole::size : NotedRole::angle, NotedSign::degrees, angle.value,
                               angle.value, angle.slack, 0, 0, of.least, of.role});
  }

  [[nodiscard]] NotedElement sized(NotedRole role, NotedSign sign, const NumberText& number) const {
    const double value = number.value * unit_;
    return {role, sign, value, value, number.slack * unit_, unit_};
  }

  NotedElement& add(NotedRole role, NotedSign sign, const NumberText& number) {
    NotedElement added = sized(role, sign, number);
    if (role == NotedRole::depth || role == NotedRole::length) {
      const NotedElement of = diameter_before();
      added.of = of.least;
      added.of_role = of.role;
    }
    return found_.elements.emplace_back(added);
  }

  void scale(NotedElement& element, double unit) const {
    for (double* value : {&element.least, &element.most, &element.slack, &element.middle}) *value *= unit / unit_;
    element.unit = unit;
  }

  // The last one of a hole or of a recess, as a diameter.
  [[nodiscard]] NotedElement diameter_before() const {
    for (auto one = found_.elements.rbegin(); one != found_.elements.rend(); ++one) {
      const bool is_hole =
          (one->role == NotedRole::size || one->role == NotedRole::thread || one->role == NotedRole::drill) &&
          (one->sign == NotedSign::diameter || one->sign == NotedSign::radius);
      if (!one->is_recess() && !is_hole) continue;
      NotedElement diameter = *one;
      if (one->sign == NotedSign::radius) diameter.least *= 2;
      return diameter;
    }
    return {NotedRole::size};
  }

  // `taken`: how many elements of it are there already.
  void unread_from(std::string_view before, std::size_t taken = 0) {
    if (!found_.unread.empty()) return;
    found_.unread = std::string(before.substr(std::min(before.size(), before.find_first_not_of(' '))));
    found_.understood = found_.elements.size() - taken;
  }

  // A word or a number.
  void leave_unread() {
    unread_from(at_.rest);
    if (const std::optional<NumberText> number = at_.take_number()) {
      add(NotedRole::unread, NotedSign::none, *number);
      return;
    }
    std::size_t length = 1;
    while (length < at_.rest.size() && (static_cast<unsigned char>(at_.rest[length]) & 0xC0U) == 0x80U) ++length;
    while (folded_letter(at_.rest).bytes == 1 && length < at_.rest.size() &&
           folded_letter(at_.rest.substr(length)).bytes == 1)
      ++length;
    at_.rest.remove_prefix(length);
  }

  NoteCursor at_;
  bool has_value_ = false;  // "<>" stands for it
  double unit_;
  NotedText found_;
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
