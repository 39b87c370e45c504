#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <functional>
#include <string>

namespace parison::tools {

/// What a browser asks for.
struct PageRequest {
  bool posts = false;
  std::string target;  ///< behind the token, "data"; decoded
  std::string body;    ///< of a POST, JSON
};

/// What it gets.
struct PageAnswer {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
  std::string policy = {};  ///< Content-Security-Policy; empty: nothing may be loaded
};

/// A page and what it asks for, for browsers on this machine alone.
struct PageService {
  std::string option;            ///< of the command line that errors begin with
  std::string token;             ///< the first part of every address; empty: none is asked for
  std::size_t largest_body = 0;  ///< of a POST, bytes; 0: none is taken
  /// Answers; called in one thread, other than that of the network.
  std::function<PageAnswer(const PageRequest&)> answer;
  /// Whether an answer takes long: such ones have a thread of their own, one for all. May be empty.
  std::function<bool(const PageRequest&)> takes_long = {};
};

/// An address that nobody can guess: 128 bits of the system's random numbers.
std::string random_token();

/// The answer that a sentence refuses something.
PageAnswer refusal(int status, const std::string& sentence);

/// Serves at the first free port from the one asked for, until it is stopped by Ctrl-C; `begun` gets the address.
/// Requests by another host name, from a page of another site, without the token or with another content than JSON are
/// refused. Throws core::RunError where no port is free.
void serve(const PageService& service, int port, const std::function<void(const std::string&)>& begun);

}  // namespace parison::tools
