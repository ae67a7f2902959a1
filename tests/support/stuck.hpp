#pragma once

namespace glassbox::test {

/// Ends this program after so many seconds, and says on standard error where each of its threads stands: a test that
/// hangs can be mended only by who knows that. Does nothing where the system is not Linux.
void tell_where_it_is_stuck_after(unsigned seconds);

}  // namespace glassbox::test
