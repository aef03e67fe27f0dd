// SPDX-License-Identifier: Apache-2.0
#include "package.hpp"

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "xml.hpp"

namespace epura::plugin::threemf {

namespace {

// XML of meshes shrinks to a tenth; the rest is for small files.
constexpr std::uint64_t max_times_larger = 64, min_allowed = std::uint64_t{256} << 20;

constexpr const char* relationships = "_rels/.rels";

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
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using File = std::unique_ptr<zip_file_t, Close>;

zip_t* open(const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr && source != nullptr) zip_source_free(source);
  const std::string reason = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (archive == nullptr)
    throw std::runtime_error("is not a ZIP archive, as 3MF files are, or is cut short: " + reason);
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
std::string unpacked(zip_t* archive, std::uint64_t number) {
  const zip_stat_t entry = entry_at(archive, number);
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

const char* without_slash(const std::string& part) { return part.c_str() + (part.substr(0, 1) == "/" ? 1 : 0); }

}  // namespace

Package::Package(const std::string& path) : bytes_(whole_file(path)), archive_(open(bytes_)) {
  const auto count = static_cast<std::uint64_t>(zip_get_num_entries(archive_.get(), 0));
  const std::uint64_t most = max_times_larger * bytes_.size() + min_allowed;
  std::uint64_t size = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const zip_stat_t entry = entry_at(archive_.get(), i);
    if (entry.size > most - size)
      throw std::runtime_error("unpacks to more than " + std::to_string(most >> 20) + " MB, " +
                               std::to_string(most / bytes_.size()) + " times its size, which models do not");
    size += entry.size;
    parts_.emplace_back(entry.name);
  }
  if (!has(relationships))
    throw std::runtime_error(std::string("is a ZIP archive, but no 3MF: '") + relationships + "' is missing");
}

bool Package::has(const std::string& part) const {
  return zip_name_locate(archive_.get(), without_slash(part), ZIP_FL_NOCASE) >= 0;
}

std::string Package::text_of(const std::string& part) const {
  const zip_int64_t number = zip_name_locate(archive_.get(), without_slash(part), ZIP_FL_NOCASE);
  if (number < 0) throw std::runtime_error("'" + part + "', to which it refers, is missing in it");
  return unpacked(archive_.get(), static_cast<std::uint64_t>(number));
}

// What else it names, such as a picture of the model, is not needed, and programs name it where it is missing.
std::string Package::model_part() const {
  constexpr std::string_view kind = "/3dmodel";
  const std::string text = text_of(relationships);
  for (Xml xml(text); xml.next();) {
    const std::string type = xml.tag().text("Type");
    const bool is_model = type.size() > kind.size() && type.substr(type.size() - kind.size()) == kind;
    if (xml.tag().name == "Relationship" && is_model) return without_slash(xml.tag().text("Target"));
  }
  throw std::runtime_error(std::string("is a ZIP archive, but no 3MF: '") + relationships + "' names no model");
}

}  // namespace epura::plugin::threemf
