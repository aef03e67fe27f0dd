// SPDX-License-Identifier: Apache-2.0
#include "sizes/note_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "scene/choices.hpp"
#include "sizes/equal_features.hpp"

namespace epura::sheet {

namespace {

struct Number {
  double value = 0;
  double slack = 0.5;  // half a unit of its last digit
  bool has_decimals = false;
};

struct UnitWord {
  std::string_view word;
  double millimetres;
};
constexpr std::array<UnitWord, 8> units{
    {{"INCH", 25.4}, {"IN", 25.4}, {"\"", 25.4}, {"″", 25.4}, {"MM", 1}, {"CM", 10}, {"DM", 100}, {"M", 1000}}};

struct RoleWord {
  std::string_view word;
  NotedRole role;
};
constexpr std::array<RoleWord, 17> role_words{{{"⌴", NotedRole::counterbore},
                                               {"COUNTERBORE", NotedRole::counterbore},
                                               {"CBORE", NotedRole::counterbore},
                                               {"C'BORE", NotedRole::counterbore},
                                               {"C-BORE", NotedRole::counterbore},
                                               {"C BORE", NotedRole::counterbore},
                                               {"SPOTFACE", NotedRole::counterbore},
                                               {"⌵", NotedRole::countersink},
                                               {"COUNTERSINK", NotedRole::countersink},
                                               {"CSINK", NotedRole::countersink},
                                               {"CSK", NotedRole::countersink},
                                               {"↧", NotedRole::depth},
                                               {"DEPTH", NotedRole::depth},
                                               {"DEEP", NotedRole::depth},
                                               {"THROUGH", NotedRole::through},
                                               {"THRU", NotedRole::through},
                                               {"BLIND", NotedRole::blind}}};

// They say nothing that the part could contradict.
constexpr std::array<std::string_view, 16> silent{"MAX", "MIN",  "TYP",  "NOM", "REF", "ALL", "LH", "DRILL",
                                                  "TAP", "REAM", "BORE", "Ⓔ",   "Ⓜ",   "Ⓛ",   "Ⓢ",  "Ⓟ"};

constexpr std::array<std::string_view, 5> counted{"HOLES", "HOLE", "PLACES", "PLCS", "PL"};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

std::string replaced(std::string text, std::string_view old, std::string_view with) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + with.size()))
    text.replace(at, old.size(), with);
  return text;
}

// With one sign for each thing, points before decimals, and without brackets around all of it.
std::string normal(std::string text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> same{
      {{"Ø", "⌀"}, {"ø", "⌀"}, {"−", "-"}, {"–", "-"}}};
  for (const auto& [old, with] : same) text = replaced(std::move(text), old, with);
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i] == ',' && is_digit(text[i + 1])) text[i] = '.';
  const bool is_whole = text.starts_with('(') && text.find(')') + 1 == text.size();
  return is_whole ? text.substr(1, text.size() - 2) : text;
}

class TextReader {
 public:
  TextReader(std::string_view text, double unit) : rest_(text), unit_(unit) {}

  NotedText read() {
    take_count();
    for (skip(); !rest_.empty(); skip())
      if (!take_words() && !take_bracket() && !take_size()) leave_unread();
    if (found_.unread.empty()) found_.understood = found_.elements.size();
    return std::move(found_);
  }

 private:
  // Between what is said.
  void skip() {
    while (take(" ") || take(",") || take(";") || (rest_.starts_with("- ") && take("-"))) continue;
  }

  bool take(std::string_view sign) {
    if (!rest_.starts_with(sign)) return false;
    rest_.remove_prefix(sign.size());
    return true;
  }

