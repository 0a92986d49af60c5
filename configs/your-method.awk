# N-rooks: one point in each of n rows and n columns. Written to the file `out`, a point a line.
BEGIN {
    srand(seed)
    for (i = 0; i < n; i++) row[i] = i
    for (i = n - 1; i > 0; i--) {
        j = int((i + 1) * rand()); kept = row[i]; row[i] = row[j]; row[j] = kept
    }
    for (i = 0; i < n; i++)
        printf "%.17g %.17g\n", (i + rand()) / n, (row[i] + rand()) / n > out
}
