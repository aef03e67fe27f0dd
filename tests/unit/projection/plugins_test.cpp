// Every plugin that was built, by its own table: nothing here knows their names, so a new one is covered by itself.
#include <map>

#include "support.hpp"

namespace epura {

/// For GoogleTest, which looks beside the type.
inline void PrintTo(const ProjectionEntry& entry, std::ostream* out) { *out << entry.name; }

}  // namespace epura

namespace epura::test {
namespace {

const Catalogue& catalogue() {
  static const Catalogue all = load_catalogue(built_plugins());
  return all;
}

class every_plugin : public testing::TestWithParam<ProjectionEntry> {
 protected:
  const ProjectionEntry& entry = GetParam();
  const Projection p = make_projection(entry, {entry.name, {}}, a_box());
};
std::string test_name(const testing::TestParamInfo<ProjectionEntry>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(built, every_plugin, testing::ValuesIn(catalogue().entries), test_name);

TEST(catalogue_of_built_plugins, has_all_families_and_nothing_bad) {
  std::map<std::string, int> families;
  for (const ProjectionEntry& entry : catalogue().entries) ++families[entry.family];
  EXPECT_EQ(families,
            (std::map<std::string, int>{{"axonometric", 3}, {"oblique", 4}, {"orthographic", 7}, {"perspective", 8}}));
  for (const BadPlugin& bad : catalogue().bad) ADD_FAILURE() << bad.path << ": " << bad.reason;
}

TEST_P(every_plugin, lies_in_the_library_of_its_name_and_describes_itself) {
  EXPECT_EQ(entry.plugin.filename(), entry.name + ".so");
  EXPECT_FALSE(entry.summary.empty());
  for (const Parameter& parameter : entry.parameters) EXPECT_FALSE(parameter.help.empty()) << parameter.name;
}

TEST_P(every_plugin, has_a_frame_of_the_plane_and_projectors_that_cut_it) {
  EXPECT_NEAR(glm::length(p.n), 1, 1e-15);
  expect_near<3>(glm::cross(p.u, p.v), p.n, 1e-14);
  EXPECT_GT(glm::dot(p.n, p.central ? p.projector - p.point : p.projector), 0.1);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) EXPECT_TRUE(std::isfinite(view_matrix(p)[column][row]));
  EXPECT_NE(glm::determinant(view_matrix(p)), 0);
}

TEST_P(every_plugin, keeps_straight_lines_straight) {
  const Vec3 a = a_box().least, b = a_box().most;
  const auto at = [&](double t) {
    const Vec3 x = a + t * (b - a);
    return Vec3(place(p, x), depth(p, x));
  };
  const double length = glm::length(at(1) - at(0));
  for (const double t : {0.1, 0.5, 0.8})
    EXPECT_LT(glm::length(glm::cross(at(1) - at(0), at(t) - at(0))), 1e-12 * length * length);
}

TEST_P(every_plugin, has_depth_that_grows_along_the_sight_line) {
  const Vec3 x = a_box().centre() + Vec3(0.3, -0.2, 0.1);
  const Vec3 step = p.central ? 0.1 * (p.projector - x) : p.projector;
  for (int i = -5; i < 5; ++i) {
    EXPECT_LT(depth(p, x + double(i) * step), depth(p, x + (i + 1.0) * step));
    expect_near<2>(place(p, x + double(i) * step), place(p, x), 1e-11);
  }
}

TEST_P(every_plugin, draws_parallels_that_meet_in_the_vanishing_point) {
  const auto points = vanishing_points(p);
  for (int i = 0; i < 3; ++i) {
    Vec3 axis(0);
    axis[i] = 1;
    const Vec3 a = a_box().least, b = a_box().most - axis;
    const Vec2 a0 = place(p, a), da = place(p, a + axis) - a0, b0 = place(p, b), db = place(p, b + axis) - b0;
    const double turn = da.x * db.y - da.y * db.x;
    if (const auto& meeting = points[static_cast<std::size_t>(i)]) {
      const double t = ((b0.x - a0.x) * db.y - (b0.y - a0.y) * db.x) / turn;
      EXPECT_LT(glm::length(a0 + t * da - *meeting), 1e-9 * (1 + glm::length(*meeting))) << "axis " << i;
    } else {
      EXPECT_NEAR(turn, 0, 1e-13) << "axis " << i;
    }
  }
}

bool same(const Projection& a, const Projection& b) {
  const auto window = [](const Projection& p) { return p.window.value_or(Window{Vec2(0), Vec2(0)}); };
  return a.point == b.point && a.u == b.u && a.n == b.n && a.central == b.central && a.projector == b.projector &&
         a.scale == b.scale && window(a).least == window(b).least && window(a).most == window(b).most &&
         a.front == b.front && a.back == b.back;
}

/// Values to try; a projection may refuse some of them.
std::vector<std::string> candidates(const Parameter& parameter) {
  if (parameter.type == ParameterType::choice) return parameter.choices;
  switch (parameter.initial.size()) {
    case 1:
      return {"20", "7", "3", "1", "0.7", "-0.3", "-7"};
    case 2:
      return {"-20,3", "30,3", "1,-40"};
    case 3:
      return {"9,-11,13", "0.2,-1,1.1"};
    default:
      return {"-1,-2,3,4"};
  }
}

TEST_P(every_plugin, answers_differently_to_each_parameter) {
  // Some parameters mean something only beside another one.
  const std::map<std::string, std::pair<std::string, std::string>> beside{{"look-at:aspect", {"fovy", "40"}}};
  for (const Parameter& parameter : entry.parameters) {
    ProjectionRequest request{entry.name, {}};
    const auto other = beside.find(entry.name + ":" + parameter.name);
    if (other != beside.end()) request.assignments.push_back(other->second);
    const Projection before = make_projection(entry, request, a_box());
    request.assignments.emplace_back(parameter.name, "");
    bool matters = false;
    for (const std::string& value : candidates(parameter)) {
      request.assignments.back().second = value;
      try {
        matters = matters || !same(make_projection(entry, request, a_box()), before);
      } catch (const Error& error) {
        EXPECT_EQ(error.trouble(), Trouble::input) << error.what();
      }
    }
    EXPECT_TRUE(matters) << parameter.name;
  }
}

TEST_P(every_plugin, answers_to_a_point_to_nothing_and_to_extreme_boxes) {
  for (const Box& box : {Box{}, Box{Vec3(2, 3, 4), Vec3(2, 3, 4)}, Box{Vec3(-1e100), Vec3(1e100)},
                         Box{Vec3(1e-100), Vec3(2e-100)}, Box{{1e9, -1e9, 0}, {1e9 + 1, -1e9 + 1, 1}}})
    EXPECT_NO_THROW(make_projection(entry, {entry.name, {}}, box));
}

}  // namespace
}  // namespace epura::test
