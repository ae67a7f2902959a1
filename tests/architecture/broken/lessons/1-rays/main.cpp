// Not compiled: what arrows_test.sh expects arrows.sh to find.
#include <ray.hpp>
#include <sphere.hpp>  // wrong
#include "../picture.hpp"
