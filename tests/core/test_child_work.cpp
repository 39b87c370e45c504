// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/process/child_work.hpp"
#include "core/process/clock.hpp"

namespace parison::core {
namespace {

std::string death_of(const std::function<std::string()>& work, const ChildLimits& limits = {}) {
  const ChildWork result = in_child(work, limits);
  EXPECT_EQ(result.text, "");
  return result.death;
}

std::string crash() {
  ::kill(::getpid(), SIGSEGV), ::pause();
  return "";
}

/// Where new memory is not had, an address sanitizer ends the program instead of throwing std::bad_alloc.
constexpr bool memory_ends_the_program =
#if defined(__SANITIZE_ADDRESS__)
    true;
#elif defined(__has_feature)
    __has_feature(address_sanitizer);
#else
    false;
#endif

TEST(ChildWork, the_text_comes_back_whole_and_nothing_else_changes) {
  const std::string text = std::string(3'000'000, 'x') + '\0' + "\n.";
  int here = 1;
  const ChildWork result = in_child([&] {
    here = 2;
    std::puts("this is not printed");
    return text;
  });
  EXPECT_EQ(result.text, text);
  EXPECT_EQ(result.death, "");
  EXPECT_EQ(here, 1);
  EXPECT_EQ(in_child([] { return std::string(); }).death, "");
}

TEST(ChildWork, a_child_that_dies_is_told_by_what_ended_it) {
  EXPECT_EQ(death_of(crash), "it was ended by \"Segmentation fault\"");
  EXPECT_EQ(death_of([]() -> std::string { std::abort(); }), "it was ended by \"Aborted\"");
  EXPECT_EQ(death_of([]() -> std::string { ::_exit(0); }), "it ended with an error");
  EXPECT_EQ(death_of([]() -> std::string { throw std::runtime_error("broken"); }), "it ended with an error");
}

TEST(ChildWork, a_child_that_waits_or_computes_without_end_is_ended) {
  const double start = wall_seconds();
  EXPECT_EQ(death_of([]() -> std::string { return std::to_string(::pause()); }, {1, 1'000'000'000}),
            "it took more than 1 s");
  volatile bool on = true;
  EXPECT_EQ(death_of(
                [&]() -> std::string {
                  while (on) continue;
                  return "";
                },
                {1, 1'000'000'000}),
            "it took more than 1 s");
  EXPECT_LT(wall_seconds() - start, 20);
}

TEST(ChildWork, what_the_program_does_at_a_crash_of_its_own_is_not_done_in_the_child) {
  const auto before = ::signal(SIGSEGV, [](int) { ::_exit(0); });
  EXPECT_EQ(death_of(crash), "it was ended by \"Segmentation fault\"");
  ::signal(SIGSEGV, before);
}

TEST(ChildWork, a_child_that_takes_too_much_memory_is_told_so) {
  EXPECT_EQ(death_of([] { return std::string(2'000'000'000, 'x'); }),
            memory_ends_the_program ? "it ended with an error" : "it took more than 1000 MB of memory");
  EXPECT_EQ(in_child([] { return std::string(500'000'000, 'x').substr(0, 1); }).text, "x");
}

}  // namespace
}  // namespace parison::core
