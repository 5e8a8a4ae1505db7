// Methods that know their error: each step as long as `tolerance` lets it be, impacts on the dense output.
#include <cmath>
#include <numbers>

#include "laboratory.hpp"
#include "scenes.hpp"

namespace animado::experiments {
namespace {

constexpr double kPi = std::numbers::pi;

std::string world(const std::string& method, const std::string& tolerance, const std::string& more = "") {
  return "world\n method " + method + (tolerance.empty() ? "" : "\n tolerance " + tolerance) + "\n" + more;
}

// Each evaluation of the forces is one batch that egesp solves.
int64_t evaluations(const Record& record) {
  return record.summary["messages_per_module"]["egesp"];
}

// Amplitude 1 cm, ten oscillations a second: x = 0.01 cos 20πt.
constexpr auto kSpring = R"(
object weight
  shape cube(edge = 0.2)
  mass 1.5
  position (0.01, 0, 0)
  force (-(20*pi)^2*mass*position.x, 0, 0)
time
  end 1
  step 0.03125
)";

double worst_error_m(const Record& spring) {
  double worst = 0;
  for (const Row& row : spring.rows)
    worst = std::max(worst, std::abs(row.position_m.x() - 0.01 * std::cos(20 * kPi * row.time_s)));
  return worst;
}

double gap_of_the_ellipse_m(const Record& orbit) {
  return (orbit.of("planet").back().position_m - Vec3(0.7, 0, 0)).norm();
}

}  // namespace

class EmbeddedSpring : public Experiment {};

// A spring passes errors on as they are, in (x, v/ω): they add up to at most the number of steps times what
// one may leave. That is √13 of its unit if all of a body's error is in one of its 13 numbers; the unit is
// the tolerance times 1 + |y| < 2.
TEST_P(EmbeddedSpring, KeepsWhatTheTolerancePromises) {
  const auto keeps = [&](const char* method, double tolerance) {
    const Record record = simulate(world(method, std::to_string(tolerance * 1e9) + "e-9") + kSpring);
    EXPECT_LT(worst_error_m(record), record.summary["steps"].get<double>() * std::sqrt(13) * tolerance * 2)
        << method << " at " << tolerance;
  };
  keeps("bs23", 1e-6);
  for (const char* method : {"fehlberg45", "cash_karp", "dopri5", "dop853", "verner87"}) {
    keeps(method, 1e-6);
    keeps(method, 1e-9);
  }
}

TEST_P(EmbeddedSpring, IsMoreExactForATighterTolerance) {
  double before_m = 1;
  for (const char* tolerance : {"1e-5", "1e-7", "1e-9", "1e-11"}) {
    const double error_m = worst_error_m(simulate(world("dopri5", tolerance) + kSpring));
    EXPECT_LT(error_m, before_m / 4) << tolerance;
    before_m = error_m;
  }
}

class EmbeddedOrbit : public Experiment {};

TEST_P(EmbeddedOrbit, TakesFewerEvaluationsThanRk4ForNoLargerAnError) {
  const Record rk4 = simulate(world("rk4", "1e-8") + kOrbit);
  for (const char* method : {"dopri5", "dop853", "verner87"}) {
    const Record record = simulate(world(method, "1e-9") + kOrbit);
    EXPECT_LT(gap_of_the_ellipse_m(record), 1.5 * gap_of_the_ellipse_m(rk4)) << method;
    EXPECT_LT(2 * evaluations(record), evaluations(rk4)) << method;
  }
}

// The worst body's error counts, not the mean over all: a hundred stones at rest do not loosen the tolerance.
TEST_P(EmbeddedOrbit, IsTheSameAmongBodiesAtRest) {
  const Record alone = simulate(world("dopri5", "1e-9") + kOrbit);
  std::string stones;
  for (int i = 0; i < 100; ++i) {
    stones += "object stone" + std::to_string(i) + "\n shape sphere(radius = 0.1)\n mass 1\n position (" +
              std::to_string(100 + i) + ", 0, 0)\n";
  }
  const Record among = simulate(world("dopri5", "1e-9") + stones + kOrbit);
  EXPECT_EQ(among.summary["steps"], alone.summary["steps"]);
  const auto expected = alone.of("planet"), actual = among.of("planet");
  ASSERT_EQ(actual.size(), expected.size());
  for (size_t i = 0; i < actual.size(); ++i) EXPECT_EQ(actual[i].position_m, expected[i].position_m);
}

class EmbeddedFall : public Experiment {};

