#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

namespace parison::core {

/// The content followed by a line with its length and its digest, the 64-bit FNV-1a hash. Whatever changes a single
/// byte changes the digest for sure, since every step of the hash is one-to-one; any other damage is missed once in
/// 2^64.
std::string with_digest(std::string content);

/// What `with_digest` was given; nothing where the line is missing or does not fit, so that some byte has changed.
std::optional<std::string> without_digest(std::string text);

}  // namespace parison::core
