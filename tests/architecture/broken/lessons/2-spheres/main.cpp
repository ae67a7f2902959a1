// Not compiled: what arrows_test.sh expects arrows.sh to find.
#include "../1-rays/main.cpp"  // wrong
#include <iostream>
#include <picture.hpp>
#include <ray.hpp>
#include <sphere.hpp>
#include "render/image.hpp"  // wrong
