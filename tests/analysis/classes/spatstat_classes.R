# Writes spatstat_classes.hpp: what spatstat (3.0, of Debian 12: apt-get install r-cran-spatstat) measures of a small set
# of points of three classes in a rectangle and in a polygon with a hole. Run in this folder: Rscript spatstat_classes.R
suppressMessages(library(spatstat.explore))
options(digits = 17)

set.seed(11)
polygon <- owin(poly = list(list(x = c(0, 60, 64, 40, 44, 8), y = c(0, 4, 40, 30, 52, 44)),
                            list(x = c(20, 18, 30, 34), y = c(14, 24, 27, 12))), check = FALSE)
# Points of each class keep some distance from each other. Those of the last one gather around those of the first.
least <- c(4, 2, 1)
wanted <- c(30, 60, 90)
points <- matrix(0, 0, 3)
for (class in 1:3) while (sum(points[, 3] == class) < wanted[class]) {
  p <- c(runif(1, 0, 64), runif(1, 0, 52))
  if (class == 3 && runif(1) < 0.7) p <- points[sample(30, 1), 1:2] + runif(2, -3, 3)
  p <- round(p, 3)
  own <- points[points[, 3] == class, 1:2, drop = FALSE]
  if (!inside.owin(p[1], p[2], polygon)) next
  if (nrow(own) > 0 && min(rowSums(sweep(own, 2, p)^2)) < least[class]^2) next
  points <- rbind(points, c(p, class))
}
windows <- list(rectangle = owin(c(-1, 66), c(-2, 55)), polygon = polygon)
reach <- 10
count <- 20
r <- reach / count * (1:count)
fine <- seq(0, reach, length.out = count * 128 + 1)
at <- (1:count) * 128 + 1

numbers <- function(values) paste(format(values, digits = 17, trim = TRUE), collapse = ", ")
out <- c("// Numbers of spatstat for a small set of points of three classes, written by spatstat_classes.R.",
         "#pragma once", "", "#include <cstdint>", "#include <vector>", "", "namespace poissonlab::test {", "",
         "/// Functions at reach / count, 2 reach / count, ... of the region's units. Pairs of classes are 0 0, 0 1, 1 1, 0 2,",
         "/// 1 2 and 2 2.",
         "struct SpatstatClassNumbers", "{",
         "    std::vector<std::vector<double>> g;       ///< sums over pairs by edge.Trans(exact = TRUE)",
         "    std::vector<std::vector<double>> pcf;     ///< pcf(), pcfcross(): on a grid",
         "    std::vector<std::vector<double>> nearest; ///< of each class, mean of nncross() from 0, 1 and 2",
         "    std::vector<double> marks;                ///< sums over pairs by edge.Trans(exact = TRUE)",
         "    std::vector<double> markcorr;             ///< markcorr(method = \"density\"): pairs count the same",
         "};", "",
         "inline const std::vector<double> spatstat_classed_points{",
         paste0("    ", numbers(as.vector(t(points[, 1:2])))), "};",
         "inline const std::vector<std::uint8_t> spatstat_classes{",
         paste0("    ", numbers(points[, 3] - 1)), "};", "")

for (name in names(windows)) {
  W <- windows[[name]]
  class <- points[, 3]
  X <- ppp(points[, 1], points[, 2], window = W, marks = factor(class), check = FALSE)
  A <- area(W)
  n <- npoints(X)
  half <- 0.15 / sqrt(n / A)
  d <- pairdist(X)
  weight <- edge.Trans(unmark(X), exact = TRUE) # A / area that is left
  diag(weight) <- 0
  diag(d) <- 1
  # The sums over pairs of points i of one class and j of another, each divided by its distance.
  sums <- function(i, j) sapply(r, function(s)
    sum((weight * 0.75 / half * pmax(0, 1 - ((s - d) / half)^2) / d)[class == i, class == j]))
  pairs <- list(c(1, 1), c(1, 2), c(2, 2), c(1, 3), c(2, 3), c(3, 3))
  g <- lapply(pairs, function(p) {
    ordered <- wanted[p[1]] * (wanted[p[2]] - (p[1] == p[2]))
    sums(p[1], p[2]) * A / (2 * pi * ordered)
  })
  pcf_of <- lapply(pairs, function(p) {
    common <- list(r = fine, correction = "translate", divisor = "d", kernel = "epanechnikov", bw = half / sqrt(5))
    if (p[1] == p[2]) do.call(pcf, c(list(unmark(X[marks(X) == p[1]])), common))$trans[at]
    else do.call(pcfcross, c(list(X, p[1], p[2]), common))$trans[at]
  })
  nearest <- lapply(1:3, function(i) sapply(1:3, function(j) {
    from <- unmark(X[marks(X) == i])
    mean(if (i == j) nndist(from) else nncross(from, unmark(X[marks(X) == j]), what = "dist"))
  }))
  same <- sums(1, 1) + sums(2, 2) + sums(3, 3)
  all <- Reduce(`+`, lapply(1:3, function(i) Reduce(`+`, lapply(1:3, function(j) sums(i, j)))))
  chance <- sum(wanted * (wanted - 1)) / (n * (n - 1))
  by_markcorr <- markcorr(X, f = function(m1, m2) m1 == m2, r = fine, correction = "translate", method = "density",
                          kernel = "epanechnikov", bw = half / sqrt(5))$trans[at]
  # markcorr() divides by the share of pairs of one class among all pairs, of points with themselves as well.
  marks <- by_markcorr * sum((wanted / n)^2) / chance
  rows <- function(lists) paste0("{", paste0("{", sapply(lists, numbers), "}", collapse = ",\n     "), "}")
  out <- c(out, sprintf("inline const SpatstatClassNumbers spatstat_classes_in_%s{", name),
           paste0("    ", rows(g), ","), paste0("    ", rows(pcf_of), ","), paste0("    ", rows(nearest), ","),
           paste0("    {", numbers(same / all / chance), "},"), paste0("    {", numbers(marks), "}};"), "")
}
out <- c(out, "}")
writeLines(out, "spatstat_classes.hpp")
