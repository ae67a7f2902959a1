"""Small changes of a function's body, as slips of whoever writes it: `mutants(body)`. They are made token by token:

    operators exchanged: + - * / among each other, comparisons, && || & |, ++ --
    operands exchanged: of - and /, of a call, in a list {…} or [a, b], about the : of a ?:
    operands left out: of each operator, call, ?: and list; a ! or a sign left out, a sign put in; a ?: for `choose`
    names exchanged: a variable for any other of the body, a member for another of the same variable; max for min, and
        others that are alike
    constants one larger, one smaller, negated; powers of two doubled and halved
    types of numbers exchanged: Real, int, float, double
    statements left out, two exchanged; {} returned; conditions negated; break for continue, if for while

A body is as clang-format leaves it: an operator with a blank on either side has two operands, and a < without is a
template's."""
import collections
import re

# What stands once in a body, what stands there instead, and the body then.
Mutant = collections.namedtuple("Mutant", "was becomes body")

TOKEN = re.compile(r"0x[\da-fA-F.]+p[+-]?\d+|\d[\d.]*|[A-Za-z_]\w*(?:::\w+)*|->|<=|>=|==|!=|&&|\|\||\+\+|--|[-+*/]=|\S")
PRECEDENCE = {"||": 1, "&&": 2, "&": 3, "==": 4, "!=": 4, "<": 5, ">": 5, "<=": 5, ">=": 5, "+": 6, "-": 6, "*": 7,
              "/": 7}
ALIKE = ["+ - * /", "< <= > >= == !=", "!= ||", "&& ||", "& | &&", "++ --", "+= -=", "std::max std::min",
         "std::abs abs", "true false", "x y z", "P D", "enters leaves"]
EXCHANGED = {word: [other for alike in ALIKE if word in alike.split() for other in alike.split() if other != word]
             for word in " ".join(ALIKE).split()}
NUMBERS = ["Real", "int", "float", "double"]
HEADED = {"if", "for", "while", "switch"}
KEYWORDS = HEADED | set("Real auto bool break case const constexpr continue default double else false float int return "
                        "true using".split())
ENDS = set(", ; = ? : ( [ { ) ] } += -= *= /= return".split())  # what no operand goes beyond


