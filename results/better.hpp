// Which way a quantity is better.
#pragma once

namespace poissonlab {

enum class Better
{
    higher,
    lower,
    neither,
};

}
