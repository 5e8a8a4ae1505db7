// src/interexpserv/leases.cpp
#include "interexpserv/leases.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace animado::interexpserv {
namespace {

Lease lease(std::string name, uint64_t connection) {
  return {std::move(name), "/tmp/socket", "0.1", "2026-01-01T00:00:00Z", 42, connection};
}

Code code_of_lookup(Leases& leases, const std::string& name) {
  try {
    leases.take_turn(name);
  } catch (const Error& error) {
    return error.code();
  }
  return Code::internal;
}

TEST(Leases, EndWithTheirConnection) {
  Leases leases;
  leases.grant(lease("egesp", 1));
  leases.grant(lease("fred", 2));
  EXPECT_EQ(leases.take_turn("egesp").pid, 42);
  leases.end(1);
  EXPECT_EQ(code_of_lookup(leases, "egesp"), Code::unavailable);
  EXPECT_EQ(leases.list().size(), 1u);
}

// A server that came back registers before the end of its former connection has been noticed.
TEST(Leases, TheEndOfAFormerConnectionDoesNotTakeTheNewLease) {
  Leases leases;
  leases.grant(lease("egesp", 1));
  leases.grant(lease("egesp", 5));
  leases.end(1);
  EXPECT_EQ(leases.take_turn("egesp").connection, 5u);
}

Lease replica(std::string socket, uint64_t connection) {
  return {"egesp", std::move(socket), "0.1", "2026-01-01T00:00:00Z", 42, connection};
}

TEST(Leases, ServersOfOneNameTakeTurns) {
  Leases leases;
  for (uint64_t i = 1; i <= 3; ++i) leases.grant(replica("/" + std::to_string(i), i));
  std::string turns;
  for (int i = 0; i < 6; ++i) turns += leases.take_turn("egesp").socket;
  EXPECT_EQ(turns, "/1/2/3/1/2/3");
  leases.end(2);
  turns.clear();
  for (int i = 0; i < 4; ++i) turns += leases.take_turn("egesp").socket;
  EXPECT_TRUE(turns == "/1/3/1/3" || turns == "/3/1/3/1") << turns;
  EXPECT_EQ(leases.list().size(), 2u);
}

TEST(Leases, ARestartIsAServerInThePlaceOfOneThatEnded) {
  Leases leases;
  leases.grant(replica("/1", 1));
  leases.grant(replica("/2", 2));
  EXPECT_EQ(leases.list()[0].restarts, 0);
  leases.end(1);
  leases.grant(replica("/3", 3));
  leases.grant(replica("/4", 4));
  EXPECT_EQ(leases.list()[0].restarts, 1);
  leases.grant(replica("/4", 5));  // the same server, over another connection
  EXPECT_EQ(leases.list()[0].restarts, 1);
}

TEST(Leases, NamesThatAreGoneMakeRoomForOthers) {
  Leases leases;
  for (uint64_t i = 0; i < 300; ++i) {
    leases.grant(lease("service" + std::to_string(i), i));
    leases.end(i);
  }
  for (uint64_t i = 0; i < 256; ++i) leases.grant(lease("service" + std::to_string(i), i));
  EXPECT_THROW(leases.grant(lease("one-too-many", 999)), Error);
}

TEST(Leases, AreListedByName) {
  Leases leases;
  leases.grant(lease("fred", 2));
  leases.grant(lease("colisao", 3));
  EXPECT_EQ(leases.list()[0].name, "colisao");
}

TEST(Leases, NeedANameAndASocket) {
  Leases leases;
  EXPECT_THROW(leases.grant(lease("", 1)), Error);
  EXPECT_THROW(leases.grant({"egesp", "", "", "", 1, 1}), Error);
}

}  // namespace
}  // namespace animado::interexpserv
