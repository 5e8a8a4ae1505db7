// src/animado/restarts.cpp
#include "animado/restarts.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

TEST(Restarts, StandAmongTheEventsInTheOrderOfTime) {
  const TemporaryDirectory directory;
  const auto events = write_text(directory / "events.jsonl",
                                 "{\"time_s\": 1.5, \"kind\": \"impact\", \"bodies\": [\"a\", \"b\"]}\n"
                                 "{\"time_s\": 2.5, \"kind\": \"impact\", \"bodies\": [\"a\", \"b\"]}\n");
  add_restarts(events, {{2, "fred"}, {2.5, "egesp"}});
  EXPECT_EQ(text_of(events),
            "{\"time_s\": 1.5, \"kind\": \"impact\", \"bodies\": [\"a\", \"b\"]}\n"
            "{\"time_s\": 2, \"kind\": \"restart\", \"bodies\": [], \"name\": \"fred\"}\n"
            "{\"time_s\": 2.5, \"kind\": \"impact\", \"bodies\": [\"a\", \"b\"]}\n"
            "{\"time_s\": 2.5, \"kind\": \"restart\", \"bodies\": [], \"name\": \"egesp\"}\n");
}

TEST(Restarts, LeaveTheFileAloneWhenThereWereNone) {
  EXPECT_NO_THROW(add_restarts("/nowhere/events.jsonl", {}));
  EXPECT_THROW(add_restarts("/nowhere/events.jsonl", {{1, "fred"}}), Error);
}

}  // namespace
}  // namespace animado
