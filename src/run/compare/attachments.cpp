// SPDX-License-Identifier: Apache-2.0
#include "compare/attachments.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string_view>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/pdf/library.hpp"

namespace epura::compare {

namespace {

using output::Attachment;
using output::Relation;

// RFC 4648, 4: whole groups of four; nothing for anything else.
std::optional<std::string> bytes_of_base64(std::string_view text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  if (text.size() % 4 != 0) return std::nullopt;
  const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with("=") ? 1 : 0;
  text.remove_suffix(padding);
  std::string bytes;
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t value = letters.find(text[i]);
    if (value == letters.npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if (i % 4 > 0) bytes += static_cast<char>(bits >> (6 - 2 * (i % 4)) & 255);
  }
  return bytes;
}

std::vector<Attachment> attachments_of_svg(const std::string& bytes, const std::string& where) {
  pugi::xml_document document;
  if (!document.load_buffer(bytes.data(), bytes.size())) throw Error(ErrorKind::input, where, "is not valid XML");
  std::vector<Attachment> attachments;
  for (const pugi::xml_node& node : document.child("svg").child("metadata").children("epura:attachment")) {
    const std::string name = node.attribute("name").value();
    std::optional<std::string> content = bytes_of_base64(node.text().get());
    if (!content) throw Error(ErrorKind::input, where, "'" + name + "' is not in base64");
    const bool is_source = std::string_view(node.attribute("relation").value()) == name_of(Relation::source);
    attachments.push_back({name, node.attribute("type").value(), node.attribute("description").value(),
                           is_source ? Relation::source : Relation::data, *std::move(content)});
  }
  return attachments;
}

bool is_pdf(const std::filesystem::path& file) { return to_lower(file.extension().string()) == ".pdf"; }

// The content of a page between its layers says in which order they come, and where.
void add_differences(const output::PdfContent& before, const output::PdfContent& after, const std::string& page,
                     std::vector<std::string>& found) {
  if (before.width != after.width || before.height != after.height) found.push_back("the size of " + page);
  if (before.page != after.page || before.layers != after.layers) found.push_back("the order of the layers of " + page);
  for (const auto& [name, content] : before.forms) {
    const auto other = after.forms.find(name), layer = before.layers.find(name);
    if (other == after.forms.end() || other->second != content)
      found.push_back("layer " + (layer == before.layers.end() ? name : layer->second));
  }
}

}  // namespace

std::vector<Attachment> attachments_in(const std::string& bytes, const std::filesystem::path& file) {
  const std::string where = file.string();
  std::vector<Attachment> attachments =
      is_pdf(file) ? output::pdf_library().read_attachments(bytes, where) : attachments_of_svg(bytes, where);
  std::set<std::string> names;
  for (const Attachment& one : attachments) {
    if (!output::is_safe_name(one.name))
      throw Error(ErrorKind::input, where, "carries a file with the name '" + one.name + "'",
                  "names of files that a drawing carries lie below an empty folder");
    if (!names.insert(one.name).second)
      throw Error(ErrorKind::input, where, "carries two files with the name '" + one.name + "'");
  }
  return attachments;
}

std::vector<std::string> differing_layers(const std::string& before, const std::string& after,
                                          const std::filesystem::path& file) {
  const std::vector<output::PdfContent> pages = output::pdf_library().read_contents(before, file.string()),
                                        others = output::pdf_library().read_contents(after, file.string());
  std::vector<std::string> found;
  if (pages.size() != others.size()) found.emplace_back("the number of pages");
  for (std::size_t i = 0; i < std::min(pages.size(), others.size()); ++i)
    add_differences(pages[i], others[i], "page " + std::to_string(i + 1), found);
  return found;
}

}  // namespace epura::compare
