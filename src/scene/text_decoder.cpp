// SPDX-License-Identifier: BSD-3-Clause
#include "text_decoder.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace drill_rig_sim
{
namespace
{
// bytes 0x80 to 0x9f; five of them are left open (U+FFFD)
constexpr std::array<std::uint16_t, 32> windows_1252 = {0x20ac, 0xfffd, 0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                                        0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0xfffd, 0x017d, 0xfffd,
                                                        0xfffd, 0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                                        0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0xfffd, 0x017e, 0x0178};

// bytes 0x80 to 0xbf; one of them is left open. Those above are the letters from A to ya (U+0410 to U+044F).
constexpr std::array<std::uint16_t, 64> windows_1251 = {
    0x0402, 0x0403, 0x201a, 0x0453, 0x201e, 0x2026, 0x2020, 0x2021, 0x20ac, 0x2030, 0x0409, 0x2039, 0x040a,
    0x040c, 0x040b, 0x040f, 0x0452, 0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014, 0xfffd, 0x2122,
    0x0459, 0x203a, 0x045a, 0x045c, 0x045b, 0x045f, 0x00a0, 0x040e, 0x045e, 0x0408, 0x00a4, 0x0490, 0x00a6,
    0x00a7, 0x0401, 0x00a9, 0x0404, 0x00ab, 0x00ac, 0x00ad, 0x00ae, 0x0407, 0x00b0, 0x00b1, 0x0406, 0x0456,
    0x0491, 0x00b5, 0x00b6, 0x00b7, 0x0451, 0x2116, 0x0454, 0x00bb, 0x0458, 0x0405, 0x0455, 0x0457};
constexpr std::size_t sure_word = 4,
                      word = 3;         // lengths of letters beyond ASCII alone; no other language writes words so long of them
constexpr double least_in_words = 0.7;  // share of such letters that stand in words

unsigned char byte_at(const std::string& bytes, std::size_t at)
{
  return static_cast<unsigned char>(bytes[at]);
}

void append_utf8(std::uint32_t point, std::string& text)
{
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((point >> shift) & 0x3f)); };
  if (point < 0x80)
  {
    text += static_cast<char>(point);
    return;
  }
  const int tails = point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
  const std::uint32_t lead = tails == 1 ? 0xc0 : tails == 2 ? 0xe0 : 0xf0;
  text += static_cast<char>(lead | (point >> (6 * tails)));
  for (int i = tails; i-- > 0;) tail(6 * i);
}

