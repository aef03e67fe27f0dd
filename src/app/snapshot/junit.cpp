// SPDX-License-Identifier: Apache-2.0
#include "app/snapshot/junit.hpp"

#include <algorithm>

#include "output/xml_text.hpp"

namespace epura {

namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void append_case(std::string& xml, const SnapshotResult& result) {
  output::append_attribute(xml += "  <testcase classname=\"epura.snapshot\"", "name", result.name);
  if (result.verdict == SnapshotVerdict::as_expected) {
    xml += "/>\n";
    return;
  }
  const std::string element = result.verdict == SnapshotVerdict::failed ? "error" : "failure";
  output::append_attribute(xml += ">\n    <" + element, "message", first_line(result.words));
  output::append_escaped(xml += ">", result.words);
  xml += "</" + element + ">\n  </testcase>\n";
}

}  // namespace

std::string junit_report(const std::vector<SnapshotResult>& results) {
  const auto count = [&](auto wanted) {
    return std::to_string(std::count_if(results.begin(), results.end(),
                                        [&](const SnapshotResult& result) { return wanted(result.verdict); }));
  };
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"epura snapshot\" tests=\"" +
      std::to_string(results.size()) + "\" failures=\"" +
      count([](SnapshotVerdict v) { return v == SnapshotVerdict::different || v == SnapshotVerdict::new_case; }) +
      "\" errors=\"" + count([](SnapshotVerdict v) { return v == SnapshotVerdict::failed; }) + "\">\n";
  for (const SnapshotResult& result : results) append_case(xml, result);
  return xml + "</testsuite>\n";
}

}  // namespace epura
