"""Reads JUnit XML as continuous integration does: prints one line for each suite and each case, and checks the counts."""

import sys
import xml.etree.ElementTree as ElementTree

root = ElementTree.parse(sys.argv[1]).getroot()
assert root.tag == "testsuites", root.tag
for suite in root:
    cases = suite.findall("testcase")
    assert int(suite.get("tests")) == len(cases)
    print("suite", suite.get("name"), suite.get("file"))
    for kind in ["failure", "error", "skipped"]:
        attribute = {"failure": "failures", "error": "errors", "skipped": "skipped"}[kind]
        assert int(suite.get(attribute)) == sum(case.find(kind) is not None for case in cases), kind
    for case in cases:
        assert float(case.get("time")) >= 0
        outcome = case[0] if len(case) else None
        what = "passed" if outcome is None else f"{outcome.tag} {outcome.get('message')}"
        print("case", case.get("classname"), "|", case.get("name"), "|", what)
total = sum(int(suite.get("tests")) for suite in root)
assert int(root.get("tests")) == total
