#include "bench/against_embree.hpp"

#include <embree3/rtcore.h>

#include <atomic>
#include <chrono>
#include <limits>

#include "engine/tile.hpp"
#include "render/parallel.hpp"
#include "render/pixel.hpp"
#include "render/view.hpp"

namespace glassbox {

struct EmbreeScene::Inside {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::atomic<std::int64_t> bytes = 0;
    double seconds = 0;
    int width = 0, height = 0;
    Vec3<float> eye;
    std::vector<float> x, y, z;  ///< of each pixel's direction
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

    in.width = scene.width;
    in.height = scene.height;
    const View seen = view(scene, {});
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
            const Ray<float> ray = convert<float>(pixel_ray(seen, x, y, scene.height));
            in.eye = ray.P;
            in.x.push_back(ray.D.x);
            in.y.push_back(ray.D.y);
            in.z.push_back(ray.D.z);
        }
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(inside_->scene);
    rtcReleaseDevice(inside_->device);
}

double EmbreeScene::build_seconds() const { return inside_->seconds; }
double EmbreeScene::bytes() const { return static_cast<double>(inside_->bytes); }
std::string EmbreeScene::version() { return RTC_VERSION_STRING; }

namespace {

RTCIntersectContext coherent() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace

void EmbreeScene::trace_one_by_one(const Job& job, NearestHits& hits) const {
    const Inside& in = *inside_;
    for_each_pixel(in.width, in.height, job, [&](int x, int y) {
        const std::size_t pixel = index_of({x, y}, in.width);
        RTCIntersectContext context = coherent();
        RTCRayHit ray{};
        ray.ray = {in.eye.x,    in.eye.y, in.eye.z, 0,          in.x[pixel], in.y[pixel],
                   in.z[pixel], 0,        infinity, 0xFFFFFFFF, 0,           0};
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(in.scene, &context, &ray);
        hits.surface[pixel] = ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? engine::no_surface : ray.hit.primID;
        hits.t[pixel] = ray.ray.tfar;
    });
}

void EmbreeScene::trace_packets(const Job& job, NearestHits& hits) const {
    const Inside& in = *inside_;
    for_each_pixel(in.width / 4, in.height / 4, job, [&](int tile_x, int tile_y) {
        alignas(64) RTCRayHit16 rays;
        alignas(64) int valid[16];
        std::size_t pixels[16];
        for (int k = 0; k < 16; ++k) {
            const std::size_t pixel = index_of({tile_x * 4 + k % 4, tile_y * 4 + k / 4}, in.width);
            pixels[k] = pixel;
            valid[k] = -1;
            rays.ray.org_x[k] = in.eye.x;
            rays.ray.org_y[k] = in.eye.y;
            rays.ray.org_z[k] = in.eye.z;
            rays.ray.tnear[k] = 0;
            rays.ray.dir_x[k] = in.x[pixel];
            rays.ray.dir_y[k] = in.y[pixel];
            rays.ray.dir_z[k] = in.z[pixel];
            rays.ray.time[k] = 0;
            rays.ray.tfar[k] = infinity;
            rays.ray.mask[k] = 0xFFFFFFFF;
            rays.ray.id[k] = rays.ray.flags[k] = 0;
            rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
            rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
        }
        RTCIntersectContext context = coherent();
        rtcIntersect16(valid, in.scene, &context, &rays);
        for (int k = 0; k < 16; ++k) {
            const bool missed = rays.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID;
            hits.surface[pixels[k]] = missed ? engine::no_surface : rays.hit.primID[k];
            hits.t[pixels[k]] = rays.ray.tfar[k];
        }
    });
}

}  // namespace glassbox
