// SPDX-License-Identifier: Apache-2.0
// ZIP archives and the files of 3MF in them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace epura::test {

inline std::uint32_t crc_of(std::string_view bytes) {
  std::uint32_t crc = ~std::uint32_t{0};
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc % 2 == 1 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

inline std::string little(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 255);
  return text;
}

struct Entry {
  std::string name, bytes;
  bool is_packed = false;     ///< by the method of blocks that are stored
  std::uint32_t claimed = 0;  ///< size that the directory tells; 0: the true one
  int flags = 0;
};

/// A ZIP archive, after the specification of PKWARE.
inline std::string archive_of(const std::vector<Entry>& entries) {
  std::string bytes, directory;
  for (const Entry& entry : entries) {
    const auto size = static_cast<std::uint32_t>(entry.bytes.size());
    // One last block of deflate: its length, the length inverted, and the bytes as they are.
    const std::string packed = entry.is_packed ? '\1' + little(size, 2) + little(~size, 2) + entry.bytes : entry.bytes;
    const std::string common = little(20, 2) + little(static_cast<std::uint32_t>(entry.flags), 2) +
                               little(entry.is_packed ? 8 : 0, 2) + little(0, 4) + little(crc_of(entry.bytes), 4) +
                               little(static_cast<std::uint32_t>(packed.size()), 4) +
                               little(entry.claimed == 0 ? size : entry.claimed, 4) +
                               little(static_cast<std::uint32_t>(entry.name.size()), 2) + little(0, 2);
    directory += "PK\1\2" + little(20, 2) + common + little(0, 10) +
                 little(static_cast<std::uint32_t>(bytes.size()), 4) + entry.name;
    bytes += "PK\3\4" + common + entry.name + packed;
  }
  const auto count = static_cast<std::uint32_t>(entries.size());
  return bytes + directory + "PK\5\6" + little(0, 4) + little(count, 2) + little(count, 2) +
         little(static_cast<std::uint32_t>(directory.size()), 4) + little(static_cast<std::uint32_t>(bytes.size()), 4) +
         little(0, 2);
}

inline const std::string types =
    R"(<?xml version="1.0" encoding="UTF-8"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">)"
    R"(<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>)"
    R"(<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)";

inline std::string relations_to(const std::string& target) {
  return R"(<?xml version="1.0" encoding="UTF-8"?>)"
         R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
         R"(<Relationship Target=")" +
         target + R"(" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";
}

inline std::vector<Entry> entries_with(const std::string& xml) {
  return {
      {"[Content_Types].xml", types}, {"_rels/.rels", relations_to("/3D/3dmodel.model")}, {"3D/3dmodel.model", xml}};
}

inline std::string model_of(const std::string& resources, const std::string& build,
                            const std::string& unit = "millimeter") {
  return R"(<?xml version="1.0" encoding="UTF-8"?><model unit=")" + unit +
         R"(" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02")"
         R"( xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02")"
         R"( xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06"><resources>)" +
         resources + "</resources><build>" + build + "</build></model>";
}

}  // namespace epura::test
