// SPDX-License-Identifier: Apache-2.0
// The walls of holes about one axis, from mouth to floor, as the faces of the models have them: no feature is asked.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "scene/threads.hpp"
#include "sizes/dimensions_in_view.hpp"
#include "surfaces/limits.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

inline constexpr double least_slot_end = 175;  ///< degrees around an axis; fillets have less

/// Where a screw thread is that a scene or a file states.
struct WallThread {
  scene::Thread form;
  std::array<double, 2> at;  ///< along the axis of its chain, ascending
};

/// A cylinder or cone around a hole, or around material.
struct HoleWall {
  int face;
  std::array<double, 2> at;      ///< where it begins and ends, along the axis of the chain from its centre; ascending
  std::array<double, 2> radius;  ///< there
  double angle = 0;              ///< of a cone, between opposite sides, degrees
  double doubt = 0;              ///< of its radius
  double sweep = 0;              ///< degrees around the axis; of one that something divides, of all its pieces
  std::optional<WallThread> thread{};

  [[nodiscard]] bool is_cone() const { return angle > 0; }
  [[nodiscard]] double length() const { return at[1] - at[0]; }
  [[nodiscard]] double widest() const { return std::max(radius[0], radius[1]); }
  [[nodiscard]] bool is_fillet() const { return sweep < least_slot_end; }
};

/// Round faces that are one, by the circle of their radius.
struct NotedRound {
  int model, face;
  WorldCircle circle;
  double sweep;  ///< degrees about the axis; 0 of a tube, which is a fillet however far it goes
  bool inwards;
  std::array<double, 2> at;  ///< from where to where it goes along its axis, from the centre of the circle
  double ring;               ///< of a tube, from the axis to its middle; 0 of others

  /// Whether the centre of a circle is on its axis, or in the middle of the tube.
  [[nodiscard]] bool has_centre(const Vec3& centre, double slack) const;
  [[nodiscard]] bool is_fillet() const { return sweep < least_slot_end; }
  [[nodiscard]] bool is_whole() const { return sweep >= surfaces::whole_turn; }
};

/// A face of one of the models.
struct FaceOfModel {
  std::size_t model;
  int face;
};

/// Walls that follow each other along an axis, in one body.
struct HoleChain {
  int model;
  Vec3 centre, axis;
  std::vector<HoleWall> walls;    ///< ascending
  std::size_t own;                ///< the wall of the circle by which it was found
  std::array<bool, 2> is_closed;  ///< whether a floor, or the point of a drill, is at its ends
  std::array<double, 2> uneven;   ///< by how much its ends vary, as mouths in round faces do

  /// Whether a wall goes on narrower at an end, or is closed there.
  [[nodiscard]] bool ends_at(std::size_t wall, int end) const;
};

/// The round faces of all models of a world, to which it refers. Models without recognised faces have none.
class HoleWalls {
 public:
  explicit HoleWalls(const world::World& world);

  /// The chain whose wall a circle is; nothing if no face around a hole has it.
  [[nodiscard]] std::optional<HoleChain> chain_at(const WorldCircle& circle) const;
  /// The widest wall about the axis of a thread that is no wider than this, and no narrower than its core, which is
  /// given in its diameters; the thread if there is none.
  [[nodiscard]] WorldCircle bore_of(WorldCircle thread, double core) const;
  /// All chains that have a wall of this radius, each once for each such wall.
  [[nodiscard]] std::vector<HoleChain> chains_of(double radius) const;
  /// Those around material whose wall a circle is.
  [[nodiscard]] std::vector<HoleWall> shafts_at(const WorldCircle& circle) const;
  /// Round faces of a radius, or all; cones by each end.
  [[nodiscard]] std::vector<NotedRound> rounds(std::optional<double> radius = {}) const;
  /// Whether a round face has a circle of this radius about an axis, or a ball its centre there.
  [[nodiscard]] bool has_round(const WorldCircle& circle) const;
  /// Whether something round reaches from one place to another, across its axis.
  [[nodiscard]] bool is_between(const Vec3& from, const Vec3& to, double radius, const Vec3& along) const;
  /// Of a hole that is named, its rim; otherwise the narrowest circle of a round face where the leader ends, or of a
  /// hole in whose middle it ends: of a cone its wider end, of a torus that of its tube.
  [[nodiscard]] std::optional<WorldCircle> circle_of(const LeaderNote& note) const;
  /// The faces that are so near to a point.
  [[nodiscard]] std::vector<FaceOfModel> faces_at(const Vec3& point, double within) const;
  /// How far off places may be that people write, in order of preference.
  [[nodiscard]] std::array<double, 2> written_slacks() const { return {slack_, 10 * slack_}; }

  [[nodiscard]] const std::vector<std::optional<world::PlacedPart>>& parts() const { return parts_; }
  /// How far apart what is the same may be.
  [[nodiscard]] double slack() const { return slack_; }

 private:
  [[nodiscard]] std::optional<WorldCircle> circle_through(const Vec3& point) const;
  [[nodiscard]] std::optional<WorldCircle> circle_about(const Vec3& point) const;
  [[nodiscard]] std::optional<WallThread> thread_on(int model, int face, const Vec2& ends) const;
  [[nodiscard]] std::vector<HoleWall> walls_about(const WorldCircle& circle, int model, int body, bool inwards) const;
  [[nodiscard]] std::array<Vec3, 3> corners_of(std::size_t model, std::size_t triangle) const;
  [[nodiscard]] std::optional<HoleChain> chain_from(const WorldCircle& circle, int model, int face) const;
  void find_ends(HoleChain& chain) const;
  [[nodiscard]] std::optional<int> face_ahead(const HoleChain& chain, const HoleWall& wall, const Vec3& along) const;
  [[nodiscard]] bool is_floor(int floor, const HoleChain& chain, int wall) const;
  [[nodiscard]] std::vector<int> beside(int model, int face) const;

  const world::World& world_;
  std::vector<std::optional<world::PlacedPart>> parts_;  // by model
  double slack_;
};

}  // namespace epura::sheet
