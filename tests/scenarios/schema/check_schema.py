"""Each scenario satisfies the schema of its format; each planted fault that a schema can see is refused by it."""

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


def schema_of(folder, name):
    """A schema with what it names in the others of its folder."""
    schema = json.loads((folder / name).read_text())
    shared = json.loads((folder / "scenario.schema.json").read_text())["$defs"]
    own = set(schema["$defs"])
    text = json.dumps(schema).replace("scenario.schema.json#/", "#/")
    schema = json.loads(text)
    schema["$defs"] = {**shared, **schema["$defs"]}
    if name != "scenario.schema.json" and own & set(shared):
        raise SystemExit(f"{name}: defines {own & set(shared)} again")
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def findings(validator, files, faults):
    """What the schema refuses of the files, and the planted faults of which it is told otherwise."""
    for name, whole in files.items():
        for error in validator.iter_errors(whole):
            yield f"{name}: {error.json_path}: {error.message}"
    for fault in faults:
        whole = files[fault.get("of", next(iter(files)))]
        is_refused = not validator.is_valid(patched(whole, fault["patch"]))
        if is_refused != fault["schema"]:
            yield f"planted fault '{fault['name']}': refused by the schema: {is_refused}"


def read_all(files):
    return {file.stem: json.loads(file.read_text()) for file in files}


def main(scenarios, tests):
    shipped = read_all(sorted(scenarios.glob("*.json")))
    fixtures = read_all(sorted((tests / "format_1").glob("*.json")))
    by_format = {format: {name: whole for name, whole in files.items() if whole["format"] == format}
                 for format, files in ((1, fixtures), (2, shipped))}
    faults = {1: json.loads((tests / "planted_faults.json").read_text()),
              2: json.loads((tests / "format_2" / "planted_faults.json").read_text())}
    schemas = {1: "scenario.schema.json", 2: "scenario_2.schema.json"}
    wrong = []
    for format, name in schemas.items():
        validator = schema_of(scenarios / "schema", name)
        # The first of the files is the one that a fault is planted in where it names none.
        first = {1: "silver", 2: "chevron"}[format]
        files = {first: by_format[format].pop(first), **by_format[format]}
        wrong += findings(validator, files, faults[format])
    count = sum(len(each) for each in faults.values())
    print("\n".join(wrong) or f"{len(shipped)} scenarios, {len(fixtures)} fixtures and {count} planted faults as told")
    return 1 if wrong or not shipped else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
