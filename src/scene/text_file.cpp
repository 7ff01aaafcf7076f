// SPDX-License-Identifier: BSD-3-Clause
#include "text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "problems.h"
#include "text_decoder.h"

namespace drill_rig_sim
{
namespace
{
/// Closes its descriptor at the end.
struct Descriptor
{
  int number;
  explicit Descriptor(int n) : number(n) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor()
  {
    if (number >= 0) ::close(number);
  }
};

std::string too_large(const char* needed, std::size_t longest)
{
  return "is larger than " + std::to_string(longest >> 20) + " MiB, needed: " + needed;
}

// why a file of this kind and size is not read; empty if it is
std::string refusal(const struct stat& status, const char* needed, std::size_t longest)
{
  if (!S_ISREG(status.st_mode)) return std::string("is not a regular file, needed: ") + needed;
  return static_cast<std::size_t>(status.st_size) > longest ? too_large(needed, longest) : "";
}

// the whole of a file; what is wrong with it, empty if nothing is
std::string read_bytes(const std::string& file, const char* needed, std::size_t longest, std::string& text)
{
  const auto unreadable = [&] { return std::string("cannot be read (") + std::strerror(errno) + "), needed: " + needed; };
  struct stat status = {};
  // looked at before it is opened, for opening alone may act on a device, and once more after, for names can change their file
  if (::stat(file.c_str(), &status) != 0) return unreadable();
  std::string wrong = refusal(status, needed, longest);
  if (!wrong.empty()) return wrong;
  const Descriptor in(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (in.number < 0 || ::fstat(in.number, &status) != 0) return unreadable();
  wrong = refusal(status, needed, longest);
  if (!wrong.empty()) return wrong;
  text.clear();
  char block[65536];
  while (true)
  {
    const ssize_t got = ::read(in.number, block, sizeof block);
    if (got == 0) return "";
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return unreadable();
    text.append(block, static_cast<std::size_t>(got));
    // it may grow while it is read, and files of /proc have no size
    if (text.size() > longest) return too_large(needed, longest);
  }
}
}  // namespace

TextFile read_text_file(const std::string& file, const char* needed, std::size_t longest)
{
  Problems problems(file);
  std::string bytes;
  const std::string wrong = read_bytes(file, needed, longest, bytes);
  if (!wrong.empty()) problems.fail(0, "", wrong);
  DecodedText decoded = decode_text(std::move(bytes));
  if (!decoded.wrong.empty()) problems.fail(decoded.wrong_line, "", decoded.wrong);
  return {std::move(decoded.text),
          decoded.taken_as.empty() ? "" : one_line(file) + ": is not UTF-8; read as " + decoded.taken_as};
}

}  // namespace drill_rig_sim
