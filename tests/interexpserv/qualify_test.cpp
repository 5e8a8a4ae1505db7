#include "interexpserv/qualify.hpp"

#include <gtest/gtest.h>

namespace animado::interexpserv {

TEST(Qualify, PutsThePrefixBeforeNamesOfTheHomeAlone) {
  MapScope scope;
  scope.input("ball.position", Type::vector).set("ball.mass", Value::scalar(2)).set("spring.k", Value::scalar(3));
  scope.input("t", Type::scalar);
  EXPECT_EQ(qualified("-spring.k*position.x + Mass*norm(position)*t", scope, "ball"),
            "-spring.k*ball.position.x + ball.mass*norm(ball.position)*t");
  EXPECT_EQ(qualified("ball.mass + 1", scope, "ball"), "ball.mass + 1");
  EXPECT_EQ(qualified("", scope, "ball"), "");
}

}  // namespace animado::interexpserv