bool is_utf8(const std::string& bytes)
{
  std::size_t at = 0;
  while (at < bytes.size())
  {
    const std::size_t length = utf8_length(bytes, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

// whether bytes that are no UTF-8 are words in windows-1251
bool is_cyrillic(const std::string& bytes)
{
  std::size_t letters = 0, in_words = 0, length = 0;
  bool sure = false;
  for (std::size_t i = 0; i <= bytes.size(); ++i)
  {
    if (i < bytes.size() && byte_at(bytes, i) >= 0xc0)
    {
      ++length;
      continue;
    }
    letters += length;
    if (length >= word) in_words += length;
    sure = sure || length >= sure_word;
    length = 0;
  }
  return sure && static_cast<double>(in_words) >= least_in_words * static_cast<double>(letters);
}

std::uint32_t latin(std::uint32_t byte)
{
  return byte >= 0x80 && byte < 0xa0 ? windows_1252[byte - 0x80] : byte;
}

std::uint32_t cyrillic(std::uint32_t byte)
{
  return byte < 0x80 ? byte : byte < 0xc0 ? windows_1251[byte - 0x80] : 0x0410 + byte - 0xc0;
}

std::string utf8_of(const std::string& bytes, std::uint32_t (*point_of)(std::uint32_t))
{
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (std::size_t i = 0; i < bytes.size(); ++i) append_utf8(point_of(byte_at(bytes, i)), text);
  return text;
}

// of bytes behind the mark; false if they are no UTF-16
bool utf8_of_utf16(const std::string& bytes, bool big_end_first, std::string& text)
{
  if (bytes.size() % 2 != 0) return false;
  const auto unit = [&](std::size_t at) -> std::uint32_t
  { return big_end_first ? byte_at(bytes, at) << 8 | byte_at(bytes, at + 1) : byte_at(bytes, at + 1) << 8 | byte_at(bytes, at); };
  for (std::size_t at = 2; at < bytes.size(); at += 2)
  {
    std::uint32_t point = unit(at);
    if (point >= 0xd800 && point < 0xe000)  // a pair of units
    {
      const std::uint32_t second = at + 2 < bytes.size() ? unit(at + 2) : 0;
      if (point >= 0xdc00 || second < 0xdc00 || second >= 0xe000) return false;
      point = 0x10000 + ((point - 0xd800) << 10) + (second - 0xdc00);
      at += 2;
    }
    append_utf8(point, text);
  }
  return true;
}

bool begins_with(const std::string& bytes, const char* mark)
{
  return bytes.compare(0, std::char_traits<char>::length(mark), mark) == 0;
}

// what a file is by its first bytes, where that is no text; "" elsewhere
std::string other_kind(const std::string& bytes)
{
  for (const auto& [mark, kind] : {std::pair<const char*, const char*>{"PK\x03\x04", "a spreadsheet (xlsx) or another zip file"},
                                   {"\xd0\xcf\x11\xe0", "a spreadsheet (xls)"},
                                   {"\x1f\x8b", "compressed (gzip)"},
                                   {"%PDF", "a PDF file"}})
    if (begins_with(bytes, mark)) return kind;
  return "";
}

// the bytes' characters; NUL is one of them here
DecodedText characters_of(std::string bytes)
{
  DecodedText decoded;
  const bool little = begins_with(bytes, "\xff\xfe"), big = begins_with(bytes, "\xfe\xff");
  if (little || big)
  {
    if (!utf8_of_utf16(bytes, big, decoded.text)) decoded.wrong = "has a UTF-16 byte order mark but is not UTF-16";
    return decoded;
  }
  if (begins_with(bytes, "\xef\xbb\xbf")) bytes.erase(0, 3);
  if (is_utf8(bytes))
  {
    decoded.text = std::move(bytes);
    return decoded;
  }
  const bool in_cyrillic = is_cyrillic(bytes);
  decoded.taken_as = in_cyrillic ? "windows-1251 (Cyrillic)" : "latin-1";
  decoded.text = utf8_of(bytes, in_cyrillic ? cyrillic : latin);
  return decoded;
}
}  // namespace

std::size_t utf8_length(const std::string& bytes, std::size_t at)
{
  const unsigned char lead = byte_at(bytes, at);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || at + length > bytes.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte_at(bytes, at + i) & 0xc0) != 0x80) return 0;
  const unsigned char next = byte_at(bytes, at + 1);
  const bool overlong = (lead == 0xe0 && next < 0xa0) || (lead == 0xf0 && next < 0x90);
  const bool outside = (lead == 0xed && next > 0x9f) || (lead == 0xf4 && next > 0x8f);
  return overlong || outside ? 0 : length;
}

DecodedText decode_text(std::string bytes)
{
  const std::string other = other_kind(bytes);
  DecodedText decoded = characters_of(std::move(bytes));
  if (!other.empty())
    decoded.wrong = "is " + other + ", needed: a text file, for example its table saved as CSV or copied into a text file";
  const std::size_t nul = decoded.text.find('\0');
  if (!decoded.wrong.empty() || nul == std::string::npos) return decoded;
  decoded.wrong = "contains a NUL byte, needed: text in UTF-8, in UTF-16 with a byte order mark, or in latin-1";
  decoded.wrong_line =
      1 + static_cast<int>(std::count(decoded.text.begin(), decoded.text.begin() + static_cast<std::ptrdiff_t>(nul), '\n'));
  return decoded;
}

}  // namespace drill_rig_sim
