// Not compiled: what arrows_test.sh expects arrows.sh to find.
#pragma once
#include <vector>  // wrong
