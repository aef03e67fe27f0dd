// SPDX-License-Identifier: Apache-2.0
#include "package.hpp"

#include <zip.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <stdexcept>
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
};
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
  if (!archive) throw std::runtime_error("is no ZIP archive, which 3MF files are, or is cut short: " + reason);
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

// Its directory may say less than there is.
std::string unpacked(zip_t* archive, std::uint64_t number, const zip_stat_t& entry) {
  const std::string what = "'" + std::string(entry.name) + "'";
  const File file(zip_fopen_index(archive, number, 0));
  if (!file) throw std::runtime_error(what + " in it cannot be unpacked: " + zip_strerror(archive));
  // One byte more than there should be.
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

}  // namespace

std::string read_package(const std::string& path) {
  std::string bytes = whole_file(path);
  const Archive archive = open(bytes);
  const auto count = static_cast<std::uint64_t>(zip_get_num_entries(archive.get(), 0));
  const std::uint64_t most = most_times_larger * bytes.size() + least_allowed;
  std::uint64_t size = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const zip_stat_t entry = entry_at(archive.get(), i);
    if (entry.size > most - size)
      throw std::runtime_error("unpacks to more than " + std::to_string(most >> 20) + " MB, " +
                               std::to_string(most / bytes.size()) + " times its size, which models do not");
    size += entry.size;
  }
  Components components;
  for (std::uint64_t i = 0; i < count; ++i) {
    const zip_stat_t entry = entry_at(archive.get(), i);
    components.scan(entry.name, unpacked(archive.get(), i, entry));
  }
  components.expect_few();
  if (zip_name_locate(archive.get(), "_rels/.rels", 0) < 0)
    throw std::runtime_error("is a ZIP archive, but no 3MF: '_rels/.rels' is missing");
  return bytes;
}

}  // namespace epura::plugin::threemf
