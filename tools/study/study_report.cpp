// SPDX-License-Identifier: Apache-2.0
#include "study/study_report.hpp"

#include "base/file.hpp"
#include "output/write.hpp"
#include "pipeline/targets.hpp"
#include "study/report_page.hpp"

namespace epura::study {

namespace {

constexpr double picture_dpi = 120;

std::string to_html(const StudyReport& report) {
  std::vector<sheet::Sheet> sheets;
  for (const Chapter& chapter : report.chapters)
    sheets.push_back(stacked(to_sheet(chapter.diagram), to_sheet(chapter.table, chapter.title, Columns::all)));
  return report_page(report.title, sheets, report.notes);
}

std::string to_json(const StudyReport& report) {
  std::string text = "{\"epura_study\": \"" + report.command + "\"";
  for (const auto& [name, table] : report.tables) text += ",\n \"" + name + "\": " + to_json_list(table);
  return text + "}\n";
}

std::string to_pdf(const StudyReport& report) {
  std::vector<sheet::Sheet> sheets;
  for (const Chapter& chapter : report.chapters) {
    sheets.push_back(to_sheet(chapter.diagram));
    if (chapter.printed) sheets.push_back(to_sheet(chapter.table, chapter.title, Columns::printed));
  }
  output::Pages pages;
  for (const sheet::Sheet& sheet : sheets) pages.push_back(&sheet);
  return output::to_pdf(pages);
}

}  // namespace

std::vector<std::string> to_files(const StudyReport& report, ReportFormat format) {
  const auto each_diagram = [&](const auto& write) {
    std::vector<std::string> files;
    for (const Chapter& chapter : report.chapters) files.push_back(write(to_sheet(chapter.diagram)));
    return files;
  };
  switch (format) {
    case ReportFormat::html:
      return {to_html(report)};
    case ReportFormat::pdf:
      return {to_pdf(report)};
    case ReportFormat::csv:
      return {to_csv(report.tables.front().second)};
    case ReportFormat::json:
      return {to_json(report)};
    case ReportFormat::svg:
      return each_diagram([](const sheet::Sheet& sheet) { return output::to_svg(sheet, {}); });
    case ReportFormat::png:
      return each_diagram([](const sheet::Sheet& sheet) { return output::to_png(sheet, picture_dpi); });
  }
  return {};
}

std::string meanings(const Table& table) {
  std::string text;
  for (const Table::Column& column : table.columns)
    if (!column.meaning.empty()) text += "\n" + column.name + ": " + column.meaning;
  return text + "\n";
}

std::vector<ReportTarget<ReportFormat>> report_targets(const std::vector<std::string>& paths) {
  return report_targets<ReportFormat>(paths, "",
                                      {{"html", ReportFormat::html},
                                       {"pdf", ReportFormat::pdf},
                                       {"csv", ReportFormat::csv},
                                       {"json", ReportFormat::json},
                                       {"svg", ReportFormat::svg},
                                       {"png", ReportFormat::png}});
}

void write_report(const StudyReport& report, const std::vector<ReportTarget<ReportFormat>>& targets,
                  const std::vector<std::string>& inputs, const Progress& progress) {
  for (const ReportTarget<ReportFormat>& target : targets) {
    const std::vector<std::string> files = to_files(report, target.format);
    const std::vector<std::string> paths = pipeline::one_for_each(target.path, files.size());
    pipeline::refuse_overwriting(paths, inputs);
    for (std::size_t i = 0; i < files.size(); ++i) write_file(paths[i], files[i], progress);
  }
}

}  // namespace epura::study
