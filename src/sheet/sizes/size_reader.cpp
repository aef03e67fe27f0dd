// SPDX-License-Identifier: Apache-2.0
#include "sizes/size_reader.hpp"

#include <algorithm>
#include <optional>

#include "base/error.hpp"

namespace epura::sheet {

bool SizeReader::take() { return take_fit() || take_bracket() || take_size(); }

// Behind a size, with what it allows: "H7", "H7/g6", "H7 (8.015/8)", "H7 +0.015 0".
bool SizeReader::take_fit() {
  const std::size_t bytes = found_.elements.empty() ? 0 : fit_at(at_.rest);
  if (bytes == 0) return false;
  if (found_.fit.empty()) found_.fit = at_.rest.substr(0, std::min(bytes, at_.rest.find('/')));
  at_.rest.remove_prefix(bytes);
  if (found_.elements.back().role == NotedRole::size) {
    NotedElement zone = found_.elements.back();
    zone.role = NotedRole::limits;
    at_.skip_spaces();
    if (reading_.take_deviations(zone) && zone.most > zone.least) found_.elements.push_back(zone);
  }
  return true;
}

// "(=60)", "(2.36 in)", "[2.36]", "(45°)", "(8.015/8)"
bool SizeReader::take_bracket() {
  const std::string_view before = at_.rest;
  check(!before.empty(), "there is something to read");
  const bool is_square = at_.rest.starts_with("[");
  if (!at_.take("(") && !at_.take("[")) return false;
  const std::string_view end = is_square ? "]" : ")";
  if (!found_.elements.empty() && found_.elements.back().role == NotedRole::size) {
    NotedElement zone = found_.elements.back();
    zone.role = NotedRole::limits;
    if (reading_.take_deviations(zone) && at_.take(end)) {
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
  if (number && take_limits(reading_.sized(NotedRole::limits, sign, *number), end)) return true;
  const std::optional<double> unit = number ? at_.take_unit() : std::nullopt;
  if (!number || !at_.take(end)) {
    at_.rest = before;
    return false;
  }
  NotedElement& added = reading_.add(is_sum ? NotedRole::sum : NotedRole::other_unit, sign, *number);
  if (unit) reading_.scale(added, *unit);
  if (!unit && !is_sum) added.unit = 0;
  return true;
}

// "8.015/8)", behind the first of them.
bool SizeReader::take_limits(NotedElement limits, std::string_view end) {
  const std::string_view before = at_.rest;
  const bool is_joined = at_.take("/") || at_.take("-");
  at_.skip_spaces();
  const std::optional<NumberText> other = is_joined ? at_.take_number() : std::nullopt;
  if (!other || !at_.take(end)) {
    at_.rest = before;
    return false;
  }
  limits.most = std::max(limits.least, other->value * reading_.unit);
  limits.least = std::min(limits.least, other->value * reading_.unit);
  limits.slack = std::min(limits.slack, other->slack * reading_.unit);
  found_.elements.push_back(limits);
  return true;
}

// With tolerances or limits, and perhaps its unit; "=" before it is a sum. "C2" is "2×45°", as in JIS B 0001.
bool SizeReader::take_size() {
  const std::string_view before = at_.rest;
  check(!before.empty(), "there is something to read");
  const bool is_sum = at_.take("=");
  at_.skip_spaces();
  const bool is_chamfer = found_.elements.empty() && at_.rest.size() > 1 && at_.rest[0] == 'C' && is_digit(at_.rest[1]);
  if (is_chamfer) at_.take("C");
  const NotedSign sign = at_.take_sign();
  if (const std::optional<NumberText> angle = at_.take_degrees()) {
    reading_.add_degrees(*angle);
    reading_.take_deviations(found_.elements.back());
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
  finish_size(reading_.add(role, sign, *number), *number);
  if (is_chamfer) found_.elements.push_back({NotedRole::angle, NotedSign::degrees, 45, 45});
  return true;
}

// Its tolerances, unit and what may stand behind it instead of before it: "8 DIA", "40 DEEP".
void SizeReader::finish_size(NotedElement& added, const NumberText& number) {
  if (!take_limit(added, number)) reading_.take_deviations(added);
  if (const std::optional<double> unit = at_.take_unit()) reading_.scale(added, *unit);
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
  reading_.speak_of(*use);
}

// "⌀10, 12 tief"
bool SizeReader::is_depth_behind(const NumberText& number, NotedSign sign) {
  if (sign != NotedSign::none || reading_.diameter_before().least <= 0) return false;
  const std::string_view before = at_.rest;
  const std::optional<double> unit = at_.take_unit();
  at_.skip_spaces();
  const auto use = at_.take_use(WordUse::depth, WordUse::length, WordUse::thickness);
  if (!use) {
    at_.rest = before;
    return false;
  }
  NotedElement& added = reading_.add(role_of(*use), NotedSign::none, number);
  if (unit) reading_.scale(added, *unit);
  return true;
}

// "60.2-60.1"; whole numbers may be something else, and what is far less is a deviation.
bool SizeReader::take_limit(NotedElement& size, const NumberText& one) {
  const std::string_view before = at_.rest;
  at_.skip_spaces();
  if (at_.take("-") || at_.take("/")) {
    at_.skip_spaces();
    const std::optional<NumberText> other = at_.take_number();
    if (other && one.has_decimals && other->has_decimals && other->value >= one.value / 2) {
      size.least = std::min(one.value, other->value) * reading_.unit;
      size.most = std::max(one.value, other->value) * reading_.unit;
      size.slack = std::max(one.slack, other->slack) * reading_.unit;
      return true;
    }
    if (other && other->value >= one.value / 2) {
      size.role = NotedRole::unread;
      reading_.unread_from(before, 1);
      return true;
    }
  }
  at_.rest = before;
  return false;
}

}  // namespace epura::sheet
