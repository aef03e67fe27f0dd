// SPDX-License-Identifier: Apache-2.0
#include "edges/contacts.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "shapes.hpp"
#include "surfaces/recognise.hpp"

namespace epura::test::contacts_test {
namespace {

using edges::Contact;

// Two boxes, each of which counts as one free form.
world::World free_forms() {
  world::World world = world_of({box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {2, 2, 2})});
  for (world::Placed& placed : world.models) {
    auto part = std::make_shared<surfaces::PartFaces>();
    part->faces.resize(1);
    part->faces.front().surface.kind = surfaces::SurfaceKind::free_form;
    part->face_of_triangle.assign(static_cast<std::size_t>(placed.mesh->triangle_count()), 0);
    placed.part = std::move(part);
  }
  return world;
}

// Of `length`, at an angle of 0 degrees, which no turn is smaller than, or of 90.
edges::FaceCrossing crossing(const world::World& world, double length, bool touches) {
  return {{Vec3(0, 0, 0), Vec3(length, 0, 0)}, {0, world.first_triangle[1]}, touches ? 0.0 : 90.0};
}

TEST(Contacts, FreeFormsTouchIfMostOfTheirCrossingsDo) {
  const world::World world = free_forms();
  for (const double touching : {0.4, 0.6}) {
    const std::vector<edges::FaceCrossing> crossings{crossing(world, touching, true),
                                                     crossing(world, 1 - touching, false)};
    const Contact expected = touching > 0.5 ? Contact::contact : Contact::none;
    EXPECT_EQ(edges::judge_contacts(world, 1, {30, 5}, crossings, {}), (std::vector<Contact>{expected, expected}));
  }
}

}  // namespace
}  // namespace epura::test::contacts_test
