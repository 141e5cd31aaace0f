package robotran.robolang.edit

import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.CodeTokens
import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionHelp
import robotran.languagesupport.CompletionKind
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.CompletionSuffix
import robotran.languagesupport.TextLines
import robotran.languagesupport.callOf
import robotran.languagesupport.completionOf
import robotran.robolang.RobolangWords
import robotran.robolang.words.Keyword
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.vocabularyOf
import robotran.robolang.words.written

/** The completions at the caret of a Robolang program; null if there are none. */
internal fun completeRobolang(request: CompletionRequest): CompletionList? {
    val lines = request.lines
    val help = request.help
    val line = lines.lineOf(request.caret)
    val lineStart = lines.start(line)
    val column = request.caret - lineStart
    val code = CodeTokens(lines, RobolangSyntax, request.brick)
    val tokens = code.of(line)
    val text = lines.line(line)
    val around = tokens.firstOrNull { column > it.start && column <= it.end }
    val word = around?.takeIf {
        it.kind == CodeTokenKind.NAME || it.kind == CodeTokenKind.KEYWORD ||
            it.kind == CodeTokenKind.BUILT_IN
    }
    if (around != null && word == null && around.kind != CodeTokenKind.SIGN) return null
    val start = word?.start ?: column
    val typed = text.substring(start, column)
    if (typed.isEmpty() && !request.isExplicit) return null
    val vocabulary = vocabularyOf(lines.text, unsure = Vocabulary.of(help.words))
    val before = tokens.filter { it.end <= start }.map { canonical(text.substring(it.start, it.end), vocabulary) }
    val names = namesIn(lines, code, lineStart + start, vocabulary)
    val header = headerAt(lines, line, vocabulary)
    val brick = header.brick ?: request.brick
    val isAtEnd = text.substring(column).isBlank()
    val candidates = if (before.isEmpty() && header.isInside) {
        settingsOn(brick) + words(listOf("end"), help)
    } else if (before.isEmpty() || before == listOf("else")) {
        val blocks = if (before.isEmpty() && isAtEnd) BLOCKS else emptyList()
        val commands = words(RobolangWords.commands, help) { if (isAtEnd) suffixOfCommand(it) else null }
        commands + blocks.map { it.copy(help = help.of(it.inserted.substringBefore(' '))) } + names
    } else {
        val last = before.last()
        val followers = followersOf(last, brick)
        if (followers != null) {
            words(followers, help) { if (isAtEnd) suffixAfter(last, it) else null }
        } else {
            words(RobolangWords.valueWordsOn(brick), help) {
                if (isAtEnd) suffixAfter(last, it) ?: suffixOfValue(it) else null
            } + names + functions(help) + words(RobolangWords.keywordsOn(brick), help)
        }
    }
    val written = candidates.map { if (it in names) it else it.inWords(vocabulary) }
    return request.completions(lineStart + start, written.distinctBy { it.label })
}

/** [word] as the tables of the language have it. */
private fun canonical(word: String, vocabulary: Vocabulary): String = vocabulary.keyword(word)?.text ?: word.lowercase()

private fun Completion.inWords(vocabulary: Vocabulary): Completion {
    val written = vocabulary.written(inserted)
    val before = vocabulary.written(inserted.take(caret))
    return copy(
        label = vocabulary.written(label),
        inserted = written,
        caret = if (written ==
            inserted
        ) {
            caret
        } else {
            before.length
        },
    )
}

private fun words(words: List<String>, help: CompletionHelp, suffix: (String) -> CompletionSuffix? = { null }) =
    words.map { word ->
        val completion = completionOf(word, suffix(word), help)
        completion.copy(offersNext = completion.inserted == "$word " && word in OFFERING)
    }

private fun functions(help: CompletionHelp) = RobolangWords.functions.map { (name, parameters) ->
    val commas = ", ".repeat(parameters - 1)
    Completion("$name($commas)", CompletionKind.FUNCTION, "$name($commas)", name.length + 1, help.of(name))
}

/** The names that the program declares, except for the one being written at offset [writing]. */
private fun namesIn(lines: TextLines, code: CodeTokens, writing: Int, vocabulary: Vocabulary): List<Completion> {
    val found = LinkedHashMap<String, Completion>()
    for (line in 0..<minOf(lines.count, MAX_LINES)) {
        if (!declares(lines, line, vocabulary)) continue
        val text = lines.line(line)
        val inLine = code.of(line)
        inLine.forEachIndexed { index, token ->
            val before = inLine.getOrNull(index - 1)?.let { canonical(text.substring(it.start, it.end), vocabulary) }
            val isBeingWritten = lines.start(line) + token.start == writing
            if (token.kind != CodeTokenKind.NAME || before !in DECLARING || isBeingWritten) return@forEachIndexed
            val name = text.substring(token.start, token.end)
            val isRoutine = before == "procedure" || before == "function"
            found.getOrPut(name.lowercase()) {
                if (isRoutine) callOf(name, CompletionKind.FUNCTION) else Completion(name, CompletionKind.NAME)
            }
        }
    }
    return found.values.toList()
}

/** Whether [line] may declare names. A fast check, for every keystroke: most lines do not. */
private fun declares(lines: TextLines, line: Int, vocabulary: Vocabulary): Boolean {
    var start = lines.start(line)
    val end = lines.end(line)
    while (start < end && (lines.text[start] == ' ' || lines.text[start] == '\t')) start++
    return DECLARATIONS.any { lines.text.startsWith(vocabulary.text(it), start, end) }
}

private fun String.startsWith(word: String, start: Int, end: Int): Boolean {
    val behind = start + word.length
    return behind < end && regionMatches(start, word, 0, word.length, ignoreCase = true) &&
        !isInWord(this[behind])
}

private val DECLARATIONS = listOf(Keyword.VAR, Keyword.CONST, Keyword.PROCEDURE, Keyword.FUNCTION, Keyword.FOR)
private val DECLARING = DECLARATIONS.map { it.text } + listOf(Keyword.EACH.text, "(", ",")

private fun block(first: String, caret: Int, label: String = "$first … end") =
    Completion(label, CompletionKind.BLOCK, "$first\n  \nend", caret)

private val BLOCKS = listOf(
    block("repeat 4 times", "repeat 4 times\n  ".length),
    block("repeat forever", "repeat forever\n  ".length),
    block("if ", "if ".length, "if … end"),
    block("procedure name()", "procedure ".length),
    block("whenever ", "whenever ".length, "whenever … end"),
)

/** Names in later lines are not found. */
private const val MAX_LINES = 5_000
