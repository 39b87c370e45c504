#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>

#include "tools/server/page_server.hpp"

namespace parison::tools {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;

/// Why a request is refused before anybody is asked for an answer; nothing where it is let through.
std::optional<PageAnswer> refused(const PageService& service, const HttpRequest& request);

/// What such a request asks for.
PageRequest page_request(const PageService& service, const HttpRequest& request);

}  // namespace parison::tools
