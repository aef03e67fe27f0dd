// SPDX-License-Identifier: Apache-2.0
#include "output/attachments.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "output/xml_text.hpp"

namespace epura::output {

bool is_safe_name(std::string_view name) {
  const auto is_unsafe = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f' || c == '\\'; };
  if (std::any_of(name.begin(), name.end(), is_unsafe)) return false;
  const std::vector<std::string_view> parts = split(name, '/');
  return std::none_of(parts.begin(), parts.end(),
                      [](std::string_view part) { return part.empty() || part == "." || part == ".."; });
}

void append_attachments(std::string& svg, const std::vector<Attachment>& attachments) {
  for (const Attachment& one : attachments) {
    append_attribute(svg += "<epura:attachment xmlns:epura=\"urn:epura:proof\"", "name", one.name);
    append_attribute(svg, "type", one.media_type);
    append_attribute(svg, "relation", name_of(one.relation));
    append_attribute(svg, "description", one.description);
    svg.append(">").append(base64(one.bytes)).append("</epura:attachment>\n");
  }
}

}  // namespace epura::output
