// SPDX-License-Identifier: Apache-2.0
#include "app/snapshot/junit.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "output/svg_paths.hpp"

namespace epura {

namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void add_case(pugi::xml_node& suite, const SnapshotResult& result) {
  pugi::xml_node one = suite.append_child("testcase");
  one.append_attribute("classname") = "epura.snapshot";
  one.append_attribute("name") = xml_text(result.name).c_str();
  if (result.verdict == SnapshotVerdict::as_expected) return;
  pugi::xml_node reason = one.append_child(result.verdict == SnapshotVerdict::failed ? "error" : "failure");
  reason.append_attribute("message") = xml_text(first_line(result.words)).c_str();
  reason.text() = xml_text(result.words).c_str();
}

}  // namespace

std::string junit_report(const std::vector<SnapshotResult>& results) {
  const auto count = [&](auto wanted) {
    return std::to_string(std::count_if(results.begin(), results.end(),
                                        [&](const SnapshotResult& result) { return wanted(result.verdict); }));
  };
  const auto differs = [](SnapshotVerdict v) {
    return v == SnapshotVerdict::different || v == SnapshotVerdict::new_case;
  };
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node suite = document.append_child("testsuite");
  suite.append_attribute("name") = "epura snapshot";
  suite.append_attribute("tests") = std::to_string(results.size()).c_str();
  suite.append_attribute("failures") = count(differs).c_str();
  suite.append_attribute("errors") = count([](SnapshotVerdict v) { return v == SnapshotVerdict::failed; }).c_str();
  for (const SnapshotResult& result : results) add_case(suite, result);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace epura