class Body:
    def __init__(self, text):
        self.text = " ".join(text.split())
        found = list(TOKEN.finditer(self.text))
        self.words = [one.group() for one in found]
        self.spans = [one.span() for one in found]
        self.partner = {}
        opened = []
        for i, word in enumerate(self.words):
            if word in "([{":
                opened.append(i)
            elif word in ")]}":
                self.partner[i] = opened.pop()
                self.partner[self.partner[i]] = i
        self.bound = {at for i, word in enumerate(self.words) if word == "[" and self.word(i - 1) in ("&", "auto")
                      for at in range(i, self.partner[i])}  # names that [a, b] declares

    def word(self, i):
        return self.words[i] if 0 <= i < len(self.words) else ""

    def part(self, first, end):
        """The text of tokens [first, end)."""
        return self.text[self.spans[first][0]:self.spans[end - 1][1]] if first < end else ""

    def is_word(self, i):
        return re.match(r"[A-Za-z_]", self.word(i)) is not None

    def is_binary(self, i):
        begin, end = self.spans[i]
        return self.words[i] in PRECEDENCE and self.text[begin - 1:begin] == self.text[end:end + 1] == " "

    def is_template(self, i):
        return self.word(i) in ("<", ">", "&") and not self.is_binary(i)

    def surroundings(self, first, end):
        """So many tokens around [first, end), one on either side or more, that they stand in the body once and have
        whole brackets, with what is called."""
        left, right = max(first - 1, 0), min(end + 1, len(self.words))
        while True:
            partners = [self.partner[at] for at in range(left, right) if at in self.partner]
            if any(not left <= at < right for at in partners):
                left, right = min(left, *partners), max(right, *(at + 1 for at in partners))
            elif self.word(left) in ("(", "["):
                left -= 1
            elif self.text.count(self.part(left, right)) == 1:
                return left, right
            elif right < len(self.words) and (right - end <= first - left or left == 0):
                right += 1
            else:
                left -= 1

    def left_operand(self, i, precedence):
        """Where the operand begins that ends before token i."""
        while i > 0:
            at = self.partner.get(i - 1, i - 1) if self.words[i - 1] in ")]}" else i - 1
            is_looser = self.is_binary(at) and PRECEDENCE[self.words[at]] < precedence
            if self.words[at] in ENDS and at == i - 1 or is_looser:
                return i
            i = at
        return i

    def right_operand(self, i, precedence):
        """Where the operand ends that begins at token i."""
        while i < len(self.words):
            if self.words[i] in "([{":
                i = self.partner[i]
            elif self.words[i] in ENDS or self.is_binary(i) and PRECEDENCE[self.words[i]] <= precedence:
                return i
            i += 1
        return i

    def elements(self, i):
        """The parts [first, end) between commas in the bracket that opens at token i."""
        first, end, found = i + 1, self.partner[i], []
        at = first
        while at < end:
            if self.words[at] == ",":
                found.append((first, at))
                first = at + 1
            at = self.partner[at] + 1 if self.words[at] in "([{" else at + 1
        return found + [(first, end)] if end > i + 1 else []

    def callee(self, i):
        """Where the name begins of what is called with the bracket that opens at token i; i itself if nothing is."""
        while True:
            if self.word(i - 1) == ">" and self.is_template(i - 1):
                while self.word(i - 1) != "<":
                    i -= 1
                i -= 1
            if not self.is_word(i - 1) or self.word(i - 1) in KEYWORDS:
                return i
            i -= 1
            if self.word(i - 1) not in (".", "->"):
                return i
            i -= 1

    def end_of_statement(self, i):
        if self.words[i] in HEADED:
            return self.end_of_statement(self.partner[i + 1] + 1)
        if self.words[i] == "{":
            return self.partner[i] + 1
        while self.words[i] != ";":
            i = self.partner[i] + 1 if self.words[i] in "([{" else i + 1
        return i + 1

    def statements(self, first, end):
        while first < end:
            if self.words[first] in ("case", "default"):
                first = self.words.index(":", first) + 1
            after = self.end_of_statement(first)
            if self.words[first] == "{":
                yield from self.statements(first + 1, after - 1)
            else:
                yield first, after
            if self.words[first] in HEADED:
                yield from self.statements(self.partner[first + 1] + 1, after)
            first = after

    def is_variable(self, i):
        if not self.is_word(i) or self.words[i] in KEYWORDS or "::" in self.words[i] or self.word(i + 1) in ("(", "{"):
            return False
        is_argument = self.word(i - 1) == "<" and self.is_template(i - 1)
        is_type = is_argument or self.is_word(i + 1) or self.is_template(i + 1)
        return self.word(i - 1) not in (".", "->") and not is_type

    def is_declared(self, i):
        before = self.word(i - 1)
        is_typed = (self.is_word(i - 1) or self.is_template(i - 1)) and before not in ("return", "case", "else")
        return is_typed or i in self.bound

    def is_member(self, i):
        return self.is_word(i) and self.word(i - 1) in (".", "->") and self.word(i + 1) != "("


def operators(body):
    for i, word in enumerate(body.words):
        if body.is_binary(i) or word in ("++", "--", "+=", "-="):
            for other in EXCHANGED.get(word, []):
                yield i, i + 1, other
        if not body.is_binary(i):
            continue
        first = body.left_operand(i, PRECEDENCE[word])
        end = body.right_operand(i + 1, PRECEDENCE[word])
        left, right = body.part(first, i), body.part(i + 1, end)
        yield first, end, left
        yield first, end, right
        if word in ("-", "/") or word == "*" and right.isupper():  # numbers commute, to the bit
            yield first, end, f"{right} {word} {left}"


def signs(body):
    for i, word in enumerate(body.words):
        if word == "!" or word == "-" and not body.is_binary(i):
            yield i, i + 1, ""
        begins = body.word(i - 1) in ("(", ",", "{", "=", "?", ":", "return") or i > 0 and body.is_binary(i - 1)
        is_made = word[0].isupper() and body.word(i + 1) in ("(", "<", "{")
        is_used = body.is_word(i) and i not in body.bound and word not in KEYWORDS
        if begins and is_used and not is_made and not word.startswith("is_"):
            yield i, i, "-"


