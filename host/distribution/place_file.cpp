#include "host/distribution/place_file.hpp"

#include "base/points/point_file.hpp"
#include "base/programs/interrupt.hpp"

namespace poissonlab {

void write_places(const std::filesystem::path& file, const PixelPlaces& places, std::uint32_t longest,
                  const std::string& comment)
{
    write_points_in_pieces(file, 2, places.size() / 2, "domain 0:1\n" + comment, [&](const PointSink& sink) {
        std::vector<double> coordinates;
        for (std::size_t i = 0; i < places.size();) {
            stop_if_interrupted();
            coordinates.clear();
            for (; i < places.size() && coordinates.size() < 65'536; ++i)
                coordinates.push_back(place_coordinate(places[i], longest));
            sink(coordinates);
        }
    });
}

}
