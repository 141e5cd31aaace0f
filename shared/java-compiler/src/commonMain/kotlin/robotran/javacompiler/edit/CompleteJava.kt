package robotran.javacompiler.edit

import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.CodeTokens
import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionKind
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.CompletionSuffix
import robotran.languagesupport.TextLines
import robotran.languagesupport.callOf
import robotran.languagesupport.completionOf

/** The completions at the caret of a Java program; null if there are none. */
internal fun completeJava(request: CompletionRequest): CompletionList? {
    val lines = request.lines
    val help = request.help
    val brick = brickOfJava(lines) ?: request.brick
    val api = BrickApi.of(brick)
    val line = lines.lineOf(request.caret)
    val text = lines.line(line)
    val lineStart = lines.start(line)
    val column = request.caret - lineStart
    val code = CodeTokens(lines, JavaSyntax, brick)
    val tokens = code.of(line)
    val around = tokens.firstOrNull { column > it.start && column <= it.end }
    if (around != null && around.kind in WITHOUT_COMPLETIONS) return null
    val word = around?.takeIf { it.kind != CodeTokenKind.SIGN }
    val start = word?.start ?: column
    val typed = text.substring(start, column)
    val before = tokens.filter { it.end <= start }.map { text.substring(it.start, it.end) }
    val isMember = before.lastOrNull() == "." && text.substring(0, start).endsWith('.')
    if (!isMember && typed.isEmpty() && !request.isExplicit) return null
    val isAtEnd = text.substring(column).isBlank()
    val candidates = if (isMember) {
        membersBehind(receiverOf(before.dropLast(1)), lines, code, api)
    } else {
        namesIn(lines, code, lineStart + start) +
            keywordsFor(brick).map { completionOf(it, KEYWORD_SUFFIXES[it].takeIf { isAtEnd }, help) } +
            api.classNames.sorted().map {
                Completion(it, CompletionKind.CLASS, help = api.classOf(it)?.help?.ifEmpty { null })
            }
    }
    return request.completions(lineStart + start, candidates)
}

/** The chain of names before a dot, such as `Motor` and `A` in `Motor.A.`; empty if anything else is before it. */
private fun receiverOf(before: List<String>): List<String> {
    val names = mutableListOf<String>()
    var index = before.lastIndex
    while (index >= 0 && before[index].first().let { it.isLetter() || it == '_' }) {
        names.add(0, before[index])
        if (before.getOrNull(index - 1) != ".") return names
        index -= 2
    }
    return emptyList()
}

private fun membersBehind(receiver: List<String>, lines: TextLines, code: CodeTokens, api: BrickApi): List<Completion> {
    if (receiver.isEmpty()) return emptyList()
    val first = receiver.first()
    var type = if (api.classOf(first) != null) first else typeOfVariable(first, lines, code, api) ?: return emptyList()
    var isClass = api.classOf(first) != null
    for (name in receiver.drop(1)) {
        type =
            api.membersOf(type).firstOrNull { it.name == name && it.parameters == null }?.type
                ?: return emptyList()
        isClass = false
    }
    return api.membersOf(type).filter { it.isStatic == isClass }.map(::completionOf)
}

private fun completionOf(member: ApiMember): Completion {
    val help = member.help.ifEmpty { null }
    val parameters = member.parameters ?: return Completion(member.name, CompletionKind.FIELD, help = help)
    val inserted = member.name + "()"
    val caret = if (parameters.isEmpty()) inserted.length else inserted.length - 1
    return Completion("${member.name}($parameters)", CompletionKind.METHOD, inserted, caret, help)
}

/** The declared type of a variable: the class name before it. */
private fun typeOfVariable(name: String, lines: TextLines, code: CodeTokens, api: BrickApi): String? {
    var before = ""
    for (line in 0..<minOf(lines.count, MAX_LINES)) {
        val text = lines.line(line)
        if (name !in text) continue
        for (token in code.of(line)) {
            val word = text.substring(token.start, token.end)
            if (word == name && before in api.classNames) return before
            before = word
        }
    }
    return null
}

private fun namesIn(lines: TextLines, code: CodeTokens, writing: Int): List<Completion> {
    val found = LinkedHashMap<String, Completion>()
    val here = lines.lineOf(writing)
    for (line in maxOf(0, here - MAX_LINES_AROUND)..minOf(lines.count - 1, here + MAX_LINES_AROUND)) {
        val text = lines.line(line)
        val inLine = code.of(line)
        inLine.forEachIndexed { index, token ->
            val isMember = index > 0 && text[inLine[index - 1].start] == '.'
            if (token.kind != CodeTokenKind.NAME || isMember || lines.start(line) + token.start == writing) {
                return@forEachIndexed
            }
            val name = text.substring(token.start, token.end)
            val isCalled = inLine.getOrNull(index + 1)?.let { text[it.start] == '(' } == true
            found.getOrPut(name) {
                if (isCalled) callOf(name, CompletionKind.METHOD) else Completion(name, CompletionKind.NAME)
            }
        }
    }
    return found.values.filter { it.label != "()" }
}

/** The suffixes of the keywords that never stand alone. */
private val KEYWORD_SUFFIXES = (
    mapOf("if" to " (|)", "while" to " (|)", "for" to " (|)", "catch" to " (|)") +
        (
            "abstract class extends final implements import instanceof interface new package private protected " +
                "public static " +
                "synchronized throw throws"
        ).split(' ').associateWith { " " }
).mapValues { CompletionSuffix.of(it.value) }

private val WITHOUT_COMPLETIONS = setOf(CodeTokenKind.COMMENT, CodeTokenKind.TEXT, CodeTokenKind.NUMBER)

/** Declarations in later lines are not found. */
private const val MAX_LINES = 5_000

/** Names further away are not offered, because this runs on every keystroke. */
private const val MAX_LINES_AROUND = 1_000
