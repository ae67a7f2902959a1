// Not compiled: what edge_test.sh expects edge.sh to find.
#include <vector>

#include "viewer/model/work.hpp"
#include "viewer/ui/shelf/shelf.hpp"
