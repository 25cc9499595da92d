#pragma once
/// Defines a binary file of named sections with checksums, written to a temporary name first: a file is whole or
/// absent.
///
///   bytes 0-7      magic, damaged by transfers as text
///   8-11           1, in the byte order of the writer
///   12-15          version of the format of the sections
///   16-19          number of the binary interface of the library that wrote it
///   20-23          sections, at most 16
///   24-39          version of that library, for people
///   40-47          bytes of the whole file
///   48-559         16 times: name (8 bytes), offset, length, XXH64 of the section; unused: zero
///   560-567        XXH64 of bytes 0-559
///   568-           the sections, one right after the other

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "support/checksum.hpp"

namespace rollcon {

/// Says what must agree between writer and reader, beside the bytes.
struct FileKind {
  unsigned char magic[8];
  const char* what;  ///< name for messages, "a rollcon body"
  std::uint32_t format, abi;
  const char* library;  ///< version of the library
};

struct SectionEntry {
  char name[8];
  std::uint64_t offset, length, checksum;
};

struct SectionHeader {
  unsigned char magic[8];
  std::uint32_t byte_order, format, abi, sections;
  char library[16];
  std::uint64_t length;
  SectionEntry section[16];
  std::uint64_t checksum;
};
static_assert(sizeof(SectionHeader) == 568);

/// Writes such a file. All failures are err_io, naming the file.
class SectionWriter {
 public:
  SectionWriter(const std::string& path, const FileKind& kind);
  /// Removes what was written unless it was committed.
  ~SectionWriter();
  SectionWriter(const SectionWriter&) = delete;
  SectionWriter& operator=(const SectionWriter&) = delete;

  /// Ends the section before and begins one. The name has 1 to 8 characters.
  void begin(const char* name);
  void write(const void* data, std::size_t bytes);
  /// Ends the file, brings it to the disk and gives it its name; an older file is replaced.
  void commit();

 private:
  void end_section();
  void flush();
  void put(const void* data, std::size_t bytes);
  [[noreturn]] void fail_here(int error) const;

  std::string path_, part_;
  int file_ = -1;
  SectionHeader header_{};
  Checksum checksum_;
  std::uint64_t position_ = 0;
  std::vector<unsigned char> buffer_;
};

class SectionReader {
 public:
  /// Checks the header. Throws err_io for what is no such file, truncated or changed, err_unsupported for another
  /// format, binary interface or byte order.
  SectionReader(const std::string& path, const FileKind& kind);
  ~SectionReader();
  SectionReader(const SectionReader&) = delete;
  SectionReader& operator=(const SectionReader&) = delete;

  bool has(const char* name) const { return find(name) != nullptr; }
  /// Lets what follows be read from this section; throws err_io when there is none.
  void begin(const char* name);
  void read(void* data, std::size_t bytes);
  /// Returns how many bytes of the section are still to be read: nothing larger may be believed in, or allocated for.
  std::uint64_t left() const { return end_ - position_; }
  /// Checks that all was read, and the checksum. What a section says is to be trusted from here on only.
  void end();
  /// Reads the sections that were not read to their end, to check their checksums.
  void verify_rest();
  /// Throws err_io with section and offset added.
  [[noreturn]] void fail_here(const std::string& what) const;

 private:
  const SectionEntry* find(const char* name) const;
  void begin(const SectionEntry& section);
  void fill(void* data, std::size_t bytes);

  std::string path_;
  int file_ = -1;
  SectionHeader header_{};
  const SectionEntry* section_ = nullptr;
  bool verified_[16] = {};
  std::uint64_t position_ = 0, end_ = 0;
  Checksum checksum_;
  std::vector<unsigned char> buffer_;
  std::size_t buffered_ = 0, taken_ = 0;
};

}  // namespace rollcon
