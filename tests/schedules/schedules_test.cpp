// SPDX-License-Identifier: Apache-2.0
// The whole way from model to file under schedules drawn by lot: the same bytes.
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "app/commands.hpp"
#include "at_length.hpp"
#include "base/parallel.hpp"
#include "folder.hpp"
#include "golden.hpp"
#include "words.hpp"

namespace epura::test {
namespace {

constexpr int schedules = 20;
/// Half of them one after the other, half on three threads. There are 76 drawings.
int schedules_of_a_drawing() { return at_length() ? schedules : 6; }

struct Files {
  std::string json, svg;
  bool operator==(const Files&) const = default;
};

// What `epura WORDS` writes; `schedule` goes where the number of threads goes.
Files draw_under(int schedule, std::vector<std::string> words) {
  const Folder folder;
  for (const char* name : {"out.json", "out.svg"}) words.insert(words.end(), {"-o", (folder / name).string()});
  DrawOptions options = draw_options_of({words.begin() + 1, words.end()});
  options.run.plugin_path.emplace_back(EPURA_TEST_PLUGINS);
  options.run.threads = schedule;
  EXPECT_EQ(draw(options), 0);
  return {read_file(folder / "out.json"), read_file(folder / "out.svg")};
}

void expect_same_under_all(const std::vector<std::string>& words) {
  const Files plain = draw_under(0, words);
  for (int schedule = 1; schedule <= schedules_of_a_drawing(); ++schedule)
    ASSERT_TRUE(draw_under(schedule, words) == plain) << "schedule " << schedule;
}

class Schedules : public testing::TestWithParam<std::string> {
 protected:
  // Paths of the cases start at the root of the repository.
  void SetUp() override { std::filesystem::current_path(std::filesystem::path(EPURA_TEST_SAMPLES).parent_path()); }
};

TEST_P(Schedules, GiveTheGoldenDrawing) {
  const std::vector<std::string> words = golden_arguments(GetParam());
  EXPECT_EQ(draw_under(1, words).json, read_file(golden_folder(GetParam()) / "expected.json"));
  expect_same_under_all(words);
}

INSTANTIATE_TEST_SUITE_P(Golden, Schedules, testing::ValuesIn(golden_cases()),
                         [](const auto& of) { return test_name(of.param); });

using SampleSchedules = Schedules;

TEST_P(SampleSchedules, GiveOneDrawing) {
  expect_same_under_all({"draw", "samples/models/" + GetParam() + ".obj", "--projection", "two-point"});
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleSchedules, testing::Values("bearing", "elbow", "flange"),
                         [](const auto& of) { return of.param; });

// Bars through each other: a scene of crossings and of faces that cut one another.
std::string grate(int bars) {
  std::string vertices, faces;
  int count = 0;
  const auto box = [&](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    for (int i = 0; i < 8; ++i) {
      vertices += "v";
      for (int k = 0; k < 3; ++k) vertices += " " + std::to_string((i >> k & 1) != 0 ? b[k] : a[k]);
      vertices += "\n";
    }
    for (const auto& face :
         {std::array{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}}) {
      faces += "f";
      for (const int corner : face) faces += " " + std::to_string(count + corner);
      faces += "\n";
    }
    count += 8;
  };
  for (int i = 0; i < bars; ++i) {
    box({3.0 * i, -1, 0}, {3.0 * i + 1, 3.0 * bars, 1});
    box({-1, 3.0 * i, 0.25 + 0.02 * i}, {3.0 * bars, 3.0 * i + 1, 1.25 + 0.02 * i});
  }
  return vertices + faces;
}

TEST_F(Schedules, DoNotChangeAGrate) {
  const Folder folder;
  expect_same_under_all(
      {"draw", folder.file("grate.obj", grate(12)), "--edges", "contour,crease,boundary,intersection,smooth"});
}

// So long that it is read in parts.
TEST_F(Schedules, DoNotChangeALongFile) {
  const Folder folder;
  std::string text;
  for (const char c : grate(4)) {
    text += c;
    if (c == '\n') text += "#" + std::string(8000, '.') + "\n";
  }
  expect_same_under_all({"draw", folder.file("long.obj", text)});
}

TEST(ShuffledLoops, CutAndReorder) {
  std::set<std::vector<std::size_t>> orders;
  for (int schedule = 2; schedule <= schedules; schedule += 2) {
    const ThreadLimit limit(schedule);
    std::vector<std::size_t> order;
    parallel_for(100, 1000, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) order.push_back(i);
    });
    orders.insert(order);
    EXPECT_FALSE(std::is_sorted(order.begin(), order.end())) << schedule;
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> all(100);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
  }
  EXPECT_EQ(orders.size(), schedules / 2);
}

}  // namespace
}  // namespace epura::test
