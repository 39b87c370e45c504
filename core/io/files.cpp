// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/io/written_files.hpp"
#include "core/process/run_error.hpp"

namespace parison::core {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  const int code = errno;
  throw SystemError(fmt::format("{}: {}: {}", path, what, std::strerror(code)), code);
}

/// A temporary file, removed unless it was given its name.
struct Temporary {
  std::string path;
  ~Temporary() { ::unlink(path.c_str()); }
};

/// Writes a file; a failure names the one that it is for.
void put(const std::string& file, const std::string& text, const std::string& named) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) fail(named, "cannot be written");
}

/// A file that was there keeps its content.
int open_own(const std::string& path, bool may_be_new) {
  require_own(path);
  if (may_be_new) note_growing(path);
  return ::open(path.c_str(), O_RDWR | O_CLOEXEC | (may_be_new ? O_CREAT : 0), 0666);
}

/// Digest of the first `size` bytes of an open file.
std::uint64_t digest_of(int file, std::int64_t size) {
  std::uint64_t digest = fingerprint("");
  std::string part(1 << 16, '\0');
  for (std::int64_t done = 0; done < size;) {
    const auto wanted = std::min<std::int64_t>(size - done, static_cast<std::int64_t>(part.size()));
    const auto got = ::pread(file, part.data(), static_cast<std::size_t>(wanted), done);
    if (got <= 0) break;
    digest = fingerprint(std::string_view(part.data(), static_cast<std::size_t>(got)), digest);
    done += got;
  }
  return digest;
}

}  // namespace

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, "cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_text(const std::string& path, const std::string& text) {
  put(path, text, path);
}

void sync_to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY);
  if (file < 0) fail(path, "cannot be opened");
  const int result = ::fsync(file);
  ::close(file);
  if (result != 0) fail(path, "cannot be brought to the disk");
}

void replace_file(const std::string& path, const std::string& text, Reach reach) {
  require_own(path);
  const Temporary temporary{unfinished_name(path)};
  put(temporary.path, text, path);
  if (reach == Reach::disk) sync_to_disk(temporary.path);
  note_written(path, text, reach == Reach::disk);
  if (std::rename(temporary.path.c_str(), path.c_str()) != 0) fail(path, "cannot be replaced");
  if (reach == Reach::disk) sync_to_disk(std::filesystem::absolute(path).parent_path().string());
}

GrowingFile::GrowingFile(std::string path, std::int64_t size)
    : path_(std::move(path)), file_(open_own(path_, size == 0)), size_(size) {
  if (file_ < 0) fail(path_, "cannot be opened");
  const auto refuse = [&](const std::string& what) {
    ::close(file_);
    throw RunError(fmt::format("{}: {}", path_, what));
  };
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) refuse("another process is writing to it");
  const std::int64_t found = ::lseek(file_, 0, SEEK_END);
  if (found < size) refuse(fmt::format("{} bytes were found, it once had {}", found, size));
  if (size > 0) note_growing(path_);
  if (::ftruncate(file_, size) != 0 || ::lseek(file_, size, SEEK_SET) != size) refuse(std::strerror(errno));
  digest_ = digest_of(file_, size);
}

GrowingFile::~GrowingFile() {
  try {
    ::fsync(file_);  // before a summary says that the run is done
    note_written(path_, static_cast<std::uint64_t>(size_), digest_);
  } catch (const RunError&) {  // it stays a file that grows
  }
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
  digest_ = fingerprint(text, digest_);
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::uint64_t fingerprint(std::string_view text, std::uint64_t hash) {
  for (const unsigned char c : text) hash = (hash ^ c) * 0x100000001b3u;
  return hash;
}

std::string fingerprint_text(std::uint64_t fingerprint) {
  return fmt::format("{:016x}", fingerprint);
}

}  // namespace parison::core
