#include "trial.hpp"

#include <stdexcept>

#include "read_drawn.hpp"
#include "render/options.hpp"
#include "render/search/build_engine.hpp"

namespace glassbox::fuzz {

namespace {

/// One pixel's ray of so many is shot by itself.
constexpr std::size_t pixels_a_ray = 31;

Vec3<double> to_vec3(const oracle::Point& p) { return {p.x, p.y, p.z}; }

}  // namespace

Trial::Trial(Drawn drawn)
    : drawn_(std::move(drawn)),
      scene_(read_drawn(drawn_)),
      view_(glassbox::view(scene_, {})),
      oracle_(drawn_.surfaces),
      engine_(build_engine(scene_, 5, 1)) {
    for (int y = 0; y < drawn_.height; ++y)
        for (int x = 0; x < drawn_.width; ++x) pixel_rays_.push_back(pixel_ray(view_, x, y, drawn_.height));
    for (const auto& [P, D] : drawn_.rays) rays_.push_back({to_vec3(P), to_vec3(D)});
    for (std::size_t pixel = 0; pixel < pixels(); pixel += pixels_a_ray) rays_.push_back(pixel_rays_[pixel]);
    const auto ask = [&](const std::vector<Ray<double>>& rays, std::vector<oracle::Answer>& answers) {
        for (const Ray<double>& ray : rays) answers.push_back(oracle_(to_oracle(ray)));
    };
    ask(pixel_rays_, pixel_answers_);
    ask(rays_, answers_);
}

}  // namespace glassbox::fuzz
