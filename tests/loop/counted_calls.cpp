#include "tests/loop/counted_calls.h"

#include <dlfcn.h>
#include <pthread.h>

#include <cstdlib>
#include <new>

namespace {

thread_local bool countsHere = false;
thread_local arris::test::Calls callsHere;

void* allocate(std::size_t size) {
  if (countsHere) {
    ++callsHere.allocations;
  }
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}

void release(void* memory) noexcept {
  if (countsHere && memory != nullptr) {
    ++callsHere.frees;
  }
  std::free(memory);
}

} // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}

void* operator new[](std::size_t size) {
  return allocate(size);
}

void operator delete(void* memory) noexcept {
  release(memory);
}

void operator delete[](void* memory) noexcept {
  release(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}

void operator delete[](void* memory, std::size_t) noexcept {
  release(memory);
}

extern "C" int pthread_mutex_lock(pthread_mutex_t* mutex) {
  using Lock = int (*)(pthread_mutex_t*);
  static const auto lock = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  if (countsHere) {
    ++callsHere.locks;
  }
  return lock(mutex);
}

namespace arris::test {

Counting::Counting() {
  callsHere = {};
  countsHere = true;
}

Counting::~Counting() {
  countsHere = false;
}

Calls Counting::calls() {
  return callsHere;
}

} // namespace arris::test
