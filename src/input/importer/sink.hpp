// SPDX-License-Identifier: Apache-2.0
// Builds a document from the calls of an importer, and checks all their arguments.
#pragma once

#include <epura/importer_abi.h>

#include <functional>
#include <set>
#include <span>
#include <string>

#include "importer/imported_file.hpp"

namespace epura::importer {

class DocumentSink {
 public:
  /// `tell` receives the fraction that is done, from 0 to 1. With `takes_splines`, the curves of edges are wanted.
  explicit DocumentSink(std::function<void(double)> tell, bool takes_splines = false);
  DocumentSink(const DocumentSink&) = delete;
  DocumentSink& operator=(const DocumentSink&) = delete;

  /// The table of calls for the importer; it refers to this object.
  [[nodiscard]] const epura_sink& calls() const { return calls_; }
  /// The first invalid call of the importer; empty if there is none.
  [[nodiscard]] const std::string& fault() const { return fault_; }
  [[nodiscard]] ImportedFile& document() { return document_; }
  /// Lets all further calls fail.
  void end() { fault_ = "comes too late"; }

 private:
  int unit(double millimetres);
  int up(char axis);
  int shape(const char* name);
  int body(const char* name);
  int points(uint64_t count, const double* xyz);
  int face(const epura_face* face);
  int polygons(uint64_t count, const uint64_t* ends, const uint32_t* corners);
  int edge(const epura_edge* edge);
  int node(const epura_node* node);
  int note(const char* sentence);
  int progress(double done);
  int rounding(uint32_t kinds);
  int colour(double red, double green, double blue);
  int step(double distance);
  int requirement(const epura_requirement* requirement);
  int saved_view(const epura_saved_view* view);
  int standard(const char* name);
  int spline(const epura_spline* spline);

  template <auto member, class... A>
  static int call(void* host, A... arguments) noexcept;
  Shape& current();
  void expect_points(uint64_t count, const uint32_t* numbers, const char* what);
  void expect_fewer(std::size_t items) const;

  enum class Begun { nothing, node, shape, body };  ///< what began last

  ImportedFile document_;
  std::function<void(double)> tell_;
  std::string fault_;
  Begun begun_ = Begun::nothing;
  std::span<const int> edge_;  ///< the points of the edge or wire that was handed over last, until it has a curve
  bool is_wire_ = false;
  std::set<std::string> ids_;  ///< of requirements
  epura_sink calls_;
};

}  // namespace epura::importer
