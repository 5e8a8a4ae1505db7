// src/rpc/prepared.hpp: servers that die between what prepares them and the request.
#include "rpc/prepared.hpp"

#include <gtest/gtest.h>

namespace animado::rpc::testing {
namespace {

// Does not know the handle when it is asked the first `deaths` times.
struct Forgetful {
  int deaths;
  Code code = Code::unknown_handle;
  int prepared = 0;

  int ask() {
    return ask_prepared([this] { ++prepared; },
                        [this] {
                          if (deaths-- > 0) throw Error(code, "restarted", "handle", "prepare again");
                          return 42;
                        });
  }
};

TEST(AskPrepared, PreparesAgainAsOftenAsTheServerDies) {
  for (const int deaths : {0, 1, 2, 5}) {
    Forgetful server{deaths};
    EXPECT_EQ(server.ask(), 42);
    EXPECT_EQ(server.prepared, deaths);
  }
}

TEST(AskPrepared, EndsWithAServerThatForgetsAlways) {
  Forgetful server{1'000'000};
  try {
    server.ask();
    ADD_FAILURE() << "it answered";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unknown_handle);
  }
  EXPECT_LT(server.prepared, 100);
}

TEST(AskPrepared, OtherErrorsAreTheCallers) {
  Forgetful server{1, Code::singular};
  EXPECT_THROW(server.ask(), Error);
  EXPECT_EQ(server.prepared, 0);
}

}  // namespace
}  // namespace animado::rpc::testing
