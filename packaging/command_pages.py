#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Writes manual pages and completions of shells from what programs say of their own options.

usage: command_pages.py --output FOLDER [--sea-file GUIDE] PROGRAM...

Runs each PROGRAM with --describe. FOLDER/PROGRAM/ is then laid out like a prefix: compressed pages
in share/man/man1, one for each command, and completions of bash, zsh and fish where these look for
them. GUIDE, the Markdown page of the sea file, becomes share/man/man5/ocean-sea.5.gz. The same
programs give the same bytes.
"""

from __future__ import annotations

import argparse
import gzip
import json
import re
import subprocess
from pathlib import Path

HELP = {
    "names": ["-h", "--help"],
    "type": "",
    "help": "Print this help message and exit",
    "required": False,
    "takes": "nothing",
    "repeats": False,
    "words": [],
    "excludes": "",
}
VERSION = HELP | {
    "names": ["--version"],
    "help": "Print the versions of this program and of its libraries",
}


def described(program: Path) -> dict:
    done = subprocess.run([program, "--describe"], check=True, stdout=subprocess.PIPE)
    return json.loads(done.stdout)


def all_options(command: dict) -> list[dict]:
    return [option for group in command["groups"] for option in group["options"]]


def is_positional(option: dict) -> bool:
    return not option["names"][0].startswith("-")


def named_options(command: dict, is_program: bool) -> list[dict]:
    """Returns the options that have a name, with those that every command or program has."""
    own = [option for option in all_options(command) if not is_positional(option)]
    return [HELP, *([VERSION] if is_program else []), *own]


def takes_file(option: dict) -> bool:
    """Tells an option whose value is a path by its placeholder: FILE, FRAME.exr, [SCRIPT]."""
    return any(word in option["type"] for word in ("FILE", "FOLDER", "DIR", "SCRIPT", ".", "PATH"))


class Program:
    """A program by its description: the command of the program itself, and its other commands."""

    def __init__(self, description: dict):
        self.version = description["version"].split("\n")[0].split()[-1]
        self.main, *self.commands = description["commands"]
        self.name = self.main["name"]

    def first_words(self) -> list[dict]:
        return [command for command in self.commands if " " not in command["name"]]

    def second_words(self, first: str) -> list[dict]:
        return [command for command in self.commands if command["name"].startswith(first + " ")]

    def usage(self, command: dict) -> str:
        """Returns "ocean terrain import"; the program's own name for its main command."""
        return self.name if command is self.main else f"{self.name} {command['name']}"


# Manual pages.


