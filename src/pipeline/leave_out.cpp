// SPDX-License-Identifier: Apache-2.0
#include "pipeline/leave_out.hpp"

#include "pipeline/choose.hpp"

namespace epura {

const std::vector<std::pair<std::string, bool LeaveOut::*>>& certificates() {
  static const std::vector<std::pair<std::string, bool LeaveOut::*>> table{{"clip", &LeaveOut::clip},
                                                                           {"intersections", &LeaveOut::intersections},
                                                                           {"visibility", &LeaveOut::visibility},
                                                                           {"hidden", &LeaveOut::hidden},
                                                                           {"text", &LeaveOut::text}};
  return table;
}

LeaveOut parse_leave_out(const std::string& text) {
  if (text == "all") return {};
  LeaveOut chosen{false, false, false, false, false};
  if (text == "none") return chosen;
  for (const std::string_view name : split(text, ','))
    chosen.*choose<bool LeaveOut::*>("--plan", std::string(name), certificates()) = true;
  return chosen;
}

}  // namespace epura