def choices(body):
    for i, word in enumerate(body.words):
        if word != "?":
            continue
        first, colon = body.left_operand(i, 0), body.right_operand(i + 1, 0)
        end = body.right_operand(colon + 1, 0)
        one, other = body.part(i + 1, colon), body.part(colon + 1, end)
        yield i + 1, end, f"{other} : {one}"
        yield first, end, one
        yield first, end, other


def lists(body):
    for i, word in enumerate(body.words):
        if word not in ("(", "[", "{"):
            continue
        elements = body.elements(i)
        if any(body.words[at] == ";" for at in range(i, body.partner[i])) or body.word(i - 1) in HEADED:
            continue
        for (first, end), (after, after_end) in zip(elements, elements[1:]):
            yield first, after_end, f"{body.part(after, after_end)}, {body.part(first, end)}"
        if word == "{":
            for left_out in elements:
                others = ", ".join(body.part(*one) for one in elements if one != left_out)
                yield i, body.partner[i] + 1, f"{{{others}}}"
        callee = body.callee(i)
        if word == "(" and callee < i:
            for first, end in elements:
                yield callee, body.partner[i] + 1, f"({body.part(first, end)})"
            if body.word(i - 1) == "choose":
                condition, one, other = (body.part(*element) for element in elements)
                yield callee, body.partner[i] + 1, f"({condition} ? {one} : {other})"


def types(body):
    for i, word in enumerate(body.words):
        if word in NUMBERS and body.is_word(i + 1):
            for other in NUMBERS:
                yield i, i + 1, other


def names(body):
    where = range(len(body.words))
    own = {}  # what the statement declares that a word stands in: it has no value yet
    for first, end in body.statements(0, len(body.words)):
        if body.words[first] not in HEADED:
            own |= dict.fromkeys(range(first, end), {body.words[i] for i in range(first, end) if body.is_declared(i)})
    variables = dict.fromkeys(body.words[i] for i in where if body.is_variable(i))
    members = collections.defaultdict(dict)  # of each variable
    for i in where:
        if body.is_member(i):
            members[body.word(i - 2)][body.words[i]] = None
    for i, word in enumerate(body.words):
        others = EXCHANGED.get(word, [])
        if not body.is_word(i) or body.is_declared(i):
            continue
        if body.is_member(i):
            others = [*members[body.word(i - 2)], *others]
        elif body.is_variable(i):
            others = [one for one in variables if one not in own.get(i, ())]
        for other in others:
            yield i, i + 1, other


def constants(body):
    for i, word in enumerate(body.words):
        if word.startswith("0x"):
            others = [f"2 * {word}", f"{word} / 2"]
        elif word.isdigit():
            others = [str(int(word) + 1), str(int(word) - 1), f"-{word}"] if word != "0" else ["1", "-1"]
        else:
            continue
        for other in others:
            yield i, i + 1, other


def statements(body):
    def declares(first, end):
        return body.words[first] not in HEADED and any(body.is_declared(i) for i in range(first, end))

    before = None
    for first, end in body.statements(0, len(body.words)):
        word = body.words[first]
        yield first, end, ";"
        if before and before[1] == first and not (declares(*before) and declares(first, end)):
            yield before[0], end, f"{body.part(first, end)} {body.part(*before)}"
        before = first, end
        if word == "return":
            yield first, end, "return {};"
        if word in ("break", "continue"):
            yield first, end, "continue;" if word == "break" else "break;"
        if word in ("if", "while"):
            yield first + 2, body.partner[first + 1], f"!({body.part(first + 2, body.partner[first + 1])})"
        if word == "while":
            yield first, first + 1, "if"


def mutants(text):
    """All small changes of a body, those that write the same once."""
    body = Body(text)
    found = {body.text: None}
    for kind in (operators, signs, choices, lists, types, names, constants, statements):
        for first, end, instead in kind(body):
            begin = body.spans[first][0]
            stop = body.spans[end - 1][1] if end > first else begin
            changed = body.text[:begin] + instead + body.text[stop:]
            if changed in found:
                continue
            left, right = body.surroundings(first, end)
            was = body.part(left, right)
            before, after = body.text[body.spans[left][0]:begin], body.text[stop:body.spans[right - 1][1]]
            found[changed] = Mutant(was, before + instead + after, changed)
    return [one for one in found.values() if one]
