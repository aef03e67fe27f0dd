// SPDX-License-Identifier: Apache-2.0
// epura batch, as users run it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <thread>

#include "../app/long_model.hpp"
#include "app/jobs/jobs.hpp"
#include "errors.hpp"
#include "program.hpp"
#include "variable.hpp"

namespace epura::test::batch_test {
namespace {

namespace fs = std::filesystem;

/// A block of the given height.
std::string block(int height) {
  const std::string top = " " + std::to_string(height) + "\n";
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0" + top + "v 1 0" + top + "v 1 1" + top + "v 0 1" + top +
         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

/// A folder with models of different sizes: parts/a/m0.obj, parts/b/m1.obj ...
struct Parts {
  Folder folder;

  explicit Parts(int count) {
    for (int i = 0; i < count; ++i) {
      const fs::path file =
          folder / ("parts/" + std::string(i % 2 == 0 ? "a" : "b") + "/m" + std::to_string(i) + ".obj");
      fs::create_directories(file.parent_path());
      write_file(file, block(i + 1));
    }
  }

  [[nodiscard]] Outcome run(std::vector<std::string> options) const {
    options.insert(options.begin(), "batch");
    return epura(options, folder / "");
  }
  [[nodiscard]] Outcome draw_all(std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"parts", "-o", "out/{folder}/{name}.svg", "--projection", "cabinet"});
    return run(options);
  }
  /// All files below a folder except manifests, by their names relative to it.
  [[nodiscard]] std::map<std::string, std::string> drawings(const std::string& below = "out") const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder / below))
      if (entry.is_regular_file() && entry.path().extension() != ".jsonl")
        files[entry.path().lexically_relative(folder / below).string()] = read_file(entry.path());
    return files;
  }
};

TEST(Batch, DrawsOnlyWhatHasChanged) {
  const Parts parts(4);
  const Outcome first = parts.draw_all();
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(first.out, "4 drawn, 0 failed\n");
  const auto drawings = parts.drawings();
  ASSERT_EQ(drawings.size(), 4U);
  EXPECT_EQ(drawings.count("parts/b/m3.svg"), 1U);
  EXPECT_EQ(parts.draw_all().out, "0 drawn, 4 unchanged, 0 failed\n");

  write_file(parts.folder / "parts/a/m2.obj", block(9));
  fs::remove(parts.folder / "out/parts/b/m1.svg");
  EXPECT_EQ(parts.draw_all().out, "2 drawn, 2 unchanged, 0 failed\n");
  EXPECT_EQ(parts.drawings().at("parts/b/m1.svg"), drawings.at("parts/b/m1.svg"));
  EXPECT_NE(parts.drawings().at("parts/a/m2.svg"), drawings.at("parts/a/m2.svg"));
  write_file(parts.folder / "out/parts/b/m1.svg", "damaged");
  EXPECT_EQ(parts.draw_all().out, "1 drawn, 3 unchanged, 0 failed\n");
  EXPECT_EQ(parts.draw_all({"--hidden", "none"}).out, "4 drawn, 0 failed\n");
  EXPECT_EQ(parts.draw_all({"--hidden", "none", "--again"}).out, "4 drawn, 0 failed\n");
  EXPECT_EQ(parts.draw_all({"--hidden", "none", "--workers", "3"}).out, "0 drawn, 4 unchanged, 0 failed\n");
}

TEST(Batch, DrawsWhatASingleRunDraws) {
  const Parts parts(2);
  ASSERT_EQ(parts.draw_all({"--title", "Part {name}"}).code, 0);
  epura({"draw", "parts/b/m1.obj", "--projection", "cabinet", "--title", "Part m1", "-o", "one.svg"},
        parts.folder / "");
  EXPECT_EQ(parts.drawings().at("parts/b/m1.svg"), read_file(parts.folder / "one.svg"));
}

