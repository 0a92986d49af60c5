# Writes spatstat_numbers.hpp: what spatstat (3.0, of Debian 12: r-cran-spatstat) and survival measure of a small set of
# points in a rectangle and in a polygon with a hole. Run in this folder: Rscript spatstat_numbers.R
suppressMessages({library(spatstat); library(survival)})
options(digits = 17)

set.seed(4)
outer <- list(x = c(0, 60, 64, 40, 44, 8), y = c(0, 4, 40, 30, 52, 44))
hole <- list(x = c(20, 18, 30, 34), y = c(14, 24, 27, 12))
polygon <- owin(poly = list(outer, hole), check = FALSE)
# Points that keep some distance from each other, in the polygon; as many decimals as a file would have.
points <- matrix(0, 0, 2)
while (nrow(points) < 150) {
  p <- round(c(runif(1, 0, 64), runif(1, 0, 52)), 3)
  if (!inside.owin(p[1], p[2], polygon)) next
  if (nrow(points) > 0 && min(rowSums(sweep(points, 2, p)^2)) < 1.2^2) next
  points <- rbind(points, p)
}
windows <- list(rectangle = owin(c(-1, 66), c(-2, 55)), polygon = polygon)
reach <- 10
count <- 20
r <- reach / count * (1:count)
fine <- seq(0, reach, length.out = count * 128 + 1)
at <- (1:count) * 128 + 1

numbers <- function(values) paste(format(values, digits = 17, trim = TRUE), collapse = ", ")
km <- function(lengths, seen) {
  fit <- survfit(Surv(pmin(lengths, seen), lengths <= seen) ~ 1)
  1 - summary(fit, times = r, extend = TRUE)$surv
}

# The Kronecker sequence of region_distances.cpp in the window's box.
places <- function(W, n) {
  i <- 0:(n - 1)
  g <- (i * 0.6180339887498949) %% 1
  x <- W$xrange[1] + (i + 0.5) / n * diff(W$xrange)
  y <- W$yrange[1] + g * diff(W$yrange)
  keep <- inside.owin(x, y, W)
  ppp(x[keep], y[keep], window = W, check = FALSE)
}

out <- c("// Numbers of spatstat and survival for a small set of points, written by spatstat_numbers.R.",
         "#pragma once", "", "#include \"base/regions/plane_region.hpp\"", "", "#include <vector>", "",
         "namespace poissonlab::test {", "",
         "/// Functions at reach / count, 2 reach / count, ...",
         "struct SpatstatNumbers", "{",
         "    std::vector<double> k_translation; ///< the sum over pairs with edge.Trans(exact = TRUE)",
         "    std::vector<double> k_isotropic;   ///< Kest(correction = \"isotropic\")",
         "    std::vector<double> g;             ///< the sum over pairs with Epanechnikov's kernel, divisor d",
         "    std::vector<double> pcf;           ///< pcf(divisor = \"d\"), whose density() is on a grid",
         "    std::vector<double> nearest;       ///< survfit() of nndist() and bdist.points()",
         "    std::vector<double> gest;          ///< Gest(correction = \"km\"), in bins",
         "    std::vector<double> empty_space;   ///< survfit() of nncross() and bdist.points() of the places of F",
         "    std::vector<double> fest;          ///< Fest(correction = \"km\"), of pixels",
         "};", "",
         "inline const std::vector<double> spatstat_points{",
         paste0("    ", numbers(as.vector(t(points)))), "};",
         sprintf("inline constexpr double spatstat_reach = %g;", reach),
         sprintf("inline constexpr std::size_t spatstat_count = %d;", count),
         "inline constexpr std::size_t spatstat_places = 5000; ///< in the box, of the Kronecker sequence",
         "inline const PlaneRegion spatstat_polygon{{{{{0, 0}, {60, 4}, {64, 40}, {40, 30}, {44, 52}, {8, 44}},",
         "                                           {{{20, 14}, {18, 24}, {30, 27}, {34, 12}}}}}};",
         "inline const PlaneRegion spatstat_rectangle{{{{{-1, -2}, {66, -2}, {66, 55}, {-1, 55}}}}};", "")

for (name in names(windows)) {
  W <- windows[[name]]
  X <- ppp(points[, 1], points[, 2], window = W, check = FALSE)
  n <- npoints(X)
  A <- area(W)
  d <- pairdist(X)
  weight <- edge.Trans(X, exact = TRUE) # A / area that is left
  diag(weight) <- 0
  k <- sapply(r, function(s) sum(weight[d <= s]) * A / (n * (n - 1)))
  half <- 0.15 / sqrt(n / A)
  g <- sapply(r, function(s) {
    kernel <- 0.75 / half * pmax(0, 1 - ((s - d) / half)^2)
    diag(d) <- 1
    sum(weight * kernel / d) * A / (2 * pi * n * (n - 1))
  })
  iso <- Kest(X, r = fine, correction = "isotropic")$iso[at]
  pcf <- pcf(X, r = fine, correction = "translate", divisor = "d", kernel = "epanechnikov", bw = half / sqrt(5))$trans[at]
  P <- places(W, 5000)
  seen <- bdist.points(P)
  nearest <- km(nndist(X), bdist.points(X))
  gest <- Gest(X, r = fine, correction = "km")$km[at]
  empty <- km(nncross(P, X, what = "dist"), seen)
  fest <- Fest(X, r = fine, correction = "km", eps = 0.02)$km[at]
  out <- c(out, sprintf("inline const SpatstatNumbers spatstat_in_%s{", name),
           paste0("    {", sapply(list(k, iso, g, pcf, nearest, gest, empty, fest), numbers), "},"), "};", "")
}
out <- c(out, "}")
writeLines(out, "spatstat_numbers.hpp")
