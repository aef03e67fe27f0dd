#include "sheet/dimensions/overall.hpp"

#include <array>

#include "sheet/dimensions/measure.hpp"

namespace epura {

namespace {

struct Extent {
  const char* direction;
  int axis;
  std::array<Vec3, 4> seen_from;  // clearest first
};

const std::array<Extent, 3> extents{{{"width", 0, {{{0, -1, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, -1}}}},
                                     {"height", 2, {{{0, -1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}}},
                                     {"depth", 1, {{{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}}}}}};

const Drawing* clearest(const World& world, std::span<const Drawing> drawings, const Extent& extent) {
  for (const Vec3& viewer : extent.seen_from)
    for (const Drawing& drawing : drawings)
      if (glm::length(drawing.projection.n - viewer) < 1e-6 &&
          shows_all(drawing, world.box.least, world.box.most, extent.axis))
        return &drawing;
  return nullptr;
}

}  // namespace

std::vector<DimensionDescription> overall_dimensions(const World& world, std::span<const Drawing> drawings,
                                                     const std::string& where) {
  std::vector<DimensionDescription> dimensions;
  for (const Extent& extent : extents) {
    const Drawing* drawing = clearest(world, drawings, extent);
    if (drawing == nullptr) continue;
    DimensionDescription& dimension = dimensions.emplace_back();
    dimension.where = where;
    dimension.view = {drawing->name, where};
    dimension.type = {"overall", where};
    dimension.direction = {extent.direction, where};
  }
  return dimensions;
}

}  // namespace epura