TEST(Batch, ReadsPatternsAndLists) {
  const Parts parts(5);
  const std::vector<std::string> output{"-o", "out/{name}-{number}.svg"};
  const auto run = [&](std::vector<std::string> sources) {
    sources.insert(sources.end(), output.begin(), output.end());
    return parts.run(sources);
  };
  EXPECT_EQ(run({"parts/**/*.obj"}).out, "5 drawn, 0 failed\n");
  EXPECT_EQ(parts.drawings().count("m4-3.svg"), 1U);  // after m0 and m2 of the first folder
  EXPECT_EQ(run({"parts/b/m?.obj"}).out, "2 drawn, 0 failed\n");
  const Outcome none = run({"parts/*.step"});
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(contains(none.err, "parts/*.step: no file fits this pattern")) << none.err;
  write_file(parts.folder / "list", "parts/a/m0.obj\nparts/b/m1.obj\n");
  const Outcome listed = epura({"batch", "-", "-o", "listed/{name}.svg"}, parts.folder / "", {}, "exec < list");
  EXPECT_EQ(listed.out, "2 drawn, 0 failed\n") << listed.err;
}

TEST(Batch, FoldersMayLinkToThemselves) {
  const Parts parts(3);
  fs::create_directory_symlink("..", parts.folder / "parts/a/up");
  fs::create_directory_symlink("b", parts.folder / "parts/c");
  fs::create_directory(parts.folder / "parts/.hidden");
  write_file(parts.folder / "parts/.hidden/m.obj", block(1));
  EXPECT_EQ(parts.draw_all().out, "3 drawn, 0 failed\n");
  EXPECT_EQ(parts.run({"parts/**/*.obj", "-o", "pattern/{name}.svg"}).out, "3 drawn, 0 failed\n");
}

TEST(Batch, TellsModelsItPassesOver) {
  const Parts parts(2);
  EXPECT_EQ(parts.draw_all().err.find("passed over"), std::string::npos);
  write_file(parts.folder / "parts/a/...obj", block(1));
  write_file(parts.folder / "parts/a/.notes", "no model");
  EXPECT_PRED2(contains, parts.draw_all().err, "epura: parts/a/...obj is passed over");
  write_file(parts.folder / "parts/b/.m.obj", block(2));
  const Outcome two = parts.draw_all();
  EXPECT_EQ(two.code, 0);
  EXPECT_PRED2(contains, two.err, "epura: parts/a/...obj and 1 more are passed over");
  EXPECT_EQ(parts.drawings().size(), 2U);
  const Outcome named = epura({"draw", "parts", "-o", "{name}.svg", "--projection", "top"}, parts.folder / "");
  EXPECT_PRED2(contains, named.err, "epura: parts/a/...obj and 1 more are passed over");
}

