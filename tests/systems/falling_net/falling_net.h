#pragma once
// A second kind of capture system, to prove that the seams hold: a square net between four corner masses that falls on
// the target. Nothing else in the program knows it.

namespace netpocket {

// Makes `system = "falling_net"` known. To be called once, before the first scenario is read.
void register_falling_net();

}  // namespace netpocket
