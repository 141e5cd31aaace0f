package robotran.javacompiler.support

import robotran.javacompiler.edit.JAVA_KEYWORDS
import robotran.languagesupport.ProgramMeasure
import robotran.languagesupport.linesOfBraceCode

internal object JavaMeasure : ProgramMeasure {
    override val isAnyOrderOfFiles = true

    override fun linesOfCode(text: String): Int = linesOfBraceCode(text)

    /** Keeps the words of Java, the names after a dot, and class names before a dot, such as `Motor.A.forward`. */
    override fun normalTokens(text: String): Sequence<String> = withoutBlockComments(text).let { code ->
        JAVA_TOKEN.findAll(code).mapNotNull { match -> javaToken(code, match.range) }
    }
}

private fun javaToken(text: String, range: IntRange): String? {
    val word = text.substring(range)
    return when {
        word.startsWith("//") -> null
        !word[0].isLetter() && word[0] != '_' -> word
        word in WORDS || isAfterDot(text, range.first) -> word
        word[0].isUpperCase() && text.getOrNull(range.last + 1) == '.' -> word
        else -> ProgramMeasure.NAME
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

private fun isAfterDot(text: String, offset: Int): Boolean = offset > 0 && text[offset - 1] == '.'

/** A line's comment, a text or character, a name, a number, or any other sign. */
private val JAVA_TOKEN = Regex(
    "//[^\\n]*|\"[^\"\\n]*\"|'[^'\\n]*'|[A-Za-z_\u00C0-\uD7FF][A-Za-z_0-9\u00C0-\uD7FF]*|[0-9][0-9A-Za-z_.]*|[^\\s]",
)

private val WORDS = JAVA_KEYWORDS.toSet() - "const" - "goto"
