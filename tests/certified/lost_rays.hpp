#pragma once

namespace glassbox::test {

/// How many of `count` rays that are aimed at an edge between two triangles meet neither, in float.
int lost_rays(int count);

}  // namespace glassbox::test