def roff(text: str) -> str:
    """Returns the text as roff shows it unchanged: with plain hyphens and no requests."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("`", "\\(ga")
    return "\n".join("\\&" + line if line[:1] in {".", "'"} else line for line in text.split("\n"))


def roff_option(option: dict) -> str:
    names = ", ".join(f"\\fB{roff(name)}\\fR" for name in option["names"])
    value = f" \\fI{roff(option['type'])}\\fR" if option["type"] else ""
    text = option["help"]
    if option["excludes"]:
        text += f"; not with {option['excludes']}"
    if option["required"] and not is_positional(option):
        text += " (required)"
    repeats = " ..." if option["repeats"] else ""
    return f".TP\n{names}{value}{repeats}\n{roff(text)}\n"


def roff_rows(rows: list[tuple[str, str]]) -> str:
    return "".join(f".TP\n\\fB{roff(name)}\\fR\n{roff(text)}\n" for name, text in rows)


def manual_page(program: Program, command: dict) -> str:
    is_program = command is program.main
    usage = program.usage(command)
    page = usage.replace(" ", "-")
    below = program.first_words() if is_program else program.second_words(command["name"])
    arguments = [option for option in all_options(command) if is_positional(option)]
    synopsis = [f"\\fB{roff(usage)}\\fR [\\fIOPTIONS\\fR]"]
    if command["runs"]:
        for option in arguments:
            name = f"\\fI{roff(option['names'][0])}\\fR"
            synopsis[0] += f" {name}" if option["required"] else f" [{name}]"
    if below:
        with_command = f"\\fB{roff(usage)}\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]"
        synopsis = [*synopsis, with_command] if command["runs"] else [with_command]
    summary = command["summary"].rstrip(".")
    text = (
        f'.TH {roff(page.upper())} 1 "" "libocean {program.version}" "libocean"\n'
        f".SH NAME\n{roff(page)} \\- {roff(summary)}\n"
        ".SH SYNOPSIS\n" + "\n.br\n".join(synopsis) + "\n"
    )
    if arguments:
        text += ".SH ARGUMENTS\n" + "".join(map(roff_option, arguments))
    text += ".SH OPTIONS\n"
    text += "".join(map(roff_option, [HELP, VERSION] if is_program else [HELP]))
    sections = {"": ""}  # groups of one name are one section; options without a group come first
    for group in command["groups"]:
        rows = [option for option in group["options"] if not is_positional(option)]
        if rows:
            name = group["name"]
            sections[name] = sections.get(name, "") + "".join(map(roff_option, rows))
    for name, rows in sections.items():
        text += f".SS {roff(name)}\n{rows}" if name else rows
    if command["pages"]:
        title = command["pages_title"].partition(" (")[0]
        rows = [(page["names"][0], page["summary"].strip()) for page in command["pages"]]
        text += f".SH {roff(title.upper())}\n" + roff_rows(rows)
        text += f".PP\n\\fB{roff(usage)} \\-\\-help\\fR \\fINAME\\fR has all about one.\n"
    if below:
        rows = [(other["name"], other["summary"]) for other in below]
        text += ".SH COMMANDS\n" + roff_rows(rows)
    footer = command["footer"] or program.main["footer"]
    if footer:
        text += f".SH NOTES\n.nf\n{roff(footer)}\n.fi\n"
    others = [program.main, *program.commands]
    see = [program.usage(other).replace(" ", "-") for other in others if other is not command]
    if see:
        rows = [f".BR {roff(name)} (1)" for name in sorted(see)]
        text += ".SH SEE ALSO\n" + ",\n".join(rows) + "\n"
    return text


def sea_file_page(program: Program, guide: str) -> str:
    """Returns the page ocean-sea(5) of a guide that has a title, paragraphs and blocks of code."""
    text = (
        f'.TH OCEAN\\-SEA 5 "" "libocean {program.version}" "libocean"\n'
        ".SH NAME\nocean\\-sea \\- file that describes a sea\n.SH DESCRIPTION\n"
    )
    for part in re.split(r"^(```.*?^```$)", guide.partition("\n")[2], flags=re.M | re.S):
        if part.startswith("```"):
            code = roff(part.partition("\n")[2].removesuffix("```"))
            text += f".PP\n.RS 4\n.nf\n{code}.fi\n.RE\n"
            continue
        for paragraph in part.strip().split("\n\n"):
            words = roff(re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", paragraph))
            words = re.sub(r"\\\(ga(.*?)\\\(ga", r"\\fB\1\\fR", words)
            words = re.sub(r"[*](.*?)[*]", r"\\fI\1\\fR", words)
            text += f".PP\n{words}\n"
    return text + ".SH SEE ALSO\n.BR ocean (1),\n.BR ocean\\-params (1),\n.BR ocean\\-presets (1)\n"


# Completions. A shell first looks for the command among the words that are typed, then offers its
# options, or the values of the option before the cursor.


def shell_quoted(text: str) -> str:
    return "'" + text.replace("'", "'\\''") + "'"


def option_words(command: dict, is_program: bool) -> str:
    options = named_options(command, is_program)
    return " ".join(name for option in options for name in option["names"])


def bash_values(command: dict, indent: str) -> str:
    """Returns a case of the word before the cursor, for the values of options."""
    rows: dict[str, list[str]] = {}  # what is done, by the names of the options
    for option in all_options(command):
        if is_positional(option) or option["takes"] == "nothing":
            continue
        action = "return"
        if option["words"]:
            action = f"words={shell_quoted(' '.join(option['words']))}"
        elif takes_file(option) or option["takes"] == "optional value":
            action = "words="
        rows.setdefault(action, []).extend(option["names"])
    if command["pages"]:
        pages = " ".join(page["names"][0] for page in command["pages"])
        rows[f"words={shell_quoted(pages)}"] = ["--help"]
    if not rows:
        return ""
    cases = [f"    {'|'.join(names)}) {action} ;;" for action, names in rows.items()]
    return "".join(f"{indent}{line}\n" for line in ["case $before in", *cases, "esac"])


def bash_completion(program: Program) -> str:
    function = "_" + program.name.replace("-", "_")
    commands = ""
    for command in [*program.commands, program.main]:
        is_program = command is program.main
        below = program.first_words() if is_program else program.second_words(command["name"])
        names = " ".join(other["name"].split()[-1] for other in below)
        pattern = "*" if is_program else shell_quoted(command["name"])
        commands += (
            f"        {pattern})\n"
            f"            options={shell_quoted(option_words(command, is_program))}\n"
            f"            commands={shell_quoted(names)}\n"
            f"{bash_values(command, ' ' * 12)}"
            "            ;;\n"
        )
    known = "|".join(shell_quoted(command["name"]) for command in program.commands)
    find_command = ""
    if known:
        find_command = f"""\
    for ((at = 1; at < COMP_CWORD; ++at)); do
        case "${{command:+$command }}${{COMP_WORDS[at]}}" in
            {known}) command="${{command:+$command }}${{COMP_WORDS[at]}}" ;;
        esac
    done
