// Not compiled: what edge_test.sh expects edge.sh to find.
#pragma once
#include <string>

#include "scene/error.hpp"
