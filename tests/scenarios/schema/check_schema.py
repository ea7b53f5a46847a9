"""Each shipped scenario satisfies the schema; each planted fault that a schema can see is refused by it."""

import copy
import json
import pathlib
import sys

import jsonschema


def steps_of(pointer):
    return [part.replace("~1", "/").replace("~0", "~") for part in pointer.split("/")[1:]]


def parent_of(document, pointer):
    parts = steps_of(pointer)
    for part in parts[:-1]:
        document = document[int(part)] if isinstance(document, list) else document[part]
    last = parts[-1]
    return document, int(last) if isinstance(document, list) else last


def patched(document, patch):
    document = copy.deepcopy(document)
    for operation in patch:
        parent, key = parent_of(document, operation["path"])
        if operation["op"] == "remove":
            del parent[key]
            continue
        if operation["op"] == "copy":
            source, source_key = parent_of(document, operation["from"])
            value = copy.deepcopy(source[source_key])
        else:
            value = operation["value"]
        if isinstance(parent, list) and operation["op"] != "replace":
            parent.insert(key, value)
        else:
            parent[key] = value
    return document


def main(scenarios, faults_file):
    schema = json.loads((scenarios / "schema" / "scenario.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    wrong = []
    shipped = sorted(scenarios.glob("*.json"))
    for file in shipped:
        for error in validator.iter_errors(json.loads(file.read_text())):
            wrong.append(f"{file.name}: {error.json_path}: {error.message}")
    faults = json.loads(faults_file.read_text())
    for fault in faults:
        whole = json.loads((scenarios / f"{fault.get('of', 'silver')}.json").read_text())
        is_refused = not validator.is_valid(patched(whole, fault["patch"]))
        if is_refused != fault["schema"]:
            wrong.append(f"planted fault '{fault['name']}': refused by the schema: {is_refused}")
    print("\n".join(wrong) or f"{len(shipped)} scenarios and {len(faults)} planted faults as told")
    return 1 if wrong or not shipped else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
