// SPDX-License-Identifier: Apache-2.0
#include "sizes/note_reading.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace epura::sheet {

namespace {

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

}  // namespace

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

// What has a word of its own is not what its holes, or its sizes, are called by.
void NoteReading::speak_of(WordUse use) {
  const NotedKind kind = kind_of(use);
  const bool is_size = kind == NotedKind::lengths || kind == NotedKind::thickness;
  if (found.kind == NotedKind::none || (kind != NotedKind::none && kind != NotedKind::holes && !is_size))
    found.kind = kind;
}

// Whether there are some. They have a middle, and make limits a zone.
bool NoteReading::take_deviations(NotedElement& size) {
  const DeviationsText found = deviations_at(at.rest);
  at.rest.remove_prefix(found.bytes);
  if (found.values.size() == 2 && size.unit > 0) {
    const auto [low, high] = std::minmax(found.values[0], found.values[1]);
    size.middle = size.least + (low + high) / 2 * size.unit;
    if (size.role == NotedRole::limits) size.most = size.least + high * size.unit, size.least += low * size.unit;
  }
  return !found.values.empty();
}

void NoteReading::add_degrees(const NumberText& angle) {
  const bool is_size = found.elements.empty();
  const NotedElement of = diameter_before();
  found.elements.push_back({is_size ? NotedRole::size : NotedRole::angle, NotedSign::degrees, angle.value, angle.value,
                            angle.slack, 0, 0, of.least, of.role});
}

NotedElement NoteReading::sized(NotedRole role, NotedSign sign, const NumberText& number) const {
  const double value = number.value * unit;
  return {role, sign, value, value, number.slack * unit, unit};
}

NotedElement& NoteReading::add(NotedRole role, NotedSign sign, const NumberText& number) {
  NotedElement added = sized(role, sign, number);
  if (role == NotedRole::depth || role == NotedRole::length) {
    const NotedElement of = diameter_before();
    added.of = of.least;
    added.of_role = of.role;
  }
  return found.elements.emplace_back(added);
}

void NoteReading::scale(NotedElement& element, double other) const {
  for (double* value : {&element.least, &element.most, &element.slack, &element.middle}) *value *= other / unit;
  element.unit = other;
}

// The last one of a hole or of a recess, as a diameter.
NotedElement NoteReading::diameter_before() const {
  for (auto one = found.elements.rbegin(); one != found.elements.rend(); ++one) {
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
void NoteReading::unread_from(std::string_view before, std::size_t taken) {
  if (!found.unread.empty()) return;
  found.unread = std::string(before.substr(std::min(before.size(), before.find_first_not_of(' '))));
  found.understood = found.elements.size() - taken;
}

// A word or a number.
void NoteReading::leave_unread() {
  unread_from(at.rest);
  if (const std::optional<NumberText> number = at.take_number()) {
    add(NotedRole::unread, NotedSign::none, *number);
    return;
  }
  std::size_t length = 1;
  while (length < at.rest.size() && (static_cast<unsigned char>(at.rest[length]) & 0xC0U) == 0x80U) ++length;
  while (folded_letter(at.rest).bytes == 1 && length < at.rest.size() &&
         folded_letter(at.rest.substr(length)).bytes == 1)
    ++length;
  at.rest.remove_prefix(length);
}

}  // namespace epura::sheet
