#include "bench/against_embree.hpp"

#include <embree3/rtcore.h>

#include <atomic>
#include <chrono>
#include <limits>

#include "bench/ray_lists.hpp"
#include "engine/tile.hpp"

namespace glassbox {

struct EmbreeScene::Inside {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::atomic<std::int64_t> bytes = 0;
    double seconds = 0;
};

EmbreeScene::EmbreeScene(const Scene& scene, bool robust) : inside_(std::make_unique<Inside>()) {
    Inside& in = *inside_;
    in.device = rtcNewDevice(nullptr);
    const Mesh& mesh = scene.meshes.front();
    in.scene = rtcNewScene(in.device);
    if (robust) rtcSetSceneFlags(in.scene, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(in.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3<float> v = convert<float>(mesh.vertices[i]);
        vertices[3 * i] = v.x;
        vertices[3 * i + 1] = v.y;
        vertices[3 * i + 2] = v.z;
    }
    auto* const faces = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.faces.size()));
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) faces[3 * i + k] = mesh.faces[i][k];
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(in.scene, geometry);
    rtcReleaseGeometry(geometry);

    rtcSetDeviceMemoryMonitorFunction(
        in.device,
        [](void* bytes, ssize_t change, bool) {
            *static_cast<std::atomic<std::int64_t>*>(bytes) += change;
            return true;
        },
        &in.bytes);
    const auto start = std::chrono::steady_clock::now();
    rtcCommitScene(in.scene);
    in.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rtcSetDeviceMemoryMonitorFunction(in.device, nullptr, nullptr);
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(inside_->scene);
    rtcReleaseDevice(inside_->device);
}

double EmbreeScene::build_seconds() const { return inside_->seconds; }
double EmbreeScene::bytes() const { return static_cast<double>(inside_->bytes); }
std::string EmbreeScene::version() { return RTC_VERSION_STRING; }

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

RTCIntersectContext context_of(Coherence coherence) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags =
        coherence == Coherence::high ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_NONE;
    return context;
}

RTCRay in_embree(const Ray<float>& ray) {
    return {ray.P.x, ray.P.y, ray.P.z, 0, ray.D.x, ray.D.y, ray.D.z, 0, infinity, 0xFFFFFFFF, 0, 0};
}

}  // namespace

void EmbreeScene::trace(std::span<const Ray<float>> rays, Coherence coherence, const Job& job,
                        NearestHits& hits) const {
    for_each_timed(rays.size(), job, [&](std::size_t i) {
        RTCIntersectContext context = context_of(coherence);
        RTCRayHit ray{};
        ray.ray = in_embree(rays[i]);
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(inside_->scene, &context, &ray);
        hits.surface[i] = ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? engine::no_surface : ray.hit.primID;
        hits.t[i] = ray.ray.tfar;
    });
}

void EmbreeScene::trace_packets(std::span<const Ray<float>> rays, const Job& job, NearestHits& hits) const {
    for_each_timed(rays.size() / 16, job, [&](std::size_t packet) {
        alignas(64) RTCRayHit16 in;
        alignas(64) int valid[16];
        for (std::size_t k = 0; k < 16; ++k) {
            const auto& [P, D] = rays[16 * packet + k];
            valid[k] = -1;
            in.ray.org_x[k] = P.x;
            in.ray.org_y[k] = P.y;
            in.ray.org_z[k] = P.z;
            in.ray.tnear[k] = 0;
            in.ray.dir_x[k] = D.x;
            in.ray.dir_y[k] = D.y;
            in.ray.dir_z[k] = D.z;
            in.ray.time[k] = 0;
            in.ray.tfar[k] = infinity;
            in.ray.mask[k] = 0xFFFFFFFF;
            in.ray.id[k] = in.ray.flags[k] = 0;
            in.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
            in.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
        }
        RTCIntersectContext context = context_of(Coherence::high);
        rtcIntersect16(valid, inside_->scene, &context, &in);
        for (std::size_t k = 0; k < 16; ++k) {
            const bool missed = in.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID;
            hits.surface[16 * packet + k] = missed ? engine::no_surface : in.hit.primID[k];
            hits.t[16 * packet + k] = in.ray.tfar[k];
        }
    });
}

void EmbreeScene::occluded(std::span<const Ray<float>> rays, Coherence coherence, const Job& job,
                           std::vector<std::uint8_t>& answers) const {
    for_each_timed(rays.size(), job, [&](std::size_t i) {
        RTCIntersectContext context = context_of(coherence);
        RTCRay ray = in_embree(rays[i]);
        rtcOccluded1(inside_->scene, &context, &ray);
        answers[i] = ray.tfar < 0;  // Embree's way to say yes
    });
}

}  // namespace glassbox
