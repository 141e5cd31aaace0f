package robotran.javacompiler.support

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceRange
import robotran.languagesupport.BrickMention
import robotran.languagesupport.SourceFile

/** The first mention of the brick that a program of [files] is for; null if it names none or both. */
internal fun mentionOfBrickIn(files: List<SourceFile>): BrickMention? {
    val mentions = files.flatMap { mentionsIn(it) }
    val first = mentions.firstOrNull()?.takeIf { mentions.all { other -> other.kind == it.kind } }
    return first?.let { BrickMention(it.kind, it.file, it.range()) }
}

/**
 * Whether a program that names no brick is most likely for an NXT: it prints with `System.out` or uses classes of
 * `java.util` that only leJOS NXJ has.
 */
internal fun looksLikeNxj(files: List<SourceFile>): Boolean {
    val texts = files.map { withoutCommentsAndTexts(it.text) }
    return texts.none { BRICK_NAME.containsMatchIn(it) } && texts.any { text ->
        SYSTEM_STREAM.containsMatchIn(text) || (UTILITIES.containsMatchIn(text) && NXJ_UTILITY.containsMatchIn(text))
    }
}

private val SYSTEM_STREAM = Regex("""(?<![\w.$])(?:java\.lang\.)?System\s*\.\s*(?:out|err)\b""")

private val UTILITIES = Regex("""\bjava\.util\.""")

/** What leJOS on an RCX lacks in `java.util`. */
private val NXJ_UTILITY = Regex(
    """\b(?:Array(?:List|s)|Collection|Date|Enumeration|Hash(?:Map|Set)|Iterator|LinkedList|List|ListIterator|Map|""" +
        """NoSuchElementException|Properties|Set|StringTokenizer|Timer|TimerTask)\b""",
)

/** A mention whose line is not counted yet: a program may have tens of thousands. */
private class NameInCode(val file: String, private val code: String, private val name: MatchResult) {
    val kind = PACKAGES.getValue(name.groupValues[1])

    fun range() = rangeOf(code, name.range)
}

private fun mentionsIn(file: SourceFile): List<NameInCode> {
    val code = withoutCommentsAndTexts(file.text)
    return BRICK_NAME.findAll(code).map { NameInCode(file.name, code, it) }.toList()
}

private fun rangeOf(code: String, name: IntRange): SourceRange {
    val lineStart = code.lastIndexOf('\n', name.first) + 1
    val line = code.substring(0, lineStart).count { it == '\n' } + 1
    return SourceRange(line, name.first - lineStart + 1, name.last - lineStart + 2)
}

/** [source] with blanks for its comments and its constants of texts and characters. */
private fun withoutCommentsAndTexts(source: String): String {
    val code = StringBuilder()
    while (code.length < source.length) {
        val start = code.length
        val end = when {
            source.startsWith("//", start) -> source.endOf("\n", start)
            source.startsWith("/*", start) -> source.endOf("*/", start + 2)
            source[start] == '"' || source[start] == '\'' -> endOfText(source, start)
            else -> start
        }
        if (end == start) code.append(source[start])
        while (code.length < end) code.append(if (source[code.length] == '\n') '\n' else ' ')
    }
    return code.toString()
}

/** The place behind the next [mark]; that of a line break itself. */
private fun String.endOf(mark: String, from: Int): Int {
    val place = indexOf(mark, from)
    return if (place < 0) {
        length
    } else if (mark == "\n") {
        place
    } else {
        place + mark.length
    }
}

/** The place behind a text that begins at [start]; it ends on its line. */
private fun endOfText(source: String, start: Int): Int {
    var place = start + 1
    while (place < source.length && source[place] != source[start] && source[place] != '\n') {
        place += if (source[place] == '\\') 2 else 1
    }
    return minOf(if (source.getOrNull(place) == source[start]) place + 1 else place, source.length)
}

/** The bricks by the root of their packages. */
private val PACKAGES = BrickKind.entries.mapNotNull { kind -> kind.java?.let { it.root to kind } }.toMap()

/** A qualified name that is no part of a longer one. */
private val BRICK_NAME = Regex("""(?<![\w.$])(${PACKAGES.keys.joinToString("|")})(?:\.(?:\w+|\*))+""")
