#pragma once
#include <memory>
#include <vector>

#include "drawn.hpp"
#include "engine/engine.hpp"
#include "oracle/of_scene.hpp"
#include "render/view.hpp"
#include "scene/scene.hpp"

namespace glassbox::fuzz {

using test::to_oracle;

/// A random scene as the program reads it, and the truth about it.
class Trial {
public:
    /// Throws glassbox::Error if the program refuses the scene.
    explicit Trial(Drawn drawn);

    const Drawn& drawn() const { return drawn_; }
    const Scene& scene() const { return scene_; }
    const View& view() const { return view_; }
    const oracle::Oracle& oracle() const { return oracle_; }
    const std::shared_ptr<const engine::Engine>& engine() const { return engine_; }

    std::size_t pixels() const { return pixel_rays_.size(); }
    int x(std::size_t pixel) const { return static_cast<int>(pixel) % drawn_.width; }
    int y(std::size_t pixel) const { return static_cast<int>(pixel) / drawn_.width; }
    /// The rays of all pixels, row by row from the top, as the program's view has them: they are taken as given.
    const std::vector<Ray<double>>& pixel_rays() const { return pixel_rays_; }
    const std::vector<oracle::Answer>& pixel_answers() const { return pixel_answers_; }

    /// The scene's rays, then those of some pixels.
    const std::vector<Ray<double>>& rays() const { return rays_; }
    const std::vector<oracle::Answer>& answers() const { return answers_; }

private:
    Drawn drawn_;
    Scene scene_;
    View view_;
    oracle::Oracle oracle_;
    std::shared_ptr<const engine::Engine> engine_;
    std::vector<Ray<double>> pixel_rays_, rays_;
    std::vector<oracle::Answer> pixel_answers_, answers_;
};

}  // namespace glassbox::fuzz
