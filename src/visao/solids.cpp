#include "visao/solids.hpp"

#include <cstring>

#include "base/error.hpp"

namespace animado::visao {

namespace {

enum Kind : unsigned { kTriangles, kSpheres };  // Embree's geometries, by number

// One thread builds: the tree, and with it the picture, is the same each time.
RTCDevice new_device() {
  const RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  if (device == nullptr) throw Error(Code::internal, "Embree does not start");
  return device;
}

template <class Element>
void set_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                const std::vector<Element>& elements, size_t count, size_t stride) {
  void* const memory = rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count);
  if (memory == nullptr) throw Error(Code::internal, "Embree has no memory for the bodies");
  std::memcpy(memory, elements.data(), count * stride);
}

void attach(RTCScene scene, RTCGeometry geometry, Kind kind) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, kind);
  rtcReleaseGeometry(geometry);
}

}  // namespace

Solids::Solids(const Stage& stage, std::span<const Pose> poses)
    : device_(new_device()), scene_(rtcNewScene(device_.get())) {
  for (uint32_t k = 0; k < stage.bodies.size(); ++k) {
    const StagedBody& body = stage.bodies[k];
    Pose pose = poses[body.index];
    pose.position_m -= stage.origin_m;
    place(body, pose, k);
    to_body_.push_back((Eigen::Translation3d(pose.position_m) * pose.orientation).inverse().cast<float>());
  }
  if (!triangles_.empty()) add_triangles();
  if (!spheres_m_.empty()) add_spheres();
  rtcCommitScene(scene_.get());
}

void Solids::place(const StagedBody& body, const Pose& pose, uint32_t index) {
  if (body.sphere_radius_m > 0) {
    spheres_m_.emplace_back();
    spheres_m_.back() << pose.position_m.cast<float>(), static_cast<float>(body.sphere_radius_m);
    body_of_sphere_.push_back(index);
    return;
  }
  const auto first = static_cast<uint32_t>(corners_m_.size());
  const Mat3 turn = pose.orientation.toRotationMatrix();
  for (const Vec3& p : body.mesh.positions_m) {
    corners_m_.push_back((pose.position_m + turn * p).cast<float>());
  }
  for (const Vec3& n : body.mesh.normals) normals_.push_back((turn * n).cast<float>());
  for (const uint32_t corner : body.mesh.triangles) triangles_.push_back(first + corner);
  body_of_triangle_.insert(body_of_triangle_.end(), body.mesh.triangles.size() / 3, index);
}

void Solids::add_triangles() {
  const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  set_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, corners_m_, corners_m_.size(),
             sizeof(Vec3f));
  set_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles_, triangles_.size() / 3,
             3 * sizeof(uint32_t));
  attach(scene_.get(), geometry, kTriangles);
}

void Solids::add_spheres() {
  const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  set_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, spheres_m_, spheres_m_.size(),
             sizeof(Eigen::Vector4f));
  attach(scene_.get(), geometry, kSpheres);
}

void Solids::meet(const int* valid, RTCRayHit16& rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect16(valid, scene_.get(), &context, &rays);
}

void Solids::block(const int* valid, RTCRay16& rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(valid, scene_.get(), &context, &rays);
}

Solids::Surface Solids::surface(const RTCHit16& hits, int ray, const Vec3f& point_m) const {
  const uint32_t element = hits.primID[ray];
  if (hits.geomID[ray] == kSpheres) {
    const Vec3f normal = (point_m - spheres_m_[element].head<3>()).normalized();
    const uint32_t body = body_of_sphere_[element];
    return {body, normal, to_body_[body] * point_m};
  }
  const uint32_t* const corner = &triangles_[3 * element];
  const float u = hits.u[ray], v = hits.v[ray];
  const Vec3f normal = (1 - u - v) * normals_[corner[0]] + u * normals_[corner[1]] + v * normals_[corner[2]];
  const uint32_t body = body_of_triangle_[element];
  return {body, normal.normalized(), to_body_[body] * point_m};
}

}  // namespace animado::visao
