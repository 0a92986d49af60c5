// Snapshots of simulations held against their headers. The files are written by h5py, as Gadget 2 to 4, SWIFT and Arepo
// lay them out; the right values are those that were written.
#include "tests/base/points/read_set.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Python's x: 729 points of a cube of side 9, in which y = 1.25 + (i // 9) % 9.
constexpr auto begin = R"(import h5py, numpy
i = numpy.arange(729)
x = numpy.stack([i % 9 + 0.5, i // 9 % 9 + 1.25 - 9 * (i // 9 % 9 == 8), i // 81 + 0.125], 1)
def snapshot(name, parts=None, box=9.0, **header):
    f = h5py.File(name, 'w')
    h = f.create_group('Header')
    for t, rows in (parts if parts is not None else {1: x}).items(): f['PartType%d/Coordinates' % t] = rows
    if box is not None: h.attrs['BoxSize'] = box
    for key, value in header.items(): h.attrs[key] = value
    return f
def counts(type, n, types=6, dtype='u4'):
    c = numpy.zeros(types, dtype); c[type] = n; return c
)";

class Snapshot : public testing::Test
{
protected:
    std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

    void write(const std::string& lines) const
    {
        folder_.write("script.py", begin + lines);
        const Outcome outcome = run_in_shell(folder_.path(), "/usr/bin/python3 script.py");
        ASSERT_EQ(outcome.status, 0) << outcome.error << " (package python3-h5py)";
    }

    /// Is the set x, in units of the box?
    void expect_x(const std::string& name, const PointReading& how = {}) const
    {
        const PointSet set = read_set(file(name), how).set;
        ASSERT_EQ(set.dimension, 3) << name;
        ASSERT_EQ(set.size(), 729u) << name;
        for (std::size_t i = 0; i < 729; ++i) {
            ASSERT_DOUBLE_EQ(set[i][0], (static_cast<double>(i % 9) + 0.5) / 9) << name << " " << i;
            ASSERT_DOUBLE_EQ(set[i][2], (static_cast<double>(i / 81) + 0.125) / 9) << name << " " << i;
        }
    }

    std::vector<std::string> told(const std::string& name) const { return read_set(file(name)).told; }

    std::string error(const std::string& name, PointReading how = {}) const
    {
        how.options.particles = "--particles {}";
        return message_of([&] { read_points(file(name), how); });
    }

    TemporaryFolder folder_;
};

TEST_F(Snapshot, MayHaveTheSideOfItsBoxInAnyShape)
{
    write(R"(
snapshot('scalar.hdf5')
snapshot('float.hdf5', box=numpy.float32(9))
snapshot('whole.hdf5', box=9)
snapshot('one.hdf5', box=numpy.array([9.0]))
snapshot('three.hdf5', box=numpy.array([9.0, 9.0, 9.0]))
snapshot('matrix.hdf5', box=numpy.array([[9.0], [9.0], [9.0]]))
f = snapshot('array.hdf5', box=None)
array = h5py.h5t.array_create(h5py.h5t.NATIVE_DOUBLE, (3,))
h5py.h5a.create(f['Header'].id, b'BoxSize', array, h5py.h5s.create(h5py.h5s.SCALAR)).write(numpy.full(3, 9.0), array)
f = snapshot('gadget4.hdf5', box=None)
p = f.create_group('Parameters'); p.attrs['BoxSize'] = 9.0; p.attrs['OutputDir'] = 'out'; p.attrs['Empty'] = h5py.Empty('f8')
f = snapshot('cosmology.hdf5', box=None); f.create_group('Cosmology').attrs['BoxSize'] = [9.0]
)");
    for (const std::string name :
         {"scalar", "float", "whole", "one", "three", "matrix", "array", "gadget4", "cosmology"}) {
        expect_x(name + ".hdf5");
        EXPECT_THAT(told(name + ".hdf5"), IsEmpty()) << name;
    }
}

TEST_F(Snapshot, IsAsGadgetAndSwiftWriteIt)
{
    write(R"(
snapshot('gadget2.hdf5', NumPart_ThisFile=counts(1, 729, dtype='i4'), NumPart_Total=counts(1, 729),
         NumPart_Total_HighWord=counts(1, 0), NumFilesPerSnapshot=1, Flag_DoublePrecision=1, Redshift=0.0,
         MassTable=numpy.ones(6))
snapshot('gadget4.hdf5', NumPart_ThisFile=counts(1, 729, 2, 'u8'), NumPart_Total=counts(1, 729, 2, 'u8'),
         NumFilesPerSnapshot=1, Git_commit='abc')
f = snapshot('glass.hdf5', {0: x}, box=numpy.array([9.0] * 3), NumPart_ThisFile=counts(0, 729, 7, 'i8'),
         NumPart_Total=counts(0, 729, 7), NumPart_Total_HighWord=counts(0, 0, 7), Dimension=numpy.array([3]),
         NumFilesPerSnapshot=numpy.array([1], 'i4'), Code='SWIFT', ThisFile=numpy.array([0]))
)");
    for (const std::string name : {"gadget2", "gadget4", "glass"}) expect_x(name + ".hdf5");
}

TEST_F(Snapshot, MustHaveASideThatIsOne)
{
    write(R"(
snapshot('text.hdf5', box='9.0')
snapshot('empty.hdf5', box=h5py.Empty('f8'))
snapshot('four.hdf5', box=[9.0] * 4)
snapshot('long.hdf5', box=[9.0, 9.0, 18.0])
snapshot('zero.hdf5', box=0.0)
snapshot('nan.hdf5', box=float('nan'))
snapshot('none.hdf5', {1: x / 9}, box=None)
snapshot('outside.hdf5', box=None)
f = h5py.File('domain.h5', 'w'); f['points'] = x / 9; f['points'].attrs['domain'] = [0.0, 0.5, 1.0]
)");
    EXPECT_THAT(error("text.hdf5"), HasSubstr("text.hdf5: the attribute Header/BoxSize is text: must hold numbers"));
    EXPECT_THAT(error("empty.hdf5"), HasSubstr("the attribute Header/BoxSize is empty: must hold numbers"));
    EXPECT_THAT(error("four.hdf5"), HasSubstr("the attribute Header/BoxSize is 9 x 9 x 9 x 9: must be one side"));
    EXPECT_THAT(error("long.hdf5"), HasSubstr("declares a domain whose sides differ"));
    PointDomain box;
    read_points_in_box(folder_.path() / "long.hdf5", {}, box);
    EXPECT_THAT(box.sides(), ElementsAre(9, 9, 18));
    EXPECT_THAT(error("zero.hdf5"), HasSubstr("the attribute Header/BoxSize is 0: must be above 0"));
    EXPECT_THAT(error("nan.hdf5"), HasSubstr("Header/BoxSize is nan"));
    EXPECT_THAT(told("none.hdf5"),
                ElementsAre("none.hdf5: the header has no BoxSize: the side of the box is taken as 1"));
    EXPECT_THAT(error("outside.hdf5"), HasSubstr("point 1: 1.25: must be a number in [0, 1)"));
    EXPECT_THAT(error("domain.h5"), HasSubstr("the attribute domain is 0, 0.5, 1: must be two numbers"));
    expect_x("text.hdf5", {.domain = CoordinateRange{0, 9}}); // what is asked for comes first
}

TEST_F(Snapshot, OfThePlaneHasASideAcrossThatDoesNotCount)
{
    write(R"(
flat = x[:81].copy(); flat[:, 2] = 0.5
snapshot('flat.hdf5', {0: flat}, box=[9.0, 9.0, 1.0])
across = flat[:, [2, 0, 1]]
snapshot('across.hdf5', {0: across}, box=[0.0, 9.0, 9.0])
snapshot('plane.hdf5', {0: flat[:, :2]}, box=[9.0, 9.0])
)");
    for (const std::string name : {"flat.hdf5", "across.hdf5", "plane.hdf5"}) {
        const PointSet set = read_set(file(name)).set;
        ASSERT_EQ(set.dimension, 2) << name;
        EXPECT_DOUBLE_EQ(set[80][0], 8.5 / 9);
        EXPECT_DOUBLE_EQ(set[80][1], 0.25 / 9);
    }
}

TEST_F(Snapshot, HasAsManyRowsAsItsHeaderSays)
{
    write(R"(
snapshot('few.hdf5', NumPart_Total=counts(1, 730))
snapshot('this.hdf5', NumPart_ThisFile=counts(1, 728), NumPart_Total=counts(1, 729))
snapshot('high.hdf5', NumPart_Total=counts(1, 729), NumPart_Total_HighWord=counts(1, 1))
snapshot('words.hdf5', NumPart_Total='729')
snapshot('half.hdf5', NumPart_Total=numpy.array([0, 1.5]))
snapshot('scalar.hdf5', NumPart_Total=729)
snapshot('files.hdf5', NumFilesPerSnapshot='two')
)");
    EXPECT_THAT(error("few.hdf5"), HasSubstr("PartType1/Coordinates has 729 rows, and Header/NumPart_Total says 730"));
    EXPECT_THAT(error("this.hdf5"), HasSubstr("has 729 rows, and Header/NumPart_ThisFile says 728"));
    EXPECT_THAT(error("high.hdf5"), HasSubstr("has 729 rows, and Header/NumPart_Total says 4294968025"));
    EXPECT_THAT(error("words.hdf5"), HasSubstr("the attribute Header/NumPart_Total is text: must hold numbers"));
    EXPECT_THAT(error("half.hdf5"), HasSubstr("the attribute Header/NumPart_Total has 1.5"));
    EXPECT_THAT(error("scalar.hdf5"), HasSubstr("the attribute Header/NumPart_Total is one number"));
    EXPECT_THAT(error("files.hdf5"), HasSubstr("the attribute Header/NumFilesPerSnapshot is text"));
}

TEST_F(Snapshot, IsReadFromAllOfItsFiles)
{
    write(R"(
for k, rows in enumerate([x[:300], x[300:300], x[300:]]):
    snapshot('s.%d.hdf5' % k, {1: rows}, NumPart_ThisFile=counts(1, len(rows)), NumPart_Total=counts(1, 729),
             NumFilesPerSnapshot=3)
    snapshot('t_%03d.hdf5' % k, {1: rows}, NumPart_Total=counts(1, 729), NumFilesPerSnapshot=3)
    snapshot('u.%03d.hdf5' % k, {1: rows} if len(rows) else {0: rows}, NumFilesPerSnapshot=3)
    snapshot('v.%d.hdf5' % k, {1: rows} if len(rows) else {}, NumFilesPerSnapshot=3)
)");
    for (const std::string name : {"s.0.hdf5", "s.1.hdf5", "s.2.hdf5", "u.000.hdf5", "u.001.hdf5", "v.1.hdf5"}) {
        expect_x(name);
        EXPECT_THAT(told(name), ElementsAre(name + ": is read with all 3 files of its snapshot"));
    }
    EXPECT_THAT(files_of_points(file("s.2.hdf5")), ElementsAre(file("s.0.hdf5"), file("s.1.hdf5"), file("s.2.hdf5")));
    EXPECT_THAT(error("t_001.hdf5"),
                HasSubstr("t_001.hdf5: is one of 3 files of a snapshot, and its name does not say which: must end in "
                          ".0.hdf5 to .2.hdf5"));
    std::vector<std::string> sentences;
    EXPECT_THAT(without_further_parts({file("s.2.hdf5"), file("u.001.hdf5"), file("s.0.hdf5")},
                                      [&](const std::string& sentence) { sentences.push_back(sentence); }),
                ElementsAre(file("s.2.hdf5"), file("u.001.hdf5")));
    ASSERT_EQ(sentences.size(), 1u);
    EXPECT_THAT(sentences[0], HasSubstr("s.0.hdf5: is read already, as part of the snapshot of "));
    std::filesystem::remove(file("s.1.hdf5"));
    EXPECT_THAT(error("s.0.hdf5"), HasSubstr("s.0.hdf5: is one of 3 files of a snapshot, and "));
    EXPECT_THAT(error("s.0.hdf5"), HasSubstr("s.1.hdf5 is missing"));
}

TEST_F(Snapshot, HasFilesThatBelongTogether)
{
    write(R"(
def parts(name, **second):
    both = dict(NumPart_Total=counts(1, 729), NumFilesPerSnapshot=2)
    snapshot(name + '.0.hdf5', {1: x[:365]}, **both)
    snapshot(name + '.1.hdf5', {1: x[365:]}, **{**both, **second})
parts('good')
parts('box', box=10.0)
parts('total', NumPart_Total=counts(1, 730))
parts('rows', NumPart_ThisFile=counts(1, 365))
parts('short')
with h5py.File('short.1.hdf5', 'a') as f: del f['PartType1']; f['PartType1/Coordinates'] = x[366:]
parts('cut')
open('cut.1.hdf5', 'r+b').truncate(2000)
)");
    expect_x("good.1.hdf5");
    EXPECT_THAT(error("box.0.hdf5"), HasSubstr("box.1.hdf5: is of another snapshot than "));
    EXPECT_THAT(error("box.0.hdf5"), HasSubstr("BoxSize differs"));
    EXPECT_THAT(error("total.0.hdf5"), HasSubstr("Header/NumPart_Total differs"));
    EXPECT_THAT(error("rows.0.hdf5"), HasSubstr("rows.1.hdf5: PartType1/Coordinates has 364 rows, and "
                                                "Header/NumPart_ThisFile says 365"));
    EXPECT_THAT(error("short.0.hdf5"), HasSubstr("has 728 rows in all files, and Header/NumPart_Total says 729"));
    EXPECT_THAT(error("cut.0.hdf5"), HasSubstr("cut.1.hdf5: cannot be read as HDF5: truncated file"));
}

TEST_F(Snapshot, OfAllFilesMayBePutTogether)
{
    write(R"(
for k, rows in enumerate([x[:300], x[300:]]):
    snapshot('s.%d.hdf5' % k, {1: rows}, NumPart_Total=counts(1, 729), NumFilesPerSnapshot=2)
layout = h5py.VirtualLayout((729, 3), 'f8')
layout[:300] = h5py.VirtualSource('s.0.hdf5', 'PartType1/Coordinates', (300, 3))
layout[300:] = h5py.VirtualSource('s.1.hdf5', 'PartType1/Coordinates', (429, 3))
with h5py.File('s.hdf5', 'w') as f:
    f.create_group('PartType1').create_virtual_dataset('Coordinates', layout)
    h = f.create_group('Header').attrs
    h['BoxSize'], h['NumPart_Total'], h['NumFilesPerSnapshot'], h['Virtual'] = 9.0, counts(1, 729), 2, 1
)");
    expect_x("s.hdf5");
    std::filesystem::remove(file("s.1.hdf5")); // HDF5 reads zeros
    EXPECT_THAT(error("s.hdf5"), HasSubstr("PartType1/Coordinates is in other files, and s.1.hdf5 is missing"));
}

TEST_F(Snapshot, HasOneTypeOfParticlesOrOneIsChosen)
{
    write(R"(
snapshot('gas.hdf5', {0: x, 1: x[:0]})
snapshot('both.hdf5', {0: x[:100], 1: x, 5: x[:3]}, NumPart_Total=[100, 729, 0, 0, 0, 3])
snapshot('left.hdf5', {1: x}, NumPart_Total=[100, 729, 0, 0, 0, 0])
snapshot('none.hdf5', {1: x[:0]})
h5py.File('points.h5', 'w')['points'] = x / 9
)");
    expect_x("gas.hdf5");
    EXPECT_THAT(error("both.hdf5"), HasSubstr("both.hdf5: has several types of particles, PartType0 (100), PartType1 "
                                              "(729), PartType5 (3): one must be chosen, as by --particles 0"));
    expect_x("both.hdf5", {.particles = 1});
    EXPECT_EQ(read_set(file("both.hdf5"), {.particles = 5}).set.size(), 3u);
    EXPECT_THAT(error("both.hdf5", {.particles = 4}),
                HasSubstr("has no particles of type 4; it has PartType0 (100), PartType1 (729), PartType5 (3)"));
    EXPECT_THAT(error("left.hdf5"), HasSubstr("PartType0 (0), PartType1 (729): one must be chosen"));
    EXPECT_THAT(error("left.hdf5", {.particles = 0}),
                HasSubstr("PartType0/Coordinates has 0 rows, and Header/NumPart_Total says 100"));
    expect_x("left.hdf5", {.particles = 1});
    EXPECT_THAT(error("none.hdf5"), HasSubstr("no points"));
    EXPECT_THAT(error("points.h5", {.particles = 1}), HasSubstr("has no types of particles, but the table /points"));
    folder_.write("points.txt", "0.5 0.5\n");
    EXPECT_THAT(error("points.txt", {.particles = 1}), HasSubstr("has no types of particles: --particles 1 is for"));
}

TEST_F(Snapshot, RoundsCoordinatesOfFloatsToItsBorder)
{
    write(R"(
y = x.astype('f4'); y[17, 1] = 9 - 1e-7; y[40, 0] = 9
snapshot('float.hdf5', {0: y}, box=[9.0] * 3)
y[3, 0] = 9.5
snapshot('outside.hdf5', {0: y}, box=[9.0] * 3)
)");
    const ReadSet read = read_set(file("float.hdf5"));
    EXPECT_EQ(read.set[17][1], 0);
    EXPECT_EQ(read.set[40][0], 0);
    EXPECT_THAT(read.told, ElementsAre("float.hdf5: 2 of 2187 coordinates lie on the end of [0, 9) by rounding: taken "
                                       "as 0, as on the torus"));
    EXPECT_THAT(error("outside.hdf5"), HasSubstr("point 4: 9.5: must be a number in [0, 9)"));
}

TEST_F(Snapshot, IsRefusedForItsOwnReason)
{
    write(R"(
snapshot('turned.hdf5', {1: x.T})
snapshot('flat.hdf5', {1: x[:, 0]})
snapshot('whole.hdf5', {1: x.astype('i4')})
f = snapshot('filter.hdf5', {0: x[:0]})
g = f.create_group('PartType1')
space = h5py.h5s.create_simple((729, 3))
how = h5py.h5p.create(h5py.h5p.DATASET_CREATE); how.set_chunk((729, 3)); how.set_filter(32001, h5py.h5z.FLAG_OPTIONAL)
h5py.h5d.create(g.id, b'Coordinates', h5py.h5t.NATIVE_DOUBLE, space, how)
snapshot('short.hdf5').close(); open('short.hdf5', 'r+b').truncate(5000)
open('head.hdf5', 'wb').write(b'\x89HDF\r\n\x1a\n' + b'garbage')
snapshot('gzip.hdf5', {}).create_dataset('PartType1/Coordinates', data=x, compression='gzip', shuffle=True)
)");
    EXPECT_THAT(error("turned.hdf5"), HasSubstr("PartType1/Coordinates is 3 x 729: points must be N x 2 or N x 3"));
    EXPECT_THAT(error("flat.hdf5"), HasSubstr("PartType1/Coordinates is 729: points must be"));
    EXPECT_THAT(error("whole.hdf5"), HasSubstr("PartType1/Coordinates: points must be floating-point numbers"));
    EXPECT_THAT(error("filter.hdf5"), HasSubstr("is compressed by the filter 32001"));
    EXPECT_THAT(error("short.hdf5"), HasSubstr("short.hdf5: cannot be read as HDF5: truncated file"));
    EXPECT_THAT(error("head.hdf5"), HasSubstr("head.hdf5: cannot be read as HDF5: "));
    expect_x("gzip.hdf5");
    for (const std::string name : {"turned", "flat", "whole", "filter", "short", "head"})
        EXPECT_THAT(error(name + ".hdf5"), Not(testing::AnyOf(HasSubstr("damaged"), HasSubstr("memory")))) << name;
}

}
}
