// SPDX-License-Identifier: Apache-2.0
#include "batch/report.hpp"

#include <algorithm>
#include <string_view>

#include "app/junit.hpp"
#include "base/text.hpp"
#include "output/html.hpp"
#include "output/xml_text.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view head =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width\">\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' file:; "
    "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n<title>epura batch</title>\n<style>\n"
    "body{font:15px sans-serif;margin:1.5em;color:#222}\n"
    "ul{display:grid;grid-template-columns:repeat(auto-fill,minmax(15em,1fr));gap:1em;padding:0;list-style:none}\n"
    "li{border:1px solid #ccc;padding:.5em;overflow-wrap:anywhere}\n"
    "img{width:100%;height:11em;object-fit:contain;background:#fff}\n"
    ".failed{border-color:#cd0000}.failed h2{color:#cd0000}\nh2{font-size:1em;margin:.3em 0}\n"
    "a{display:block}small,p.message{color:#666;margin:.2em "
    "0}\ninput{font:inherit;width:20em}\n</style>\n</head>\n<body>\n";

constexpr std::string_view script =
    "<script>\nconst search = document.querySelector('input');\nconst show = () => {\n"
    "  const words = search.value.toLowerCase().split(/\\s+/);\n"
    "  for (const item of document.querySelectorAll('li')) {\n"
    "    const text = item.textContent.toLowerCase();\n"
    "    item.hidden = !words.every(word => text.includes(word));\n  }\n};\n"
    "search.addEventListener('input', show);\n</script>\n";

// A relative address; RFC 3986.
std::string address_of(const std::string& path, const fs::path& page) {
  constexpr std::string_view digits = "0123456789ABCDEF", plain = "-._~/";
  const fs::path folder = fs::absolute(page).lexically_normal().parent_path();
  std::string address;
  for (const char c : fs::absolute(path).lexically_normal().lexically_relative(folder).string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_word || plain.find(c) != std::string_view::npos)
      address += c;
    else
      address += {'%', digits[byte / 16], digits[byte % 16]};
  }
  // The first part of a relative address must not look like a protocol.
  return "./" + address;
}

void append_outputs(std::string& html, const JobRecord& record, const fs::path& page) {
  const auto shown = std::find_if(record.outputs.begin(), record.outputs.end(),
                                  [](const WrittenFile& file) { return is_picture(file.path); });
  const bool is_output = shown != record.outputs.end();
  const std::string picture = is_output ? shown->path : record.picture.path;
  if (!picture.empty() && !record.outputs.empty()) {
    html +=
        "<a href=\"" + address_of(is_output ? picture : record.outputs.front().path, page) + "\"><img loading=\"lazy\"";
    output::append_attribute(html, "alt", "drawing of " + record.name);
    html += " src=\"" + address_of(picture, page) + "\"></a>\n";
  }
  for (const WrittenFile& file : record.outputs)
    html += "<a href=\"" + address_of(file.path, page) + "\">" +
            output::html_text(fs::path(file.path).filename().string()) + "</a>\n";
}

void append_record(std::string& html, const JobRecord& record, const fs::path& page) {
  html += record.is_good() ? "<li>\n" : "<li class=\"failed\">\n";
  html += "<h2>" + output::html_text(record.name) + "</h2>\n";
  append_outputs(html, record, page);
  if (!record.is_good()) html += "<p>failed: exit code " + std::to_string(record.code) + "</p>\n";
  for (const std::string& message : record.messages)
    html += "<p class=\"message\">" + output::html_text(message) + "</p>\n";
  html += "<small>" + format_rounded(record.seconds, 3) + " s, " + format_rounded(record.megabytes, 3) +
          " MB</small>\n</li>\n";
}

std::string all_messages(const JobRecord& record) {
  std::string text;
  for (const std::string& message : record.messages) text += message + "\n";
  return text;
}

}  // namespace

std::string batch_page(const std::vector<JobRecord>& records, const fs::path& file) {
  const auto failed =
      std::count_if(records.begin(), records.end(), [](const JobRecord& record) { return !record.is_good(); });
  std::string html(head);
  html += "<main>\n<h1>epura batch</h1>\n<p>" + std::to_string(records.size()) + " jobs, " + std::to_string(failed) +
          " failed</p>\n<p><label>Search <input type=\"search\"></label></p>\n<ul>\n";
  for (const bool is_good : {false, true})
    for (const JobRecord& record : records)
      if (record.is_good() == is_good) append_record(html, record, file);
  html += "</ul>\n</main>\n";
  html += script;
  return html + "</body>\n</html>\n";
}

bool is_picture(const std::string& path) {
  const std::string extension = to_lower(fs::path(path).extension().string());
  return extension == ".svg" || extension == ".png";
}

std::string batch_junit(const std::vector<JobRecord>& records) {
  std::vector<TestCase> cases;
  for (const JobRecord& record : records)
    cases.push_back({record.name, record.is_good() ? TestVerdict::passed : TestVerdict::error, all_messages(record)});
  return junit_report("epura batch", "epura.batch", cases);
}

}  // namespace epura
