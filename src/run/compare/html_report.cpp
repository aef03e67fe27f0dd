// SPDX-License-Identifier: Apache-2.0
#include "compare/html_report.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "compare/overlay.hpp"
#include "output/format.hpp"
#include "output/html.hpp"
#include "output/write.hpp"

namespace epura::compare {

namespace {

std::string svg_of(const sheet::Sheet& sheet) {
  output::VectorOptions options;
  options.plain = true;
  options.decimals = 3;
  return output::to_svg(sheet, options);
}

std::vector<std::string> svgs_of(const PictureFile& file) {
  std::vector<std::string> pictures;
  for (const Picture& page : file.pages) pictures.push_back(svg_of(sheet_of(page)));
  return pictures;
}

constexpr std::string_view head =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n"
    "body{font:15px sans-serif;margin:1.5em;color:#222}\n"
    ".pictures{display:grid;grid-template-columns:repeat(3,1fr);gap:1em}\n"
    "figure{margin:0}\nimg{width:100%;border:1px solid #ccc;background:#fff}\n"
    "figcaption{padding:.3em 0}\npre{background:#f4f4f4;padding:.7em;overflow:auto}\n"
    ".removed{color:#cd0000}.added{color:#008c3c}.changed{color:#b06f00}.same{color:#888}\n</style>\n";

constexpr std::string_view legend =
    "<p><span class=\"removed\">removed</span> · <span class=\"added\">added</span> · "
    "<span class=\"changed\">changed</span> · <span class=\"same\">same</span></p>\n";

// In a separate data URL, so that the style sheets of several pictures do not mix. RFC 2397, RFC 3986.
std::string image(std::string_view svg) {
  constexpr std::string_view digits = "0123456789ABCDEF", special = "%#\"<>&'\n\t";
  std::string html = "<img alt=\"\" src=\"data:image/svg+xml,";
  for (const char c : svg) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 128 && special.find(c) == std::string_view::npos) {
      html += c;
    } else {
      html += {'%', digits[byte / 16], digits[byte % 16]};
    }
  }
  return html + "\">";
}

void append_figure(std::string& html, const std::string& caption, const std::vector<std::string>& pages,
                   std::size_t page) {
  html += "<figure><figcaption>" + caption + "</figcaption>";
  html += page < pages.size() ? image(pages[page]) : "none";
  html += "</figure>\n";
}

void append_case(std::string& html, const ReportedCase& one) {
  html += "<h2>" + output::html_text(one.name) + "</h2>\n<pre>" + output::html_text(one.words) + "</pre>\n";
  const std::size_t pages = std::max({one.expected.size(), one.overlays.size(), one.actual.size()});
  for (std::size_t page = 0; page < pages; ++page) {
    html += "<div class=\"pictures\">\n";
    append_figure(html, "expected", one.expected, page);
    append_figure(html, "overlay", one.overlays, page);
    append_figure(html, "actual", one.actual, page);
    html += "</div>\n";
  }
}

}  // namespace

ReportedCase add_pictures(ReportedCase reported, const PictureFile& expected, const PictureFile& actual,
                          const Comparison& comparison) {
  reported.expected = svgs_of(expected);
  reported.actual = svgs_of(actual);
  for (const PageComparison& page : comparison.pages) reported.overlays.push_back(svg_of(overlay_of(page)));
  return reported;
}

std::string overlay_page(const std::string& title, const std::string& words, const PictureFile& before,
                         const PictureFile& after, const Comparison& comparison) {
  std::vector<sheet::Sheet> sheets;
  const auto add = [&sheets](sheet::Sheet sheet, const std::string& name, std::size_t number, std::size_t count) {
    sheet.title = name + (count > 1 ? " " + std::to_string(number + 1) : "");
    sheets.push_back(std::move(sheet));
  };
  for (std::size_t i = 0; i < comparison.pages.size(); ++i)
    add(overlay_of(comparison.pages[i]), "Differences", i, comparison.pages.size());
  for (std::size_t i = 0; i < before.pages.size(); ++i)
    add(sheet_of(before.pages[i]), "Before", i, before.pages.size());
  for (std::size_t i = 0; i < after.pages.size(); ++i) add(sheet_of(after.pages[i]), "After", i, after.pages.size());
  output::VectorOptions options;
  options.decimals = 3;
  const report::Report report;
  output::FileContent content{{}, options, report, title, "Differences"};
  for (const sheet::Sheet& sheet : sheets) content.sheets.push_back({sheet});
  if (!content.sheets.empty()) content.sheets.front().answers = words;
  return output::to_html(content);
}

std::string html_report(const std::string& title, const std::vector<ReportedCase>& cases) {
  std::string bad, good;
  std::size_t failed = 0;
  for (const ReportedCase& one : cases) {
    if (one.good) {
      good += "<li>" + output::html_text(one.name) + "</li>\n";
    } else {
      append_case(bad, one);
      ++failed;
    }
  }
  std::string html(head);
  html += "<title>" + output::html_text(title) + "</title>\n</head>\n<body>\n<h1>" + output::html_text(title) +
          "</h1>\n<p>" + std::to_string(cases.size() - failed) + " of " + std::to_string(cases.size()) +
          " are as expected.</p>\n";
  if (failed > 0) html += std::string(legend) + bad;
  if (!good.empty()) html += "<h2>As expected</h2>\n<ul>\n" + good + "</ul>\n";
  return html + "</body>\n</html>\n";
}

}  // namespace epura::compare
