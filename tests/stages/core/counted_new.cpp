// The program's operator new, which counts. In a file of its own, because compilers know the standard one too well.
#include <cstdlib>
#include <new>

extern long allocations;
long allocations = 0;  // a global for once: nothing else sees every operator new of a program

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc{};
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
