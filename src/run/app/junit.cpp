// SPDX-License-Identifier: Apache-2.0
#include "app/junit.hpp"

#include <algorithm>

#include "output/xml_text.hpp"

namespace epura {

namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void append_case(std::string& xml, const std::string& class_name, const TestCase& one) {
  output::append_attribute(xml += "  <testcase", "classname", class_name);
  output::append_attribute(xml, "name", one.name);
  if (one.verdict == TestVerdict::passed) {
    xml += "/>\n";
    return;
  }
  const std::string element = one.verdict == TestVerdict::error ? "error" : "failure";
  output::append_attribute(xml += ">\n    <" + element, "message", first_line(one.words));
  output::append_escaped(xml += ">", one.words);
  xml += "</" + element + ">\n  </testcase>\n";
}

}  // namespace

std::string junit_report(const std::string& suite, const std::string& class_name, const std::vector<TestCase>& cases) {
  const auto count = [&](TestVerdict verdict) {
    return std::to_string(
        std::count_if(cases.begin(), cases.end(), [&](const TestCase& one) { return one.verdict == verdict; }));
  };
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"" + suite + "\" tests=\"" +
                    std::to_string(cases.size()) + "\" failures=\"" + count(TestVerdict::failure) + "\" errors=\"" +
                    count(TestVerdict::error) + "\">\n";
  for (const TestCase& one : cases) append_case(xml, class_name, one);
  return xml + "</testsuite>\n";
}

}  // namespace epura
