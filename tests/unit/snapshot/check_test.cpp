// SPDX-License-Identifier: Apache-2.0
// epura check, as users run it: a drawing proves itself, and each part of it that was changed is found.
#include <gtest/gtest.h>
#include <qpdf/qpdf-c.h>

#include <cstdlib>
#include <functional>

#include "app/hash.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::check_test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

std::string box_of_height(const std::string& height) {
  std::string text;
  for (const std::string& z : {std::string("0"), height})
    for (const char* corner : {"0 0 ", "40 0 ", "40 30 ", "0 30 "}) text += std::string("v ") + corner + z + "\n";
  return text + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

/// A folder with box.obj, and a drawing of it.
struct Drawn {
  Folder folder;
  std::string name;

  Drawn(const std::string& file, const std::string& proof, std::vector<std::string> more = {}) : name(file) {
    write_file(folder / "box.obj", box_of_height("20"));
    more.insert(more.begin(), {"draw", "box.obj", "--views", "front,top", "--dimensions", "overall", "--sheet", "A4",
                               "--title", "A box", "--proof", proof, "-o", file});
    const Outcome run = epura(more, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
  }

  [[nodiscard]] std::string bytes() const { return read_file(folder / name); }
  [[nodiscard]] Outcome check(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"check", name});
    return epura(more, folder / "");
  }
  /// Checks other bytes under the same name.
  [[nodiscard]] Outcome check_changed(const std::string& bytes) const {
    write_file(folder / name, bytes);
    return check();
  }
};

void expect_found(const Outcome& run, const std::string& words) {
  EXPECT_EQ(run.code, 1) << run.out << run.err;
  EXPECT_TRUE(contains(run.out, words)) << run.out << run.err;
  EXPECT_TRUE(run.out.ends_with("NOT proved\n")) << run.out;
}

/// A PDF file, changed by qpdf through its C interface, and written again.
std::string rewritten(const std::string& bytes, const std::function<void(qpdf_data)>& change) {
  qpdf_data pdf = qpdf_init();
  qpdf_read_memory(pdf, "test", bytes.data(), bytes.size(), nullptr);
  change(pdf);
  qpdf_init_write_memory(pdf);
  qpdf_set_deterministic_ID(pdf, QPDF_TRUE);
  qpdf_write(pdf);
  std::string written(reinterpret_cast<const char*>(qpdf_get_buffer(pdf)), qpdf_get_buffer_length(pdf));
  qpdf_cleanup(&pdf);
  return written;
}

std::string content_of(qpdf_data pdf, qpdf_oh stream) {
  unsigned char* data = nullptr;
  std::size_t length = 0;
  qpdf_oh_get_stream_data(pdf, stream, qpdf_dl_all, nullptr, &data, &length);
  std::string content(reinterpret_cast<const char*>(data), length);
  std::free(data);
  return content;
}

void replace_content(qpdf_data pdf, qpdf_oh stream, const std::string& content) {
  qpdf_oh_replace_stream_data(pdf, stream, reinterpret_cast<const unsigned char*>(content.data()), content.size(),
                              qpdf_oh_new_null(pdf), qpdf_oh_new_null(pdf));
}

/// The stream of the layer with this name, on the first page.
qpdf_oh layer_of(qpdf_data pdf, const std::string& name) {
  qpdf_oh page = qpdf_get_page_n(pdf, 0), contents = qpdf_oh_get_key(pdf, page, "/Contents");
  qpdf_oh layers = qpdf_oh_get_key(pdf, qpdf_oh_get_key(pdf, page, "/Resources"), "/Properties");
  for (int i = 0; 2 * i + 1 < qpdf_oh_get_array_n_items(pdf, contents); ++i) {
    qpdf_oh layer = qpdf_oh_get_key(pdf, layers, ("/layer" + std::to_string(i)).c_str());
    if (qpdf_oh_get_utf8_value(pdf, qpdf_oh_get_key(pdf, layer, "/Name")) == name)
      return qpdf_oh_get_array_item(pdf, contents, 2 * i + 1);
  }
  ADD_FAILURE() << "no layer " << name;
  return contents;
}

