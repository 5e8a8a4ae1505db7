// A step of 10,000 free tops, in-process and on one thread: RK4 with egesp solving at every stage and colisao
// sweeping, beside Bullet and ODE, which make one explicit step. `error10s` is what became of the angular
// momentum after 10 s.
#include <benchmark/benchmark.h>
#include <btBulletDynamicsCommon.h>
#include <ode/ode.h>

#include "animado/in_process.hpp"
#include "base/state.hpp"
#include "controle/simulation.hpp"
#include "free_tops.hpp"

namespace animado::bench {
namespace {

constexpr size_t kTops = 10000;
constexpr int kSteps = 600;

void report(benchmark::State& state, double error) {
  state.counters["error10s"] = error;
  state.counters["ns_a_body"] =
      benchmark::Counter(static_cast<double>(kTops) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

double animado_error(const controle::Stepper& stepper) {
  AngularMomentumError error(free_tops(kTops));
  for (size_t i = 0; i < kTops; ++i) {
    const BodyState body = load_body(stepper.state(), kTops, i);
    error.add(i, body.pose.orientation, body.angular_velocity_rad_s());
  }
  return error.mean();
}

void FreeTopsAnimado(benchmark::State& state) {
  const auto suite = suite_in_process();
  rpc::Log silent;
  controle::Simulation simulation(free_tops_scene(kTops), *suite, "bench", silent, [](const auto&) {});
  controle::Stepper& stepper = simulation.stepper();
  int steps = 0;
  for (auto _ : state) stepper.advance_to(kStep_s * ++steps);
  while (steps < kSteps) stepper.advance_to(kStep_s * ++steps);
  report(state, animado_error(stepper));
}

void FreeTopsBullet(benchmark::State& state) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, 0, 0});
  const auto vector = [](const Vec3& v) {
    return btVector3(btScalar(v.x()), btScalar(v.y()), btScalar(v.z()));
  };
  btBoxShape box(vector(kHalf_m));
  btVector3 inertia;
  box.calculateLocalInertia(btScalar(top_mass_kg()), inertia);
  const auto tops = free_tops(kTops);
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  for (const Top& top : tops) {
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(top_mass_kg()), nullptr, &box, inertia);
    info.m_startWorldTransform.setOrigin(vector(top.position_m));
    bodies.push_back(std::make_unique<btRigidBody>(info));
    bodies.back()->setAngularVelocity(vector(top.angular_velocity_rad_s));
    bodies.back()->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(bodies.back().get());
  }
  int steps = 0;
  const auto step = [&] { world.stepSimulation(btScalar(kStep_s), 0), ++steps; };
  for (auto _ : state) step();
  while (steps < kSteps) step();
  AngularMomentumError error(tops);
  for (size_t i = 0; i < kTops; ++i) {
    const btQuaternion q = bodies[i]->getOrientation();
    const btVector3 w = bodies[i]->getAngularVelocity();
    error.add(i, Quat(q.w(), q.x(), q.y(), q.z()), {w.x(), w.y(), w.z()});
  }
  report(state, error.mean());
  for (auto& body : bodies) world.removeRigidBody(body.get());
}

void FreeTopsOde(benchmark::State& state) {
  dInitODE();
  const dWorldID world = dWorldCreate();
  const dSpaceID space = dHashSpaceCreate(nullptr);
  dWorldSetGravity(world, 0, 0, 0);
  const auto tops = free_tops(kTops);
  std::vector<dBodyID> bodies;
  for (const Top& top : tops) {
    const dBodyID body = dBodyCreate(world);
    dMass mass;
    dMassSetBoxTotal(&mass, top_mass_kg(), 2 * kHalf_m.x(), 2 * kHalf_m.y(), 2 * kHalf_m.z());
    dBodySetMass(body, &mass);
    dBodySetPosition(body, top.position_m.x(), top.position_m.y(), top.position_m.z());
    const Vec3& w = top.angular_velocity_rad_s;
    dBodySetAngularVel(body, w.x(), w.y(), w.z());
    const dGeomID geometry = dCreateBox(space, 2 * kHalf_m.x(), 2 * kHalf_m.y(), 2 * kHalf_m.z());
    dGeomSetBody(geometry, body);
    bodies.push_back(body);
  }
  int steps = 0;
  const auto step = [&] {
    dSpaceCollide(space, nullptr, [](void*, dGeomID, dGeomID) {});
    dWorldQuickStep(world, kStep_s);
    ++steps;
  };
  for (auto _ : state) step();
  while (steps < kSteps) step();
  AngularMomentumError error(tops);
  for (size_t i = 0; i < kTops; ++i) {
    const dReal *q = dBodyGetQuaternion(bodies[i]), *w = dBodyGetAngularVel(bodies[i]);
    error.add(i, Quat(q[0], q[1], q[2], q[3]), {w[0], w[1], w[2]});
  }
  report(state, error.mean());
  dSpaceDestroy(space);
  dWorldDestroy(world);
}

BENCHMARK(FreeTopsAnimado)->Unit(benchmark::kMillisecond)->Iterations(200);
BENCHMARK(FreeTopsBullet)->Unit(benchmark::kMillisecond)->Iterations(200);
BENCHMARK(FreeTopsOde)->Unit(benchmark::kMillisecond)->Iterations(200);

}  // namespace
}  // namespace animado::bench
