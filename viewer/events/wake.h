// Work that is done in the background ends while the interface sleeps: this wakes it.
#pragma once

namespace sectile::viewer {

/// Ends the sleep of whoever waits for events; from any thread. Does nothing without a window.
void wake();

/// What wake() calls from now on; null: nothing. Returns when no call of the one before runs any
/// more.
void set_wake(void (*function)());

}  // namespace sectile::viewer