TEST(Batch, DrawSaysTheSameInSmall) {
  const Parts parts(2);
  const Outcome run = epura({"draw", "parts/a/m0.obj", "parts/b/m1.obj", "-o", "{name}.svg"}, parts.folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(fs::exists(parts.folder / "m0.svg"));
  EXPECT_TRUE(fs::exists(parts.folder / "m1.svg"));
  EXPECT_FALSE(fs::exists(parts.folder / "epura-batch.jsonl"));
  const Outcome sorted = epura({"draw", "parts/a/m0.obj", "-o", "new/{folder}/{name}.svg"}, parts.folder / "");
  EXPECT_EQ(sorted.code, 0) << sorted.err;
  EXPECT_TRUE(fs::exists(parts.folder / "new/parts/a/m0.svg"));
}

TEST(Batch, ReadsTables) {
  const Parts parts(3);
  write_file(parts.folder / "jobs.csv",
             "file;output;title;projection\r\n"
             "parts/a/m0.obj;csv/one.svg;\"A \"\"cube\"\"; and more\";cavalier\r\n"
             "parts/b/m1.obj;csv/{name}.svg;;\r\n");
  EXPECT_EQ(parts.run({"--table", "jobs.csv"}).out, "2 drawn, 0 failed\n");
  EXPECT_TRUE(contains(read_file(parts.folder / "csv/one.svg"), "<title>A &quot;cube&quot;; and more</title>"));
  write_file(
      parts.folder / "jobs.toml",
      "[[job]]\nfile = \"parts/a/m2.obj\"\noutput = \"toml/{name}.svg\"\ntitle = \"{name}\"\nhidden = \"none\"\n");
  EXPECT_EQ(parts.run({"--table", "jobs.toml"}).out, "1 drawn, 0 failed\n");
  EXPECT_TRUE(contains(read_file(parts.folder / "toml/m2.svg"), "<title>m2</title>"));
  write_file(parts.folder / "lists.toml",
             "[[job]]\nfile = \"parts/a/m2.obj\"\noutput = [\"two/a.svg\", \"two/a.pdf\"]\n"
             "projection = [\"front\", \"top\"]\n");
  EXPECT_EQ(parts.run({"--table", "lists.toml"}).out, "1 drawn, 0 failed\n");
  EXPECT_TRUE(contains(read_file(parts.folder / "two/a.svg"), "inkscape:label=\"top\""));
  EXPECT_TRUE(fs::exists(parts.folder / "two/a.pdf"));
}

// Whoever wrote it may be a stranger: what holds for scene files holds for tables.
TEST(BatchTableOfAStranger, NamesOnlyWhatLiesBelowItsFolder) {
  const Parts parts(1);
  fs::create_directories(parts.folder / "theirs/plugins");
  fs::copy(parts.folder / "parts/a/m0.obj", parts.folder / "theirs/m.obj");
  fs::copy(parts.folder / "parts/a/m0.obj", parts.folder / "m.obj");
  fs::create_symlink("../absent.svg", parts.folder / "theirs/link.svg");
  fs::create_symlink("../m.obj", parts.folder / "theirs/link.obj");
  write_file(parts.folder / "style.toml", "[visible]\ncolour = \"#f00\"\n");
  struct Case {
    std::string heading, row, words;
  };
  const std::vector<Case> cases{
      {"file,output,plugin-path", "m.obj,x.svg,plugins", "a table must not say 'plugin-path'"},
      {"file,output,allow-outside", "m.obj,x.svg,true", "a table must not say 'allow-outside'"},
      {"file,output,sandbox", "m.obj,x.svg,off", "a table must not say 'sandbox'"},
      {"file,output", "m.obj,../x.svg", "x.svg' lies outside"},
      {"file,output", "m.obj," + (parts.folder / "x.svg").string(), "x.svg' lies outside"},
      {"file,output", "m.obj,link.svg", "link.svg' lies outside"},
      {"file,output", "m.obj,../{name}.svg", "m.svg' lies outside"},
      {"file,output", "m.obj:memory=9,x.svg", "'memory' changes what reading the file may take"},
      {"file,output", "../m.obj,x.svg", "m.obj' lies outside"},
      {"file,output", "link.obj,x.svg", "link.obj' lies outside"},
      {"file,output,style", "m.obj,x.svg,../style.toml", "style.toml' lies outside"},
      {"file,output,template", "m.obj,x.svg,/etc/passwd", "passwd' lies outside"},
      {"file,output,font", "m.obj,x.svg,../font.ttf", "font.ttf' lies outside"},
  };
  const auto names = parts.folder.names();
  for (const Case& one : cases) {
    write_file(parts.folder / "theirs/jobs.csv", one.heading + "\n" + one.row + "\n");
    const Outcome run = parts.run({"--table", "theirs/jobs.csv"});
    EXPECT_EQ(run.code, 2) << one.row;
    EXPECT_TRUE(contains(run.err, "jobs.csv:2: ") && contains(run.err, one.words)) << run.err;
    EXPECT_EQ(parts.folder.names(), names) << one.row;
  }
  // What the user writes on the command line is the user's.
  write_file(parts.folder / "theirs/jobs.csv", "file,style\n../m.obj,../style.toml\n");
  EXPECT_EQ(parts.run({"--table", "theirs/jobs.csv", "-o", "{name}.svg"}).code, 2);
  const Outcome run = parts.run({"--table", "theirs/jobs.csv", "-o", "{name}.svg", "--allow-outside"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(read_file(parts.folder / "m.svg"), "stroke=\"#ff0000\""));
}

TEST(BatchTableOfAStranger, GetsNoManifestElsewhere) {
  const Parts parts(1);
  fs::create_directory(parts.folder / "theirs");
  fs::copy(parts.folder / "parts/a/m0.obj", parts.folder / "theirs/m.obj");
  fs::create_symlink("../absent", parts.folder / "theirs/epura-batch.jsonl");
  write_file(parts.folder / "theirs/jobs.csv", "file,output\nm.obj,x.svg\n");
  const Outcome run = parts.run({"--table", "theirs/jobs.csv"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "epura-batch.jsonl: is a link that leaves its folder")) << run.err;
  EXPECT_FALSE(fs::exists(parts.folder / "absent"));
}

TEST(Batch, ANameThatLeadsUpwardsDoesNot) {
  const Parts parts(0);
  fs::create_directory(parts.folder / "in");
  for (const char* name : {"...obj", "..obj"}) write_file(parts.folder / "in" / name, block(1));
  const Outcome run = parts.run({"in/...obj", "in/..obj", "-o", "out/{name}/x.svg"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(parts.drawings("out").count("...obj/x.svg"), 1U);
  EXPECT_EQ(parts.drawings("out").size(), 2U);
  EXPECT_FALSE(fs::exists(parts.folder / "x.svg"));
}

TEST(Batch, TellsHowManyDrawingsHaveWarnings) {
  const Parts parts(2);
  // A face without an area, whose repair is told.
  write_file(parts.folder / "parts/a/m0.obj", block(1) + "f 1 1 2\n");
  const std::string told = "0 failed, 1 with warnings (--report FILE.html shows them)\n";
  EXPECT_EQ(parts.draw_all().out, "2 drawn, " + told);
  EXPECT_EQ(parts.draw_all().out, "0 drawn, 2 unchanged, " + told);
  const Outcome run = parts.draw_all({"--report", "r.html"});
  EXPECT_TRUE(contains(run.out, "1 with warnings (see r.html)")) << run.out;
}

TEST(Batch, TellsRowsWithTheSameModelApart) {
  const Parts parts(1);
  write_file(parts.folder / "jobs.csv",
             "file,output,hidden\nparts/a/m0.obj,one.svg,none\nparts/a/m0.obj,two.svg,dots\n");
  const Outcome run = parts.run({"--table", "jobs.csv", "--junit", "r.xml"});
  EXPECT_TRUE(contains(run.err, "FAILED parts/a/m0.obj (two.svg)\n")) << run.err;
  EXPECT_TRUE(contains(read_file(parts.folder / "r.xml"), "name=\"parts/a/m0.obj (one.svg)\""));
}

TEST(Batch, TheReportHasPicturesOfWhatBrowsersDoNotShow) {
  const Parts parts(2);
  const std::vector<std::string> jobs{"parts", "-o", "pdf/{name}.pdf", "--projection", "cabinet"};
  const auto run = [&](std::vector<std::string> options) {
    options.insert(options.begin(), jobs.begin(), jobs.end());
    return parts.run(options).out;
  };
  EXPECT_EQ(run({}), "2 drawn, 0 failed\n");
  EXPECT_FALSE(fs::exists(parts.folder / "pdf/index-pictures"));
  EXPECT_EQ(run({"--report", "pdf/index.html"}), "2 drawn, 0 failed\n");
  const std::string page = read_file(parts.folder / "pdf/index.html");
  EXPECT_TRUE(contains(page, "<a href=\"./m0.pdf\"><img")) << page;
  std::vector<fs::path> pictures;
  for (const auto& entry : fs::directory_iterator(parts.folder / "pdf/index-pictures")) {
    pictures.push_back(entry.path());
    EXPECT_TRUE(contains(page, " src=\"./index-pictures/" + entry.path().filename().string() + "\""));
    EXPECT_TRUE(read_file(entry.path()).starts_with("\x89PNG"));
  }
  ASSERT_EQ(pictures.size(), 2U);
  EXPECT_EQ(run({"--report", "pdf/index.html"}), "0 drawn, 2 unchanged, 0 failed\n");
  EXPECT_EQ(run({}), "0 drawn, 2 unchanged, 0 failed\n");
  fs::remove(pictures.front());
  EXPECT_EQ(run({"--report", "pdf/index.html"}), "1 drawn, 1 unchanged, 0 failed\n");
}

TEST(Batch, ResumesOnlyWhatWasBegun) {
  const Parts parts(2);
  const Outcome nothing = parts.draw_all({"--resume"});
  EXPECT_EQ(nothing.code, 2);
  EXPECT_TRUE(contains(nothing.err, "epura-batch.jsonl: there is no batch to continue")) << nothing.err;
  EXPECT_FALSE(fs::exists(parts.folder / "out"));
  EXPECT_EQ(parts.draw_all().code, 0);
  fs::remove(parts.folder / "out/parts/b/m1.svg");
  EXPECT_EQ(parts.draw_all({"--resume"}).out, "1 drawn, 1 unchanged, 0 failed\n");
  EXPECT_EQ(parts.draw_all({"--resume", "--again"}).code, 2);
}

TEST(Batch, RefusesWhatWouldLoseDrawings) {
  const Parts parts(2);
  struct Case {
    std::vector<std::string> options;
    std::string words;
  };
  write_file(parts.folder / "unknown.csv", "file,titel\nparts/a/m0.obj,x\n");
  write_file(parts.folder / "open.csv", "file,title\nparts/a/m0.obj,\"x\n");
  write_file(parts.folder / "wide.csv", "file\nparts/a/m0.obj,x\n");
  write_file(parts.folder / "no.csv", "title\nx\n");
  for (const Case& one : std::vector<Case>{
           {{"parts", "-o", "x.svg"}, "x.svg: would be written for parts/a/m0.obj and for parts/b/m1.obj"},
           {{"parts", "-o", "{nam}.svg"}, "unknown placeholder '{nam}'"},
           {{"parts"}, "has no output"},
           {{"parts/a/m0.obj", "-o", "-"}, "a batch writes to files only"},
           {{"parts/a/m0.obj", "-o", "parts/a/../a/{name}.obj"}, "is an output and also a model"},
           {{"-o", "{name}.svg"}, "there are no jobs"},
           {{"--table", "unknown.csv", "-o", "{name}.svg"}, "unknown.csv:2: unknown column 'titel'"},
           {{"--table", "open.csv", "-o", "{name}.svg"}, "open.csv:2: a quotation mark is not closed"},
           {{"--table", "wide.csv", "-o", "{name}.svg"}, "wide.csv:2: has 2 cells, and the heading 1"},
           {{"--table", "no.csv", "-o", "{name}.svg"}, "no.csv:2: has no model"},
           {{"parts", "-o", "out/{name}.svg", "--shard", "3/2"}, "part 3 of 2 does not exist"},
           {{"parts", "-o", "out/{name}.svg", "--shard", "auto"}, "no scheduler has numbered this job"},
           {{"--merge", "parts"}, "has no parts beside it"},
           {{"--merge", "nowhere/epura-batch.jsonl"}, "nowhere: cannot be listed: No such file or directory"}}) {
    const Outcome run = parts.run(one.options);
    EXPECT_EQ(run.code, 2) << one.words;
    EXPECT_TRUE(contains(run.err, one.words)) << run.err;
  }
}

TEST(Batch, AJobThatFailsCostsTheOthersNothing) {
  const Parts parts(4);
  write_file(parts.folder / "parts/a/m2.obj", "v 0 0\n");
  write_file(parts.folder / "parts/b/empty.obj", "");
  const Outcome run = parts.draw_all({"--junit", "r.xml", "--report", "out/index.html"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out, "3 drawn, 2 failed\n");
  EXPECT_TRUE(contains(run.err, "FAILED parts/a/m2.obj\n  parts/a/m2.obj:1: ")) << run.err;
  EXPECT_TRUE(contains(run.err, "FAILED parts/b/empty.obj\n")) << run.err;
  EXPECT_TRUE(contains(read_file(parts.folder / "r.xml"), "tests=\"5\" failures=\"0\" errors=\"2\""));
  const std::string page = read_file(parts.folder / "out/index.html");
  EXPECT_TRUE(contains(page, "<p>5 jobs, 2 failed</p>"));
  EXPECT_TRUE(contains(page, "src=\"./parts/b/m1.svg\""));
  // Failed jobs are tried again.
  write_file(parts.folder / "parts/a/m2.obj", block(9));
  write_file(parts.folder / "parts/b/empty.obj", block(1));
  EXPECT_EQ(parts.draw_all().out, "2 drawn, 3 unchanged, 0 failed\n");
}

TEST(Batch, LimitsTheTimeAndMemoryOfJobs) {
  const Parts parts(2);
  write_file(parts.folder / "parts/a/long.obj", tangle(1500));
  const Outcome late = parts.draw_all({"--job-time", "0.3", "--hidden", "dashed"});
  EXPECT_EQ(late.code, 1);
  EXPECT_EQ(late.out, "2 drawn, 1 failed\n");
  EXPECT_TRUE(contains(late.err, "parts/a/long.obj: takes more than 0.3 s")) << late.err;
  const Outcome large = parts.draw_all({"--job-memory", "50", "--hidden", "dashed"});
  EXPECT_EQ(large.out, "0 drawn, 2 unchanged, 1 failed\n");
  EXPECT_TRUE(contains(large.err, "parts/a/long.obj: takes more than 50 MB")) << large.err;
}

struct Process {
  std::string command;
  pid_t parent = 0;
};

Process process(const std::string& number) {
  std::ifstream stat("/proc/" + number + "/stat");
  std::string word, state;
  Process found;
  stat >> word >> found.command >> state >> found.parent;
  return found;
}

/// The processes in a folder that the batch started, without those that they started themselves.
std::vector<pid_t> workers_in(const fs::path& folder) {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::error_code gone;
    if (fs::read_symlink(entry.path() / "cwd", gone) != fs::canonical(folder) || gone) continue;
    const Process worker = process(name), batch = process(std::to_string(worker.parent));
    const Process starter = process(std::to_string(batch.parent));
    if (worker.command == "(epura)" && batch.command == "(epura)" && starter.command != "(epura)")
      found.push_back(std::stoi(name));
  }
  return found;
}

TEST(Batch, ReportsAJobWhoseProcessIsKilled) {
  const Parts parts(3);
  write_file(parts.folder / "parts/a/long.obj", tangle(1500));
  // A folder would start importers for a moment.
  Running run({"batch", "parts/**/*.obj", "-o", "out/{name}.svg", "--hidden", "dashed", "--workers", "1"},
              parts.folder / "");
  std::vector<pid_t> workers;
  while (workers.empty()) workers = workers_in(parts.folder / "");
  EXPECT_EQ(workers.size(), 1U);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  ::kill(workers.front(), SIGKILL);
  const Outcome outcome = run.wait();
  EXPECT_EQ(outcome.out, "3 drawn, 1 failed\n");
  EXPECT_TRUE(contains(outcome.err, "long.obj: crashes (Killed)")) << outcome.err;
}

TEST(Batch, LosesNothingWhenItIsKilled) {
  const Parts parts(30);
  ASSERT_EQ(parts.draw_all().code, 0);
  const auto expected = parts.drawings();
  for (const int milliseconds : {2, 10, 20, 40, 80}) {
    fs::remove_all(parts.folder / "out");
    {
      Running run({"batch", "parts", "-o", "out/{folder}/{name}.svg", "--projection", "cabinet"}, parts.folder / "");
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      run.signal(SIGKILL);
      static_cast<void>(run.wait());
    }
    while (!workers_in(parts.folder / "").empty()) ::usleep(1000);
    fs::create_directories(parts.folder / "out");
    for (const auto& [name, bytes] : parts.drawings()) EXPECT_EQ(bytes, expected.at(name)) << name;
    EXPECT_EQ(parts.draw_all().code, 0);
    EXPECT_EQ(parts.drawings(), expected);
    EXPECT_EQ(parts.draw_all().out, "0 drawn, 30 unchanged, 0 failed\n");
  }
}

TEST(Batch, PartsMakeTheSameAsTheWhole) {
  const Parts parts(7);
  ASSERT_EQ(parts.draw_all().code, 0);
  const auto expected = parts.drawings();
  fs::remove_all(parts.folder / "out");
  ASSERT_EQ(parts.draw_all({"--shard", "1/3"}).code, 0);
  const Outcome early = parts.run({"--merge", "out"});
  EXPECT_EQ(early.code, 2);
  EXPECT_TRUE(contains(early.err, "part 2 of 3 is missing")) << early.err;
  {
    const Variable id("SLURM_ARRAY_TASK_ID", "11"), min("SLURM_ARRAY_TASK_MIN", "10"),
        count("SLURM_ARRAY_TASK_COUNT", "3");
    ASSERT_EQ(parts.draw_all({"--shard", "auto"}).code, 0);
  }
  {
    const Variable index("JOB_COMPLETION_INDEX", "2");
    ASSERT_EQ(parts.draw_all({"--shard", "auto/3"}).code, 0);
  }
  EXPECT_EQ(parts.drawings(), expected);
  EXPECT_EQ(parts.run({"--merge", "out", "--report", "out.html"}).out, "out/epura-batch.jsonl: 7 drawn, 0 failed\n");
  EXPECT_EQ(parts.draw_all().out, "0 drawn, 7 unchanged, 0 failed\n");
}

TEST(Batch, WorksWithAnyNames) {
  const Parts parts(0);
  for (const std::string name : {"a b", "new\nline", "q\"uote'", "ünïcode ✓", "<script>alert(1)</script>", "{name}"}) {
    std::string file = name;
    std::replace(file.begin(), file.end(), '/', '_');
    fs::create_directories(parts.folder / "parts");
    write_file(parts.folder / ("parts/" + file + ".obj"), block(1));
  }
  EXPECT_EQ(parts.draw_all({"--report", "r.html"}).out, "6 drawn, 0 failed\n");
  EXPECT_EQ(parts.drawings().size(), 6U);
  EXPECT_EQ(parts.draw_all().out, "0 drawn, 6 unchanged, 0 failed\n");
  EXPECT_FALSE(contains(read_file(parts.folder / "r.html"), "<script>alert"));
}

TEST(Batch, WaitsForTheLastWorkersOfAKilledBatch) {
  const Parts parts(2);
  ASSERT_EQ(parts.draw_all().code, 0);
  const int manifest = ::open((parts.folder / "out/epura-batch.jsonl").c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(manifest, LOCK_EX), 0);
  std::thread worker([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ::close(manifest);
  });
  const Outcome run = parts.draw_all();
  worker.join();
  EXPECT_EQ(run.out, "0 drawn, 2 unchanged, 0 failed\n") << run.err;
}

TEST(Batch, EstimatesTimesFromNumbersOfTriangles) {
  const Folder folder;
  const auto estimate = [&](const std::string& name, const std::string& bytes) {
    write_file(folder / name, bytes);
    return estimated_time({(folder / name).string()});
  };
  const double nothing = estimated_time({});
  const double one =
      (estimate("facet.stl", std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(50, ' ')) - nothing);
  EXPECT_GT(one, 0);
  EXPECT_DOUBLE_EQ(estimate("text.stl", "solid" + std::string(995, ' ')) - nothing, 4 * one);
  EXPECT_DOUBLE_EQ(estimate("a.ply", "ply\nelement vertex 9\nelement face 1000\r\nend_header\n") - nothing, 1000 * one);
  EXPECT_DOUBLE_EQ(estimate("a.off", "OFF # by hand\n# comment\n8 12 0\n") - nothing, 12 * one);
  EXPECT_DOUBLE_EQ(estimate("a.obj", std::string(350, ' ')) - nothing, 10 * one);
  EXPECT_GT(estimate("a.step", " "), estimate("b.obj", std::string(1000, ' ')));
  EXPECT_DOUBLE_EQ(estimated_time({(folder / "absent.stl").string()}), nothing);
}

TEST(Batch, RefusesASecondBatchInOneFolder) {
  const Parts parts(1);
  write_file(parts.folder / "parts/a/long.obj", tangle(1500));
  Running run({"batch", "parts", "-o", "out/{name}.svg", "--hidden", "dashed"}, parts.folder / "");
  while (!fs::exists(parts.folder / "out/epura-batch.jsonl")) ::usleep(1000);
  const Outcome second = parts.run({"parts", "-o", "out/{name}.svg"});
  EXPECT_EQ(second.code, 4);
  EXPECT_TRUE(contains(second.err, "another batch is writing to it")) << second.err;
  run.signal(SIGINT);
  EXPECT_EQ(run.wait().code, 130);
}

}  // namespace
}  // namespace epura::test::batch_test
