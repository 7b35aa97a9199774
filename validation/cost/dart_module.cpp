/// Loads the module dart_engine.cpp at run time.

#include <dlfcn.h>

#include "validation/cost/peers.hpp"

namespace trivium::cost {

namespace {

using Make = Engine* (*)(const PeerScene&);

Make load() {
  void* module = dlopen(TRIVIUM_COST_DART, RTLD_NOW | RTLD_LOCAL);
  void* make = module ? dlsym(module, "trivium_make_dart_engine") : nullptr;
  if (!make) throw std::runtime_error(dlerror());
  return reinterpret_cast<Make>(make);
}

}  // namespace

std::unique_ptr<Engine> dart_engine(const PeerScene& scene) {
  static const Make make = load();
  return std::unique_ptr<Engine>(make(scene));
}

}  // namespace trivium::cost
