// SPDX-License-Identifier: Apache-2.0
#include "output/svg_metadata.hpp"

#include <array>
#include <string>

#include "output/metadata.hpp"
#include "output/svg_paths.hpp"

namespace epura {

namespace {

/// A fact of the sheet and its element of Dublin Core. Agents are people and companies.
struct Element {
  const char *fact, *name;
  bool agent;
};
constexpr std::array<Element, 6> elements = {{{"author", "dc:creator", true},
                                              {"approver", "dc:contributor", true},
                                              {"owner", "dc:rights", true},
                                              {"number", "dc:identifier", false},
                                              {"date", "dc:date", false},
                                              {"language", "dc:language", false}}};

void add_text(pugi::xml_node parent, const char* name, const std::string& text) {
  if (!text.empty()) parent.append_child(name).text() = xml_text(text).c_str();
}

// All that Dublin Core has no element for.
std::string remarks(const Sheet& sheet) {
  std::string text = description_of(sheet);
  for (const auto& [fact, value] : sheet.facts) {
    bool told = value.empty();
    for (const Element& element : elements) told = told || fact == element.fact;
    if (!told) text += (text.empty() ? "" : "\n") + fact + ": " + value;
  }
  return text;
}

}  // namespace

void add_svg_metadata(pugi::xml_node svg, const Sheet& sheet) {
  svg.append_child("title").text() = xml_text(sheet.title).c_str();
  add_text(svg, "desc", description_of(sheet));
  pugi::xml_node rdf = svg.append_child("metadata").append_child("rdf:RDF");
  rdf.append_attribute("xmlns:rdf") = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
  rdf.append_attribute("xmlns:cc") = "http://creativecommons.org/ns#";
  rdf.append_attribute("xmlns:dc") = "http://purl.org/dc/elements/1.1/";
  pugi::xml_node work = rdf.append_child("cc:Work");
  work.append_attribute("rdf:about") = "";
  work.append_child("dc:format").text() = "image/svg+xml";
  add_text(work, "dc:title", sheet.title);
  for (const Element& element : elements) {
    const std::string value = fact_of(sheet, element.fact);
    if (value.empty()) continue;
    if (element.agent) {
      add_text(work.append_child(element.name).append_child("cc:Agent"), "dc:title", value);
    } else {
      add_text(work, element.name, value);
    }
  }
  add_text(work, "dc:description", remarks(sheet));
}

}  // namespace epura
