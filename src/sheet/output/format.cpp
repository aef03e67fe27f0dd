// SPDX-License-Identifier: Apache-2.0
// The table of output formats, the only place that lists them. A new format consists of a file in this folder, whose
// function may be declared here, and a row.
#include "output/format.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "base/text.hpp"
#include "output/write.hpp"

namespace epura::output {

namespace {

template <std::string (*write)(const sheet::Sheet&, const Progress&)>
std::string one_sheet(const FileContent& file, const Progress& progress) {
  return write(file.sheets.front().sheet, progress);
}

Pages pages_of(const FileContent& file) {
  Pages pages;
  for (const SheetContent& content : file.sheets) pages.push_back(&content.sheet);
  return pages;
}

std::string svg(const FileContent& file, const Progress& progress) {
  return to_svg(file.sheets.front().sheet, file.options, progress);
}

std::string pdf(const FileContent& file, const Progress& progress) {
  return to_pdf(pages_of(file), progress, file.options);
}

std::string ps(const FileContent& file, const Progress& progress) { return to_ps(pages_of(file), progress); }

std::string dxf(const FileContent& file, const Progress& progress) {
  return to_dxf(file.sheets.front().sheet, file.options, progress);
}

std::string png(const FileContent& file, const Progress& progress) {
  return to_png(file.sheets.front().sheet, file.options.dpi.value_or(usual_dpi), progress);
}

std::string json(const FileContent& file, const Progress& progress) {
  const SheetContent& content = file.sheets.front();
  return to_json(content.sheet, content.scale, content.drawings, file.report, progress);
}

std::string html(const FileContent& file, const Progress& progress) { return to_html(file, progress); }

// All digits of a double are written.
double none(const VectorOptions& /*options*/, bool /*has_arcs*/) { return 0; }

// Half of a pixel's diagonal.
double of_pixels(const VectorOptions& options, bool /*has_arcs*/) {
  return 25.4 / options.dpi.value_or(usual_dpi) / std::numbers::sqrt2;
}

// Both coordinates are rounded. The middle of a quarter of a circle moves with both ends, and with its radius.
double of_decimals(const VectorOptions& options, bool has_arcs) {
  double place = 1;
  for (int i = 0; i < options.decimals.value_or(usual_decimals); ++i) place /= 10;
  return has_arcs ? 2 * place : place / std::numbers::sqrt2;
}

// Cairo's coordinates are multiples of 1/256 of a thousandth of a millimetre; its curves are Bezier pieces.
double of_cairo(const VectorOptions& /*options*/, bool has_arcs) { return has_arcs ? 2e-5 : 1e-5; }

constexpr bool pages = true, drawings = true, facts = true, carries = true, pictures = true;

constexpr std::array table = {
    Format{"svg", !pages, !drawings, !facts, carries, pictures, "emf wmf svgz", svg, of_decimals},
    Format{"pdf", pages, !drawings, !facts, carries, pictures, "ai", pdf, of_cairo},
    Format{"ps", pages, !drawings, !facts, !carries, pictures, "", ps, of_cairo},
    Format{"eps", !pages, !drawings, !facts, !carries, pictures, "", one_sheet<to_eps>, of_cairo},
    Format{"png", !pages, !drawings, !facts, !carries, pictures, "jpg jpeg gif bmp tif tiff webp", png, of_pixels},
    Format{"dxf", !pages, !drawings, !facts, !carries, !pictures, "dwg", dxf, none},
    Format{"json", !pages, drawings, !facts, !carries, pictures, "", json, none},
    Format{"html", pages, drawings, facts, !carries, pictures, "htm xhtml", html, of_decimals},
};

}  // namespace

std::span<const Format> formats() { return table; }

const Format* find_format(std::string_view extension) {
  if (extension.starts_with('.')) extension.remove_prefix(1);
  const auto is_it = [name = to_lower(extension)](const Format& format) { return format.name == name; };
  const auto found = std::find_if(table.begin(), table.end(), is_it);
  return found == table.end() ? nullptr : &*found;
}

std::string format_hint(std::string_view extension) {
  const std::string wanted = to_lower(extension);
  for (const Format& format : table)
    for (const std::string_view other : split(format.instead_of, ' '))
      if (!wanted.empty() && other == wanted)
        return "write " + std::string(format.name) + " instead, which programs for " + wanted + " read";
  return did_you_mean(extension, format_names());
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const Format& format : table) names.emplace_back(format.name);
  return names;
}

}  // namespace epura::output
