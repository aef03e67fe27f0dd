// SPDX-License-Identifier: Apache-2.0
// Finding and loading plugins, naming bad ones, and reading requests.
#include <unistd.h>

#include <cstdlib>

#include "base/file.hpp"
#include "support.hpp"
#include "variable.hpp"

namespace epura::test::catalogue_test {
namespace {

namespace fs = std::filesystem;

fs::path bad(const std::string& folder) { return fs::path(EPURA_TEST_BAD_PLUGINS) / folder; }
fs::path built(const std::string& name) { return built_plugins()[0] / (name + ".so"); }

class with_folder : public testing::Test {
 protected:
  with_folder() {
    std::string pattern = (fs::temp_directory_path() / "epura-XXXXXX").string();
    folder = mkdtemp(pattern.data());
  }
  ~with_folder() override { fs::remove_all(folder); }
  fs::path folder;
};

struct Refusal {
  const char* folder;
  const char* reason;
};
void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.folder; }

class refused_when_loaded : public testing::TestWithParam<Refusal> {};
INSTANTIATE_TEST_SUITE_P(
    bad_plugins, refused_when_loaded,
    testing::Values(Refusal{"missing-symbol", "no function epura_projections_v1"},
                    Refusal{"no-list", "returns nothing"}, Refusal{"other-abi", "ABI 9, this program has 1"},
                    Refusal{"short-list", "too short: 8 of"}, Refusal{"empty-list", "provides no projection"},
                    Refusal{"long-list", "claims to provide 1001 projections"}, Refusal{"short-row", "rows of 8 bytes"},
                    Refusal{"no-name", "projection 1 has no name"}, Refusal{"bad-name", "'Plain View'"},
                    Refusal{"no-function", "'plain' has no function"},
                    Refusal{"bad-default", "'scale' has a default outside"}));

TEST_P(refused_when_loaded, is_named_with_the_reason) {
  const projection::Catalogue found = projection::load_catalogue({bad(GetParam().folder)});
  EXPECT_TRUE(found.entries.empty());
  ASSERT_EQ(found.bad.size(), 1);
  EXPECT_EQ(found.bad[0].path, bad(GetParam().folder) / "plain.so");
  EXPECT_TRUE(contains(found.bad[0].reason, GetParam().reason)) << found.bad[0].reason;
}

TEST_P(refused_when_loaded, is_named_when_it_is_looked_up) {
  const Error error = error_of([] { projection::find_projection("plain", {bad(GetParam().folder)}); });
  EXPECT_EQ(error.kind(), ErrorKind::plugin);
  EXPECT_EQ(error.where(), (bad(GetParam().folder) / "plain.so").string());
  EXPECT_TRUE(contains(error.what(), GetParam().reason)) << error.what();
}

class refused_when_asked : public testing::TestWithParam<Refusal> {};
INSTANTIATE_TEST_SUITE_P(bad_plugins, refused_when_asked,
                         testing::Values(Refusal{"nan", "the normal of the plane is not finite"},
                                         Refusal{"no-normal", "the normal of the plane is zero"},
                                         Refusal{"up-along-normal", "up direction is parallel"},
                                         Refusal{"plane-holds-projector", "plane contains the direction of projection"},
                                         Refusal{"no-scale", "scale is not a positive number"},
                                         Refusal{"empty-window", "window is empty"},
                                         Refusal{"front-behind-back", "the front plane must lie in front of"},
                                         Refusal{"crosses", "threw an exception"}));

TEST_P(refused_when_asked, is_named_with_the_reason) {
  const projection::ProjectionEntry entry = projection::find_projection("plain", {bad(GetParam().folder)});
  const Error error = error_of([&] { projection::make_projection(entry, {"plain", {}}, a_box()); });
  EXPECT_EQ(error.kind(), ErrorKind::plugin);
  EXPECT_EQ(error.where(), entry.plugin.string());
  EXPECT_TRUE(contains(error.what(), GetParam().reason)) << error.what();
}

TEST(a_plugin, that_has_a_sentence_to_say_is_heard) {
  const auto answer = [](const char* folder, const char* text) {
    const scene::ProjectionRequest request = scene::parse_request(text);
    const projection::ProjectionEntry entry = projection::find_projection(request.name, {bad(folder)});
    return error_of([&] { projection::make_projection(entry, request, a_box()); });
  };
  EXPECT_STREQ(answer("sentence", "plain:scale=2").what(), "plain: not today");
  EXPECT_EQ(answer("sentence", "plain:scale=2").kind(), ErrorKind::input);
  EXPECT_TRUE(contains(answer("sentence", "plain").what(), "plain.so: 'plain': not today"));
  EXPECT_EQ(answer("sentence", "plain").kind(), ErrorKind::plugin);
  EXPECT_TRUE(contains(answer("throws", "throws-error").what(), "the moon is not full"));
  EXPECT_TRUE(contains(answer("throws", "throws-number").what(), "threw something"));
}

TEST(a_plugin, in_plain_c_is_as_good_as_any) {
  const projection::ProjectionEntry entry = projection::find_projection("plain", {bad("good")});
  EXPECT_EQ(entry.summary, "a slanted view");
  EXPECT_EQ(entry.reference, "");
  const projection::Projection p = projection::make_projection(entry, scene::parse_request("plain:scale=2"), a_box());
  EXPECT_EQ(p.scale, 2);
  EXPECT_FALSE(p.window);
  EXPECT_EQ(p.front, HUGE_VAL);
  EXPECT_EQ(p.back, -HUGE_VAL);
  expect_near<2>(step(p, {0, 1, 0}), {0, 0.5}, 1e-15);
}

TEST(a_plugin, receives_each_value_in_its_place) {
  const projection::ProjectionEntry entry = projection::find_projection("every-type", {bad("good")});
  const auto make_it = [&](const char* text) {
    return projection::make_projection(entry, scene::parse_request(text), a_box());
  };
  const projection::Projection p =
      make_it("every-type:pair=5,-6:word=double:point=7,8,9:ratio=-2:central=yes:window=-1,-2,3,4");
  EXPECT_EQ(p.front, 5);
  EXPECT_EQ(p.back, -6);
  EXPECT_EQ(p.scale, 2);
  EXPECT_EQ(p.point, Vec3(7, 8, 9));
  EXPECT_EQ(p.projector, Vec3(-2, -1e3, 0));
  EXPECT_TRUE(p.central);
  EXPECT_EQ(p.window->min, Vec2(-1, -2));
  EXPECT_EQ(p.window->max, Vec2(3, 4));
  EXPECT_EQ(p.values.size(), 6);
  EXPECT_EQ(p.values[1], (std::pair<std::string, std::vector<double>>{"word", {2}}));
}

TEST(a_plugin, finds_defaults_from_the_box_and_they_are_not_recorded) {
  const projection::ProjectionEntry entry = projection::find_projection("every-type", {bad("good")});
  const projection::Projection p = projection::make_projection(entry, {"every-type", {}}, a_box());
  EXPECT_EQ(p.point, a_box().max);
  for (const auto& [name, value] : p.values) EXPECT_NE(name, "point");
}

TEST(a_plugin, from_the_manual_draws_what_the_manual_says) {
  const auto make_it = [](const char* text) {
    const scene::ProjectionRequest request = scene::parse_request(text);
    return projection::make_projection(projection::find_projection(request.name, {bad("manual")}), request, a_box());
  };
  const projection::Projection slanted = make_it("slanted:ratio=0.7:angle=90"), military = make_it("military");
  expect_near<2>(step(slanted, {0, 1, 0}), {0, 0.7}, 1e-15);
  expect_near<2>(step(military, {0, 1, 0}), {0, 1}, 1e-15);
  expect_near<2>(step(military, {0, 0, 1}), {0, 1}, 1e-15);
}

TEST(two_libraries, with_one_name_in_a_folder_are_reported) {
  const projection::Catalogue found = projection::load_catalogue({bad("duplicate")});
  ASSERT_EQ(found.entries.size(), 1);
  EXPECT_EQ(found.entries[0].plugin.filename(), "first.so");
  ASSERT_EQ(found.bad.size(), 1);
  EXPECT_EQ(found.bad[0].path.filename(), "second.so");
  EXPECT_EQ(found.bad[0].reason, "provides the projection 'plain', which first.so already provides");
}

TEST(two_libraries, with_one_name_in_two_folders_hide_each_other_in_order) {
  const projection::Catalogue found = projection::load_catalogue({bad("good"), bad("sentence")});
  EXPECT_TRUE(found.bad.empty());
  ASSERT_EQ(found.entries.size(), 2);
  EXPECT_EQ(found.entries[1].plugin, bad("good") / "plain.so");
  EXPECT_EQ(projection::find_projection("plain", {bad("sentence"), bad("good")}).plugin, bad("sentence") / "plain.so");
  // The library of that name wins over an earlier one that offers it, too.
  EXPECT_EQ(projection::load_catalogue({bad("duplicate"), bad("good")}).entries[1].plugin, bad("good") / "plain.so");
  EXPECT_EQ(projection::find_projection("plain", {bad("duplicate"), bad("good")}).plugin, bad("good") / "plain.so");
}

TEST_F(with_folder, junk_is_named_and_other_files_are_left_alone) {
  write_file(folder / "junk.so", "this is not a library");
  write_file(folder / "empty.so", "");
  write_file(folder / "notes.txt", "nor is this");
  fs::create_directory(folder / "folder.so");
  const projection::Catalogue found = projection::load_catalogue({folder});
  ASSERT_EQ(found.bad.size(), 2);
  EXPECT_EQ(found.bad[0].path, folder / "empty.so");
  EXPECT_EQ(found.bad[0].reason, "file too short");
  EXPECT_EQ(found.bad[1].path, folder / "junk.so");
  EXPECT_FALSE(contains(found.bad[1].reason, folder.string())) << found.bad[1].reason;
}

TEST_F(with_folder, missing_folder_is_named) {
  const projection::Catalogue found = projection::load_catalogue({folder / "none"});
  ASSERT_EQ(found.bad.size(), 1);
  EXPECT_TRUE(contains(found.bad[0].reason, "not a folder")) << found.bad[0].reason;
}

TEST_F(with_folder, only_the_library_of_the_name_is_opened) {
  fs::copy(built("front"), folder / "front.so");
  fs::copy(bad("mark") / "plain.so", folder / "mark.so");
  const test::Variable mark("EPURA_TEST_MARK", (folder / "mark").c_str());
  EXPECT_EQ(projection::find_projection("front", {folder}).name, "front");
  EXPECT_FALSE(fs::exists(folder / "mark"));
  EXPECT_EQ(projection::find_projection("plain", {folder}).plugin, folder / "mark.so");
  EXPECT_TRUE(fs::exists(folder / "mark"));
}

TEST_F(with_folder, a_library_cut_short_beside_good_ones_is_named_and_hides_none) {
  fs::copy(built("front"), folder / "front.so");
  const std::string whole = read_file(built("back"));
  write_file(folder / "short.so", whole.substr(0, whole.size() / 2));
  const Error error = error_of([&] { projection::find_projection("fornt", {folder}); });
  EXPECT_EQ(error.kind(), ErrorKind::plugin);
  EXPECT_TRUE(error.hint().starts_with("did you mean 'front'?\n" + (folder / "short.so").string() + ": "))
      << error.hint();
}

TEST_F(with_folder, projection_in_a_library_of_another_name_is_found) {
  fs::copy(built("front"), folder / "views.so");
  EXPECT_EQ(projection::find_projection("front", {folder}).plugin, folder / "views.so");
}

TEST(find_projection, says_what_was_perhaps_meant) {
  const Error error = error_of([] { projection::find_projection("isometrik", built_plugins()); });
  EXPECT_EQ(error.kind(), ErrorKind::input);
  EXPECT_STREQ(error.what(), "isometrik: no such projection");
  EXPECT_EQ(error.hint(), "did you mean 'isometric'?");
}

TEST_F(with_folder, name_does_not_lead_out_of_it) {
  fs::create_directory(folder / "inside");
  fs::copy(built("front"), folder / "outside.so");
  EXPECT_EQ(error_of([&] { projection::find_projection("../outside", {folder / "inside"}); }).kind(),
            ErrorKind::plugin);
  EXPECT_EQ(error_of([&] { projection::find_projection("../outside", {folder / "inside"}); }).hint(),
            "no projections were found");
}

TEST(plugin_folders, are_those_given_then_the_environment_then_beside_the_program) {
  setenv("EPURA_PLUGIN_PATH", "/a::/b", 1);
  const std::vector<fs::path> folders = projection::plugin_folders({"/x"});
  unsetenv("EPURA_PLUGIN_PATH");
  ASSERT_EQ(folders.size(), 4);
  EXPECT_EQ(folders[0], "/x");
  EXPECT_EQ(folders[1], "/a");
  EXPECT_EQ(folders[2], "/b");
  EXPECT_TRUE(folders[3].is_absolute());
  EXPECT_TRUE(folders[3].string().ends_with("epura/projections"));
}

TEST(plugin_folders, of_the_environment_are_absolute) {
  setenv("EPURA_PLUGIN_PATH", "/a:here", 1);
  const Error error = error_of([] { projection::plugin_folders({}); });
  unsetenv("EPURA_PLUGIN_PATH");
  EXPECT_EQ(error.kind(), ErrorKind::plugin);
  EXPECT_STREQ(error.what(), "EPURA_PLUGIN_PATH: 'here' is not an absolute path");
  EXPECT_EQ(error.hint(), "give " + (fs::current_path() / "here").string() + ", or use --plugin-path");
}

TEST(parse_request, takes_names_and_assignments_apart) {
  const scene::ProjectionRequest request = scene::parse_request("look-at:eye=4,-9,5:ref=0,0,0");
  EXPECT_EQ(request.name, "look-at");
  ASSERT_EQ(request.assignments.size(), 2);
  EXPECT_EQ(request.assignments[0], (std::pair<std::string, std::string>{"eye", "4,-9,5"}));
}

TEST(parse_request, refuses_what_is_no_assignment) {
  for (const char* text : {"", ":x=1", "front:", "front:x", "front:=1", "front::x=1", "front:x=1:x=2"})
    EXPECT_EQ(error_of([&] { scene::parse_request(text); }).kind(), ErrorKind::input) << text;
}

struct Wrong {
  const char* request;
  const char* message;
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.request; }
class wrong_value : public testing::TestWithParam<Wrong> {};
INSTANTIATE_TEST_SUITE_P(
    requests, wrong_value,
    testing::Values(Wrong{"isometric:foreshortned=true", "isometric:foreshortned: no such parameter"},
                    Wrong{"isometric:foreshortened=yes", "isometric:foreshortened: 'yes' is not one of false, true"},
                    Wrong{"front:scale=2", "front:scale: this projection has no parameters"},
                    Wrong{"cavalier:angle=steep", "cavalier:angle: 'steep' is not a number"},
                    Wrong{"cavalier:angle=", "cavalier:angle: '' is not a number"},
                    Wrong{"cavalier:angle=1,2", "cavalier:angle: takes 1 numbers separated by commas, not 2"},
                    Wrong{"cavalier:angle=nan", "cavalier:angle: must be finite"},
                    Wrong{"cavalier:angle=400", "cavalier:angle: is 400, allowed is -360 to 360 deg"},
                    Wrong{"look-at:eye=1,2", "look-at:eye: takes 3 numbers separated by commas, not 2"},
                    Wrong{"look-at:eye=1,2,x", "look-at:eye: '1,2,x' is not a number list"},
                    Wrong{"look-at:eye=1,2,inf", "look-at:eye: must be finite"},
                    Wrong{"look-at:eye=0,0,0:ref=0,0,0", "look-at: the eye and the point it looks at are the same"},
                    Wrong{"look-at:vup=1,-1,1", "look-at: the up direction is parallel to the normal of the plane"},
                    Wrong{"look-at:window=1,1,0,2",
                          "look-at: the window is empty: its minimum must be below its maximum"},
                    Wrong{"frustum:n=-1", "frustum:n: is -1, allowed is 0 model units or more"},
                    Wrong{"phigs:f=-5:b=5", "phigs: the front plane must lie in front of the back plane"}));

TEST_P(wrong_value, is_named_with_what_is_allowed) {
  const Error error = error_of([] { make(GetParam().request, a_box()); });
  EXPECT_EQ(error.kind(), ErrorKind::input);
  EXPECT_STREQ(error.what(), GetParam().message);
}

TEST(wrong_key, comes_with_a_suggestion) {
  EXPECT_EQ(error_of([] { make("isometric:foreshortned=true", a_box()); }).hint(), "did you mean 'foreshortened'?");
}

}  // namespace
}  // namespace epura::test::catalogue_test
