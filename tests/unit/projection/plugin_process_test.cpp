// SPDX-License-Identifier: Apache-2.0
// What plugins do that are neither good nor merely wrong, and what of it reaches this process.
#include "projection/plugin_process.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cfenv>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

#include "base/file.hpp"
#include "base/shared_library.hpp"
#include "foreign/messages.hpp"
#include "foreign/packing.hpp"
#include "projection/answer.hpp"
#include "projection/loader.hpp"
#include "support.hpp"

namespace epura::test::plugin_process_test {
namespace {

std::filesystem::path plain(const std::string& folder) {
  return std::filesystem::path(EPURA_TEST_BAD_PLUGINS) / folder / "plain.so";
}

projection::ProjectionEntry entry_of(const std::string& folder,
                                     projection::Afterwards afterwards = projection::Afterwards::waits) {
  return projection::read_plugin_apart(plain(folder), afterwards, 1).at(0);
}

projection::Projection projection_of(const std::string& folder) {
  return projection::make_projection(entry_of(folder), {"plain", {}}, a_box());
}

struct Deed {
  const char* folder;
  const char* sentence;
};
void PrintTo(const Deed& deed, std::ostream* out) { *out << deed.folder; }

class deed_when_loaded : public testing::TestWithParam<Deed> {};
INSTANTIATE_TEST_SUITE_P(plugins, deed_when_loaded,
                         testing::Values(Deed{"crashes", "crashes (Aborted) while loading"},
                                         Deed{"garbage-name", "crashes (Segmentation fault) while loading"},
                                         Deed{"exits", "exits while loading"},
                                         Deed{"hangs", "takes more than 1 s while loading"}));

TEST_P(deed_when_loaded, is_told) {
  const Error error = error_of([] { entry_of(GetParam().folder); });
  EXPECT_EQ(error.kind(), ErrorKind::plugin);
  EXPECT_STREQ(error.what(), GetParam().sentence);
}

class deed_when_asked : public testing::TestWithParam<Deed> {};
INSTANTIATE_TEST_SUITE_P(plugins, deed_when_asked,
                         testing::Values(Deed{"crashes-when-asked", "crashes (Aborted)"},
                                         Deed{"exits-when-asked", "exits"},
                                         Deed{"hangs-when-asked", "takes more than 1 s"},
                                         Deed{"cuts-the-line", "exits"},
                                         Deed{"crosses", "threw an exception across the C interface"},
                                         Deed{"rounds-up", "leaves another rounding mode"}));

TEST_P(deed_when_asked, is_told_with_the_library_and_the_name_each_time) {
  const projection::ProjectionEntry entry = entry_of(GetParam().folder);
  for (int time = 0; time < 2; ++time) {
    const Error error = error_of([&] { projection::make_projection(entry, {"plain", {}}, a_box()); });
    EXPECT_EQ(error.kind(), ErrorKind::plugin);
    EXPECT_TRUE(
        std::string(error.what()).starts_with(plain(GetParam().folder).string() + ": 'plain' " + GetParam().sentence))
        << error.what();
  }
}

TEST(what_a_plugin_changes, stays_with_it) {
  const projection::Projection good = projection_of("good");
  for (const char* folder : {"rounds-up-when-loaded", "hangs-at-its-end", "prints"}) {
    SCOPED_TRACE(folder);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(projection::view_matrix(projection_of(folder)), projection::view_matrix(good));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  }
}

TEST(what_a_plugin_changes, is_mended_where_it_is_loaded) {
  for (const char* folder : {"rounds-up-when-loaded", "rounds-up"}) {
    const projection::ProjectionEntry entry = projection::read_plugin(plain(folder)).at(0);
    EXPECT_EQ(std::fegetround(), FE_TONEAREST) << folder;
    try {
      projection::ask_plugin(entry, foreign::default_values(entry.parameters), a_box());
    } catch (const Error&) {
      EXPECT_STREQ(folder, "rounds-up");
    }
    EXPECT_EQ(std::fegetround(), FE_TONEAREST) << folder;
  }
}

TEST(what_a_plugin_says, is_fit_for_a_terminal) {
  const std::string shown =
      "a\xEF\xBF\xBD[2Jb\xEF\xBF\xBD"
      "31mc\xEF\xBF\xBD"
      "d epura: e\xEF\xBF\xBD";
  const projection::ProjectionEntry entry = entry_of("escapes");
  EXPECT_EQ(entry.summary, shown);
  const Error error =
      error_of([&] { projection::make_projection(entry, scene::parse_request("plain:scale=2"), a_box()); });
  EXPECT_EQ(error.what(), "plain: " + shown);
}

/// Numbers of the processes that this thread has begun and that have not been waited for.
std::string children() { return read_file("/proc/thread-self/children"); }

TEST(a_plugin_process, lives_no_longer_than_its_entries) {
  const std::string before = children();
  {
    const projection::ProjectionEntry waiting = entry_of("good");
    EXPECT_NE(children(), before);
  }
  EXPECT_EQ(children(), before);
}

TEST(a_plugin_process, that_rests_is_made_again_for_questions) {
  const std::string before = children();
  const projection::ProjectionEntry resting = entry_of("good", projection::Afterwards::rests);
  EXPECT_EQ(children(), before);
  EXPECT_EQ(projection::make_projection(resting, scene::parse_request("plain:scale=2"), a_box()).scale, 2);
}

// A process that is forked in the meantime may hang in the loader.
TEST(a_plugin_process, begins_when_no_other_thread_is_loading) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  ::setenv("EPURA_TEST_PIPE", std::to_string(ends[1]).c_str(), 1);
  std::thread other([] { load_library(plain("tells-its-loading"), ErrorKind::plugin); });
  char byte = 0;
  EXPECT_EQ(::read(ends[0], &byte, 1), 1);
  entry_of("good");
  pollfd is_loaded{ends[0], POLLIN, 0};
  EXPECT_EQ(::poll(&is_loaded, 1, 0), 1);
  other.join();
  ::close(ends[0]), ::close(ends[1]);
}

TEST(a_message, is_no_longer_than_its_reader_says) {
  for (const std::size_t length : {10U, 11U}) {
    std::array<int, 2> ends{};
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    foreign::Packer message;
    for (std::size_t i = 0; i < length; ++i) message('x');
    EXPECT_TRUE(foreign::send_message(ends[0], message));
    foreign::Incoming incoming;
    const foreign::Received received = incoming.receive(ends[1], {}, 10);
    EXPECT_EQ(received, length == 10 ? foreign::Received::all : foreign::Received::nothing);
    EXPECT_EQ(incoming.take(), length == 10 ? "xxxxxxxxxx" : "");
    for (const int end : ends) close(end);
  }
}

TEST(packed_values, end_where_the_bytes_end) {
  foreign::Packer pack;
  pack(std::vector<std::string>{"a", "bc"}), pack(7.5);
  for (std::size_t size = 0; size <= pack.bytes().size(); ++size) {
    foreign::Unpacker unpack(std::string_view(pack.bytes()).substr(0, size));
    std::vector<std::string> texts;
    double number = 0;
    const auto take_all = [&] { unpack(texts), unpack(number); };
    if (size < pack.bytes().size()) {
      EXPECT_STREQ(error_of(take_all).what(), "corrupts its process") << size;
    } else {
      take_all();
      EXPECT_EQ(texts, (std::vector<std::string>{"a", "bc"}));
      EXPECT_EQ(number, 7.5);
    }
  }
}

TEST(packed_values, are_not_believed_to_be_more_than_there_are) {
  foreign::Packer pack;
  pack(~std::size_t{0});
  std::vector<double> numbers;
  foreign::Unpacker unpack(pack.bytes());
  EXPECT_STREQ(error_of([&] { unpack(numbers); }).what(), "corrupts its process");
}

}  // namespace
}  // namespace epura::test::plugin_process_test