"""
    return f"""\
# Completion of {program.name} for bash, written by packaging/command_pages.py.
{function}() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
    local command= options= commands= words=- at
    COMPREPLY=()
    # --option=value comes as three words.
    if [ "$word" = "=" ]; then
        word=
    elif [ "$before" = "=" ]; then
        before=${{COMP_WORDS[COMP_CWORD - 2]}}
    fi
    # So does preset:NAME.
    if [ "$before$word" = "preset:" ]; then
        before=preset: word=
    elif [ "$before" = ":" ] && [ "${{COMP_WORDS[COMP_CWORD - 2]}}" = preset ]; then
        before=preset:
    fi
{find_command}    case $command in
{commands}    esac
    if [ "$before" = "preset:" ] || [ "$command $words" = "presets -" ]; then
        words=$(ocean presets 2>/dev/null | sed -n 's/^  *\\([^ ]*\\).*/\\1/p')
    fi
    if [ "$words" = "-" ]; then  # no value of an option
        words=$commands
        [[ $word != -* ]] || words=$options
    fi
    [ -z "$words" ] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    if [ ${{#COMPREPLY[@]}} -eq 0 ]; then
        compopt -o filenames
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}}
complete -F {function} {program.name}
"""


def zsh_option(option: dict) -> str:
    """Returns an argument of _arguments for an option or a positional argument."""
    text = option["help"].replace("\\", "\\\\").replace("[", "\\[").replace("]", "\\]")
    text = text.replace(":", "\\:")
    if is_positional(option):
        return shell_quoted(f"::{option['names'][0]}:_files")
    value = ""
    if option["takes"] != "nothing":
        action = "_files" if takes_file(option) else " "
        if option["words"]:
            action = f"({' '.join(option['words'])})"
        colons = "::" if option["takes"] == "optional value" else ":"
        value = f"{colons}{option['type'].replace(':', chr(92) + ':')}:{action}"
    names = option["names"]
    if option["repeats"]:
        start = "'*'"
    elif len(names) > 1:
        start = shell_quoted(f"({' '.join(names)})")
    else:
        start = ""
    each = "{" + ",".join(names) + "}" if len(names) > 1 else names[0]
    return f"{start}{each}{shell_quoted(f'[{text}]{value}')}"


def zsh_completion(program: Program) -> str:
    def arguments(command: dict, indent: str) -> str:
        is_program = command is program.main
        options = named_options(command, is_program)
        options += [option for option in all_options(command) if is_positional(option)]
        return f" \\\n{indent}    ".join(["_arguments -s", *map(zsh_option, options)])

    text = (
        f"#compdef {program.name}\n"
        f"# Completion of {program.name} for zsh, written by packaging/command_pages.py.\n"
    )
    if not program.commands:
        return text + arguments(program.main, "") + "\n"

    def listed(commands: list[dict]) -> str:
        rows = []
        for command in commands:
            name = command["name"].split()[-1]
            rows.append(shell_quoted(f"{name}:{command['summary']}"))
        return " ".join(rows)

    cases = ""
    for command in sorted(program.commands, key=lambda one: -one["name"].count(" ")):
        below = program.second_words(command["name"])
        offer = ""
        if below:
            offer = (
                f"            if (( CURRENT == 3 )); then\n"
                f"                commands=({listed(below)})\n"
                "                _describe command commands\n"
                "            fi\n"
            )
        pattern = command["name"].replace(" ", "\\ ")
        depth = command["name"].count(" ") + 1
        cases += (
            f"        {pattern}\\ *)\n{offer}"
            f'            words=("$words[1]" "${{(@)words[{depth + 2},-1]}}")\n'
            f"            (( CURRENT -= {depth} ))\n"
            f"            {arguments(command, ' ' * 12)}\n            ;;\n"
        )
    return (
        text
        + f"""\
local -a commands
if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then
    commands=({listed(program.first_words())})
    _describe command commands
else
    case "${{(j: :)words[2,-1]}} " in
{cases}        *)
            {arguments(program.main, " " * 12)}
            ;;
    esac
