package robotran.assignments.tokens

import robotran.language.ProgramLanguage
import robotran.nqc.edit.NqcTokenKind
import robotran.nqc.edit.nqcTokens
import robotran.projects.ProjectProgram
import robotran.robolang.SourceTokenKind
import robotran.robolang.robolangTokensOfLines

/**
 * The words, numbers and signs of [program], at most [MAXIMUM_TOKENS], without comments. All names that a pupil may
 * choose are the same, so that renaming changes nothing.
 */
internal fun normalTokens(program: ProjectProgram): List<String> = when (program.language) {
    ProgramLanguage.ROBOLANG -> program.files.asSequence().flatMap { robolang(it.text) }
    ProgramLanguage.JAVA -> program.files.asSequence().sortedBy { it.name }.flatMap { java(it.text) }
    ProgramLanguage.NQC -> program.files.asSequence().flatMap { nqc(it.text) }
    ProgramLanguage.LASM -> program.files.asSequence().flatMap { lasm(it.text) }
}.take(MAXIMUM_TOKENS).toList()

private fun robolang(text: String): Sequence<String> = text.lineSequence().zip(
    robolangTokensOfLines(text).asSequence(),
).flatMap { (line, tokens) ->
    tokens.mapNotNull { token ->
        when (token.kind) {
            SourceTokenKind.COMMENT -> null
            SourceTokenKind.NAME -> NAME
            else -> line.substring(token.start, token.end).lowercase()
        }
    }
}

private fun nqc(text: String): Sequence<String> {
    var isInComment = false
    return text.lineSequence().flatMap { line ->
        val tokens = nqcTokens(line, isInComment).also { isInComment = it.endsInComment }.tokens
        tokens.mapNotNull { token ->
            when (token.kind) {
                NqcTokenKind.COMMENT -> null
                NqcTokenKind.NAME -> NAME
                else -> line.substring(token.start, token.end)
            }
        }
    }
}

/** Labels are named after addresses, so a command's words are its mnemonic and numbers. */
private fun lasm(text: String): Sequence<String> = text.lineSequence().flatMap { line ->
    LASM_WORD.findAll(line.substringBefore(';')).map { if (LASM_LABEL.matches(it.value)) NAME else it.value }
}

/** Keeps the words of Java, the names after a dot, and class names before a dot, such as `Motor.A.forward`. */
private fun java(source: String): Sequence<String> = withoutBlockComments(source).let { text ->
    JAVA_TOKEN.findAll(text).mapNotNull { match -> javaToken(text, match.range) }
}

private fun javaToken(text: String, range: IntRange): String? {
    val word = text.substring(range)
    return when {
        word.startsWith("//") -> null
        !word[0].isLetter() && word[0] != '_' -> word
        word in JAVA_WORDS || isAfterDot(text, range.first) -> word
        word[0].isUpperCase() && text.getOrNull(range.last + 1) == '.' -> word
        else -> NAME
    }
}

/** The words, numbers and signs of Java in [source], without comments. */
internal fun javaWords(source: String): Sequence<String> =
    JAVA_TOKEN.findAll(withoutBlockComments(source)).map { it.value }.filterNot { it.startsWith("//") }

/** A comment in a text or behind another comment is rare, and its loss does no harm. */
private fun withoutBlockComments(text: String): String {
    if ("/*" !in text) return text
    return text.split("/*").mapIndexed { index, part ->
        if (index == 0) part else " " + part.substringAfter("*/", "")
    }.joinToString("")
}

private fun isAfterDot(text: String, place: Int): Boolean = place > 0 && text[place - 1] == '.'

/** Whether both are the same, whatever their comments, blanks and chosen names. */
fun isSameProgram(one: ProjectProgram, other: ProjectProgram): Boolean =
    one.language == other.language && normalTokens(one) == normalTokens(other)

internal const val MAXIMUM_TOKENS = 5_000
private const val NAME = "name"

/** A line's comment, a text or character, a name, a number, or any other sign. */
private val JAVA_TOKEN = Regex(
    "//[^\\n]*|\"[^\"\\n]*\"|'[^'\\n]*'|[A-Za-z_\u00C0-\uD7FF][A-Za-z_0-9\u00C0-\uD7FF]*|[0-9][0-9A-Za-z_.]*|[^\\s]",
)

private val LASM_WORD = Regex("[A-Za-z_]\\w*|-?\\d+")
private val LASM_LABEL = Regex("[st]\\d{7}")

private val JAVA_WORDS = (
    "abstract boolean break byte case catch char class continue default do double else extends final finally float " +
        "for if implements import instanceof int interface long native new null package private protected public " +
        "return short static super switch synchronized this throw throws transient true false try void volatile while"
).split(' ').toSet()
