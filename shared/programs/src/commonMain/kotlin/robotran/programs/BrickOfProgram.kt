package robotran.programs

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceRange
import robotran.robolang.brickOfRobolang

/**
 * The first place where a program names something that only one kind of brick has.
 *
 * @property file the name of the file.
 * @property range the name, such as `lejos.nxt.Motor`, in an import or in code.
 */
data class BrickMention(val kind: BrickKind, val file: String, val range: SourceRange)

/**
 * The kind of brick that a Java program of [files] is for: `lejos.` names the packages of an NXT, `josx.` those of an RCX.
 * Null if the program names neither or both.
 */
fun brickOf(files: List<SourceFile>): BrickKind? = brickMentionIn(files)?.kind

/** The first mention of the brick that a program of [files] is for; null as for [brickOf]. */
fun brickMentionIn(files: List<SourceFile>): BrickMention? {
    val mentions = files.flatMap { mentionsIn(it) }
    val first = mentions.firstOrNull()?.takeIf { mentions.all { other -> other.kind == it.kind } }
    return first?.let { BrickMention(it.kind, it.file, it.range()) }
}

/** The kind of brick that this program is for; null if it does not tell. */
fun brickOf(program: ProgramSource): BrickKind? = when (program) {
    is ProgramSource.Robolang -> brickOfRobolang(program.text)
    is ProgramSource.Java -> brickOf(program.files)
    is ProgramSource.CompiledClasses -> brickOfClasses(program.classFiles.values)
    is ProgramSource.ForLegoFirmware -> BrickKind.OF_LEGO_FIRMWARE
}

/** Looks for names of packages among the constants of the [classFiles]. */
private fun brickOfClasses(classFiles: Collection<ByteArray>): BrickKind? = PACKAGES.filter { (start, _) ->
    classFiles.any { it.contains("$start/".encodeToByteArray()) }
}.values.singleOrNull()

private fun ByteArray.contains(part: ByteArray): Boolean =
    (0..size - part.size).any { place -> part.indices.all { this[place + it] == part[it] } }

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
internal fun withoutCommentsAndTexts(source: String): String {
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
internal val BRICK_NAME = Regex("""(?<![\w.$])(${PACKAGES.keys.joinToString("|")})(?:\.(?:\w+|\*))+""")
