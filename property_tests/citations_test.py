"""Citations and docs/references.bib agree both ways: every [Key] cited is there, every key there is cited."""
import pathlib
import re
import sys

ENDINGS = {".cpp", ".hpp", ".md", ".py"}
FOLDERS = ["ref", "checker", "property_tests", "fuzz", "docs", "scripts"]
# A key is a name and a year, "[Cohen93]" or "[Cohen93, section 2.4]", or one of the works without a year.
CITATION = re.compile(r"\[([A-Z][A-Za-z]+\d{2}(?:\d{2})?|ITA)(?:, [^\]]*)?\](?!\()")
ENTRY = re.compile(r"^@\w+\{([^,]+),", re.MULTILINE)


def citations(root):
    found = {}
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in ENDINGS and path.name != pathlib.Path(__file__).name:
                # A citation may be broken over two comment lines.
                text = re.sub(r"\n\s*(?:///?|#)?\s*", " ", path.read_text())
                for key in CITATION.findall(text):
                    found.setdefault(key, path)
    return found


def main():
    root = pathlib.Path(sys.argv[1])
    entries = ENTRY.findall((root / "docs" / "references.bib").read_text())
    cited = citations(root)
    complaints = [f"{path}: [{key}] is not in docs/references.bib" for key, path in cited.items() if key not in entries]
    complaints += [f"docs/references.bib: {key} is cited nowhere" for key in entries if key not in cited]
    complaints += [f"docs/references.bib: {key} stands there twice" for key in set(entries) if entries.count(key) > 1]
    if len(cited) < 10:
        complaints.append(f"only {len(cited)} citations found: the pattern or the folders are wrong")
    print("\n".join(complaints + [f"{len(entries)} entries, {len(complaints)} complaints"]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
