#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "io/part_file.hpp"
#include "io/section_file.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 18U;

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

void SectionWriter::fail_here(int error) const {
  fail(Status::err_io, "cannot write '%s': %s", path_.c_str(), std::generic_category().message(error).c_str());
}

SectionWriter::SectionWriter(const std::string& path, const FileKind& kind) : path_(path) {
  if (path.empty()) fail(Status::err_argument, "path is empty");
  std::copy_n(kind.magic, sizeof header_.magic, header_.magic);
  header_.byte_order = 1;
  header_.format = kind.format;
  header_.abi = kind.abi;
  std::snprintf(header_.library, sizeof header_.library, "%s", kind.library);
  buffer_.reserve(buffer_bytes);
  file_ = open_part(path_, part_);
  if (file_ < 0) {
    const int error = errno;
    part_.clear();
    fail_here(error);
  }
  put(&header_, sizeof header_);  // reserves its room, in the buffer only
}

SectionWriter::~SectionWriter() {
  if (file_ >= 0) close(file_);
  if (!part_.empty()) std::remove(part_.c_str());
}

void SectionWriter::flush() {
  std::size_t done = 0;
  while (done < buffer_.size()) {
    const ssize_t n = ::write(file_, buffer_.data() + done, buffer_.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail_here(n < 0 ? errno : ENOSPC);
    done += static_cast<std::size_t>(n);
  }
  buffer_.clear();
}

void SectionWriter::put(const void* data, std::size_t bytes) {
  const auto* from = static_cast<const unsigned char*>(data);
  position_ += bytes;
  while (bytes > 0) {
    const std::size_t part = std::min(bytes, buffer_bytes - buffer_.size());
    buffer_.insert(buffer_.end(), from, from + part);
    from += part;
    bytes -= part;
    if (buffer_.size() == buffer_bytes) flush();
  }
}

void SectionWriter::end_section() {
  if (header_.sections == 0) return;
  SectionEntry& entry = header_.section[header_.sections - 1];
  entry.length = position_ - entry.offset;
  entry.checksum = checksum_.value();
}

void SectionWriter::begin(const char* name) {
  end_section();
  if (header_.sections == std::size(header_.section))
    fail(Status::err_internal, "'%s' has too many sections", path_.c_str());
  SectionEntry& entry = header_.section[header_.sections++];
  std::memcpy(entry.name, name, std::min(std::strlen(name), sizeof entry.name));
  entry.offset = position_;
  checksum_ = Checksum();
}

void SectionWriter::write(const void* data, std::size_t bytes) {
  checksum_.add(data, bytes);
  put(data, bytes);
}

void SectionWriter::commit() {
  end_section();
  header_.length = position_;
  Checksum own;
  own.add(&header_, offsetof(SectionHeader, checksum));
  header_.checksum = own.value();
  flush();
  if (lseek(file_, 0, SEEK_SET) != 0) fail_here(errno);
  put(&header_, sizeof header_);
  flush();
  // The new name might reach the disk before what it names, without this.
  if (fsync(file_) != 0) fail_here(errno);
  const int file = file_;
  file_ = -1;
  if (close(file) != 0) fail_here(errno);
  std::error_code renamed;
  std::filesystem::rename(part_, path_, renamed);
  if (renamed) fail_here(renamed.default_error_condition().value());
  part_.clear();
  // Some file systems cannot bring a folder to the disk; the file itself is whole in any case.
  if (const int folder = open(folder_of(path_).c_str(), O_RDONLY | O_CLOEXEC); folder >= 0) {
    static_cast<void>(fsync(folder));
    close(folder);
  }
}

}  // namespace rollcon
