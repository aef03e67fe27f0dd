// SPDX-License-Identifier: Apache-2.0
// C++ wrapper of importer_abi.h: header-only, compiled into the plugin, so that only C crosses the interface.
//
// An importer is a struct with name, summary, extensions, optionally a table `parameters`, and
//   static void read(const Source&, Sink&)
// and, if its files can be recognised by their first bytes, static bool recognises(std::string_view first_bytes). If a
// file cannot be read, throw std::runtime_error with a message for the user. EPURA_IMPORTER(Struct) defines the
// library's entry point for one importer, EPURA_IMPORTERS(A, B...) for several.
#pragma once

#include <epura/importer_abi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <epura/parameter_rows.hpp>
#include <exception>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace epura::plugin {

/// Thrown by a sink if the host stops the reading; importers need not catch it.
struct Cancelled {};

using Point = std::array<double, 3>;

/// The rows of a 3x4 matrix that maps points of a node to its parent.
using Transform = std::array<double, 12>;
inline constexpr Transform identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

/// The file to read, and the required precision: see epura_source.
struct Source {
  std::string path;
  unsigned threads = 1;
  double tolerance = 0, relative_tolerance = 0;
  const double* values = nullptr;  ///< values of the parameters
  bool may_leave = false;          ///< the file may refer to files outside its folder

  /// Returns the permitted deviation from curved surfaces in mm, for a model whose box has this diagonal in mm.
  [[nodiscard]] double tolerance_of(double diagonal) const {
    const double relative = relative_tolerance * diagonal;
    return tolerance > 0 && (tolerance < relative || relative == 0) ? tolerance : relative;
  }
};

/// Receives the content of the file: see epura_sink.
class Sink {
 public:
  explicit Sink(const epura_sink& sink) : sink_(sink) {}

  void unit(double millimetres) { expect(sink_.unit(sink_.host, millimetres)); }
  void up(char axis) { expect(sink_.up(sink_.host, axis)); }
  /// EPURA_SINGLE, EPURA_PRINTED or both.
  void rounding(std::uint32_t kinds) { expect(sink_.rounding(sink_.host, kinds)); }
  /// Returns its number.
  std::uint32_t shape(const std::string& name) {
    expect(sink_.shape(sink_.host, name.c_str()));
    return shapes_++;
  }
  void body(const std::string& name) { expect(sink_.body(sink_.host, name.c_str())); }
  void points(std::span<const Point> points) {
    expect(sink_.points(sink_.host, points.size(), points.empty() ? nullptr : points.front().data()));
  }
  void face(epura_face face) {
    face.size = sizeof face;
    expect(sink_.face(sink_.host, &face));
  }
  void polygons(std::span<const std::uint64_t> ends, std::span<const std::uint32_t> corners) {
    expect(sink_.polygons(sink_.host, ends.size(), ends.data(), corners.data()));
  }
  void triangles(std::span<const std::array<std::uint32_t, 3>> corners) {
    std::vector<std::uint64_t> ends(corners.size());
    for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = 3 * (i + 1);
    polygons(ends, {corners.empty() ? nullptr : corners.front().data(), 3 * corners.size()});
  }
  /// `angle` is in degrees, between the normals of the faces.
  void edge(std::span<const std::uint32_t> vertices, bool is_tangent,
            double angle = std::numeric_limits<double>::quiet_NaN()) {
    tell_edge(vertices, is_tangent ? EPURA_TANGENT : EPURA_SHARP, angle);
  }
  /// Adds a line that bounds no face, through these points.
  void wire(std::span<const std::uint32_t> vertices) {
    tell_edge(vertices, EPURA_WIRE, std::numeric_limits<double>::quiet_NaN());
  }
  /// Adds a point that belongs to no face or line.
  void point(std::uint32_t vertex) { tell_edge({&vertex, 1}, EPURA_POINT, std::numeric_limits<double>::quiet_NaN()); }
  /// Returns its number.
  std::uint32_t node(const std::string& name, std::uint32_t parent = EPURA_NONE, std::uint32_t shape = EPURA_NONE,
                     const Transform& transform = identity) {
    epura_node node{sizeof(epura_node), parent, shape, 0, name.c_str(), {}};
    for (std::size_t i = 0; i < transform.size(); ++i) node.transform[i] = transform[i];
    expect(sink_.node(sink_.host, &node));
    return nodes_++;
  }
  /// Of the node, body or shape that began last; sRGB, each from 0 to 1. Older hosts ignore it.
  void colour(double red, double green, double blue) {
    if (sink_.size >= offsetof(epura_sink, colour) + sizeof sink_.colour)
      expect(sink_.colour(sink_.host, red, green, blue));
  }
  /// Of coordinates of the current shape. Older hosts ignore it.
  void step(double distance) {
    if (sink_.size >= offsetof(epura_sink, step) + sizeof sink_.step) expect(sink_.step(sink_.host, distance));
  }
  /// Whether the host takes requirements. Older ones do not.
  [[nodiscard]] bool takes_requirements() const {
    return sink_.size >= offsetof(epura_sink, requirement) + sizeof sink_.requirement;
  }
  /// Older hosts ignore it.
  void requirement(epura_requirement requirement) {
    requirement.size = sizeof requirement;
    if (takes_requirements()) expect(sink_.requirement(sink_.host, &requirement));
  }
  /// A view that the file has stored. Older hosts ignore it.
  void saved_view(epura_saved_view view) {
    view.size = sizeof view;
    if (sink_.size >= offsetof(epura_sink, saved_view) + sizeof sink_.saved_view)
      expect(sink_.saved_view(sink_.host, &view));
  }
  /// By which dimensions and tolerances are to be understood. Older hosts ignore it.
  void standard(const std::string& name) {
    if (sink_.size >= offsetof(epura_sink, standard) + sizeof sink_.standard)
      expect(sink_.standard(sink_.host, name.c_str()));
  }
  /// Whether the host takes splines. Most have no use for them.
  [[nodiscard]] bool takes_splines() const {
    return sink_.size >= offsetof(epura_sink, spline) + sizeof sink_.spline && sink_.spline != nullptr;
  }
  /// The curve of the edge or wire that was handed over last. Other hosts ignore it.
  void spline(epura_spline spline) {
    spline.size = sizeof spline;
    if (takes_splines()) expect(sink_.spline(sink_.host, &spline));
  }
  void note(const std::string& sentence) { expect(sink_.note(sink_.host, sentence.c_str())); }
  void progress(double done) { expect(sink_.progress(sink_.host, done)); }

