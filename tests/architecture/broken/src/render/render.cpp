// Not compiled: what arrows_test.sh expects arrows.sh to find.
#include <fmt/format.h>
#include <ray.hpp>
#include "cellar/wine.hpp"   // wrong
#include "cli/commands.hpp"  // wrong
#include "numerics/magnitude.hpp"
#include "output/png.hpp"  // wrong
#include "scene/scene.hpp"
