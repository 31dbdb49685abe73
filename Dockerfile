# ikbench in a container: docker build -t ikbench . && docker run --rm -v "$PWD:/work" ikbench run my.toml
FROM debian:12 AS build
COPY . /source
RUN apt-get update -qq && /source/setup --with-package release package

FROM debian:12-slim
COPY --from=build /source/build/release/ikbench_*.deb /tmp/ikbench.deb
RUN apt-get update -qq && apt-get install -y -qq /tmp/ikbench.deb python3 && rm -rf /var/lib/apt/lists /tmp/ikbench.deb
WORKDIR /work
ENTRYPOINT ["ikbench"]