fi
"""
    )


def fish_completion(program: Program) -> str:
    lines = [f"# Completion of {program.name} for fish, written by packaging/command_pages.py."]
    names = " ".join(command["name"] for command in program.first_words())

    def condition(command: dict) -> str:
        if command is program.main:
            return f"not __fish_seen_subcommand_from {names}" if names else ""
        first, _, second = command["name"].partition(" ")
        seen = f"__fish_seen_subcommand_from {first}"
        if second:
            return f"{seen}; and __fish_seen_subcommand_from {second}"
        below = " ".join(other["name"].split()[1] for other in program.second_words(first))
        return f"{seen}; and not __fish_seen_subcommand_from {below}" if below else seen

    def line(command: dict, *words: str) -> str:
        when = condition(command)
        start = ["complete", "-c", program.name, *(["-n", shell_quoted(when)] if when else [])]
        return " ".join([*start, *words])

    for command in [program.main, *program.commands]:
        is_program = command is program.main
        below = program.first_words() if is_program else program.second_words(command["name"])
        for other in below:
            word, summary = other["name"].split()[-1], shell_quoted(other["summary"])
            lines.append(line(command, *(["-f"] if is_program else []), "-a", word, "-d", summary))
        for option in named_options(command, is_program):
            words = []
            for name in option["names"]:
                words += ["-l", name[2:]] if name.startswith("--") else ["-s", name[1:]]
            if option["takes"] == "value":
                words.append("-r" if takes_file(option) else "-x")
            if option["words"]:
                words += ["-a", shell_quoted(" ".join(option["words"]))]
            lines.append(line(command, *words, "-d", shell_quoted(option["help"])))
    return "\n".join(lines) + "\n"


def files_of(program: Program, sea_file: Path | None) -> dict[str, bytes]:
    """Returns the files by their paths below the prefix."""
    files = {
        f"share/bash-completion/completions/{program.name}": bash_completion(program).encode(),
        f"share/zsh/vendor-completions/_{program.name}": zsh_completion(program).encode(),
        f"share/fish/vendor_completions.d/{program.name}.fish": fish_completion(program).encode(),
    }
    for command in [program.main, *program.commands]:
        name = program.usage(command).replace(" ", "-")
        page = manual_page(program, command).encode()
        files[f"share/man/man1/{name}.1.gz"] = gzip.compress(page, 9, mtime=0)
    if sea_file:
        page = sea_file_page(program, sea_file.read_text()).encode()
        files["share/man/man5/ocean-sea.5.gz"] = gzip.compress(page, 9, mtime=0)
    return files


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, required=True, help="the folder for the files")
    parser.add_argument("--sea-file", type=Path, help="the guide that becomes ocean-sea(5)")
    parser.add_argument("program", type=Path, nargs="+", help="ocean, ocean-bridge, ocean-preview")
    asked = parser.parse_args()
    for path in asked.program:
        program = Program(described(path))
        for name, data in files_of(program, asked.sea_file).items():
            target = asked.output / program.name / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)


if __name__ == "__main__":
    main()
