// SPDX-License-Identifier: Apache-2.0
#include "output/pdf/packing.hpp"

#include <algorithm>
#include <cctype>
#include <qpdf/Pipeline.hh>
#include <qpdf/Pl_Flate.hh>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"

namespace epura::output {

namespace {

constexpr const char* hint = "epura compares only PDF files that it wrote itself";

// Stores or counts the incoming bytes, and stops the stream if there are too many.
class Basin : public Pipeline {
 public:
  Basin(std::size_t room, bool keeps) : Pipeline("basin", nullptr), room_(room), keeps_(keeps) {}

  void write(const unsigned char* data, std::size_t length) override {
    overflows_ = overflows_ || length > room_;
    if (overflows_) throw std::runtime_error("too much");  // qpdf stops reading, and does not pass this on
    room_ -= length;
    if (keeps_) bytes_.append(reinterpret_cast<const char*>(data), length);
  }
  void finish() override {}

  [[nodiscard]] bool overflows() const { return overflows_; }
  [[nodiscard]] std::size_t room() const { return room_; }
  std::string take() { return std::move(bytes_); }

 private:
  std::size_t room_;
  bool keeps_, overflows_ = false;
  std::string bytes_;
};

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\f' || c == '\0'; }

bool ends_name(char c) { return is_blank(c) || std::string("()<>[]{}/%").find(c) != std::string::npos; }

// A part of a file from one stream to the next, searched for names at any position.
class Names {
 public:
  Names(const std::string& file, std::size_t begin, std::size_t end) : file_(file), at_(begin), end_(end) {}

  /// The next name without its slash, with "#69" decoded; false if there is none.
  bool next(std::string& name) {
    at_ = std::min(file_.find('/', at_), end_);
    if (at_ == end_) return false;
    name.clear();
    for (++at_; at_ < end_ && !ends_name(file_[at_]); ++at_) name += character();
    return true;
  }

  // The position after the name.
  [[nodiscard]] std::size_t place() const { return at_; }
  void pass_blanks() {
    while (at_ < end_ && is_blank(file_[at_])) ++at_;
  }
  bool pass(const std::string& text) {
    pass_blanks();
    if (file_.compare(at_, text.size(), text) != 0) return false;
    at_ += text.size();
    return true;
  }
  bool pass_number() {
    pass_blanks();
    const std::size_t begin = at_;
    while (at_ < end_ && std::isdigit(static_cast<unsigned char>(file_[at_])) != 0) ++at_;
    return at_ > begin;
  }
  [[nodiscard]] bool at_end_of_name() const { return at_ >= end_ || ends_name(file_[at_]); }
  // False in a reference to another object, such as 12 0 R.
  bool at_end_of_value() {
    pass_blanks();
    return at_ >= end_ || file_[at_] == '/' || file_[at_] == '>';
  }

 private:
  char character() {
    const auto digit = [&](std::size_t at) {
      const char c = at < end_ ? file_[at] : ' ';
      return c >= '0' && c <= '9'   ? c - '0'
             : c >= 'A' && c <= 'F' ? c - 'A' + 10
             : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                    : -1;
    };
    const int high = digit(at_ + 1), low = digit(at_ + 2);
    if (file_[at_] != '#' || high < 0 || low < 0) return file_[at_];
    at_ += 2;
    return static_cast<char>(16 * high + low);
  }

  const std::string& file_;
  std::size_t at_, end_;
};

// Values of at most 999.
bool are_short_rows(Names& names) {
  if (!names.pass("<<")) return false;
  while (names.pass("/Columns") || names.pass("/Predictor")) {
    const std::size_t begin = names.place();
    if (!names.pass_number() || names.place() - begin > 4 || !names.at_end_of_value()) return false;
  }
  return names.pass(">>");
}

// Whether epura writes this after such a name, and directly instead of in another object, which qpdf would look up at
// once.
bool is_usual(const std::string& name, Names& names) {
  if (name == "Filter") return names.pass("/FlateDecode") && names.at_end_of_name();
  if (name == "DecodeParms") return are_short_rows(names);
  if (name == "Length") return names.pass_number() && names.at_end_of_value();
  return name != "Encrypt";
}

// Whether the stream with this dictionary is a table of objects.
bool check_head(const std::string& file, std::size_t begin, std::size_t end, const std::string& where) {
  bool is_table = false;
  Names names(file, begin, end);
  for (std::string name; names.next(name);) {
    if (!is_usual(name, names))
      throw Error(ErrorKind::input, where, "is packed in a way that epura does not use", hint);
    is_table = is_table || name == "XRef";
  }
  return is_table;
}

}  // namespace

void UnpackRoom::refuse() const {
  throw Error(ErrorKind::input, where_, "unpacks to more than " + std::to_string(max_ / 1'000'000) + " MB",
              "a drawing of this file size is smaller");
}

std::string UnpackRoom::unpack(QPDFObjectHandle stream) {
  Basin basin(left_, true);
  const bool whole = stream.pipeStreamData(&basin, 0, qpdf_dl_specialized, true, false);
  if (basin.overflows()) refuse();
  if (!whole) throw Error(ErrorKind::input, where_, "has a stream that cannot be unpacked", "is the file complete?");
  left_ = basin.room();
  return basin.take();
}

void UnpackRoom::measure(const std::string& file, std::size_t at) {
  Basin basin(left_, false);
  Pl_Flate flate("flate", &basin, Pl_Flate::a_inflate);
  try {
    flate.write(reinterpret_cast<const unsigned char*>(file.data() + at), file.size() - at);
    flate.finish();
  } catch (const std::exception&) {
    if (basin.overflows()) refuse();  // qpdf reports other errors
  }
  left_ = basin.room();
}

void check_packing(const std::string& file, const std::string& where) {
  static const std::string word = "stream";
  UnpackRoom room(1'000'000 + file.size() / 4, where);
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(file.find(word, begin), file.size());
    const bool is_table = check_head(file, begin, end, where);
    if (end == file.size()) return;
    begin = end + word.size();
    while (is_table && begin < file.size() && is_blank(file[begin])) ++begin;  // Flate data never begin with a blank
    if (is_table) room.measure(file, begin);
  }
}

void check_object_streams(QPDF& pdf, std::size_t bytes, const std::string& where) {
  const auto table = pdf.getXRefTable();
  std::set<QPDFObjGen> holders;
  for (const auto& [object, entry] : table)
    if (entry.getType() == 2) holders.emplace(entry.getObjStreamNumber(), 0);
  UnpackRoom room(2'000'000 + bytes, where);
  for (const QPDFObjGen& holder : holders) {
    const auto place = table.find(holder);
    // An object stream inside another one would be read before it is examined.
    if (place == table.end() || place->second.getType() != 1 || !pdf.getObject(holder).isStream())
      throw Error(ErrorKind::input, where, "is not a readable PDF: it lacks objects", hint);
    room.unpack(pdf.getObject(holder));
  }
}

}  // namespace epura::output