/// The stream of the attachment with this name.
qpdf_oh attachment_of(qpdf_data pdf, const std::string& name) {
  qpdf_oh files = qpdf_oh_get_key(pdf, qpdf_get_root(pdf), "/AF");
  for (int i = 0; i < qpdf_oh_get_array_n_items(pdf, files); ++i) {
    qpdf_oh file = qpdf_oh_get_array_item(pdf, files, i);
    if (qpdf_oh_get_utf8_value(pdf, qpdf_oh_get_key(pdf, file, "/UF")) == name)
      return qpdf_oh_get_key(pdf, qpdf_oh_get_key(pdf, file, "/EF"), "/UF");
  }
  ADD_FAILURE() << "no attachment " << name;
  return files;
}

/// The same file with a change of an attachment.
std::string with_attachment(const std::string& pdf, const std::string& name, const std::string& from,
                            const std::string& to) {
  return rewritten(pdf, [&](qpdf_data data) {
    qpdf_oh stream = attachment_of(data, name);
    replace_content(data, stream, replaced(content_of(data, stream), from, to));
  });
}

class Carried : public testing::TestWithParam<const char*> {};

TEST_P(Carried, ProvesADrawingByTheModelInIt) {
  const Drawn drawn(GetParam(), "model");
  std::filesystem::remove(drawn.folder / "box.obj");
  const Outcome run = drawn.check();
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(contains(run.out, "box.obj (carried by the drawing): the file that was drawn, SHA-256 " +
                                    hash_of_bytes(box_of_height("20"))))
      << run.out;
  EXPECT_TRUE(contains(run.out, "the same file, byte for byte")) << run.out;
  EXPECT_TRUE(contains(run.out, " 0 wrong")) << run.out;
  EXPECT_TRUE(run.out.ends_with("proved: it is what its models and options give\n")) << run.out;
  EXPECT_EQ(drawn.folder.names(), std::vector<std::string>{GetParam()});
}

TEST_P(Carried, NeedsTheModelOfADrawingWithoutIt) {
  const Drawn drawn(GetParam(), "data");
  EXPECT_EQ(drawn.check().code, 0);
  write_file(drawn.folder / "box.obj", box_of_height("21"));
  expect_found(drawn.check(), "box.obj (box.obj): is not the file that was drawn");
  std::filesystem::remove(drawn.folder / "box.obj");
  const Outcome run = drawn.check();
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "was drawn from box.obj, which it does not carry")) << run.err;
  std::filesystem::create_directory(drawn.folder / "models");
  write_file(drawn.folder / "models/box.obj", box_of_height("20"));
  EXPECT_EQ(drawn.check({"--inputs", "models"}).code, 0);
}

INSTANTIATE_TEST_SUITE_P(Formats, Carried, testing::Values("box.pdf", "box.svg"));

TEST(Check, SaysThatADrawingCarriesNoProof) {
  const Drawn drawn("box.pdf", "none");
  const Outcome run = drawn.check();
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "carries no proof")) << run.err;
}

TEST(Check, FindsAChangedSizeInAPdf) {
  const Drawn drawn("box.pdf", "model");
  const std::string changed = rewritten(drawn.bytes(), [](qpdf_data pdf) {
    qpdf_oh layer = layer_of(pdf, "front/dimensions");
    replace_content(pdf, layer, replaced(content_of(pdf, layer), "(40)", "(45)"));
  });
  expect_found(drawn.check_changed(changed), "layer front/dimensions is not as drawn now");
}

TEST(Check, FindsAChangedLineInAPdf) {
  const Drawn drawn("box.pdf", "model");
  const std::string changed = rewritten(drawn.bytes(), [](qpdf_data pdf) {
    qpdf_oh layer = layer_of(pdf, "front/visible");
    std::string content = content_of(pdf, layer);
    const std::size_t end = content.find(" re");  // of the outline, a rectangle: its height
    ASSERT_NE(end, content.npos);
    content[end - 4] = content[end - 4] == '1' ? '2' : '1';
    replace_content(pdf, layer, content);
  });
  const Outcome run = drawn.check_changed(changed);
  expect_found(run, "layer front/visible is not as drawn now");
  EXPECT_TRUE(contains(run.out, "lines that are seen:")) << run.out;
}

TEST(Check, FindsAChangedSizeInAnSvg) {
  const Drawn drawn("box.svg", "model", {"--svg-text", "text"});
  expect_found(drawn.check_changed(replaced(drawn.bytes(), ">40<", ">45<")), "front: width '40' -> '45'");
}

