#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "io/section_file.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 18U;
constexpr std::uint32_t swapped_order = 0x01000000U;

std::string text_of(const char* field, std::size_t most) {
  return {field, std::find(field, field + most, '\0')};
}

std::uint64_t checksum_of(const SectionHeader& header) {
  Checksum sum;
  sum.add(&header, offsetof(SectionHeader, checksum));
  return sum.value();
}

/// Says whether the sections follow one another without a gap, to the end of the file.
bool contiguous(const SectionHeader& header) {
  std::uint64_t position = sizeof header;
  if (header.sections > std::size(header.section)) return false;
  for (std::uint32_t i = 0; i < header.sections; ++i) {
    const SectionEntry& entry = header.section[i];
    if (entry.offset != position || entry.length > header.length - position) return false;
    position += entry.length;
  }
  return position == header.length;
}

unsigned long long wide(std::uint64_t v) {
  return v;
}

}  // namespace

SectionReader::SectionReader(const std::string& path, const FileKind& kind) : path_(path) {
  if (path.empty()) fail(Status::err_argument, "path is empty");
  const auto refuse = [&](Status status, const std::string& why) {
    if (file_ >= 0) close(file_);
    fail(status, "cannot read '%s': %s", path_.c_str(), why.c_str());
  };
  buffer_.resize(buffer_bytes);
  // The call does not wait for the other end of a pipe.
  file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat about {};
  if (file_ < 0 || fstat(file_, &about) != 0) refuse(Status::err_io, std::generic_category().message(errno));
  if (!S_ISREG(about.st_mode)) refuse(Status::err_io, "it is no regular file");
  const auto size = static_cast<std::uint64_t>(about.st_size);
  const std::string foreign = "it is not " + std::string(kind.what);
  std::size_t got = 0;
  while (got < sizeof header_) {
    const ssize_t n = ::read(file_, reinterpret_cast<unsigned char*>(&header_) + got, sizeof header_ - got);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) refuse(Status::err_io, std::generic_category().message(errno));
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
  }
  const std::size_t begun = std::min(got, sizeof kind.magic);
  if (!std::equal(kind.magic, kind.magic + begun, header_.magic))
    refuse(Status::err_io, foreign + ": its first bytes are others");
  if (got < sizeof header_)
    refuse(Status::err_io, "it is truncated: it has " + std::to_string(size) + " bytes, its header alone " +
                               std::to_string(sizeof header_));
  if (header_.byte_order == swapped_order)
    refuse(Status::err_unsupported, "it was written on a machine of the other byte order");
  const bool whole_header = checksum_of(header_) == header_.checksum;
  // A damaged header says anything; one that is whole and has another version says so.
  if (!whole_header && header_.format == kind.format)
    refuse(Status::err_io, "it was changed or damaged: the checksum of its header is wrong");
  const std::string writer = text_of(header_.library, sizeof header_.library);
  if (header_.format != kind.format)
    refuse(whole_header ? Status::err_unsupported : Status::err_io,
           "its format is " + std::to_string(header_.format) + ", that of this library is " +
               std::to_string(kind.format) +
               (whole_header ? " (it was written by rollcon " + writer + ")"
                             : ", and the checksum of its header is wrong"));
  if (header_.abi != kind.abi)
    refuse(Status::err_unsupported, "it was written by rollcon " + writer + " of binary interface " +
                                        std::to_string(header_.abi) + ", this library has " + std::to_string(kind.abi));
  if (size < header_.length)
    refuse(Status::err_io,
           "it is truncated: it has " + std::to_string(size) + " of " + std::to_string(header_.length) + " bytes");
  if (size > header_.length)
    refuse(Status::err_io,
           "it has " + std::to_string(size - header_.length) + " bytes too many: something was appended");
  if (header_.byte_order != 1 || !contiguous(header_)) refuse(Status::err_io, "its table of sections makes no sense");
}

SectionReader::~SectionReader() {
  if (file_ >= 0) close(file_);
}

void SectionReader::fail_here(const std::string& what) const {
  fail(Status::err_io, "cannot read '%s': section '%s', offset %llu: %s", path_.c_str(),
       section_ ? text_of(section_->name, sizeof section_->name).c_str() : "", wide(position_), what.c_str());
}

const SectionEntry* SectionReader::find(const char* name) const {
  for (std::uint32_t i = 0; i < header_.sections; ++i)
    if (text_of(header_.section[i].name, sizeof header_.section[i].name) == name) return &header_.section[i];
  return nullptr;
}

void SectionReader::begin(const char* name) {
  const SectionEntry* found = find(name);
  if (!found) fail(Status::err_io, "cannot read '%s': it has no section '%s'", path_.c_str(), name);
  begin(*found);
}

void SectionReader::begin(const SectionEntry& section) {
  section_ = &section;
  position_ = section_->offset;
  end_ = position_ + section_->length;
  checksum_ = Checksum();
  buffered_ = taken_ = 0;
  if (lseek(file_, static_cast<off_t>(position_), SEEK_SET) < 0) fail_here(std::generic_category().message(errno));
}

// Reads straight from the file, or through the buffer if it is little.
void SectionReader::fill(void* data, std::size_t bytes) {
  auto* to = static_cast<unsigned char*>(data);
  const auto from_file = [&](unsigned char* target, std::size_t least, std::size_t most) {
    std::size_t got = 0;
    while (got < least) {
      const ssize_t n = ::read(file_, target + got, most - got);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail_here(std::generic_category().message(errno));
      if (n == 0) fail_here("the file ends here");
      got += static_cast<std::size_t>(n);
    }
    return got;
  };
  while (bytes > 0) {
    if (taken_ == buffered_) {
      if (bytes >= buffer_bytes) {
        from_file(to, bytes, bytes);
        return;
      }
      taken_ = buffered_ = 0;
      buffered_ = from_file(buffer_.data(), 1, buffer_bytes);
    }
    const std::size_t part = std::min(bytes, buffered_ - taken_);
    std::memcpy(to, buffer_.data() + taken_, part);
    taken_ += part;
    to += part;
    bytes -= part;
  }
}

void SectionReader::read(void* data, std::size_t bytes) {
  if (bytes > left()) fail_here("what is to be read here reaches beyond the section");
  fill(data, bytes);
  checksum_.add(data, bytes);
  position_ += bytes;
}

void SectionReader::end() {
  if (left() > 0) fail_here(std::to_string(left()) + " bytes are left over");
  if (checksum_.value() != section_->checksum) fail_here("it was changed or damaged: its checksum is wrong");
  verified_[section_ - header_.section] = true;
}

void SectionReader::verify_rest() {
  for (std::uint32_t i = 0; i < header_.sections; ++i) {
    if (verified_[i]) continue;
    begin(header_.section[i]);
    unsigned char piece[4096];
    while (left() > 0) read(piece, std::min<std::uint64_t>(left(), sizeof piece));
    end();
  }
}

}  // namespace rollcon
