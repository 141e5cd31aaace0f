package robotran.robolang.python

import robotran.robolang.RobolangProgram
import robotran.robolang.check.CheckedProgram
import robotran.robolang.python.writer.withInner
import robotran.robolang.syntax.Statement
import robotran.robolang.template.fillIn
import robotran.robolang.template.sectionsOf
import robotran.robolang.template.templates
import robotran.robolang.translate.LineMap

/**
 * The Python of [translation], which is one of [program] for a hub with Pybricks, so that it tells which line runs: before
 * a statement it prints a line with [sign] and the number of a line of this Python, which is one of that statement. It is
 * for a hub that the app listens to, and not to be read.
 *
 * So that Bluetooth keeps up, no line is told twice in a row, and in [RunningLineLimits.WINDOW] only one, and
 * [RunningLineLimits.MOST] with those that take time.
 */
fun withRunningLines(program: RobolangProgram, translation: PythonTranslation, sign: Char): PythonTranslation =
    withRunningLines(program, translation, sign, RunningLineLimits.WINDOW)

/** @param window in milliseconds; with 0 each statement is told. */
internal fun withRunningLines(
    program: RobolangProgram,
    translation: PythonTranslation,
    sign: Char,
    window: Int,
): PythonTranslation = RunningLines(program.checked, translation).write(sign, window)

/** How often a program tells which line runs. */
internal object RunningLineLimits {
    /** Milliseconds; nobody reads faster. */
    const val WINDOW = 100

    /** How many lines in a window if they take time: the last of them may be the one that the robot is at for long. */
    const val MOST = 5
}

private class RunningLines(program: CheckedProgram, private val translation: PythonTranslation) {
    private val lines = translation.python.removeSuffix("\n").lines()
    private val origins = lines.indices.map { translation.lineMap.sourceLineOf(it + 1) ?: LineMap.NO_LINE }

    /** The lines of the program at which a statement begins that is told; true if one there takes time. */
    private val statements: Map<Int, Boolean> = withInner(
        program.tree.statements + program.tree.behaviours.flatMap { it.body } +
            RoutinesWithLines(program.tree).all.flatMap { it.body },
    ).groupBy { it.range.line }.mapValues { (_, here) -> here.any(::takesTime) }

    fun write(sign: Char, window: Int): PythonTranslation {
        val names = namesThatAreFree()
        val texts = helper(names, sign, window).lines().toMutableList()
        val newOrigins = MutableList(texts.size) { LineMap.NO_LINE }
        repeat(GAP) {
            texts += ""
            newOrigins += LineMap.NO_LINE
        }
        lines.forEachIndexed { index, line ->
            if (isFirstOfStatement(index)) {
                val most = if (statements.getValue(origins[index])) ", ${RunningLineLimits.MOST}" else ""
                texts += "${line.takeWhile { it == ' ' }}${names.getValue("MARK")}(${texts.size + 1}$most)"
                newOrigins += origins[index]
            }
            texts += line
            newOrigins += origins[index]
        }
        val text = texts.joinToString("") { "$it\n" }
        return PythonTranslation(translation.fileName, text, LineMap(newOrigins), translation.notes)
    }

    /** A drive, a sound, and a loop that may only wait for something. */
    private fun takesTime(statement: Statement): Boolean = isLong(statement) || statement is Statement.RepeatForever ||
        statement is Statement.RepeatWhile || statement is Statement.RepeatUntil

    /** Whether a statement begins at the line with the [index], so that a line may stand above it. */
    private fun isFirstOfStatement(index: Int): Boolean {
        val text = lines[index].trim()
        val isStatement = origins[index] in statements && isCode(index) && NOT_FIRST.none { text.startsWith(it) }
        return isStatement && origins[index] != (index - 1 downTo 0).firstOrNull(::isCode)?.let(origins::get)
    }

    private fun isCode(index: Int): Boolean = lines[index].trim().let { it.isNotEmpty() && !it.startsWith('#') }

    /** The names of the helper by their places in it, none of which the program has. */
    private fun namesThatAreFree(): Map<String, String> {
        val taken = WORD.findAll(translation.python).map { it.value }.toSet()
        return NAMES.mapValues { (_, wanted) -> generateSequence(wanted) { "${it}_" }.first { it !in taken } }
    }

    private fun helper(names: Map<String, String>, sign: Char, window: Int): String =
        SECTIONS.getValue("RUNNING_LINE").fillIn(
            names + mapOf("WINDOW" to "$window", "SIGN" to "\\x" + sign.code.toString(radix = 16).padStart(2, '0')),
        )

    private companion object {
        /** Blank lines behind the helper. */
        const val GAP = 2
        val NAMES = mapOf("MARK" to "at_line", "CLOCK" to "at_clock", "TOLD" to "at_last", "COUNT" to "at_count")
        val NOT_FIRST = listOf("elif ", "else:", "def ", "async def ")
        val WORD = Regex("""\w+""")
        val SECTIONS: Map<String, String> by lazy { sectionsOf(templates.getValue("python/running-line.py")) }
    }
}
