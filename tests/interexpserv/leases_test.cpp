// src/interexpserv/leases.cpp
#include "interexpserv/leases.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace animado::interexpserv {
namespace {

Lease lease(std::string name, uint64_t connection) {
  return {std::move(name), "/tmp/socket", "0.1", "2026-01-01T00:00:00Z", 42, connection};
}

Code code_of_lookup(const Leases& leases, const std::string& name) {
  try {
    leases.find(name);
  } catch (const Error& error) {
    return error.code();
  }
  return Code::internal;
}

TEST(Leases, EndWithTheirConnection) {
  Leases leases;
  leases.grant(lease("egesp", 1));
  leases.grant(lease("fred", 2));
  EXPECT_EQ(leases.find("egesp").pid, 42);
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
  EXPECT_EQ(leases.find("egesp").connection, 5u);
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