// After √(2h/g), then each 2 εⁿ √(2h/g) later.
TEST_P(EmbeddedFall, LandsWhenTheFormulaSays) {
  const Record record =
      simulate(world("dopri5", "1e-9", "gravity (0, -9.81, 0)\n") + bouncing_ball("3", "0.05"));
  const auto impacts = record.impacts();
  ASSERT_EQ(impacts.size(), 3u);
  const double first_s = std::sqrt(2 * 2 / 9.81);
  double expected_s = first_s;
  for (int n = 0; n < 3; ++n) {
    EXPECT_NEAR(impacts[static_cast<size_t>(n)]["time_s"].get<double>(), expected_s, 1e-9) << "bounce " << n;
    expected_s += 2 * std::pow(0.8, n + 1) * first_s;
  }
}

// What a path prescribes is no error of the method, however abrupt it is.
TEST_P(EmbeddedFall, TakesNoShorterStepsForABodyOnAPath) {
  const auto scene = [](const std::string& path) {
    return world("dopri5", "1e-9", "gravity (0, -9.81, 0)\n") +
           "object paddle\n shape cube(edge = 1)\n motion path\n" + " path position (50 + " + path +
           R"(, 0, 0)
object ball
  shape sphere(radius = 0.25)
  mass 1
time
  end 1
  step 0.1
)";
  };
  EXPECT_EQ(simulate(scene("abs(t - 0.437)")).summary["steps"], simulate(scene("0")).summary["steps"]);
}

class Grazing : public Experiment {};

// x = sin 10πt reaches a wall that stands a hundred-thousandth before its largest: where steps are as long as
// an eighth-order method lets them be, the cubic between their ends falls short of it by more.
TEST_P(Grazing, IsFoundOnTheDenseOutput) {
  const Record record = simulate(world("dop853", "1e-9") + R"(
object wall
  shape plane(normal = (-1, 0, 0), offset = -1.09999)
  motion static
  restitution 1
object ball
  shape sphere(radius = 0.1)
  mass 2
  restitution 1
  velocity (10*pi, 0, 0)
  force (-(10*pi)^2*mass*position.x, 0, 0)
time
  end 0.12
  step 0.12
)");
  const auto impacts = record.impacts();
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts[0]["time_s"].get<double>(), std::asin(1 - 1e-5) / (10 * kPi), 1e-9);
}

// A bar that turns at a constant rate while it falls: its corner is the first to arrive.
TEST_P(Grazing, ACornerMeetsTheFloorWhenTheFormulaSays) {
  const Record record = simulate(world("dop853", "1e-9") + R"(
object floor
  shape plane(normal = (0, 1, 0), offset = 0)
  motion static
object bar
  shape box(size = (2, 0.1, 0.1))
  mass 2
  position (0, 1.05, 0)
  velocity (0, -0.2, 0)
  angular velocity (0, 0, 20)
time
  end 0.5
  step 0.1
)");
  ASSERT_FALSE(record.impacts().empty());
  // The first zero of 1.05 − 0.2 t − |sin 20t| − 0.05 |cos 20t|, by bisection.
  EXPECT_NEAR(record.impacts()[0]["time_s"].get<double>(), 0.37857112574196705, 1e-9);
}

// A box that tumbles on a floor: free flight, impacts, islands in contact.
TEST(EmbeddedMethods, GiveTheSameBitsBothWays) {
  for (const char* method : {"bs23", "dopri5", "dop853", "verner87"}) {
    const std::string scene = world(method, "1e-7", "gravity (0, -9.81, 0)\n") + R"(
object floor
  shape plane(normal = (0, 1, 0), offset = 0)
  motion static
object box
  shape box(size = (0.4, 0.6, 0.8))
  mass 2
  position (0, 1.2, 0)
  angular velocity (3, 1, 2)
  force -0.2*velocity
time
  end 2
  step 0.1
)";
    const Record sockets = simulate(scene, Way::sockets), in_process = simulate(scene, Way::in_process);
    EXPECT_GT(sockets.impacts().size(), 2u) << method;
    EXPECT_EQ(sockets.summary["state_hash"], in_process.summary["state_hash"]) << method;
    EXPECT_EQ(sockets.events, in_process.events) << method;
  }
}

ANIMADO_BOTH_WAYS(EmbeddedSpring);
ANIMADO_BOTH_WAYS(EmbeddedOrbit);
ANIMADO_BOTH_WAYS(EmbeddedFall);
ANIMADO_BOTH_WAYS(Grazing);

}  // namespace animado::experiments
