#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::tools {

/// Opens standard input, output and error on /dev/null where they are closed. A file opened later would otherwise get
/// the number of standard output, and what is printed would go into the results.
void open_standard_streams();

/// Whether everything printed so far has been written.
bool output_was_written();

}  // namespace parison::tools
