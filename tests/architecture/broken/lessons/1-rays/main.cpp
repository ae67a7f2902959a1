// Not compiled: what arrows_test.sh expects arrows.sh to find.
#include <picture.hpp>
#include <ray.hpp>
#include <sphere.hpp>  // wrong
