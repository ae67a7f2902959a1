// Not compiled: what edge_test.sh expects edge.sh to find.
#pragma once
#include <thread>

#include "learn/subprocess/subprocess.hpp"
