#include "forge.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

#include "io/section_file.hpp"
#include "scenes.hpp"
#include "support/checksum.hpp"

namespace fuzz {
namespace {

using rollcon::SectionHeader;

std::uint64_t sum_of(const void* data, std::size_t bytes) {
  rollcon::Checksum sum;
  sum.add(data, bytes);
  return sum.value();
}

/// These counts, ids, enumerators and reals are seldom meant.
constexpr std::uint64_t words[] = {0,
                                   1,
                                   2,
                                   7,
                                   0x7fffffff,
                                   0x80000000,
                                   0xffffffff,
                                   std::uint64_t{1} << 40U,
                                   std::uint64_t{1} << 61U,
                                   ~std::uint64_t{0},
                                   0x7ff8000000000000,
                                   0x7ff0000000000000,
                                   0x7fefffffffffffff,
                                   0x3ff0000000000000,
                                   0xbff0000000000000,
                                   1};

void edit(Bytes& section, Input& in) {
  const int how = in.below(8);
  const std::size_t unit = in.one_in(4) ? 1 : 4;
  const std::size_t bytes = in.one_in(2) ? 4 : 8;
  const std::size_t at = section.empty() ? 0 : unit * in.word(2) % section.size();
  const auto begin = section.begin() + static_cast<std::ptrdiff_t>(at);
  const std::size_t room = std::min(bytes, section.size() - at);
  std::uint64_t value = 0;
  std::memcpy(&value, section.data() + at, room);
  switch (how) {
    case 0:
      value = words[in.below(16)];
      break;
    case 1:
      value = in.word(static_cast<int>(bytes));
      break;
    case 2:
      value += in.byte() - 128U;
      break;
    case 3:
      value ^= std::uint64_t{1} << (in.byte() % 64U);
      break;
    case 4: {
      const double real = in.real();
      std::memcpy(&value, &real, sizeof value);
      break;
    }
    case 5:
      section.insert(begin, bytes * (1U + in.byte() % 8U), in.byte());
      return;
    case 6:
      section.erase(begin, begin + static_cast<std::ptrdiff_t>(room));
      return;
    default:
      section.resize(at);
      return;
  }
  std::memcpy(section.data() + at, &value, room);
}

}  // namespace

const Bytes& saved_body(int recipe) {
  static std::map<int, Bytes> known;
  const auto found = known.find(recipe);
  if (found != known.end()) return found->second;
  Input nothing(nullptr, 0);
  World world(nothing);
  rollcon_context* context = nullptr;
  require(rollcon_context_create(ROLLCON_ABI, &context) == ROLLCON_OK, "no context");
  rollcon_context_set_threads(world.add(context), 1);
  make_bodies(world, recipe);
  Bytes& bytes = known[recipe];
  // The list stays empty without the component.
  if (world.contacts.empty()) return bytes;
  const double load[3] = {0.1, 0.2, 0.3};
  const std::size_t which = recipe == recipes - 1 ? 1 : 0;
  rollcon_body* body = world.bodies[which].handle;
  if (which == 0) rollcon_body_set_traction(body, 6, load);
  rollcon_body_set_int(body, "prepare", 1);
  rollcon_contact_solve(world.contacts[0].handle);
  const std::string path = own_folder() + "/original";
  if (rollcon_body_save(body, path.c_str()) != ROLLCON_OK) return bytes;
  std::ifstream file(path, std::ios::binary);
  bytes.assign(std::istreambuf_iterator<char>(file), {});
  return bytes;
}

Bytes forged(const Bytes& good, Input& in) {
  SectionHeader header;
  if (good.size() < sizeof header) return good;
  std::memcpy(&header, good.data(), sizeof header);
  std::vector<Bytes> section;
  for (std::uint32_t i = 0; i < header.sections; ++i) {
    const auto begin = good.begin() + static_cast<std::ptrdiff_t>(header.section[i].offset);
    section.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(header.section[i].length));
  }
  const int wrong = in.byte();
  for (int edits = in.below(6); edits >= 0; --edits) edit(section[in.byte() % section.size()], in);
  Bytes bad(sizeof header);
  for (std::size_t i = 0; i < section.size(); ++i) {
    header.section[i].offset = bad.size();
    header.section[i].length = section[i].size();
    header.section[i].checksum = sum_of(section[i].data(), section[i].size());
    bad.insert(bad.end(), section[i].begin(), section[i].end());
  }
  header.length = bad.size();
  const auto header_byte = [&](std::size_t at) {
    reinterpret_cast<std::uint8_t*>(&header)[at % sizeof header] = in.byte();
  };
  if (wrong % 16 == 15) header_byte(in.word(2));
  header.checksum = sum_of(&header, offsetof(SectionHeader, checksum));
  if (wrong % 32 == 14) header_byte(in.word(2));
  std::memcpy(bad.data(), &header, sizeof header);
  if (wrong % 32 == 13) bad.resize(in.word(2) % bad.size());
  return bad;
}

}  // namespace fuzz
