// Not compiled: what arrows_test.sh expects arrows.sh to find.
#pragma once
#include <sphere.hpp>
#include "ray.hpp"         // wrong
#include "render/job.hpp"  // wrong
#include "scene/error.hpp"
