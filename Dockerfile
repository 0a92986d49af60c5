# This builds the program and the Python package in a container of Debian 12, without a graphics card (OpenCL by PoCL):
#
#   docker build -t poissonlab .
#   docker run --rm -v "$PWD":/work -u "$(id -u):$(id -g)" poissonlab run configs/quick.toml --out out/quick
#
# A test compares these packages with the tables in ./lab.
FROM debian:12-slim AS build
RUN apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
    g++ cmake ninja-build ocl-icd-opencl-dev opencl-clhpp-headers pocl-opencl-icd librandom123-dev libtomlplusplus-dev \
    libcli11-dev libfmt-dev nlohmann-json3-dev libopenexr-dev libopenimageio-dev libmuparser-dev libopenblas-dev \
    libfftw3-dev libcairo2-dev pkg-config libxxhash-dev libtbb-dev libgmp-dev libcgal-dev libkainjow-mustache-dev \
    gnuplot-nox fonts-dejavu-core lib2geom-dev libexpat1-dev libproj-dev libgeos-dev libeigen3-dev libmaxflow-dev \
    libhdf5-dev dpkg-dev file pybind11-dev python3-dev python3-numpy
COPY . /source
WORKDIR /source
RUN cmake --preset release -DPOISSONLAB_PYTHON=ON && cmake --build --preset release && cd build/release && cpack

FROM debian:12-slim
COPY --from=build /source/build/release/poissonlab_*.deb /tmp/
RUN apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends /tmp/poissonlab_*.deb && \
    rm -rf /tmp/poissonlab_*.deb /var/lib/apt/lists/*
# Compiled kernels and built tile sets are kept here, for any user.
ENV XDG_CACHE_HOME=/tmp/cache POCL_CACHE_DIR=/tmp/pocl
WORKDIR /work
ENTRYPOINT ["poissonlab"]
