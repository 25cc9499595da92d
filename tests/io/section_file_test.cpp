// Tests files of sections: there and back, and everything that can be wrong with one.

#include "io/section_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

namespace fs = std::filesystem;

constexpr FileKind kind{{0x89, 'T', 'E', 'S', 'T', '\r', '\n', '\n'}, "a test", 3, 7, "1.2.3"};

class SectionFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("rollcon_sections_" + std::to_string(getpid()));
    fs::create_directory(folder);
    path = (folder / "file").string();
  }
  void TearDown() override { fs::remove_all(folder); }

  void write(const std::string& to, FileKind as = kind) const {
    SectionWriter file(to, as);
    file.begin("first");
    file.write(numbers.data(), numbers.size() * sizeof numbers[0]);
    file.begin("empty");
    file.begin("eight888");
    file.write("tail", 4);
    file.commit();
  }
  /// Reads all of it; what was wrong goes to `text`.
  Status read(std::string* text = nullptr, FileKind as = kind) const {
    try {
      SectionReader file(path, as);
      std::vector<double> back(numbers.size());
      file.begin("first");
      if (file.left() == back.size() * sizeof back[0]) {
        file.read(back.data(), back.size() * sizeof back[0]);
        file.end();
        EXPECT_EQ(back, numbers);
      }
      file.verify_rest();
      EXPECT_TRUE(file.has("empty") && file.has("eight888") && !file.has("tail"));
      return Status::ok;
    } catch (const Error& e) {
      if (text) *text = e.what();
      return e.status();
    }
  }
  std::string bytes() const {
    std::ifstream in(path, std::ios::binary);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
  }
  void overwrite(const std::string& bytes) const { std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes; }
  void expect_refused(Status status, const std::string& word, FileKind as = kind) const {
    std::string text;
    EXPECT_EQ(read(&text, as), status) << text;
    EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' in: " << text;
    EXPECT_NE(text.find(path), std::string::npos) << text;
  }
  void expect_no_write(const std::string& to, const std::string& word) const {
    try {
      write(to);
      ADD_FAILURE() << to << " was written";
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), Status::err_io);
      EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find(to), std::string::npos) << e.what();
    }
  }
  /// Counts files in the folder.
  std::ptrdiff_t count() const { return std::distance(fs::directory_iterator(folder), fs::directory_iterator()); }

  std::vector<double> numbers = std::vector<double>(12, 0.25);
  fs::path folder;
  std::string path;
};

// A killed process of the same number may have left such names.
TEST_F(SectionFile, names_in_use_are_passed_over) {
  for (int k = 0; k < 100; ++k)
    std::ofstream(path + "." + std::to_string(getpid()) + "-" + std::to_string(k) + ".part") << k;
  write(path);
  EXPECT_EQ(read(), Status::ok);
}

TEST_F(SectionFile, comes_back) {
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = 1.0 / static_cast<double>(k + 1);
  write(path);
  std::string text;
  EXPECT_EQ(read(&text), Status::ok) << text;
  numbers.assign(200000, -3.5);  // beyond every buffer
  write(path);
  EXPECT_EQ(read(&text), Status::ok) << text;
  EXPECT_EQ(count(), 1) << "nothing is left beside it";
}

TEST_F(SectionFile, a_flipped_bit_in_any_byte_is_found) {
  write(path);
  const std::string good = bytes();
  for (std::size_t k = 0; k < good.size(); ++k) {
    std::string bad = good;
    bad[k] = static_cast<char>(bad[k] ^ 1 << k % 8);
    overwrite(bad);
    const Status status = read();
    ASSERT_TRUE(status == Status::err_io || status == Status::err_unsupported)
        << "byte " << k << ", status " << static_cast<int>(status);
  }
}

TEST_F(SectionFile, every_shorter_and_longer_file_is_refused) {
  write(path);
  const std::string good = bytes();
  for (std::size_t length = 0; length < good.size(); ++length) {
    overwrite(good.substr(0, length));
    ASSERT_EQ(read(), Status::err_io) << length;
  }
  overwrite(good.substr(0, good.size() - 1));
  expect_refused(Status::err_io, "truncated");
  overwrite(good.substr(0, 20));
  expect_refused(Status::err_io, "truncated");
  overwrite(good + "x");
  expect_refused(Status::err_io, "1 bytes too many");
}

