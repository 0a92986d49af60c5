"""Makes types that help() shows in words, without quotes and without the insides of NumPy's own."""

import inspect


class Hint(str):
    """The text of a type."""

    def __repr__(self):
        return str(self)


#: The types of parameters of methods and of keys of kinds.
OF_KINDS = {"number": "float", "integer": "int", "boolean": "bool", "text": "str", "choice": "str", "own": "Any",
            "switch": "bool | str",
            "list": "Sequence[float]", "file": "str | os.PathLike[str]",
            "region": "str | os.PathLike[str] | dict[str, Any]",
            "paths": "str | os.PathLike[str] | Sequence[str | os.PathLike[str]]", "command": "str | Sequence[str]",
            "sampler": "Sampler | str | dict[str, Any]"}

#: All calls that make something have these arguments, with types and defaults.
COMMON = {"rng": ("int | numpy.random.Generator | None", None), "engine": ("str", "opencl"),
          "device": ("str | int | None", None)}


def keyword(name, hint, default):
    """Returns a keyword of a signature."""
    return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=Hint(hint))


def keyword_of(name, kind, default, is_required):
    """Returns the keyword of a described value, with its default where a value can say it."""
    hint = OF_KINDS[kind]
    if is_required:
        return keyword(name, hint, inspect.Parameter.empty)
    return keyword(name, hint if default is not None else hint + " | None", default)


def words_of(help_text):
    """Returns the help of a value in words of Python, because configs and commands call some things otherwise."""
    for of_configs, of_python in ((", in quotes", ""), (" in quotes", ""), ("true or false", "True or False"),
                                  ("default: true", "default: True"), ("default: false", "default: False"),
                                  ("analysis.points", "n")):
        help_text = help_text.replace(of_configs, of_python)
    return help_text


def show(values):
    """Lets signatures of functions and of members of classes show their types as text."""
    for value in values:
        if isinstance(value, property):
            value = value.fget
        if inspect.isclass(value) and value.__module__.startswith("poissonlab"):
            show(vars(value).values())
        elif inspect.isfunction(value):
            value.__annotations__ = {key: Hint(hint) for key, hint in value.__annotations__.items()}
