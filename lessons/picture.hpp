#pragma once
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <not_written.hpp>

/// A picture as the lessons see it: column j counts to the right, row i upwards, from the bottom-left pixel's 0.
class Picture {
public:
    Picture(int w, int h) : width(w), height(h), bytes(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    /// Any three numbers will do as a colour, red, green, blue from 0 to 255.
    template <class Color>
    void paint(int j, int i, const Color& color) {
        const auto& [red, green, blue] = color;
        const auto pixel = static_cast<std::size_t>(height - 1 - i) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(j);  // a file begins with the top row
        bytes[3 * pixel] = byte(static_cast<double>(red));
        bytes[3 * pixel + 1] = byte(static_cast<double>(green));
        bytes[3 * pixel + 2] = byte(static_cast<double>(blue));
    }

    /// Paints a part of the picture, one step of a lesson: `color(j, i)` gives the colour of its column j and row i. As
    /// long as a function that it needs is not written yet, the part is striped, and the function is named.
    template <class Colors>
    void paint_part(int left, int bottom, int w, int h, const Colors& color) {
        try {
            for (int i = 0; i < h; ++i)
                for (int j = 0; j < w; ++j) paint(left + j, bottom + i, color(j, i));
        } catch (const glassbox::NotWritten& missing) {
            std::fprintf(stderr, "striped in the picture: %s\n", missing.what());
            const int dark[] = {34, 34, 34}, light[] = {51, 51, 51};
            for (int i = 0; i < h; ++i)
                for (int j = 0; j < w; ++j) paint(left + j, bottom + i, (i + j) / 8 % 2 == 0 ? dark : light);
        }
    }

    /// Writes the picture as a PPM file, whole or not at all, and returns the program's exit status.
    int write(const std::string& path) const {
        const std::string part = path + ".part";
        std::ofstream file(part, std::ios::binary);
        file << "P6\n" << width << ' ' << height << "\n255\n";
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        file.close();
        if (file && std::rename(part.c_str(), path.c_str()) == 0) return 0;
        std::remove(part.c_str());
        std::fprintf(stderr, "%s: error: cannot write the picture; does its folder exist?\n", path.c_str());
        return 1;
    }

private:
    /// Truncated; what is no number is 0. Beyond 255 it begins anew from 0, as bytes do: a wrong colour is to be seen.
    static char byte(double x) {
        if (!(std::abs(x) < 1e18)) return 0;
        return static_cast<char>(static_cast<unsigned char>(static_cast<long long>(x)));
    }

    int width, height;
    std::vector<char> bytes;
};
