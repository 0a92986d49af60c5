"""Follows every link of a built site: check_links.py SITE. Prints those that lead nowhere, or that load from the net."""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADED = {("img", "src"), ("script", "src"), ("link", "href"), ("source", "src"), ("iframe", "src")}


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.places = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key == "id" or (tag == "a" and key == "name"):
                self.places.add(value)
            if key in ("href", "src") and value:
                self.links.append((tag, key, value))


def main():
    root = Path(sys.argv[1]).resolve()
    pages = {path.resolve(): Page(path) for path in root.rglob("*.html") if path.name != "404.html"}
    wrong, followed = [], 0
    for path, page in pages.items():
        for tag, key, link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                if (tag, key) in LOADED and parts.scheme != "data":
                    wrong.append(f"{path.relative_to(root)} loads {link}")
                continue
            followed += 1
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file():
                wrong.append(f"{path.relative_to(root)}: {link} leads nowhere")
            elif parts.fragment and target in pages and not parts.fragment.startswith("__") \
                    and unquote(parts.fragment) not in pages[target].places:
                wrong.append(f"{path.relative_to(root)}: {link} has no such place")
    print("\n".join(wrong))
    print(f"{followed} links of {len(pages)} pages")
    return 1 if wrong or followed < 1000 else 0


sys.exit(main())
