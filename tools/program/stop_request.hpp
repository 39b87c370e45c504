#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::tools {

/// From here on the first Ctrl-C or SIGTERM asks for a stop, the second ends the program. A file too large for its
/// limit is an error like a full disk.
void catch_signals();

/// Whether a stop was asked for.
bool stop_requested();

}  // namespace parison::tools
