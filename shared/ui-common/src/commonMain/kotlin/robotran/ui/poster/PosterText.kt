package robotran.ui.poster

import androidx.compose.ui.graphics.Color
import robotran.brick.kind.BrickKind
import robotran.languagesupport.CodeTokens
import robotran.languagesupport.TextLines
import robotran.programs.Program
import robotran.programs.support
import robotran.ui.code.codeColoursFor
import robotran.uikit.*

/** The lines of [program] in the colours of the editor; a program of several files has their names between them. */
internal fun codeLines(program: Program): List<List<PosterRun>> = program.files.flatMapIndexed { index, file ->
    val text = file.text.trimEnd()
    val lines = TextLines(text)
    val tokens = CodeTokens(lines, program.language.support.code, BrickKind.default)
    val heading = if (program.files.size == 1) emptyList() else headingOf(file.name, isFirst = index == 0)
    heading + (0..<lines.count).map { line -> runsOf(lines.line(line), tokens, line) }
}

private fun headingOf(name: String, isFirst: Boolean): List<List<PosterRun>> =
    listOfNotNull(emptyList<PosterRun>().takeIf { !isFirst }, listOf(PosterRun("// $name", COLOURS.comment)))

private fun runsOf(line: String, tokens: CodeTokens, index: Int): List<PosterRun> = buildList {
    var column = 0
    for (token in tokens.of(index)) {
        if (token.start > column) add(PosterRun(line.substring(column, token.start), COLOURS.plain))
        add(PosterRun(line.substring(token.start, token.end), COLOURS.of(token.kind)))
        column = token.end
    }
    if (column < line.length) add(PosterRun(line.substring(column), COLOURS.plain))
}.map { PosterRun(it.words.replace("\t", TAB), it.colour) }

/**
 * The line of [runs] in lines of at most [columns] characters; what does not fit is indented a little more than the
 * line begins.
 */
internal fun wrapped(runs: List<PosterRun>, columns: Int): List<List<PosterRun>> {
    val length = runs.sumOf { it.words.length }
    if (length <= columns) return listOf(runs)
    val text = runs.joinToString("") { it.words }
    val indent = minOf(text.length - text.trimStart().length + CONTINUATION, columns / 2)
    val lines = mutableListOf(mutableListOf<PosterRun>())
    var room = columns
    for (run in runs) {
        var words = run.words
        while (words.length > room) {
            // An emoji is not cut in two.
            val cut = if (room > 0 && words[room - 1].isHighSurrogate()) room - 1 else room
            lines.last() += PosterRun(words.take(cut), run.colour)
            words = words.drop(cut)
            lines += mutableListOf(PosterRun(" ".repeat(indent), run.colour))
            room = columns - indent
        }
        if (words.isNotEmpty()) lines.last() += PosterRun(words, run.colour)
        room -= words.length
    }
    return lines
}

private val COLOURS = codeColoursFor(RobotranColours.LIGHT)
private const val TAB = "  "
private const val CONTINUATION = 4

/** The colours of the texts around the program. */
internal val TITLE_COLOUR: Color = RobotranColours.LIGHT.onPane
internal val QUIET_COLOUR: Color = RobotranColours.LIGHT.quiet
