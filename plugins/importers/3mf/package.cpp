// SPDX-License-Identifier: Apache-2.0
#include "package.hpp"

#include <zip.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "components.hpp"

namespace epura::plugin::threemf {

namespace {

// XML of meshes shrinks to a tenth; the rest is for small files.
constexpr std::uint64_t most_times_larger = 64, least_allowed = std::uint64_t{256} << 20;

std::string whole_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  if (!file || size < 0) throw std::runtime_error("cannot be opened");
  std::string bytes(static_cast<std::size_t>(size), 0);
  file.seekg(0);
  file.read(bytes.data(), size);
  if (!file) throw std::runtime_error("cannot be read");
  return bytes;
}

struct Close {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, Close>;
using Archive = std::unique_ptr<zip_t, Close>;
using File = std::unique_ptr<zip_file_t, Close>;

Archive open(const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  Archive archive(source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error));
  if (!archive && source != nullptr) zip_source_free(source);
  const std::string reason = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (!archive) throw std::runtime_error("is not a ZIP archive, as 3MF files are, or is cut short: " + reason);
  return archive;
}

zip_stat_t entry_at(zip_t* archive, std::uint64_t number) {
  zip_stat_t entry;
  zip_stat_init(&entry);
  constexpr std::uint64_t needed = ZIP_STAT_NAME | ZIP_STAT_SIZE;
  if (zip_stat_index(archive, number, 0, &entry) != 0 || (entry.valid & needed) != needed)
    throw std::runtime_error("holds an archive with a damaged directory");
  if ((entry.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && entry.encryption_method != ZIP_EM_NONE)
    throw std::runtime_error("is encrypted: '" + std::string(entry.name) + "' cannot be read");
  return entry;
}

// The archive's directory may give too small a size.
std::string unpacked(zip_t* archive, std::uint64_t number, const zip_stat_t& entry) {
  const std::string what = "'" + std::string(entry.name) + "'";
  const File file(zip_fopen_index(archive, number, 0));
  if (!file) throw std::runtime_error(what + " in it cannot be unpacked: " + zip_strerror(archive));
  // One byte more than expected.
  std::string text(entry.size + 1, 0);
  std::uint64_t size = 0;
  while (size < text.size()) {
    const zip_int64_t count = zip_fread(file.get(), text.data() + size, text.size() - size);
    if (count < 0) throw std::runtime_error(what + " in it is damaged: " + zip_file_strerror(file.get()));
    if (count == 0) break;
    size += static_cast<std::uint64_t>(count);
  }
  if (size > entry.size) throw std::runtime_error(what + " in it is larger than its directory says");
  if (size < entry.size) throw std::runtime_error(what + " in it is cut short");
  text.pop_back();
  return text;
}

std::string_view value_of(std::string_view tag, std::string_view name) {
  const std::size_t found = tag.find(name);
  if (found == std::string_view::npos) return {};
  const std::size_t quote = tag.find_first_of("\"'", found + name.size());
  if (quote == std::string_view::npos) return {};
  const std::size_t end = tag.find(tag[quote], quote + 1);
  return tag.substr(quote + 1, end == std::string_view::npos ? end : end - quote - 1);
}

// Replaces triangles with two equal corners by blanks, and returns their number.
std::size_t blank_degenerate(std::string& text) {
  constexpr std::string_view start = "<triangle", end = "/>";
  std::size_t count = 0;
  for (std::size_t place = text.find(start); place != std::string::npos; place = text.find(start, place)) {
    const std::size_t behind = text.find('>', place);
    if (behind == std::string::npos) break;
    const std::string_view tag = std::string_view(text).substr(place, behind + 1 - place);
    const bool is_whole = tag.find_first_of(" \t\r\n") == start.size() && tag.substr(tag.size() - end.size()) == end;
    const std::string_view a = value_of(tag, "v1"), b = value_of(tag, "v2"), c = value_of(tag, "v3");
    if (is_whole && !a.empty() && !b.empty() && !c.empty() && (a == b || b == c || c == a)) {
      text.replace(place, tag.size(), tag.size(), ' ');
      ++count;
    }
    place = behind;
  }
  return count;
}

// Returns the archive with the texts of these entries replaced.
std::string with_entries(const std::string& bytes, const std::map<std::uint64_t, std::string>& texts) {
  const auto expect = [](bool is_done) {
    if (!is_done) throw std::runtime_error("holds an archive that cannot be mended");
  };
  const Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr));
  expect(source != nullptr);
  zip_source_keep(source.get());
  Archive archive(zip_open_from_source(source.get(), 0, nullptr));
  if (!archive) zip_source_free(source.get());
  expect(archive != nullptr);
  for (const auto& [number, text] : texts) {
    zip_source_t* replacement = zip_source_buffer(archive.get(), text.data(), text.size(), 0);
    const bool is_replaced = replacement != nullptr && zip_file_replace(archive.get(), number, replacement, 0) == 0;
    if (!is_replaced && replacement != nullptr) zip_source_free(replacement);
    expect(is_replaced && zip_set_file_compression(archive.get(), number, ZIP_CM_STORE, 0) == 0);
  }
  expect(zip_close(archive.get()) == 0);
  static_cast<void>(archive.release());
  zip_stat_t stat;
  zip_stat_init(&stat);
  expect(zip_source_stat(source.get(), &stat) == 0 && zip_source_open(source.get()) == 0);
  std::string mended(stat.size, 0);
  const zip_int64_t count = zip_source_read(source.get(), mended.data(), mended.size());
  zip_source_close(source.get());
  expect(count == static_cast<zip_int64_t>(mended.size()));
  return mended;
}

}  // namespace

Package read_package(const std::string& path) {
  Package package{whole_file(path)};
  const Archive archive = open(package.bytes);
  const auto count = static_cast<std::uint64_t>(zip_get_num_entries(archive.get(), 0));
  const std::uint64_t most = most_times_larger * package.bytes.size() + least_allowed;
  std::uint64_t size = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const zip_stat_t entry = entry_at(archive.get(), i);
    if (entry.size > most - size)
      throw std::runtime_error("unpacks to more than " + std::to_string(most >> 20) + " MB, " +
                               std::to_string(most / package.bytes.size()) + " times its size, which models do not");
    size += entry.size;
  }
  Components components;
  std::map<std::uint64_t, std::string> mended;
  for (std::uint64_t i = 0; i < count; ++i) {
    const zip_stat_t entry = entry_at(archive.get(), i);
    std::string text = unpacked(archive.get(), i, entry);
    components.scan(entry.name, text);
    const std::size_t degenerate = blank_degenerate(text);
    package.degenerate += degenerate;
    if (degenerate > 0) mended.emplace(i, std::move(text));
  }
  components.expect_few();
  if (zip_name_locate(archive.get(), "_rels/.rels", 0) < 0)
    throw std::runtime_error("is a ZIP archive, but no 3MF: '_rels/.rels' is missing");
  if (!mended.empty()) package.bytes = with_entries(package.bytes, mended);
  return package;
}

}  // namespace epura::plugin::threemf
