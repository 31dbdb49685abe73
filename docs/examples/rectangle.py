#!/usr/bin/env python3
# Prints poses once around a rectangle in a y-z plane. A study takes the file as kind = "csv".
centre, width, height, points = (45, 10, 30), 30, 20, 31  # [cm]
print("x_cm,y_cm,z_cm")  # without an orientation the tool points straight down
for k in range(points):
    way = 2 * (width + height) * k / (points - 1)
    y = min(way, width) - min(max(way - width - height, 0), width)
    z = min(max(way - width, 0), height) - max(way - 2 * width - height, 0)
    print(f"{centre[0]},{centre[1] + y - width / 2},{centre[2] + z - height / 2}")
