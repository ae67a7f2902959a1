// Not compiled: what arrows_test.sh expects arrows.sh to find.
#pragma once
#include <cmath>

#include <fmt/format.h>    // wrong
#include <math.h>          // wrong
#include <sphere.hpp>      // wrong
#include "render/job.hpp"  // wrong
