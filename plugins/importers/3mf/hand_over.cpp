// SPDX-License-Identifier: Apache-2.0
#include "hand_over.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "../words.hpp"

namespace epura::plugin::threemf {

namespace {

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

/// What is not drawn.
struct LeftOut {
  std::map<Role, std::size_t> pieces{};
  std::map<std::string, std::size_t> unread{};  ///< objects by what they are made of
  std::size_t beams = 0, slices = 0, degenerate = 0, repeated = 0;

  void tell(Sink& sink) const {
    tell_roles(sink);
    for (const auto& [what, count] : unread)
      sink.note(counted(count, "object is", "objects are") + " made of '" + what + "', which is not read");
    if (beams > 0) sink.note(counted(beams, "beam", "beams") + " of lattices are not drawn");
    if (slices > 0) sink.note("slices are not drawn");
    if (degenerate > 0) sink.note(counted(degenerate, "triangle", "triangles") + " with two equal corners left out");
    if (repeated > 0)
      sink.note(counted(repeated, "part stands", "parts stand") + " in the place of the same part: drawn once");
  }

 private:
  [[nodiscard]] std::size_t count(Role role) const {
    const auto found = pieces.find(role);
    return found == pieces.end() ? 0 : found->second;
  }

  void tell_roles(Sink& sink) const {
    struct Row {
      Role role;
      std::string_view one, many;
    };
    constexpr std::array<Row, 5> rows{{{Role::modifier, "modifier", "modifiers"},
                                       {Role::blocker, "support blocker", "support blockers"},
                                       {Role::enforcer, "support enforcer", "support enforcers"},
                                       {Role::support, "support", "supports"},
                                       {Role::other, "object of type 'other'", "objects of type 'other'"}}};
    std::string list;
    std::size_t all = 0;
    for (const Row& row : rows) {
      if (count(row.role) == 0) continue;
      list += (list.empty() ? "" : ", ") + counted(count(row.role), row.one, row.many);
      all += count(row.role);
    }
    if (all > 0) sink.note(list + (all == 1 ? " is no part" : " are no parts") + " of what is printed: left out");
    if (count(Role::negative) > 0)
      sink.note(counted(count(Role::negative), "negative volume is", "negative volumes are") +
                " left out: the slicer would cut such out of the parts, which are drawn whole");
  }
};

/// The triangles of one piece, with the points that they use.
class Mesh {
 public:
  explicit Mesh(const Object& object) : object_(object), numbers_(object.points.size(), EPURA_NONE) {}

  void add(Sink& sink, std::size_t first, std::size_t last, LeftOut& left_out) {
    std::vector<Triangle> triangles;
    std::vector<Point> points;
    for (std::size_t i = first; i <= last && i < object_.triangles.size(); ++i) {
      Triangle t = object_.triangles[i];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        ++left_out.degenerate;
        continue;
      }
      for (std::uint32_t& corner : t) {
        if (numbers_[corner] == EPURA_NONE) {
          numbers_[corner] = count_++;
          points.push_back(object_.points[corner]);
        }
        corner = numbers_[corner];
      }
      triangles.push_back(t);
    }
    sink.points(points);
    sink.triangles(triangles);
  }

 private:
  const Object& object_;
  std::vector<std::uint32_t> numbers_;  ///< of its points, in the order in which they are passed on
  std::uint32_t count_ = 0;
};

/// Positions objects according to items and components. Their levels have already been counted.
class Tree {
 public:
  Tree(const Model& model, Sink& sink) : model_(model), sink_(sink), shapes_(model.objects.size()) {}

  void add(const std::vector<Placed>& all, std::uint32_t parent) {
    std::set<std::pair<std::uint32_t, Transform>> seen;
    for (const Placed& placed : all) {
      const Role role = placed.role == Role::part ? model_.objects[placed.object].role : placed.role;
      if (role != Role::part)
        ++left_out_.pieces[role];
      else if (!seen.emplace(placed.object, placed.transform).second)
        ++left_out_.repeated;
      else
        add(placed, parent);
    }
  }

