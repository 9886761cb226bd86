/// What all adapters have in common: they read instances and write claims, once or in a loop.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "flatdt/ref/instance.hpp"

namespace flatdt::adapters {

/// The instance is outside of what the peer can do.
class Unsupported : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes the text of the output file. Errors: Unsupported.
using Answer = std::function<std::string(const ref::Instance&)>;

/// ADAPTER ... INSTANCE OUTPUT   answers one instance: exit code 0, 4 if it is not supported, 2, 3 as all
/// programs; ADAPTER ... --loop            answers the instances on standard input (docs/campaigns.md,
/// "Persistent mode"). `files`: the arguments that are left when the adapter's own are taken out.
int run_adapter(const std::string& name, const std::vector<std::string>& files, const Answer& answer);

}  // namespace flatdt::adapters