 private:
  void tell_edge(std::span<const std::uint32_t> vertices, std::uint32_t kind, double angle) {
    const epura_edge edge{sizeof(epura_edge), kind, angle, vertices.size(), vertices.data()};
    expect(sink_.edge(sink_.host, &edge));
  }
  static void expect(int answer) {
    if (answer != 0) throw Cancelled{};
  }

  const epura_sink& sink_;
  std::uint32_t shapes_ = 0, nodes_ = 0;
};

namespace importer {

template <class I>
int recognises(const unsigned char* bytes, std::uint64_t count) noexcept {
  try {
    return I::recognises(std::string_view(reinterpret_cast<const char*>(bytes), count)) ? 1 : 0;
  } catch (...) {
    return 0;
  }
}

/// Calls `read` with what the host gave, and returns the sentence if it fails.
template <class Read>
const char* answer(const epura_source* source, const epura_sink* sink, const Read& read) noexcept {
  static thread_local std::string sentence;
  try {
    Sink to(*sink);
    // An older host has a shorter source.
    const bool may_leave = source->size >= sizeof(epura_source) && source->may_leave != 0;
    read(Source{source->path != nullptr ? source->path : "", source->threads, source->tolerance,
                source->relative_tolerance, source->values, may_leave},
         to);
    return nullptr;
  } catch (const std::exception& error) {
    sentence = error.what();
  } catch (const Cancelled&) {
    sentence = "is cancelled";
  } catch (...) {
    sentence = "threw something that is no std::exception";
  }
  return sentence.c_str();
}

template <class I>
const char* read(const epura_source* source, const epura_sink* sink) noexcept {
  return answer(source, sink, &I::read);
}

template <class I>
constexpr epura_importer describe() {
  epura_importer row{sizeof(epura_importer), 0, I::name, I::summary, I::extensions, nullptr, 0, nullptr, &read<I>};
  if constexpr (requires { I::parameters; }) {
    row.parameters = I::parameters.data();
    row.parameter_count = I::parameters.size();
  }
  if constexpr (requires { I::recognises(std::string_view()); }) row.recognises = &recognises<I>;
  return row;
}

template <class... I>
const epura_importer_list* list() {
  static constexpr std::array<epura_importer, sizeof...(I)> rows{describe<I>()...};
  static constexpr epura_importer_list all{EPURA_IMPORTER_ABI_VERSION, sizeof(epura_importer_list), rows.size(),
                                           rows.data()};
  return &all;
}

}  // namespace importer
}  // namespace epura::plugin

#define EPURA_IMPORTERS(...) \
  const epura_importer_list* epura_importers_v1(void) { return epura::plugin::importer::list<__VA_ARGS__>(); }
#define EPURA_IMPORTER(importer) EPURA_IMPORTERS(importer)