TEST(Check, FindsAChangedLineInAnSvg) {
  const Drawn drawn("box.svg", "model");
  const std::string bytes = drawn.bytes();
  const std::size_t line = bytes.find("data-kind=\"contour\"");
  ASSERT_NE(line, bytes.npos);
  const std::size_t begin = bytes.rfind('\n', line), end = bytes.find('\n', line);
  expect_found(drawn.check_changed(bytes.substr(0, begin) + bytes.substr(end)),
               "removed    front: visible line, 80 mm, (113.5, 141.825) to (193.5, 141.825), edge 0:0-1");
}

TEST(Check, FindsChangedAttachments) {
  const Drawn drawn("box.pdf", "model");
  const std::string bytes = drawn.bytes();
  expect_found(drawn.check_changed(with_attachment(bytes, "lint.json", "epura_lint", "epura_lind")),
               "lint.json was changed");
  expect_found(drawn.check_changed(with_attachment(bytes, "drawing-1.json", "contour", "crease")),
               "drawing-1.json was changed");
  expect_found(drawn.check_changed(with_attachment(bytes, "box.obj", "v 40 30 20", "v 40 30 21")),
               "box.obj (carried by the drawing): is not the file that was drawn");
  expect_found(drawn.check_changed(with_attachment(bytes, "proof.toml", "A box", "A cube")),
               "layer sheet/text is not as drawn now");
}

/// The same drawing with the first byte of a file changed that it carries, or without this file.
std::string with_damage(const std::string& bytes, bool is_pdf, const std::string& name, bool is_removed) {
  if (!is_pdf) {
    const std::size_t named = bytes.find(" name=\"" + name + "\" type="), text = bytes.find('>', named) + 1;
    EXPECT_NE(named, bytes.npos) << name;
    const std::string end = "</epura:attachment>";
    if (is_removed) return bytes.substr(0, bytes.rfind('<', named)) + bytes.substr(bytes.find(end, named) + end.size());
    std::string changed = bytes;
    changed[text] = changed[text] == 'Z' ? 'Y' : 'Z';
    return changed;
  }
  return rewritten(bytes, [&](qpdf_data pdf) {
    const qpdf_oh stream = attachment_of(pdf, name);
    if (!is_removed) {
      std::string content = content_of(pdf, stream);
      content[0] = content[0] == '~' ? '|' : '~';
      return replace_content(pdf, stream, content);
    }
    const qpdf_oh files = qpdf_oh_get_key(pdf, qpdf_get_root(pdf), "/AF");
    for (int i = qpdf_oh_get_array_n_items(pdf, files); i-- > 0;)
      if (qpdf_oh_get_utf8_value(pdf, qpdf_oh_get_key(pdf, qpdf_oh_get_array_item(pdf, files, i), "/UF")) == name)
        qpdf_oh_erase_item(pdf, files, i);
  });
}

