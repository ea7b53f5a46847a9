#!/usr/bin/env python3
"""Groups of sources that are compiled as one, so that the headers they share are read once and not once a file.

    group_sources.py LINES ASKED CHOSEN

A line of the file ASKED is a target and one of its sources, with a tab between them; a line of CHOSEN besides the number of the
group that the source belongs to. What CHOSEN says from the last time is kept where it can be, so that a new name or a new line
moves few files. Files whose private names would meet stay apart: no name that one file declares for itself alone occurs in
another of its group, nor is declared by a header that only the other reads, so that each means the same as if it were compiled
alone. Private is what stands in an unnamed namespace, and each `static`, constant, `using` and alias of a source; the same
`using` may be said again. A group begins with at most LINES lines: a change compiles little anew.
"""
import collections
import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDED = re.compile(r'^\s*#\s*include "([^"]+)"', re.M)
TOKEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\''
    r'|\#[^\n]*(?:\\\n[^\n]*)*|(?P<word>[A-Za-z_]\w*)|\d[\w.\']*|::|->|(?P<mark2>\S)', re.S)
KINDS = ('struct', 'class', 'enum', 'union')
QUALIFIERS = ('const', 'noexcept', 'final', 'override')
OPENERS = ('(', '=', '{', '[', ',', ';', ':')
TEST_MACRO = re.compile(r'(TEST|TEST_F|TEST_P|RC_GTEST_\w+|INSTANTIATE_\w+|BENCHMARK\w*|static_assert|TYPED_TEST\w*)$')


def tokens_of(text):
    """Words and marks in order; comments, strings, numbers and lines of the preprocessor are left out."""
    found = []
    for match in TOKEN.finditer(text):
        token = match.group(0)
        if match.group('word') or match.group('mark2') or token in ('::', '->'):
            found.append(token)
        elif token[0] in '"R\'0123456789':
            found.append('0')
    return found


def used_words(tokens):
    """Words that a private name of another file could be taken for: no members, nothing that is qualified."""
    return {word for before, word in zip([''] + tokens, tokens) if word[0].isalpha() and before not in ('.', '->', '::')}


def without_template(statement):
    """A declaration behind its template's parameters."""
    depth = 0
    for place, token in enumerate(statement[1:], 1):
        depth += (token == '<') - (token == '>')
        if depth == 0:
            return statement[place + 1:] or statement if statement[0] == 'template' else statement
    return statement


def declared_names(statement):
    """Words that a declaration may be the one of: those before what opens its arguments, its value or its body."""
    if statement[0] in ('using', 'namespace'):
        return {statement[1] if '=' in statement else statement[-1]}
    kind = without_template(statement)
    if kind[0] in KINDS:
        # Of a type with bases its own name alone.
        return {next((token for token in kind[1:] if token[0].isalpha() and token not in KINDS), '')} - {''}
    names, depth = set(), 0
    for before, token, after in zip([''] + statement, statement, statement[1:] + [';']):
        if depth == 0 and token[0].isalpha() and before != '::' and (after in OPENERS or before in KINDS):
            names.add(token)
        depth += (token in ('(', '<', '[', '{')) - (token in (')', '>', ']', '}'))
    return names - set(KINDS + QUALIFIERS)


def statements_of(tokens):
    """Statements at the level of a namespace, each with whether that namespace is unnamed; bodies are left out."""
    named = []  # of each namespace that is open
    statement, body = [], 0
    for token in tokens:
        body += (token == '{') - (token == '}') if body else 0
        if body:
            continue
        if token == '{' and statement[:1] == ['namespace']:
            named.append(len(statement) > 1)
            statement = []
        elif token == '{':
            statement.append(token)
            body = 1
        elif token == '}' and statement[-1:] == ['{']:
            statement.append(token)
        elif token == '}':
            yield statement, not all(named)
            statement = []
            named.pop()
        elif token == ';' or (statement[-1:] == ['}'] and token not in (',', '=')):
            yield statement, not all(named)
            statement = [] if token == ';' else [token]
        else:
            statement.append(token)


def private_names(tokens):
    """Names that the file declares for itself alone; of a `using`, which may be said again, with what it says."""
    names = {}
    for statement, unnamed in statements_of(tokens):
        if not statement or TEST_MACRO.match(statement[0]):
            continue
        if unnamed or statement[0] in ('using', 'namespace', 'static', 'constexpr', 'const'):
            said = ' '.join(statement) if statement[0] in ('using', 'namespace') else None
            names.update(dict.fromkeys(declared_names(statement), said))
    return names


@functools.cache
def read_header(name):
    """Names that a header of ours declares, and the headers that it includes itself; of a generated one, nothing."""
    path = ROOT / name
    text = path.read_text() if path.is_file() else ''
    statements = [statement for statement, _ in statements_of(tokens_of(text)) if statement]
    return set().union(*map(declared_names, statements)), INCLUDED.findall(text)


def headers_read(text):
    """Headers that a file includes, and those that they include in their turn."""
    found, waiting = set(), INCLUDED.findall(text)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += read_header(name)[1]
    return found


class Source:
    def __init__(self, path):
        text = pathlib.Path(path).read_text()
        tokens = tokens_of(text)
        self.path = path
        self.lines = text.count('\n')
        self.private = private_names(tokens)
        self.used = used_words(tokens)
        self.headers = headers_read(text)
        self.opened = set(re.findall(r'using namespace [\w:]+', text))
        # The headers of X define macros of everyday words; who replaces `new` does it for the program, not for these lines.
        self.alone = bool(re.search(r'^\s*#\s*(define|undef|if|include <X11/)|^void\*? operator (new|delete)', text, re.M))

    def hides(self, other):
        """Whether a private name of this file could be taken for a name that the other, or a header of it, uses."""
        return any(name in other.used and (said is None or other.private.get(name) != said)
                   for name, said in self.private.items()) or any(
                       not read_header(name)[0].isdisjoint(self.private) for name in other.headers - self.headers)

    def meets(self, other):
        return self.opened != other.opened or self.hides(other) or other.hides(self)


@functools.cache
def source_at(path):
    return Source(path)


def has_room(group, source, lines):
    return not group or (sum(other.lines for other in group) + source.lines <= lines and not source.alone
                         and not any(other.alone or source.meets(other) for other in group))


def groups_of(sources, lines, before):
    """Sources by the number of their group: the one `before`, else the first with room, since neighbours read the same."""
    groups = {number: [] for number in before.values()}
    for source in sources:
        number = before.get(source.path)
        if number is None or not has_room(groups[number], source, 2 * lines):
            number = next((n for n, group in groups.items() if group and has_room(group, source, lines)),
                          max(groups, default=-1) + 1)
        groups.setdefault(number, []).append(source)
    return groups


def rows_of(file):
    return [line.split('\t') for line in file.read_text().splitlines()] if file.is_file() else []


def main():
    lines, asked, chosen = sys.argv[1:]
    paths, before = collections.defaultdict(list), collections.defaultdict(dict)
    for target, path in rows_of(pathlib.Path(asked)):
        paths[target].append(path)
    for target, path, number in rows_of(pathlib.Path(chosen)):
        before[target][path] = int(number)
    rows = [f'{target}\t{source.path}\t{number}\n' for target in paths
            for number, group in groups_of([source_at(path) for path in paths[target]], int(lines), before[target]).items()
            for source in group]
    pathlib.Path(chosen).write_text(''.join(rows))


if __name__ == '__main__':
    main()