  // In capitals or not, and not as the beginning of a longer word.
  bool take_word(std::string_view word) {
    if (rest_.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
      if (std::toupper(static_cast<unsigned char>(rest_[i])) != static_cast<unsigned char>(word[i]) &&
          rest_[i] != word[i])
        return false;
    if (is_letter(word.back()) && rest_.size() > word.size() && is_letter(rest_[word.size()])) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  void take_count() {
    const Count count = count_of(rest_);
    rest_.remove_prefix(count.end);
    found_.count = count.number;
    if (count.end > 0) return;
    const std::string_view before = rest_;
    const std::optional<Number> number = take_number();
    if (number && !number->has_decimals) {
      skip();
      for (const std::string_view word : counted)
        if (take_word(word)) {
          found_.count = std::max(1, static_cast<int>(number->value));
          return;
        }
    }
    rest_ = before;
  }

  std::optional<Number> take_number() {
    Number number;
    const bool is_number =
        !rest_.empty() && (is_digit(rest_[0]) || (rest_[0] == '.' && rest_.size() > 1 && is_digit(rest_[1])));
    if (!is_number) return std::nullopt;
    const auto [end, error] =
        std::from_chars(rest_.data(), rest_.data() + rest_.size(), number.value, std::chars_format::fixed);
    if (error != std::errc()) return std::nullopt;
    const std::string_view digits = rest_.substr(0, static_cast<std::size_t>(end - rest_.data()));
    if (const std::size_t point = digits.find('.'); point != std::string_view::npos) {
      number.slack = std::pow(10.0, -static_cast<double>(digits.size() - point - 1)) / 2;
      number.has_decimals = true;
    }
    rest_.remove_prefix(digits.size());
    return number;
  }

  std::optional<double> take_unit() {
    const std::string_view before = rest_;
    skip();
    for (const UnitWord& unit : units)
      if (take_word(unit.word)) return unit.millimetres;
    rest_ = before;
    return std::nullopt;
  }

  // "THRU ALL", "CSK ⌀12 X 90°", "X 5 DEEP", "H7/g6", "M6×1", "<ST>"
  bool take_words() {
    check(!rest_.empty(), "there is something to read");
    const std::string_view before = rest_;
    for (const RoleWord& one : role_words) {
      if (!take_word(one.word)) continue;
      const bool is_whole = one.role == NotedRole::through || one.role == NotedRole::blind;
      if (is_whole) found_.elements.push_back({one.role});
      skip();
      if (is_whole || take_role(one.role)) return true;
      rest_ = before;
    }
    if ((take("×") || take_word("X")) && take_after_times()) return true;
    rest_ = before;
    if (std::ranges::any_of(silent, [this](std::string_view word) { return take_word(word); })) return true;
    if (const std::size_t end = rest_.find('>'); rest_.starts_with("<") && end != std::string_view::npos) {
      rest_.remove_prefix(end + 1);
      return true;
    }
    return take_thread() || take_fit();
  }

  // Behind "⌴", "⌵" or "↧".
  bool take_role(NotedRole role) {
    const NotedSign sign = take_sign();
    const std::optional<Number> number = take_number();
    if (!number) return false;
    if (role == NotedRole::depth && (take("°") || sign != NotedSign::none)) return false;
    add(role, sign, *number);
    return true;
  }

  // "×90°", "X 5 DEEP", "x 8" of a hole.
  bool take_after_times() {
    skip();
    const std::optional<Number> number = take_number();
    if (!number) return false;
    if (take("°")) {
      add_degrees(*number);
      return true;
    }
    skip();
    const bool is_depth = take_word("DEEP") || take_word("DEPTH");
    if (!is_depth && (found_.elements.empty() || diameter_before().least <= 0)) return false;
    add(NotedRole::depth, NotedSign::none, *number);
    return true;
  }

  // "M6", "G1/4", "M6×0.75-6H"
  bool take_thread() {
    if (rest_.size() < 2 || (rest_[0] != 'M' && rest_[0] != 'G') || !is_digit(rest_[1])) return false;
    const bool is_metric = rest_[0] == 'M';
    rest_.remove_prefix(1);
    const std::optional<Number> number = take_number();
    check(number.has_value(), "a digit begins a number");
    while (!rest_.empty() && !rest_.starts_with(" ")) rest_.remove_prefix(1);
    found_.elements.push_back({NotedRole::thread, NotedSign::diameter, number->value, number->value});
    if (!is_metric) found_.elements.back().least = found_.elements.back().most = 0;  // its diameter is in a table
    return true;
  }

  // Behind a size: "H7", "H7/g6".
  bool take_fit() {
    if (found_.elements.empty()) return false;
    std::size_t end = 0, letters = 0, digits = 0;
    for (; end < rest_.size() && rest_[end] != ' '; ++end) {
      if (is_letter(rest_[end]))
        ++letters;
      else if (is_digit(rest_[end]))
        ++digits;
      else if (rest_[end] != '/')
        return false;
    }
    if (letters == 0 || letters > 4 || digits == 0 || !is_letter(rest_[0]) || !is_digit(rest_[end - 1])) return false;
    rest_.remove_prefix(end);
    return true;
  }

  NotedSign take_sign() {
    constexpr std::array<std::pair<std::string_view, NotedSign>, 5> signs{{{"S⌀", NotedSign::sphere},
                                                                           {"SR", NotedSign::sphere_radius},
                                                                           {"⌀", NotedSign::diameter},
                                                                           {"R", NotedSign::radius},
                                                                           {"□", NotedSign::square}}};
    for (const auto& [sign, meaning] : signs) {
      const std::string_view before = rest_;
      if (take(sign)) {
        skip();
        if (!rest_.empty() && (is_digit(rest_[0]) || rest_[0] == '.')) return meaning;
      }
      rest_ = before;
    }
    return NotedSign::none;
  }

  // "(=60)", "(2.36 in)", "[2.36]"
  bool take_bracket() {
    const std::string_view before = rest_;
    const bool is_square = rest_.starts_with("[");
    if (!take("(") && !take("[")) return false;
    const bool is_sum = take("=");
    const NotedSign sign = take_sign();
    const std::optional<Number> number = take_number();
    const std::optional<double> unit = number ? take_unit() : std::nullopt;
    if (!number || !take(is_square ? "]" : ")")) {
      rest_ = before;
      return false;
    }
    NotedElement& added = add(is_sum ? NotedRole::sum : NotedRole::other_unit, sign, *number);
    if (unit) scale(added, *unit);
    if (!unit && !is_sum) added.unit = 0;
    return true;
  }

  // With tolerances or limits, and perhaps its unit; "=" before it is a sum.
  bool take_size() {
    check(!rest_.empty(), "there is something to read");
    const std::string_view before = rest_;
    const bool is_sum = take("=");
    skip();
    const NotedSign sign = take_sign();
    const std::optional<Number> number = take_number();
    if (!number) {
      rest_ = before;
      return false;
    }
    if (take("°")) {
      add_degrees(*number);
      take_deviations();
      return true;
    }
    const bool is_first = is_sum || std::ranges::none_of(found_.elements, [](const NotedElement& one) {
                            return one.role == NotedRole::size || one.role == NotedRole::thread;
                          });
    if (!is_first || !found_.unread.empty()) {
      rest_ = before;
      return false;
    }
    NotedElement& added = add(is_sum ? NotedRole::sum : NotedRole::size, sign, *number);
    if (!take_limit(added, *number)) take_deviations();
    if (const std::optional<double> unit = take_unit()) scale(added, *unit);
    return true;
  }

  // "60.2-60.1"; whole numbers may be something else, and what is far less is a deviation.
  bool take_limit(NotedElement& size, const Number& one) {
    const std::string_view before = rest_;
    skip_spaces();
    if (take("-") || take("/")) {
      skip_spaces();
      const std::optional<Number> other = take_number();
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
    rest_ = before;
    return false;
  }

  void skip_spaces() {
    while (take(" ")) continue;
  }

  // "±0.1", "+0.2 -0.1", "+2/+1.5", "0/-0.1"
  void take_deviations() {
    for (;;) {
      const std::string_view before = rest_;
      skip_spaces();
      take("/");
      const bool is_signed = take("±") || take("+") || take("-");
      const bool is_zero = !is_signed && rest_.starts_with("0") && (rest_.size() == 1 || !is_digit(rest_[1]));
      if ((!is_signed && !is_zero) || !take_number()) {
        rest_ = before;
        return;
      }
      if (!take("°") && !take("'")) take("′");
    }
  }

  // Behind degrees: "30'", and perhaps "15''".
  void add_degrees(Number angle) {
    double part = 60;
    for (const std::string_view sign : {"'", "\""}) {
      const std::string_view before = rest_;
      const std::optional<Number> number = take_number();
      if (!number || !(take(sign) || take(sign == "'" ? "′" : "″"))) {
        rest_ = before;
        break;
      }
      angle = {angle.value + number->value / part, number->slack / part};
      part *= 60;
    }
    const bool is_size = found_.elements.empty();
    const NotedElement of = diameter_before();
    found_.elements.push_back({is_size ? NotedRole::size : NotedRole::angle, NotedSign::degrees, angle.value,
                               angle.value, angle.slack, 0, of.least, of.role});
  }

  NotedElement& add(NotedRole role, NotedSign sign, const Number& number) {
    const NotedElement of = role == NotedRole::depth ? diameter_before() : NotedElement{NotedRole::size};
    const double value = number.value * unit_;
    return found_.elements.emplace_back(
        NotedElement{role, sign, value, value, number.slack * unit_, unit_, of.least, of.role});
  }

  void scale(NotedElement& element, double unit) const {
    for (double* value : {&element.least, &element.most, &element.slack}) *value *= unit / unit_;
    element.unit = unit;
  }

  // The last one of a hole or of a recess, as a diameter.
  [[nodiscard]] NotedElement diameter_before() const {
    for (auto one = found_.elements.rbegin(); one != found_.elements.rend(); ++one) {
      const bool is_recess = one->role == NotedRole::counterbore || one->role == NotedRole::countersink;
      const bool is_hole = (one->role == NotedRole::size || one->role == NotedRole::thread) &&
                           (one->sign == NotedSign::diameter || one->sign == NotedSign::radius);
      if (!is_recess && !is_hole) continue;
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
    unread_from(rest_);
    if (const std::optional<Number> number = take_number()) {
      add(NotedRole::unread, NotedSign::none, *number);
      return;
    }
    std::size_t length = 1;
    while (length < rest_.size() && (static_cast<unsigned char>(rest_[length]) & 0xC0U) == 0x80U) ++length;
    while (is_letter(rest_[0]) && length < rest_.size() && is_letter(rest_[length])) ++length;
    rest_.remove_prefix(length);
  }

  std::string_view rest_;
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
