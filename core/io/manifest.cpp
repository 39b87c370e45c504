// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/manifest.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <sstream>

#include "core/io/files.hpp"
#include "core/process/run_error.hpp"

namespace parison::core {
namespace {

/// A manifest as far as it was read.
struct Manifest {
  std::string file;        ///< which one: number and time of birth, as a folder may be removed and made anew
  std::uint64_t read = 0;  ///< bytes, whole lines
  std::string kind;
  std::map<std::string, std::vector<NotedContent>> contents;
};

std::mutex guard;

/// The manifests of this process by their paths: each line is read once.
std::map<std::string, Manifest>& manifests() {
  static std::map<std::string, Manifest> known;
  return known;
}

std::string path_of(const std::string& folder) {
  return (std::filesystem::absolute(folder).lexically_normal() / manifest_name).string();
}

/// A name without line breaks.
std::string on_one_line(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '\n' ? "\\n" : c == '\\' ? "\\\\" : std::string(1, c);
  return text;
}

/// Lengths of the beginnings with a digest of their own: a file that is cut is known by a quarter of it at least.
std::vector<std::uint64_t> beginnings(std::uint64_t size) {
  std::vector<std::uint64_t> lengths;
  for (std::uint64_t length = 1; length < size; length *= 4) lengths.push_back(length);
  lengths.push_back(size);
  return lengths;
}

/// "kind sweep", "grows history.csv", "has 17 0123456789abcdef,...,0123456789abcdef summary.json"; what it does not
/// know it passes over.
void take(const std::string& line, Manifest& manifest) {
  std::istringstream words(line);
  std::string word, name;
  NotedContent content;
  words >> word;
  if (word == "has") {
    words >> content.size;
    for (char next = ','; next == ',';) {
      words >> std::hex >> content.digests.emplace_back();
      next = static_cast<char>(words.peek());
      if (next == ',') words.get();
    }
  }
  if (!words || words.get() != ' ' || !std::getline(words, name)) return;
  content.grows = word == "grows";
  if (word == "kind")
    manifest.kind = name;
  else if (word == "has" || content.grows)
    manifest.contents[name].push_back(content);
}

/// Reads the lines that have come since the last time.
Manifest& manifest_of(const std::string& folder) {
  const std::string path = path_of(folder);
  Manifest& manifest = manifests()[path];
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  struct statx facts {};
  const bool is_there = file >= 0 && ::statx(file, "", AT_EMPTY_PATH, STATX_BASIC_STATS | STATX_BTIME, &facts) == 0 &&
                        S_ISREG(facts.stx_mode);
  const std::string found = fmt::format("{} {} {}", facts.stx_ino, facts.stx_btime.tv_sec, facts.stx_btime.tv_nsec);
  if (!is_there || found != manifest.file || facts.stx_size < manifest.read) manifest = {};
  if (is_there) {
    manifest.file = found;
    std::string text(facts.stx_size - manifest.read, '\0');
    const ssize_t got = ::pread(file, text.data(), text.size(), static_cast<off_t>(manifest.read));
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    text.resize(text.rfind('\n') + 1);  // none is npos + 1: nothing whole
    manifest.read += text.size();
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) take(line, manifest);
  }
  if (file >= 0) ::close(file);
  return manifest;
}

/// In one write of its own, behind whatever a killed process has left of a line.
void add_line(const std::string& folder, const std::string& text, bool on_disk) {
  const std::string path = path_of(folder), line = '\n' + text + '\n';
  const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  const bool is_of_another = file < 0 && (errno == EACCES || errno == EPERM) && ::access(folder.c_str(), W_OK) == 0;
  if (is_of_another) return;
  const ssize_t written = file < 0 ? -1 : ::write(file, line.data(), line.size());
  int reason = written < 0 ? errno : written < static_cast<ssize_t>(line.size()) ? ENOSPC : 0;
  if (reason == 0 && on_disk && ::fsync(file) != 0) reason = errno;
  if (file >= 0) ::close(file);
  if (reason == 0) return;
  throw SystemError(fmt::format("{}: cannot be written to: {}", folder, std::strerror(reason)), reason);
}

}  // namespace

NotedContent NotedContent::of(const std::string& content) {
  NotedContent noted;
  noted.size = content.size();
  std::uint64_t digest = fingerprint(""), done = 0;
  for (const std::uint64_t length : beginnings(noted.size)) {
    digest = fingerprint(std::string_view(content).substr(done, length - done), digest);
    noted.digests.push_back(digest);
    done = length;
  }
  return noted;
}

bool NotedContent::fits(const std::string& file) const {
  if (grows || file.empty()) return true;
  const auto own = of(file).digests;
  if (digests.size() == 1 || file.size() >= size) return file.size() == size && own.back() == digests.back();
  const auto lengths = beginnings(size);
  std::size_t known = 0;
  while (lengths[known] <= file.size()) ++known;
  return known > 0 && fingerprint(std::string_view(file).substr(0, lengths[known - 1])) == digests[known - 1];
}

std::vector<NotedContent> contents_noted(const std::string& folder, const std::string& name) {
  const std::lock_guard lock(guard);
  const auto& contents = manifest_of(folder).contents;
  const auto found = contents.find(on_one_line(name));
  return found == contents.end() ? std::vector<NotedContent>{} : found->second;
}

std::string kind_noted(const std::string& folder) {
  const std::lock_guard lock(guard);
  return manifest_of(folder).kind;
}

void note_content(const std::string& folder, const std::string& name, const NotedContent& content, bool on_disk) {
  const std::string file = on_one_line(name);
  add_line(folder,
           content.grows ? "grows " + file
                         : fmt::format("has {} {:016x} {}", content.size, fmt::join(content.digests, ","), file),
           on_disk);
}

void note_kind(const std::string& folder, const std::string& kind) {
  add_line(folder, "kind " + kind, true);
}

}  // namespace parison::core
