// SPDX-License-Identifier: Apache-2.0
// Finds where ink is required and where it is allowed along one line of the page.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "verify/fold_rule.hpp"
#include "verify/slice.hpp"

namespace epura::verify {

/// An interval of the line over which one piece is in front.
struct SeenPart {
  double from, to;
  int piece;  ///< of the slice
};

/// Returns the parts in ascending order; where nothing is seen, there is none. Merges halves (Hershberger, Finding the
/// upper envelope of n line segments in O(n log n) time, IPL 1989, without its refinement). Of two equal pieces, the
/// first wins.
std::vector<SeenPart> upper_envelope(const Slice& slice);

/// A position that requires a line.
struct LineMark {
  double u;                      ///< position along the line, mm
  bool jump;                     ///< whether something lies far behind; otherwise two faces meet or cross
  std::array<int, 2> edge;       ///< of the mesh, as vertices of the world; {-1, -1} where two faces cross
  std::array<int, 2> triangles;  ///< seen to the left and right of the position; -1: nothing
};

/// Where a line crosses an edge of the mesh.
struct EdgePlace {
  std::array<int, 2> edge;
  double t;           ///< in space, 0 to 1
  int triangle = -1;  ///< through which the line leads to it; -1: it begins there
};

/// An edge of the mesh that a line crosses.
struct MetEdge {
  std::array<int, 2> edge;
  bool is_seen;
  int front;  ///< where the surface turns away from the viewer, its triangle that is nearer to the viewer; otherwise -1
  std::vector<EdgePlace> path{};  ///< there: the edges that the line crosses on the surface around it
};

/// What is found near a position of a line, whoever asks for it.
struct Around {
  std::vector<MetEdge> edges;
  bool is_vague = false;                             ///< rounding makes positions uncertain
  bool at_limit = false;                             ///< a depth limit ends a surface that is seen
  bool wire = false;                                 ///< a line of a file
  bool seen_crossing = false, any_crossing = false;  ///< two surfaces cross or touch: what is seen, or behind it
};

/// What may meet one line: numbers of the world.
struct MetByLine {
  std::span<const int> triangles, wires;
};

/// Lengths in mm.
struct MarkLimits {
  double reach;    ///< positions closer together than this are one
  double quantum;  ///< the step to which the page is rounded
  double contact;  ///< Tolerance::contact
};

class LineMarks {
 public:
  LineMarks(const ScanScene& scene, const FoldRule& rule, const ScanLine& line, const MarkLimits& limits,
            const MetByLine& met);

  [[nodiscard]] std::vector<LineMark> asked() const;
  /// Positions at which the depth of what is seen jumps at an edge of the mesh, whether the surface goes on behind it
  /// or not.
  [[nodiscard]] std::vector<LineMark> jumps() const;
  [[nodiscard]] Around around(double u, double reach) const;
  /// Whether a line of some kind is permitted within `reach` mm of a position. The kind matters in two respects: a line
  /// within a surface may lie at any edge, and the position of an intersection of faces that hardly cross is uncertain.
  [[nodiscard]] bool allows(EdgeKind kind, double u, double reach) const;
  /// Whether two edges are the long sides of one needle that the line crosses, so that they represent one line.
  [[nodiscard]] bool same_line(const std::array<int, 2>& first, const std::array<int, 2>& second, double u,
                               double reach) const;

 private:
  struct Beyond {
    int triangle = -1;   ///< -1: unknown
    bool right = false;  ///< to the right of the crossing at which it is entered; otherwise to the left
  };

  // A position at which what is seen changes, with the pieces on both sides; -1 for nothing.
  struct Change {
    double u;
    int left, right;
  };

  // A change at which depth jumps: the edge of the nearer piece that ends there.
  struct Jump {
    int front, back;
    double depth;  ///< by how much
    bool is_clear;
    int end;  ///< crossing; otherwise cut_there or goes_on
  };

  [[nodiscard]] Jump jump_at(const Change& change) const;
  [[nodiscard]] int front_of_fold(int crossing) const;
  [[nodiscard]] EdgePlace place_of(int crossing) const;
  [[nodiscard]] std::vector<EdgePlace> path_around(int crossing) const;
  void note_crossings(double from, double to, Around& around) const;
  void note_crossing(const std::array<const SlicePiece*, 2>& pieces, const std::array<double, 2>& within,
                     Around& around) const;
  [[nodiscard]] const PieceEnd* end_of(int crossing, int triangle) const;
  [[nodiscard]] bool is_edge_on(const std::array<int, 2>& edge, int triangle) const;
  [[nodiscard]] Beyond beyond(int crossing, int triangle, FoldRule::Needle needle) const;
  [[nodiscard]] Need pair(int crossing, const std::vector<int>& sheets, FoldRule::Needle needle) const;
  [[nodiscard]] Need need_at(int crossing) const;
  [[nodiscard]] bool continues(int crossing, int piece) const;
  [[nodiscard]] int crossing_at(int piece, double u) const;
  [[nodiscard]] bool is_fold_of_face(int crossing, int back, double step) const;
  [[nodiscard]] bool is_break(const Change& change) const;
  [[nodiscard]] bool is_hidden_by(const SeenPart& part, double u, double depth) const;
  [[nodiscard]] bool is_seen(double u, double depth) const;
  [[nodiscard]] bool is_surely_seen(const WireCrossing& crossing) const;
  [[nodiscard]] bool faces_meet(double u, double reach) const;
  void find_cuts_edge_on();
  [[nodiscard]] bool is_cut_edge_on(double from, double to) const;
  [[nodiscard]] bool is_vague(const Change& change) const;
  [[nodiscard]] int triangle_of(int piece) const { return piece < 0 ? -1 : slice_.pieces[piece].triangle; }
  [[nodiscard]] std::vector<Change> changes(double from, double to) const;
  [[nodiscard]] std::array<int, 2> crossings_between(double from, double to) const;
  void add_marks(const Change& change, std::vector<LineMark>& marks) const;

  const ScanScene& scene_;
  const FoldRule& rule_;
  ScanLine line_;
  MarkLimits limits_;
  Slice slice_;
  std::vector<WireCrossing> wires_;  ///< that may be drawn
  std::vector<SeenPart> seen_;
  std::vector<std::array<double, 2>> cuts_edge_on_{};  ///< their ends along the line
};

}  // namespace epura::verify
