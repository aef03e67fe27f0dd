// SPDX-License-Identifier: Apache-2.0
#include "scene/threads.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/standard_threads.hpp"

namespace epura::scene {

namespace {

/// A diameter with its pitches, mm.
struct Size {
  double diameter;
  double coarse;               ///< 0: none
  std::array<double, 5> fine;  ///< 0: no further one
};

// ISO 261:1998, table 2, up to 100 mm.
constexpr std::array sizes{
    Size{1, 0.25, {0.2}},
    Size{1.1, 0.25, {0.2}},
    Size{1.2, 0.25, {0.2}},
    Size{1.4, 0.3, {0.2}},
    Size{1.6, 0.35, {0.2}},
    Size{1.8, 0.35, {0.2}},
    Size{2, 0.4, {0.25}},
    Size{2.2, 0.45, {0.25}},
    Size{2.5, 0.45, {0.35}},
    Size{3, 0.5, {0.35}},
    Size{3.5, 0.6, {0.35}},
    Size{4, 0.7, {0.5}},
    Size{4.5, 0.75, {0.5}},
    Size{5, 0.8, {0.5}},
    Size{5.5, 0, {0.5}},
    Size{6, 1, {0.75}},
    Size{7, 1, {0.75}},
    Size{8, 1.25, {1, 0.75}},
    Size{9, 1.25, {1, 0.75}},
    Size{10, 1.5, {1.25, 1, 0.75}},
    Size{11, 1.5, {1, 0.75}},
    Size{12, 1.75, {1.5, 1.25, 1}},
    Size{14, 2, {1.5, 1.25, 1}},
    Size{15, 0, {1.5, 1}},
    Size{16, 2, {1.5, 1}},
    Size{17, 0, {1.5, 1}},
    Size{18, 2.5, {2, 1.5, 1}},
    Size{20, 2.5, {2, 1.5, 1}},
    Size{22, 2.5, {2, 1.5, 1}},
    Size{24, 3, {2, 1.5, 1}},
    Size{25, 0, {2, 1.5, 1}},
    Size{26, 0, {1.5}},
    Size{27, 3, {2, 1.5, 1}},
    Size{28, 0, {2, 1.5, 1}},
    Size{30, 3.5, {3, 2, 1.5, 1}},
    Size{32, 0, {2, 1.5}},
    Size{33, 3.5, {3, 2, 1.5}},
    Size{35, 0, {1.5}},
    Size{36, 4, {3, 2, 1.5}},
    Size{38, 0, {1.5}},
    Size{39, 4, {3, 2, 1.5}},
    Size{40, 0, {3, 2, 1.5}},
    Size{42, 4.5, {4, 3, 2, 1.5}},
    Size{45, 4.5, {4, 3, 2, 1.5}},
    Size{48, 5, {4, 3, 2, 1.5}},
    Size{50, 0, {3, 2, 1.5}},
    Size{52, 5, {4, 3, 2, 1.5}},
    Size{55, 0, {4, 3, 2, 1.5}},
    Size{56, 5.5, {4, 3, 2, 1.5}},
    Size{58, 0, {4, 3, 2, 1.5}},
    Size{60, 5.5, {4, 3, 2, 1.5}},
    Size{62, 0, {4, 3, 2, 1.5}},
    Size{64, 6, {4, 3, 2, 1.5}},
    Size{65, 0, {4, 3, 2, 1.5}},
    Size{68, 6, {4, 3, 2, 1.5}},
    Size{70, 0, {6, 4, 3, 2, 1.5}},
    Size{72, 0, {6, 4, 3, 2, 1.5}},
    Size{75, 0, {4, 3, 2, 1.5}},
    Size{76, 0, {6, 4, 3, 2, 1.5}},
    Size{78, 0, {2}},
    Size{80, 0, {6, 4, 3, 2, 1.5}},
    Size{82, 0, {2}},
    Size{85, 0, {6, 4, 3, 2}},
    Size{90, 0, {6, 4, 3, 2}},
    Size{95, 0, {6, 4, 3, 2}},
    Size{100, 0, {6, 4, 3, 2}},
};

std::string name_of(const Size& size) { return "M" + format_number(size.diameter); }

const Size& size_of(double diameter, const std::string& quoted, const std::string& where) {
  const auto found =
      std::find_if(sizes.begin(), sizes.end(), [&](const Size& size) { return size.diameter == diameter; });
  if (found != sizes.end()) return *found;
  const auto above =
      std::find_if(sizes.begin(), sizes.end(), [&](const Size& size) { return size.diameter > diameter; });
  std::string near = above == sizes.end() ? "the largest known here is " + name_of(sizes.back()) : name_of(*above);
  if (above != sizes.end() && above != sizes.begin()) near = name_of(above[-1]) + " and " + near + " are the nearest";
  refuse_input(where, quoted + " is not a thread: ISO 261 has no M" + format_number(diameter), near);
}

double pitch_of(const Size& size, std::optional<double> wanted, const std::string& quoted, const std::string& where) {
  std::string known = size.coarse > 0 ? format_number(size.coarse) : "";
  for (const double pitch : size.fine)
    if (pitch > 0) append_to_list(known, format_number(pitch));
  if (!wanted && size.coarse > 0) return size.coarse;
  if (!wanted)
    refuse_input(where, quoted + " has no coarse pitch in ISO 261",
                 "give its pitch, as " + name_of(size) + "x" + format_number(size.fine.front()));
  const bool is_fine = std::find(size.fine.begin(), size.fine.end(), *wanted) != size.fine.end();
  if (!(*wanted > 0) || (!is_fine && *wanted != size.coarse))
    refuse_input(
        where, quoted + " is not a thread: ISO 261 has no pitch of " + format_number(*wanted) + " for " + name_of(size),
        "its pitches are " + known);
  return *wanted;
}

// A tolerance class, one or two grades with letters: "6H", "5g6g"; or LH.
bool is_suffix(std::string_view part) {
  if (part == "LH") return true;
  if (part.size() != 2 && part.size() != 4) return false;
  for (std::size_t i = 0; i < part.size(); i += 2) {
    constexpr std::string_view letters = "GHefgh";
    if (part[i] < '3' || part[i] > '9' || letters.find(part[i + 1]) == std::string_view::npos) return false;
  }
  return true;
}

}  // namespace

double Thread::minor() const { return diameter - 2 * 5.0 / 8 * std::numbers::sqrt3 / 2 * pitch; }

Thread parse_thread(std::string_view text, const std::string& where) {
  const std::string quoted = "'" + std::string(text) + "'";
  const auto expect = [&](bool is_so) {
    if (!is_so)
      refuse_input(where, quoted + " is not a metric screw thread",
                   "write M6, M6x0.75 with a fine pitch, or M6-6H with a "
                   "tolerance class");
  };
  const std::vector<std::string_view> parts = split(text, '-');
  expect(parts.front().size() > 1 && parts.front().front() == 'M');
  const std::string_view size = parts.front().substr(1);
  const std::string_view times = size.find("×") != std::string_view::npos ? "×" : "x";
  const std::size_t at = size.find(times);
  const std::optional<double> diameter = parse_number(size.substr(0, at));
  expect(diameter.has_value() && std::isfinite(*diameter) && *diameter > 0);
  std::optional<double> pitch;
  if (at != std::string_view::npos) {
    pitch = parse_number(size.substr(at + times.size()));
    expect(pitch.has_value() && std::isfinite(*pitch));
  }
  expect(std::all_of(parts.begin() + 1, parts.end(), is_suffix));
  const Size& row = size_of(*diameter, quoted, where);
  Thread thread{*diameter, pitch_of(row, pitch, quoted, where), name_of(row)};
  if (thread.pitch != row.coarse) thread.text += "×" + format_number(thread.pitch);
  for (std::size_t i = 1; i < parts.size(); ++i) thread.text += "-" + std::string(parts[i]);
  return thread;
}

bool suits(const Thread& thread, double diameter, bool internal) {
  const double least = thread.diameter - (internal ? smallest_hole : smallest_shaft) * thread.pitch;
  const double most = internal ? thread.diameter - largest_hole * thread.pitch : largest_shaft * thread.diameter;
  return diameter >= least && diameter <= most;
}

std::vector<Thread> threads_between(double from, double to) {
  std::vector<Thread> threads;
  for (const Size& size : sizes) {
    if (size.diameter < from || size.diameter > to) continue;
    if (size.coarse > 0) threads.push_back({size.diameter, size.coarse, name_of(size)});
    for (const double pitch : size.fine)
      if (pitch > 0) threads.push_back({size.diameter, pitch, name_of(size) + "×" + format_number(pitch)});
  }
  return threads;
}

}  // namespace epura::scene
