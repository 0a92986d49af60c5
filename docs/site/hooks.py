"""What mkdocs calls while it builds the site: pages that are found by patterns, and search without a server."""

import json
from pathlib import Path


def on_config(config):
    """Lets the navigation name pages by patterns, so that a new method has its page without being listed."""
    config["nav"] = _expanded(config["nav"], Path(config["docs_dir"]))
    return config


def _expanded(entries, folder):
    result = []
    for entry in entries:
        if isinstance(entry, dict):
            result.append({title: _expanded(value, folder) if isinstance(value, list) else value
                           for title, value in entry.items()})
        elif "*" in entry:
            result.extend(sorted(str(page.relative_to(folder)) for page in folder.glob(entry)))
        else:
            result.append(entry)
    return result


def on_post_build(config):
    """Writes the index as a script. From the disk, browsers load neither JSON nor workers, but scripts they do: the
    index becomes a value, and the worker is made of its own text."""
    site = Path(config["site_dir"])
    index = (site / "search" / "search_index.json").read_text(encoding="utf-8")
    (worker,) = (site / "assets" / "javascripts" / "workers").glob("search.*.min.js")
    source = json.dumps(worker.read_text(encoding="utf-8").split("\n//# sourceMappingURL")[0])
    script = (f"var __search = {{index: Promise.resolve({index})}};\n"
              f'if (location.protocol === "file:")\n'
              f'  __search.worker = URL.createObjectURL(new Blob([{source}], {{type: "text/javascript"}}));\n')
    (site / "search" / "search_index.js").write_text(script, encoding="utf-8")
