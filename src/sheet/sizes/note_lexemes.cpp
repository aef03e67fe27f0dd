// SPDX-License-Identifier: Apache-2.0
#include "sizes/note_lexemes.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "scene/standard_threads.hpp"
#include "sizes/note_words.hpp"

namespace epura::sheet {

namespace {

constexpr double inch = 25.4;  // mm

std::size_t digits_at(std::string_view text) {
  std::size_t count = 0;
  while (count < text.size() && is_digit(text[count])) ++count;
  return count;
}

int integer_of(std::string_view digits) {
  int value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

std::size_t spaces_at(std::string_view text) { return std::min(text.size(), text.find_first_not_of(' ')); }

bool is_inches(std::string_view text) {
  text.remove_prefix(spaces_at(text));
  return text.starts_with('"') || text.starts_with("″") || word_at(text, "IN") > 0 || word_at(text, "INCH") > 0;
}

struct UnitWord {
  std::string_view word;
  double millimetres;
};

struct Fraction {
  double value;
  std::size_t bytes;
};

// "5/32": halves to 64ths.
std::optional<Fraction> fraction_at(std::string_view text) {
  const std::size_t upper = digits_at(text);
  if (upper == 0 || upper >= text.size() || text[upper] != '/') return std::nullopt;
  const std::size_t lower = digits_at(text.substr(upper + 1));
  const int above = integer_of(text.substr(0, upper)), below = integer_of(text.substr(upper + 1, lower));
  constexpr std::array whole{2, 4, 8, 16, 32, 64};
  if (std::ranges::find(whole, below) == whole.end() || above >= below) return std::nullopt;
  return Fraction{static_cast<double>(above) / below, upper + 1 + lower};
}

// "3 5/32", "5/32"
std::optional<Fraction> mixed_at(std::string_view text) {
  if (const auto alone = fraction_at(text)) return alone;
  const std::size_t whole = digits_at(text);
  const bool is_joined = whole > 0 && whole < text.size() && (text[whole] == ' ' || text[whole] == '-');
  const auto rest = is_joined ? fraction_at(text.substr(whole + 1)) : std::nullopt;
  if (!rest) return std::nullopt;
  return Fraction{integer_of(text.substr(0, whole)) + rest->value, whole + 1 + rest->bytes};
}

// Of pipes. ISO 228-1.
struct PipeThread {
  std::string_view size;
  double diameter;
};
constexpr std::array<PipeThread, 10> pipe_threads{{{"1/8", 9.728},
                                                   {"1/4", 13.157},
                                                   {"3/8", 16.662},
                                                   {"1/2", 20.955},
                                                   {"5/8", 22.911},
                                                   {"3/4", 26.441},
                                                   {"1 1/4", 41.91},
                                                   {"1 1/2", 47.803},
                                                   {"1", 33.249},
                                                   {"2", 59.614}}};

constexpr std::array<std::string_view, 4> inch_series{"UNC", "UNF", "UNEF", "UN"};

std::size_t series_at(std::string_view text) {
  for (const std::string_view one : inch_series)
    if (text.starts_with(one) && folded_letter(text.substr(one.size())).capital == 0) return one.size();
  return 0;
}

// Behind a thread: "-6H", " - 5g6g", "-2B", "-LH".
std::size_t classes_at(std::string_view text) {
  std::size_t end = 0;
  for (;;) {
    std::size_t at = end + spaces_at(text.substr(end));
    if (at >= text.size() || text[at] != '-') return end;
    at += 1 + spaces_at(text.substr(at + 1));
    const std::size_t from = at;
    bool has_letter = false;
    for (; at < text.size() && (is_digit(text[at]) || folded_letter(text.substr(at)).bytes == 1); ++at)
      has_letter = has_letter || !is_digit(text[at]);
    if (at == from || !has_letter) return end;
    end = at;
  }
}

// A pitch of ISO 261 for the diameter, which is its first one unless another one is behind it.
std::size_t pitch_at(std::string_view text, double diameter, double& pitch) {
  const auto sizes = scene::threads_between(diameter, diameter);
  if (!sizes.empty()) pitch = sizes.front().pitch;
  std::size_t at = spaces_at(text);
  const std::string_view sign = text.substr(at).starts_with("×") ? "×" : "x";
  const bool is_times = text.substr(at).starts_with(sign) || text.substr(at).starts_with("X");
  if (!is_times) return 0;
  at += sign.size();
  at += spaces_at(text.substr(at));
  const auto number = number_at(text.substr(at));
  if (!number) return 0;
  const bool is_pitch = std::ranges::any_of(
      sizes, [&number](const scene::Thread& one) { return std::abs(one.pitch - number->value) <= number->slack / 10; });
  if (!is_pitch) return 0;
  pitch = number->value;
  return at + number->bytes;
}

std::optional<ThreadText> metric_at(std::string_view text) {
  if (text.size() < 2 || text[0] != 'M' || !is_digit(text[1])) return std::nullopt;
  const auto number = number_at(text.substr(1));
  check(number.has_value(), "a digit begins a number");
  std::size_t end = 1 + number->bytes;
  double pitch = 0;
  end += pitch_at(text.substr(end), number->value, pitch);
  return ThreadText{number->value, pitch, end + classes_at(text.substr(end))};
}

std::optional<ThreadText> pipe_at(std::string_view text) {
  if (text.size() < 2 || text[0] != 'G') return std::nullopt;
  const std::size_t from = 1 + spaces_at(text.substr(1));
  for (const PipeThread& one : pipe_threads)
    if (text.substr(from).starts_with(one.size)) return ThreadText{one.diameter, 0, from + one.size.size()};
  return std::nullopt;
}

// A fraction, a number of ASME B1.1 or decimals, and the threads an inch: "5/16-18", "#10-32", ".250-20".
std::optional<ThreadText> inches_at(std::string_view text) {
  std::size_t end = text.starts_with("#") || text.starts_with(".") ? 1 : 0;
  double diameter = 0;
  if (const auto mixed = mixed_at(text)) {
    diameter = mixed->value * inch;
    end = mixed->bytes;
  } else {
    const std::size_t digits = digits_at(text.substr(end));
    if (digits == 0) return std::nullopt;
    const double number = integer_of(text.substr(end, digits));
    constexpr double smallest = 0.06, step = 0.013;  // inches
    diameter = inch * (text.starts_with(".") ? number / std::pow(10, digits) : smallest + step * number);
    end += digits;
  }
  check(end > 0, "a size has digits");
  if (end >= text.size() || text[end] != '-') return std::nullopt;
  const std::size_t pitch = digits_at(text.substr(end + 1));
  const int an_inch = integer_of(text.substr(end + 1, pitch));
  return an_inch == 0 ? std::nullopt : std::optional(ThreadText{diameter, inch / an_inch, end + 1 + pitch});
}

std::optional<ThreadText> inch_thread_at(std::string_view text) {
  std::size_t begin = series_at(text);
  const bool is_named = begin > 0;
  if (is_named) begin += spaces_at(text.substr(begin));
  auto size = inches_at(text.substr(begin));
  if (!size) return std::nullopt;
  size->bytes += begin;
  if (!is_named) {
    const std::size_t gap = spaces_at(text.substr(size->bytes));
    const std::size_t series = series_at(text.substr(size->bytes + gap));
    if (series == 0) return std::nullopt;
    size->bytes += gap + series;
  }
  size->bytes += classes_at(text.substr(size->bytes));
  return size;
}

std::size_t class_at(std::string_view text) {
  constexpr std::array<std::string_view, 27> letters{"JS", "CD", "EF", "FG", "ZA", "ZB", "ZC", "A", "B",
                                                     "C",  "D",  "E",  "F",  "G",  "H",  "J",  "K", "M",
                                                     "N",  "P",  "R",  "S",  "T",  "U",  "V",  "Y", "Z"};
  constexpr int greatest = 18;
  for (const std::string_view one : letters) {
    if (text.size() <= one.size()) continue;
    const std::string_view own = text.substr(0, one.size());
    const bool is_capital = own == one, is_small = std::ranges::equal(own, one, [](char a, char b) {
                                          return a == std::tolower(static_cast<unsigned char>(b));
                                        });
    const std::size_t digits = digits_at(text.substr(one.size()));
    if ((is_capital || is_small) && digits > 0 && integer_of(text.substr(one.size(), digits)) <= greatest)
      return one.size() + digits;
  }
  return 0;
}

}  // namespace

std::optional<NumberText> number_at(std::string_view text) {
  constexpr double of_fraction = 1.0 / 128;
  const bool is_number =
      !text.empty() && (is_digit(text[0]) || (text[0] == '.' && text.size() > 1 && is_digit(text[1])));
  if (!is_number) return std::nullopt;
  if (const auto mixed = mixed_at(text); mixed && is_inches(text.substr(mixed->bytes)))
    return NumberText{mixed->value, of_fraction, true, mixed->bytes};
  NumberText number{0, 0.5, false, 0};
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number.value, std::chars_format::fixed);
  if (error != std::errc()) return std::nullopt;
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.data()));
  if (const std::size_t point = digits.find('.'); point != std::string_view::npos) {
    number.slack = std::pow(10.0, -static_cast<double>(digits.size() - point - 1)) / 2;
    number.has_decimals = true;
  }
  number.bytes = digits.size();
  check(number.bytes > 0, "a number has digits");
  return number;
}