  [[nodiscard]] const LeftOut& left_out() const { return left_out_; }

 private:
  void add(const Placed& placed, std::uint32_t parent) {
    const Object& object = model_.objects[placed.object];
    const std::uint32_t shape = shape_of(placed.object);
    // Pieces have names of their own.
    const bool has_pieces = parts_of(object) > 1;
    const std::string& name = !placed.name.empty() ? placed.name : has_pieces ? std::string() : name_of(object);
    const std::uint32_t node = sink_.node(name, parent, shape, placed.transform);
    add(object.components, node);
  }

  static std::size_t parts_of(const Object& object) {
    return static_cast<std::size_t>(std::count_if(object.volumes.begin(), object.volumes.end(),
                                                  [](const Volume& volume) { return volume.role == Role::part; }));
  }

  static std::string name_of(const Object& object) {
    if (parts_of(object) != 1) return object.name;
    const auto part = std::find_if(object.volumes.begin(), object.volumes.end(),
                                   [](const Volume& volume) { return volume.role == Role::part; });
    return part->name.empty() ? object.name : part->name;
  }

  std::uint32_t shape_of(std::uint32_t number) {
    std::optional<std::uint32_t>& shape = shapes_[number];
    if (shape) return *shape;
    const Object& object = model_.objects[number];
    left_out_.beams += object.beams;
    left_out_.slices += object.has_slices ? 1 : 0;
    const bool is_empty = object.triangles.empty();
    if (is_empty && object.components.empty() && !object.unread.empty()) ++left_out_.unread[object.unread];
    shape = is_empty ? EPURA_NONE : sink_.shape(object.volumes.empty() ? object.name : std::string());
    if (is_empty) return *shape;
    if (object.colour) sink_.colour((*object.colour)[0], (*object.colour)[1], (*object.colour)[2]);
    add_pieces(object);
    return *shape;
  }

  void add_pieces(const Object& object) {
    Mesh mesh(object);
    const bool has_pieces = parts_of(object) > 1;
    std::size_t next = 0;  // triangle that no volume has had
    const auto add_rest = [&](std::size_t end) {
      if (next >= end) return;
      if (has_pieces) sink_.body(object.name);
      mesh.add(sink_, next, end - 1, left_out_);
      next = end;
    };
    for (const Volume& volume : object.volumes) {
      const std::size_t end = std::min(volume.last, object.triangles.size() - 1) + 1;
      add_rest(std::min(volume.first, end));
      if (volume.role != Role::part) {
        ++left_out_.pieces[volume.role];
      } else if (next < end) {
        if (has_pieces) sink_.body(volume.name);
        mesh.add(sink_, next, end - 1, left_out_);
      }
      next = std::max(next, end);
    }
    add_rest(object.triangles.size());
  }

  const Model& model_;
  Sink& sink_;
  LeftOut left_out_;
  std::vector<std::optional<std::uint32_t>> shapes_;
};

// For a model without build items: the objects that are not components.
std::vector<Placed> tops_of(const Model& model) {
  std::vector<char> is_component(model.objects.size(), 0);
  for (const Object& object : model.objects)
    for (const Placed& component : object.components) is_component[component.object] = 1;
  std::vector<Placed> tops;
  for (std::uint32_t object = 0; object < model.objects.size(); ++object)
    if (is_component[object] == 0) tops.push_back({object, identity});
  return tops;
}

}  // namespace

void hand_over(const Model& model, Sink& sink) {
  sink.unit(model.millimetres);
  sink.rounding(EPURA_SINGLE | EPURA_PRINTED);
  const bool builds = !model.items.empty();
  if (!builds) sink.note("builds nothing: all of its objects are drawn");
  Tree tree(model, sink);
  tree.add(builds ? model.items : tops_of(model), EPURA_NONE);
  tree.left_out().tell(sink);
  for (const auto& [place, text] : model.words) tell_words(sink, place, text);
}

}  // namespace epura::plugin::threemf
