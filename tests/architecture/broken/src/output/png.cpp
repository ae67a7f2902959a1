// Not compiled: what arrows_test.sh expects arrows.sh to find.
#include "output/png.hpp"
#include "cli/commands.hpp"  // wrong
#include "render/image.hpp"
