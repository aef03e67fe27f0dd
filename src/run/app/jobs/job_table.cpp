// SPDX-License-Identifier: Apache-2.0
#include "app/jobs/job_table.hpp"

#include <filesystem>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "scene/scene_values.hpp"

namespace epura {

namespace {

struct CsvLine {
  int number = 0;  ///< of its first line in the file
  std::vector<std::string> cells;
};

// RFC 4180: cells in quotation marks may hold separators and line breaks, and a doubled mark stands for one.
class CsvReader {
 public:
  CsvReader(std::string text, std::string path) : text_(std::move(text)), path_(std::move(path)) {
    const std::size_t first = text_.find_first_of(",;\t\n");
    if (first != std::string::npos && text_[first] != '\n') separator_ = text_[first];
  }

  std::vector<CsvLine> lines() {
    std::vector<CsvLine> all;
    while (at_ < text_.size()) {
      CsvLine line{number_, {}};
      bool goes_on = true;
      while (goes_on) {
        line.cells.push_back(cell());
        goes_on = at_ < text_.size() && text_[at_] == separator_;
        if (goes_on) ++at_;
      }
      end_line();
      if (line.cells.size() > 1 || !line.cells.front().empty()) all.push_back(std::move(line));
    }
    return all;
  }

 private:
  std::string cell() {
    if (at_ < text_.size() && text_[at_] == '"') return quoted_cell();
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n') ++at_;
    std::size_t end = at_;
    while (end > begin && (text_[end - 1] == '\r' || text_[end - 1] == ' ')) --end;
    return text_.substr(begin, end - begin);
  }

  std::string quoted_cell() {
    const int begun = number_;
    std::string value;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') ++number_;
      if (text_[at_] != '"') {
        value += text_[at_];
      } else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
        value += text_[++at_];
      } else {
        ++at_;
        expect_end_of_cell();
        return value;
      }
    }
    throw Error(ErrorKind::input, place(begun), "a quotation mark is not closed");
  }

  void expect_end_of_cell() {
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n')
      throw Error(ErrorKind::input, place(number_), "there is text after a quotation mark",
                  "double the quotation marks in a text");
  }

  void end_line() {
    if (at_ < text_.size()) ++at_;
    ++number_;
  }

  [[nodiscard]] std::string place(int line) const { return path_ + ":" + std::to_string(line); }

  std::string text_, path_;
  std::size_t at_ = 0;
  int number_ = 1;
  char separator_ = ',';
};

std::vector<TableRow> read_csv(const std::string& path) {
  const std::vector<CsvLine> lines = CsvReader(without_byte_order_mark(read_file(path)), path).lines();
  std::vector<TableRow> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string>&names = lines.front().cells, &cells = lines[i].cells;
    TableRow row{path + ":" + std::to_string(lines[i].number), {}};
    if (cells.size() > names.size())
      throw Error(ErrorKind::input, row.where,
                  "has " + std::to_string(cells.size()) + " cells, and the heading " + std::to_string(names.size()));
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].empty()) continue;
      row.cells.emplace_back(names[c], scene::value_of_option(row.where + ": '" + names[c] + "'", cells[c]));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<TableRow> read_jobs_of_toml(const std::string& path) {
  const scene::TomlValue root = scene::read_toml(path);
  std::vector<TableRow> rows;
  for (const scene::TomlValue& value : scene::table_of(root).values) {
    if (value.key != "job")
      throw Error(ErrorKind::input, value.key_where, "unknown key '" + value.key + "'",
                  "a table of jobs has only [[job]]");
    for (const scene::TomlValue* job : scene::tables_of(value)) {
      TableRow row{job->where, {}};
      for (const scene::TomlValue& cell : scene::table_of(*job).values) row.cells.emplace_back(cell.key, cell);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace

std::vector<TableRow> read_job_table(const std::string& path) {
  const bool is_toml = to_lower(std::filesystem::path(path).extension().string()) == ".toml";
  std::vector<TableRow> rows = is_toml ? read_jobs_of_toml(path) : read_csv(path);
  if (rows.empty())
    throw Error(ErrorKind::input, path, "has no jobs",
                is_toml ? "write a [[job]] for each" : "the first line names the columns, each further one is a job");
  return rows;
}

}  // namespace epura
