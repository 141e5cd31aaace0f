package robotran.learning.hint

/**
 * A line of a program in either language, without comments, blanks and empty lines.
 *
 * @property number its place in the program, from 1.
 * @property tokens its words in lower case, numbers, texts and signs.
 */
internal data class CodeLine(val number: Int, val tokens: List<String>) {
    /** Whether it only closes a block. */
    val isEnd: Boolean get() = tokens == listOf("end") || tokens == listOf("}")
}

/** The lines of [program] without comments behind `//`. A sign that neither language has is a token of its own. */
internal fun codeLines(program: String): List<CodeLine> = program.lines().mapIndexed { index, line ->
    CodeLine(index + 1, TOKEN.findAll(line.substringBefore("//")).map { it.value.lowercase() }.toList())
}.filter { it.tokens.isNotEmpty() }

/** Whether the tokens of [words] follow each other somewhere in a line; the number of the first such line, or null. */
internal fun List<CodeLine>.lineWith(words: List<String>): Int? = firstOrNull { line ->
    line.tokens.windowed(words.size).any { it == words }
}?.number

/** The tokens of [words], such as `repeat until`. */
internal fun tokensOf(words: String): List<String> = codeLines(words).flatMap { it.tokens }

internal fun isNumber(token: String): Boolean = token.first() in '0'..'9'

private val TOKEN = Regex("[0-9]+(\\.[0-9]+)?|[\\p{L}_][\\p{L}0-9_]*|\"[^\"]*\"?|[<>=!]=|\\S")
