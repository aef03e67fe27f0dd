// SPDX-License-Identifier: Apache-2.0
#include "step_graph.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

namespace occt {

namespace {

bool tells_of_requirements(std::string_view keyword) {
  constexpr std::array<std::string_view, 25> parts{"TOLERANCE",
                                                   "DIMENSION",
                                                   "DATUM",
                                                   "SHAPE_ASPECT",
                                                   "UNIT",
                                                   "MEASURE",
                                                   "QUALIF",
                                                   "FITS",
                                                   "ANGULAR",
                                                   "ITEM_SPECIFIC",
                                                   "ITEM_IDENTIFIED",
                                                   "REPRESENTATION_ITEM",
                                                   "PROPERTY_DEFINITION",
                                                   "SHAPE_DEFINITION",
                                                   "WITH_PARAMETERS",
                                                   "ANNOTATION_",
                                                   "CALLOUT",
                                                   "TEXT_LITERAL",
                                                   "COMPOSITE_TEXT",
                                                   "DRAUGHTING_MODEL_ITEM",
                                                   "ZONE_DEFINITION",
                                                   "SURFACE_TEXTURE",
                                                   "VALUE_RANGE",
                                                   "DOCUMENT",
                                                   "ROLE"};
  const bool is_one =
      keyword == "PRODUCT_DEFINITION_SHAPE" || keyword == "REPRESENTATION" || keyword.ends_with("ID_ATTRIBUTE");
  return is_one || std::any_of(parts.begin(), parts.end(),
                               [&](std::string_view part) { return keyword.find(part) != std::string_view::npos; });
}

void append_utf8(std::string& text, unsigned long code) {
  const auto byte = [&](unsigned long bits) { text += static_cast<char>(bits); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xc0 | code >> 6), byte(0x80 | (code & 0x3f));
  } else {
    byte(0xe0 | (code >> 12 & 0xf)), byte(0x80 | (code >> 6 & 0x3f)), byte(0x80 | (code & 0x3f));
  }
}

// Appends characters that are coded in `digits` hexadecimal digits each.
void append_coded(std::string& text, std::string_view coded, std::size_t digits) {
  for (std::size_t at = 0; at + digits <= coded.size(); at += digits) {
    unsigned long code = 0;
    const char* begin = coded.data() + at;
    if (std::from_chars(begin, begin + digits, code, 16).ptr != begin + digits) return;
    append_utf8(text, code);
  }
}

// What "\X2\00F8\X0\" and "\X\F8" stand for (ISO 10303-21, 6.4.3). Returns how many characters it takes; 0: it is none.
std::size_t decode(std::string_view text, std::string& to) {
  constexpr std::string_view wide = "\\X2\\", end = "\\X0\\", narrow = "\\X\\";
  if (text.substr(0, wide.size()) == wide) {
    const std::size_t close = std::min(text.find(end, wide.size()), text.size());
    append_coded(to, text.substr(wide.size(), close - wide.size()), 4);
    return std::min(close + end.size(), text.size());
  }
  if (text.substr(0, narrow.size()) != narrow || text.size() < narrow.size() + 2) return 0;
  append_coded(to, text.substr(narrow.size(), 2), 2);
  return narrow.size() + 2;
}

}  // namespace

StepGraph::StepGraph(std::string_view text) {
  visit_statements(text, [&](const Statement& statement) {
    if (has_record(statement, tells_of_requirements)) statements_.emplace(statement.number, statement);
  });
}

const Statement* StepGraph::find(EntityNumber number) const {
  const auto found = statements_.find(number);
  return found == statements_.end() ? nullptr : &found->second;
}

void visit_parts(EntityNumber root, const std::function<const Statement*(EntityNumber number)>& find,
                 const std::function<bool(EntityNumber owner, const Record& record)>& follows) {
  std::vector<EntityNumber> open{root};
  std::set<EntityNumber> seen{root};
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Statement* statement = find(open[i]);
    if (statement == nullptr) continue;
    for (const Record& record : statement->records) {
      if (!follows(statement->number, record)) continue;
      for (const EntityNumber part : references_in(record.arguments))
        if (seen.insert(part).second) open.push_back(part);
    }
  }
}

const Record* record_of(const Statement& statement, std::string_view keyword) {
  const auto found = std::find_if(statement.records.begin(), statement.records.end(),
                                  [&](const Record& record) { return record.keyword == keyword; });
  return found == statement.records.end() ? nullptr : &*found;
}

bool has_record(const Statement& statement, bool (*is_one)(std::string_view keyword)) {
  return std::any_of(statement.records.begin(), statement.records.end(),
                     [&](const Record& record) { return is_one(record.keyword); });
}

std::string_view argument_of(const Record& record, std::size_t place) {
  const std::vector<std::string_view> arguments = separated(record.arguments);
  return place < arguments.size() ? arguments[place] : std::string_view();
}

std::vector<EntityNumber> references_in(std::string_view text) {
  std::vector<EntityNumber> numbers;
  bool is_quoted = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\'') is_quoted = !is_quoted;
    if (is_quoted || text[at] != '#') continue;
    if (const EntityNumber number = reference_in(text.substr(at))) numbers.push_back(number);
  }
  return numbers;
}

std::string lower_case(std::string text) {
  for (char& c : text)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string words_of(std::string_view keyword) {
  std::string words = lower_case(std::string(keyword));
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::vector<std::string> enumerations_in(std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t at = text.find('.'); at != std::string_view::npos; at = text.find('.', at)) {
    const std::size_t end = text.find('.', at + 1);
    if (end == std::string_view::npos) break;
    const std::string_view name = text.substr(at + 1, end - at - 1);
    const bool is_name = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
      return ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_';
    });
    if (is_name) names.push_back(words_of(name));
    at = is_name ? end + 1 : end;
  }
  return names;
}

std::string unquoted(std::string_view text) {
  if (text.size() < 2 || text.front() != '\'' || text.back() != '\'') return {};
  text = text.substr(1, text.size() - 2);
  std::string plain;
  while (!text.empty()) {
    if (const std::size_t taken = decode(text, plain)) {
      text.remove_prefix(taken);
      continue;
    }
    plain += text.front();
    const bool is_double = text.substr(0, 2) == "''" || text.substr(0, 2) == "\\\\";
    text.remove_prefix(is_double ? 2 : 1);
  }
  return plain;
}

std::string_view last_argument_of(const Record& record) {
  const std::vector<std::string_view> arguments = separated(record.arguments);
  return arguments.empty() ? std::string_view() : arguments.back();
}

void append(std::string& list, std::string_view word, std::string_view between) {
  if (word.empty()) return;
  if (!list.empty()) list += between;
  list += word;
}

}  // namespace occt
