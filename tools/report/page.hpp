#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

/// A page with all that it needs in itself: template, styles, scripts and the plotting library of share/parison, a
/// title, and the data as report_data makes them or `null`. Throws core::RunError where those files are missing.
std::string page_text(const std::string& title, const std::string& data);

/// A text as HTML shows it.
std::string html_text(const std::string& text);

}  // namespace parison::tools