TEST_F(SectionFile, others_are_named) {
  overwrite("<?xml version=\"1.0\"?>" + std::string(1000, ' '));
  expect_refused(Status::err_io, "it is not a test");
  write(path);
  FileKind later = kind;
  later.format = 4;
  expect_refused(Status::err_unsupported, "its format is 3, that of this library is 4", later);
  later = kind;
  later.abi = 8;
  expect_refused(Status::err_unsupported, "rollcon 1.2.3 of binary interface 7", later);
  fs::remove(path);
  expect_refused(Status::err_io, "No such file");
  fs::create_directory(path);
  expect_refused(Status::err_io, "no regular file");
  fs::remove(path);
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  expect_refused(Status::err_io, "no regular file");
}

// A table that is whole by its checksum may still say anything.
TEST_F(SectionFile, a_forged_table_is_refused) {
  write(path);
  const std::string good = bytes();
  const auto forge = [&](const std::function<void(SectionHeader&)>& change) {
    std::string bad = good;
    SectionHeader header;
    std::memcpy(&header, bad.data(), sizeof header);
    change(header);
    Checksum sum;
    sum.add(&header, offsetof(SectionHeader, checksum));
    header.checksum = sum.value();
    std::memcpy(bad.data(), &header, sizeof header);
    overwrite(bad);
  };
  forge([](SectionHeader& h) { h.sections = 17; });
  expect_refused(Status::err_io, "table of sections");
  forge([](SectionHeader& h) { h.section[0].length = ~std::uint64_t{0}; });
  expect_refused(Status::err_io, "table of sections");
  forge([](SectionHeader& h) { h.section[2].offset -= 8; });
  expect_refused(Status::err_io, "table of sections");
  forge([](SectionHeader& h) { h.length = ~std::uint64_t{0}; });
  expect_refused(Status::err_io, "truncated");
  forge([](SectionHeader& h) { h.section[0].checksum ^= 1; });
  expect_refused(Status::err_io, "section 'first'");
  forge([](SectionHeader& h) { h.byte_order = 0x01000000; });
  expect_refused(Status::err_unsupported, "byte order");
}

TEST_F(SectionFile, reading_stops_at_the_end_of_a_section) {
  write(path);
  SectionReader file(path, kind);
  file.begin("eight888");
  char text[8];
  EXPECT_THROW(file.read(text, 5), Error);
  file.begin("eight888");
  file.read(text, 3);
  EXPECT_THROW(file.end(), Error) << "one byte is left over";
  EXPECT_THROW(file.begin("second"), Error);
}

TEST_F(SectionFile, what_cannot_be_written_leaves_nothing) {
  expect_no_write((folder / "no" / "file").string(), "No such file");
  expect_no_write(folder.string(), "no regular file");
  fs::create_directory(folder / "closed");
  fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
  if (geteuid() != 0) expect_no_write((folder / "closed" / "file").string(), "Permission denied");
  fs::permissions(folder / "closed", fs::perms::owner_all);
  fs::remove(folder / "closed");
  EXPECT_EQ(count(), 0);
}

TEST_F(SectionFile, a_full_disk_keeps_the_older_file) {
  write(path);
  const std::string before = bytes();
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t room : {std::size_t{0}, std::size_t{100}, before.size() - 1, std::size_t{600000}}) {
    if (room > before.size()) numbers.assign(200000, 1);
    const rlimit small{room, old.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    expect_no_write(path, "File too large");
    setrlimit(RLIMIT_FSIZE, &old);
    EXPECT_EQ(bytes(), before) << room;
    EXPECT_EQ(count(), 1) << room;
  }
  std::signal(SIGXFSZ, handler);
}

TEST_F(SectionFile, what_is_not_committed_is_removed) {
  {
    SectionWriter file(path, kind);
    file.begin("first");
    file.write("x", 1);
    EXPECT_EQ(count(), 1) << "under another name";
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_EQ(count(), 0);
}

}  // namespace
}  // namespace rollcon