std::optional<UnitText> unit_at(std::string_view text) {
  constexpr std::array<UnitWord, 8> units{
      {{"INCH", inch}, {"IN", inch}, {"\"", inch}, {"″", inch}, {"MM", 1}, {"CM", 10}, {"DM", 100}, {"M", 1000}}};
  const std::size_t gap = spaces_at(text);
  for (const UnitWord& unit : units)
    if (const std::size_t bytes = word_at(text.substr(gap), unit.word); bytes > 0)
      return UnitText{unit.millimetres, gap + bytes};
  return std::nullopt;
}

std::optional<NumberText> degrees_at(std::string_view text) {
  std::optional<NumberText> angle = number_at(text);
  const std::string_view sign = "°";
  if (!angle || !text.substr(angle->bytes).starts_with(sign)) return std::nullopt;
  angle->bytes += sign.size();
  double part = 60;
  for (const auto& [plain, prime] : {std::pair("'", "′"), std::pair("\"", "″")}) {
    const std::string_view rest = text.substr(angle->bytes);
    const auto number = number_at(rest);
    const std::string_view behind = number ? rest.substr(number->bytes) : std::string_view();
    const std::string_view found = behind.starts_with(plain) ? plain : behind.starts_with(prime) ? prime : "";
    if (found.empty()) break;
    angle->value += number->value / part;
    angle->slack = number->slack / part;
    angle->bytes += number->bytes + found.size();
    check(angle->bytes <= text.size(), "what is taken is there");
    part *= 60;
  }
  return angle;
}

