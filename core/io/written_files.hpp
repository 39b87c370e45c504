#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <set>
#include <string>

namespace parison::core {

/// What this program has written: each folder has a manifest of its files, `.parison_written`, with size and digest of
/// every content that each was given. A file is the program's own where its content is one of these, or the beginning
/// of one, as a loss of power leaves it; all others are the user's, and nothing here overwrites or removes them. Names
/// that begin with `.parison_` are the program's.
bool is_own(const std::string& path);

/// Whether a file has the size of a content that the program gave it, and other bytes: what a disk has damaged.
bool is_damaged(const std::string& path);

/// Throws CaseError that names a file that is there and is not the program's own; of a folder, the first one in it.
void require_own(const std::string& path);

/// Makes a folder, or goes on with one, for the results of a command: `kind` is its name. Throws CaseError where it
/// holds those of another command, or where an entry with one of the names is there that this program has not written;
/// a name may end with a `*` for any ending.
void claim_folder(const std::string& folder, const std::string& kind, const std::set<std::string>& names);

/// Notes a content that a file is about to get, before it is there: a process that is killed leaves nothing foreign,
/// and where the note has reached the disk no loss of power does.
void note_written(const std::string& path, const std::string& content, bool on_disk = false);
void note_written(const std::string& path, std::uint64_t size, std::uint64_t digest);

/// Notes a file that grows: it is the program's own, whatever its content, until a whole content is noted.
void note_growing(const std::string& path);

/// Gives what another program has made under the unfinished name its own.
void take_made(const std::string& path);

/// Removes a file or a folder with all that is in it; throws as require_own before it removes anything.
void remove_own(const std::string& path);

/// Removes a file or a folder as far as it is the program's own; what is the user's stays.
void remove_own_files(const std::string& path);

/// Gives a file another name, or a second one; a file of that name that is not the program's own is set aside.
void rename_own(const std::string& from, const std::string& to);
void link_own(const std::string& from, const std::string& to);

/// Gives a file a free name beside its own, so that nothing is lost where it is written anew.
void set_aside(const std::string& path);

/// The name beside a path for what is not complete yet.
std::string unfinished_name(const std::string& path);

}  // namespace parison::core
