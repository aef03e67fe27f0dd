// SPDX-License-Identifier: Apache-2.0
#include "step_notes.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "../words.hpp"
#include "measures.hpp"
#include "requirements.hpp"

namespace occt {

namespace {

bool is_picture(std::string_view keyword) {
  return keyword == "DRAUGHTING_CALLOUT" ||
         (keyword.find("ANNOTATION_") != std::string_view::npos && keyword.ends_with("OCCURRENCE"));
}

class NoteReader {
 public:
  NoteReader(const StepGraph& graph, const RequirementIndex& index, std::size_t& items_left)
      : graph_(graph), index_(index), items_left_(items_left) {
    for (const auto& [number, statement] : graph_.statements())
      if (const Record* callout = record_of(statement, "DRAUGHTING_CALLOUT"))
        for (const EntityNumber part : references_in(argument_of(*callout, 1))) parts_.insert(part);
  }

  Notes read() {
    Notes notes;
    notes.wordless.length_unit = length_unit_in(graph_);
    for (const auto& [number, statement] : graph_.statements()) {
      Requirement note;
      if (has_record(statement, is_picture) && parts_.count(number) == 0) {
        const bool may_be_lost = !read_picture(number, statement, note) && is_whole(statement);
        if (may_be_lost && note.text.empty()) notes.wordless.annotations.push_back(number);
      } else if (const Record* property = record_of(statement, "PROPERTY_DEFINITION")) {
        read_property(number, *property, note);
      }
      if (note.text.empty()) continue;
      note.kind = EPURA_NOTE;
      note.id = "#" + std::to_string(number);
      note.type = "note";
      note.length_unit = notes.wordless.length_unit;
      notes.all.push_back(std::move(note));
    }
    return notes;
  }

 private:
  void add_items(EntityNumber aspect, Requirement& note) {
    const std::vector<EntityNumber> items = items_of(index_, aspect, items_left_);
    note.items.insert(note.items.end(), items.begin(), items.end());
  }

  // Where a file has callouts, annotations beside them are parts of such, too.
  [[nodiscard]] bool is_whole(const Statement& picture) const {
    return parts_.empty() || record_of(picture, "DRAUGHTING_CALLOUT") != nullptr;
  }

  // A callout and the annotations of which it consists have their words as properties or as letters. Returns whether
  // they show a requirement.
  bool read_picture(EntityNumber number, const Statement& picture, Requirement& note) {
    std::vector<EntityNumber> all{number};
    if (const Record* callout = record_of(picture, "DRAUGHTING_CALLOUT")) {
      note.name = unquoted(argument_of(*callout, 0));
      for (const EntityNumber part : references_in(argument_of(*callout, 1))) all.push_back(part);
    }
    std::set<EntityNumber> about;
    for (const EntityNumber one : all)
      for (const EntityNumber shown : listed(index_.shown, one)) about.insert(shown);
    if (std::any_of(about.begin(), about.end(), [this](EntityNumber one) { return is_requirement(one); })) return true;
    for (const EntityNumber one : all)
      for (const EntityNumber property : listed(index_.properties, one)) append(note.text, words_in(property), " ");
    if (note.text.empty())
      for (const EntityNumber one : all) append(note.text, letters_of(one), " ");
    // The words may be those of the aspect alone, or again.
    const bool is_again = std::any_of(about.begin(), about.end(), [&](EntityNumber aspect) {
      const std::vector<EntityNumber>& properties = listed(index_.properties, aspect);
      return std::any_of(properties.begin(), properties.end(), [&](EntityNumber property) {
        const std::string words = words_in(property);
        return !words.empty() && (note.text.empty() || words == note.text);
      });
    });
    if (is_again) note.text.clear();
    if (!note.text.empty())
      for (const EntityNumber aspect : about) add_items(aspect, note);
    return is_again;
  }

  // Of an aspect of the shape, or of the product.
  void read_property(EntityNumber number, const Record& property, Requirement& note) {
    const EntityNumber about = reference_in(argument_of(property, 2));
    const Statement* statement = graph_.find(about);
    if (statement != nullptr && (has_record(*statement, is_picture) || is_requirement(about))) return;
    note.name = unquoted(argument_of(property, 0));
    note.text = words_in(number);
    if (!note.text.empty()) add_items(about, note);
  }

  [[nodiscard]] bool is_requirement(EntityNumber number) const {
    const Statement* statement = graph_.find(number);
    return statement != nullptr &&
           (has_record(*statement, is_dimension) || has_record(*statement, is_tolerance) ||
            has_record(*statement, is_datum) || record_of(*statement, "DATUM_FEATURE") != nullptr);
  }

  // Whether it is called a note, or belongs to an aspect that is.
  [[nodiscard]] bool is_note(const Record& property) const {
    const Statement* about = graph_.find(reference_in(argument_of(property, 2)));
    const Record* aspect = about == nullptr ? nullptr : record_of(*about, "SHAPE_ASPECT");
    return epura::plugin::names_words(unquoted(argument_of(property, 0))) ||
           (aspect != nullptr && epura::plugin::names_words(unquoted(argument_of(*aspect, 1))));
  }

  // The words that a property is; empty if it is none.
  [[nodiscard]] std::string words_in(EntityNumber number) const {
    const Statement* statement = graph_.find(number);
    const Record* property = statement == nullptr ? nullptr : record_of(*statement, "PROPERTY_DEFINITION");
    const bool is_named = property != nullptr && is_note(*property);
    std::string words;
    for (const EntityNumber representation : listed(index_.representations, number)) {
      const Statement* whole = graph_.find(representation);
      const Record* list = whole == nullptr ? nullptr : record_of(*whole, "REPRESENTATION");
      if (list == nullptr) continue;
      for (const EntityNumber item : references_in(argument_of(*list, 1))) {
        const Statement* text = graph_.find(item);
        const Record* record = text == nullptr ? nullptr : record_of(*text, "DESCRIPTIVE_REPRESENTATION_ITEM");
        if (record != nullptr && (is_named || epura::plugin::names_words(unquoted(argument_of(*record, 0)))))
          append(words, unquoted(argument_of(*record, 1)), " ");
      }
    }
    return words;
  }

  // What an annotation consists of at the end: texts, or texts of texts. The border has texts of one line.
  [[nodiscard]] std::string letters_of(EntityNumber annotation) const {
    std::string letters;
    const auto find = [this](EntityNumber number) { return graph_.find(number); };
    visit_parts(annotation, find, [&](EntityNumber owner, const Record& record) {
      if (record.keyword == "TEXT_LITERAL" || record.keyword.starts_with("TEXT_LITERAL_WITH")) {
        const std::string second = unquoted(argument_of(record, 1));
        append(letters, second.empty() ? unquoted(argument_of(record, 0)) : second, " ");
        return false;
      }
      return owner == annotation || record.keyword.starts_with("COMPOSITE_TEXT");
    });
    return letters;
  }

  const StepGraph& graph_;
  const RequirementIndex& index_;
  std::size_t& items_left_;
  std::set<EntityNumber> parts_{};  ///< annotations of callouts
};

}  // namespace

Notes notes_in_step(const StepGraph& graph, const RequirementIndex& index, std::size_t& items_left) {
  return NoteReader(graph, index, items_left).read();
}

}  // namespace occt