DeviationsText deviations_at(std::string_view text) {
  DeviationsText found;
  for (;;) {
    std::size_t at = found.bytes + spaces_at(text.substr(found.bytes));
    if (text.substr(at).starts_with("/")) ++at;
    const std::string_view rest = text.substr(at), both = "±";
    const bool is_both = rest.starts_with(both), is_signed = rest.starts_with("+") || rest.starts_with("-");
    const bool is_zero = rest.starts_with("0") && (rest.size() == 1 || !is_digit(rest[1]));
    const std::size_t sign = is_both ? both.size() : is_signed ? 1 : 0;
    const auto number = sign > 0 || is_zero ? number_at(rest.substr(sign)) : std::nullopt;
    if (!number) return found;
    found.values.push_back(is_both ? 0 : (rest[0] == '-' ? -1 : 1) * number->value);
    found.bytes = at + sign + number->bytes;
    check(found.bytes <= text.size(), "what is taken is there");
    for (const std::string_view unit : {"°", "'", "′"})
      if (text.substr(found.bytes).starts_with(unit)) {
        found.bytes += unit.size();
        break;
      }
  }
}

std::optional<ThreadText> thread_at(std::string_view text) {
  if (const auto metric = metric_at(text)) return metric;
  if (const auto pipe = pipe_at(text)) return pipe;
  return inch_thread_at(text);
}

std::size_t fit_at(std::string_view text) {
  std::size_t end = class_at(text);
  if (end == 0) return 0;
  if (text.substr(end).starts_with("/")) {
    const std::size_t other = class_at(text.substr(end + 1));
    if (other == 0) return 0;
    end += 1 + other;
  }
  const bool goes_on = folded_letter(text.substr(end)).capital != 0;
  return goes_on ? 0 : end;
}

}  // namespace epura::sheet
