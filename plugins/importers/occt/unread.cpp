// SPDX-License-Identifier: Apache-2.0
#include "unread.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "model.hpp"
#include "part21.hpp"
#include "requirements.hpp"

namespace occt {

namespace {

enum class Thing { dimension, tolerance, datum, annotation, view, triangles, construction };

/// The order of the sentence.
constexpr std::array<std::pair<Thing, const char*>, 7> words{{{Thing::dimension, "dimension"},
                                                              {Thing::tolerance, "geometric tolerance"},
                                                              {Thing::datum, "datum"},
                                                              {Thing::annotation, "annotation"},
                                                              {Thing::view, "saved view"},
                                                              {Thing::triangles, "shape of triangles"},
                                                              {Thing::construction, "set of construction geometry"}}};

using Counts = std::map<Thing, std::size_t>;

std::string plural_of(std::size_t count, const std::string& thing) {
  if (count != 1 && thing.find(" of ") != std::string::npos)
    return std::to_string(count) + " " + thing.substr(0, thing.find(' ')) + "s" + thing.substr(thing.find(' '));
  return counted(count, thing);
}

std::string sentence_of(const Counts& counts) {
  std::vector<std::string> items;
  std::size_t all = 0;
  for (const auto& [thing, word] : words) {
    const auto found = counts.find(thing);
    if (found == counts.end() || found->second == 0) continue;
    items.push_back(plural_of(found->second, word));
    all += found->second;
  }
  std::string list;
  for (std::size_t i = 0; i < items.size(); ++i)
    list += (i == 0 ? "" : i + 1 < items.size() ? ", " : " and ") + items[i];
  return list.empty() ? list : list + " of the file " + (all == 1 ? "is" : "are") + " not drawn";
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// What says more of requirements than `requirements_in_step` reads.
bool is_unread_requirement(std::string_view keyword) {
  constexpr std::array<std::string_view, 7> parts{"ZONE_DEFINITION",
                                                  "ORIENTED_TOLERANCE_ZONE",
                                                  "SURFACE_TEXTURE",
                                                  "SURFACE_CONDITION",
                                                  "DEFAULT_TOLERANCE_TABLE",
                                                  "THREAD_FEATURE",
                                                  "EXTERNALLY_DEFINED_DIMENSION"};
  return std::any_of(parts.begin(), parts.end(),
                     [&](std::string_view part) { return keyword.find(part) != std::string_view::npos; });
}

bool is_of_triangles(std::string_view keyword) {
  return keyword == "TESSELLATED_SOLID" || keyword == "TESSELLATED_SHELL";
}

bool is_body(std::string_view keyword) {
  return ends_with(keyword, "_BREP") || keyword == "BREP_WITH_VOIDS" || keyword == "SHELL_BASED_SURFACE_MODEL";
}

/// Goes through the statements of a STEP file. Dimensions, tolerances, datums and saved views are read elsewhere.
class StepCounter {
 public:
  explicit StepCounter(const std::set<EntityNumber>& read) : read_(read) {}

  void see(const Statement& statement) {
    std::set<Thing> things;
    for (const Record& record : statement.records) {
      if (const Thing* thing = thing_of(record.keyword)) things.insert(*thing);
      if (is_unread_requirement(record.keyword) && read_.count(statement.number) == 0)
        ++unread_[std::string(record.keyword)];
      if (record.keyword == "PRESENTATION_LAYER_ASSIGNMENT") layers_.insert(statement.number);
      if (record.keyword == "INVISIBILITY") note_hidden(record.arguments);
      if (is_body(record.keyword)) bodies_.insert(statement.number);
      if (ends_with(record.keyword, "STYLED_ITEM")) note_styled(statement.number, record.arguments);
    }
    for (const Thing thing : things) ++counts_[thing];
  }

  [[nodiscard]] std::vector<std::string> sentences() const {
    std::vector<std::string> sentences;
    if (std::string sentence = sentence_of(counts_); !sentence.empty()) sentences.push_back(std::move(sentence));
    std::string unread;
    for (const auto& [keyword, count] : unread_)
      unread += (unread.empty() ? "" : ", ") + std::to_string(count) + " " + keyword;
    if (!unread.empty()) sentences.push_back("not read of what the file requires: " + unread);
    std::size_t layers = 0, bodies = 0;
    for (const unsigned long long item : hidden_) {
      layers += layers_.count(item);
      const auto styled = styled_.find(item);
      bodies += styled == styled_.end() ? 0 : bodies_.count(styled->second);
    }
    if (layers > 0)
      sentences.push_back(counted(layers, "layer") + (layers == 1 ? " is" : " are") +
                          " switched off in the file, which is not heeded");
    if (bodies > 0)
      sentences.push_back(std::to_string(bodies) + (bodies == 1 ? " body is" : " bodies are") +
                          " hidden in the file, but drawn");
    return sentences;
  }

 private:
  const Thing* thing_of(std::string_view keyword) {
    static constexpr std::array<std::pair<std::string_view, Thing>, 1> exact{
        {{"CONSTRUCTIVE_GEOMETRY_REPRESENTATION", Thing::construction}}};
    static constexpr Thing triangles = Thing::triangles;
    if (is_of_triangles(keyword)) return &triangles;
    const auto found = std::find_if(exact.begin(), exact.end(), [&](const auto& row) { return row.first == keyword; });
    return found == exact.end() ? nullptr : &found->second;
  }

  void note_hidden(std::string_view arguments) {
    for (const std::string_view list : arguments_of(arguments))
      for (const std::string_view item : arguments_of(list)) hidden_.insert(reference_in(item));
  }

  // The last argument is what has the style.
  void note_styled(unsigned long long number, std::string_view arguments) {
    for (const std::string_view argument : arguments_of(arguments))
      if (const unsigned long long item = reference_in(argument)) styled_.insert_or_assign(number, item);
  }

  const std::set<EntityNumber>& read_;
  Counts counts_{};
  std::map<std::string, std::size_t> unread_{};  ///< entities that say more of requirements
  std::set<unsigned long long> layers_{}, hidden_{}, bodies_{};
  std::map<unsigned long long, unsigned long long> styled_{};  ///< what styled items style
};

}  // namespace

std::vector<std::string> unread_in_step(std::string_view text, const std::set<EntityNumber>& read) {
  StepCounter counter(read);
  visit_statements(text, [&](const Statement& statement) { counter.see(statement); });
  return counter.sentences();
}

std::string unread_shapes_in_step(std::string_view text) {
  std::string of_triangles, bare;
  visit_statements(text, [&](const Statement& statement) {
    for (const Record& record : statement.records) {
      if (is_of_triangles(record.keyword)) of_triangles = record.keyword;
      if (record.keyword == "FACE") bare = "#" + std::to_string(statement.number);
    }
  });
  if (!of_triangles.empty())
    return "its shapes are triangles (" + of_triangles +
           "), which are not read: export it with exact surfaces, or as 3MF, STL or OBJ";
  if (!bare.empty())
    return "its faces have no surfaces (" + bare + "=FACE), and such are not read: export it as 3MF, STL or OBJ";
  return {};
}

// In section D, each entity has two lines of 80 columns, of which the first begins with its type.
std::vector<std::string> unread_in_iges(std::string_view text) {
  constexpr std::size_t section = 72, width = 8;
  Counts counts;
  bool is_first = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(text.find_first_not_of("\r\n", end), text.size()));
    if (line.size() <= section || line[section] != 'D') continue;
    if (std::exchange(is_first, !is_first)) {
      const std::string_view field = line.substr(0, width);
      const std::size_t begin = std::min(field.find_first_not_of(' '), field.size());
      int type = 0;
      std::from_chars(field.data() + begin, field.data() + field.size(), type);
      // IGES 5.3, table 3: 202 to 222 are dimensions, labels, notes and leaders; 410 a view, 404 a drawing.
      constexpr std::array dimensions{202, 206, 216, 218, 220, 222}, annotations{208, 210, 212, 213, 228, 230};
      const auto is_in = [&](const auto& types) { return std::find(types.begin(), types.end(), type) != types.end(); };
      if (is_in(dimensions)) ++counts[Thing::dimension];
      if (is_in(annotations)) ++counts[Thing::annotation];
      if (type == 410) ++counts[Thing::view];
    }
  }
  const std::string sentence = sentence_of(counts);
  return sentence.empty() ? std::vector<std::string>() : std::vector{sentence};
}

}  // namespace occt
