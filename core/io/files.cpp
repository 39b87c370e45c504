// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/process/run_error.hpp"

namespace parison::core {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw RunError(fmt::format("{}: {}: {}", path, what, std::strerror(errno)));
}

/// A temporary file, removed unless it was given its name.
struct Temporary {
  std::string path;
  ~Temporary() { ::unlink(path.c_str()); }
};

}  // namespace

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, "cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) fail(path, "cannot be written");
}

void sync_to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY);
  if (file < 0) fail(path, "cannot be opened");
  const int result = ::fsync(file);
  ::close(file);
  if (result != 0) fail(path, "cannot be brought to the disk");
}

void replace_file(const std::string& path, const std::function<void(const std::string& temporary)>& write) {
  const Temporary temporary{path + ".part"};
  write(temporary.path);
  if (std::rename(temporary.path.c_str(), path.c_str()) != 0) fail(path, "cannot be replaced");
}

void replace_file(const std::string& path, const std::string& text) {
  replace_file(path, [&](const std::string& temporary) { write_text(temporary, text); });
}

GrowingFile::GrowingFile(std::string path, std::int64_t size)
    : path_(std::move(path)),
      file_(::open(path_.c_str(), O_WRONLY | O_CLOEXEC | (size == 0 ? O_CREAT : 0), 0666)),
      size_(size) {
  if (file_ < 0) fail(path_, "cannot be opened");
  const auto refuse = [&](const std::string& what) {
    ::close(file_);
    throw RunError(fmt::format("{}: {}", path_, what));
  };
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) refuse("another process is writing to it");
  const std::int64_t found = ::lseek(file_, 0, SEEK_END);
  if (found < size) refuse(fmt::format("{} bytes were found, it once had {}", found, size));
  if (::ftruncate(file_, size) != 0 || ::lseek(file_, size, SEEK_SET) != size) refuse(std::strerror(errno));
}

GrowingFile::~GrowingFile() {
  ::close(file_);
}

void GrowingFile::append(const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const auto written = ::write(file_, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int reason = errno;
      if (::ftruncate(file_, size_) == 0) ::lseek(file_, size_, SEEK_SET);  // a row cut in a number would look whole
      errno = reason;
      fail(path_, "cannot be written");
    }
    done += static_cast<std::size_t>(written);
  }
  size_ += static_cast<std::int64_t>(text.size());
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::uint64_t fingerprint(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const unsigned char c : text) hash = (hash ^ c) * 0x100000001b3u;
  return hash;
}

std::string fingerprint_text(std::uint64_t fingerprint) {
  return fmt::format("{:016x}", fingerprint);
}

}  // namespace parison::core