// Whatever it carries, in whatever format: a scene file, a model, sheets as JSON, what lint finds, the proof itself.
TEST(Check, FindsDamageOfEachFile) {
  const Folder folder;
  write_file(folder / "box.obj", box_of_height("20"));
  write_file(folder / "scene.toml", "[[model]]\nfile = \"box.obj\"\n[[view]]\nprojection = \"front\"\n");
  const Outcome run = epura({"draw", "scene.toml", "--proof", "model", "-o", "box.pdf", "-o", "box.svg"}, folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  std::filesystem::remove(folder / "box.obj");
  for (const std::string drawing : {"box.pdf", "box.svg"}) {
    const std::string bytes = read_file(folder / drawing);
    for (const std::string name : {"box.obj", "drawing-1.json", "lint.json", "proof.toml", "scene.toml"})
      for (const bool is_removed : {false, true}) {
        write_file(folder / drawing, with_damage(bytes, drawing == "box.pdf", name, is_removed));
        const Outcome check = epura({"check", drawing}, folder / "");
        EXPECT_NE(check.code, 0) << drawing << name << is_removed << check.out;
        const std::string told = is_removed && name == "proof.toml" ? "carries no proof" : name;
        EXPECT_TRUE(contains(check.out + check.err, told)) << drawing << name << is_removed << check.out << check.err;
        EXPECT_FALSE(check.out.ends_with("\nproved: it is what its models and options give\n")) << drawing << name;
      }
  }
}

// Hashes that fit help nobody: the drawing is made again.
TEST(Check, FindsAnotherModelWithItsOwnHash) {
  const Drawn drawn("box.pdf", "model");
  std::string changed = with_attachment(drawn.bytes(), "box.obj", "v 40 30 20", "v 40 30 21");
  changed = with_attachment(changed, "proof.toml", hash_of_bytes(box_of_height("20")),
                            hash_of_bytes(replaced(box_of_height("20"), "v 40 30 20", "v 40 30 21")));
  expect_found(drawn.check_changed(changed), "layer front/visible is not as drawn now");
}

TEST(Check, FindsAFileThatWasAdded) {
  const Drawn drawn("box.svg", "model");
  const std::string one = "<epura:attachment xmlns:epura=\"urn:epura:proof\" name=\"more.txt\">TQ==</epura:attachment>";
  expect_found(drawn.check_changed(replaced(drawn.bytes(), "</metadata>", one + "</metadata>")), "more.txt was added");
}

// A stranger wrote the drawing.
TEST(Check, RefusesToReadOrWriteElsewhere) {
  const Drawn drawn("box.pdf", "model");
  const std::string bytes = drawn.bytes();
  struct Case {
    std::string from, to, words;
  };
  const std::string title = "name = \"--title\"\nvalue = \"A box\"";
  for (const auto& [from, to, words] : std::vector<Case>{
           {title, "name = \"--output\"\nvalue = \"out.svg\"", "is not an option of the drawing itself"},
           {title, "name = \"--plugin-path\"\nvalue = \".\"", "is not an option of the drawing itself"},
           {title, "name = \"--allow-outside\"\nvalue = \"true\"", "is not an option of the drawing itself"},
           {title, "name = \"--sandbox\"\nvalue = \"off\"", "is not an option of the drawing itself"},
           {title, "name = \"--logo\"\nvalue = \"../logo.svg\"", "does not lie below the folder"},
           {title, "name = \"--logo\"\nvalue = \"/etc/passwd\"", "does not lie below the folder"},
           {title, "name = \"--font\"\nvalue = \"/tmp/a.ttf\"", "does not lie below the folder"},
           {"models = [\"box.obj\"]", "models = [\"/etc/passwd\"]", "does not lie below the folder"},
           {"models = [\"box.obj\"]", "models = [\"a/../../box.obj\"]", "does not lie below the folder"},
           {"models = [\"box.obj\"]", "models = [\"box.obj:memory=100\"]", "changes what reading the file may take"},
           {"file = \"box.obj\"", "file = \"../../box.obj\"", "does not lie below the folder"},
           {"proof = 1", "proof = 2", "is of a newer epura"},
           {"proof = 1", "proof = [", "proof.toml:"}}) {
    const Outcome run = drawn.check_changed(with_attachment(bytes, "proof.toml", from, to));
    EXPECT_EQ(run.code, 2) << to << run.out;
    EXPECT_TRUE(contains(run.err, words)) << to << run.err;
    EXPECT_EQ(drawn.folder.names(), (std::vector<std::string>{"box.obj", "box.pdf"})) << to;
  }
}

TEST(Check, ProvesDrawingsOfSceneFiles) {
  const Folder folder;
  std::filesystem::create_directories(folder / "a/parts");
  write_file(folder / "a/parts/box.obj", box_of_height("20"));
  write_file(folder / "a/scene.toml",
             "[[model]]\nfile = \"parts/box.obj\"\n[[view]]\nprojection = \"front\"\nsheet = 1\n"
             "[[view]]\nprojection = \"top\"\nsheet = 2\n[[sheet]]\n[[sheet]]\n");
  const Outcome run = epura({"draw", "a/scene.toml", "--proof", "model", "-o", "x.pdf", "-o", "x.svg"}, folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* name : {"x.pdf", "x-1.svg", "x-2.svg"})
    EXPECT_EQ(epura({"check", name}, folder / "").code, 0) << name;
}

TEST(Check, RefusesProofsThatCouldNotBeRepeated) {
  const Folder folder;
  write_file(folder / "box.obj", box_of_height("20"));
  for (const std::vector<std::string>& more : {std::vector<std::string>{"-o", "x.dxf"},
                                               {"-o", "x.svg", "--inline"},
                                               {"-o", "x.svg", "--time-limit", "9"},
                                               {"-o", "x.svg", "--allow-outside"}}) {
    std::vector<std::string> words{"draw", "box.obj", "--proof", "data"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = epura(words, folder / "");
    EXPECT_EQ(run.code, 2) << more.back();
    EXPECT_TRUE(contains(run.err, "--proof")) << run.err;
  }
}

}  // namespace
}  // namespace epura::test::check_test
