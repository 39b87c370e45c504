// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/input_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace parison::core {
namespace {

/// An open file, closed at the end of its scope.
struct Descriptor {
  int id;
  ~Descriptor() {
    if (id >= 0) ::close(id);
  }
};

InputFile problem(std::string sentence) {
  return {"", std::move(sentence)};
}

InputFile unreadable() {
  return problem(fmt::format("cannot be read: {}", std::strerror(errno)));
}

InputFile too_large(std::size_t max_bytes) {
  return problem(fmt::format("is too large, allowed are files of up to {} MB", max_bytes / 1'000'000));
}

thread_local ReadRecord* innermost = nullptr;

void record(const std::string& path, const std::string& content) {
  if (!innermost) return;
  const std::string absolute = std::filesystem::absolute(path).lexically_normal().string();
  for (ReadFile& file : innermost->files)
    if (file.path == absolute) {
      file.content = content;
      return;
    }
  innermost->files.push_back({absolute, content});
}

}  // namespace

ReadRecord::ReadRecord() : outer_(innermost) {
  innermost = this;
}

ReadRecord::~ReadRecord() {
  innermost = outer_;
}

InputFile read_input_file(const std::string& path, std::size_t max_bytes) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
  struct stat facts {};
  if (file.id < 0 || ::fstat(file.id, &facts) != 0) return unreadable();
  if (!S_ISREG(facts.st_mode)) return problem("is not a file with a content, allowed is a regular file");
  if (static_cast<std::size_t>(facts.st_size) > max_bytes) return too_large(max_bytes);
  InputFile result;
  constexpr std::size_t portion = 1 << 16;
  for (std::size_t size = 0;;) {
    result.content.resize(std::max(size + portion, static_cast<std::size_t>(facts.st_size) + 1));
    const auto read = ::read(file.id, result.content.data() + size, result.content.size() - size);
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) return unreadable();
    size += static_cast<std::size_t>(read);
    if (size > max_bytes) return too_large(max_bytes);
    if (read > 0) continue;
    result.content.resize(size);
    record(path, result.content);
    return result;
  }
}

}  // namespace parison::core
