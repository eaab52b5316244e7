// SPDX-License-Identifier: GPL-3.0-or-later
// g++ adapter.cpp -o student && pixelplumb-cli try ./student --input lines --scene SCENE
// Reads the scene, draws with drawTriangle of scanconverter.h, prints the picture (PPM).
#include "scanconverter.h" // drawTriangle(Frame &, Vertex, Vertex, Vertex); y grows upward

#include <iostream>
#include <string>

int main()
{
    int width = 0, height = 0;
    Frame frame; // frame[y][x] is a Pixel {r, g, b}; a Vertex is {x, y, r, g, b}
    Pixel background;
    for (std::string word; std::cin >> word;) {
        const auto read = [](auto &...numbers) { (std::cin >> ... >> numbers); };
        Vertex a, b, c;
        if (word == "frame")
            read(width, height);
        else if (word == "background")
            read(background.r, background.g, background.b);
        else if (word == "triangle") {
            frame.resize(height, std::vector<Pixel>(width, background));
            for (Vertex *v : {&a, &b, &c})
                read(v->x, v->y, v->r, v->g, v->b);
            drawTriangle(frame, a, b, c);
        }
    }
    std::cout << "P3 " << width << ' ' << height << " 255\n";
    for (int y = height - 1; y >= 0; --y) // the top row first
        for (const Pixel &pixel : frame[y])
            std::cout << pixel.r << ' ' << pixel.g << ' ' << pixel.b << '\n';
}
