package robotran.blockediting

import robotran.robolang.outline.DeclaredName
import robotran.robolang.outline.NameKind
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.LineForm

/** The result of [snippetOf]. */
sealed interface SnippetProgram {
    /**
     * A program that does only what was asked for.
     *
     * @property text its lines have the same numbers as in the whole program, in which all others are empty. Lines that
     * are not in the whole program come behind it.
     */
    data class Success(val text: String) : SnippetProgram

    /** There can be no such program. */
    data class Failure(val reason: BlockEditError) : SnippetProgram
}

/**
 * A program of the blocks of [run] alone, with all that is inside of them and what they need: the procedures and
 * functions that they call, the declarations of the names that they use, and the `robot` block. A variable begins with
 * the value of its declaration. A procedure without parameters is called.
 */
fun snippetOf(program: BlockProgram, run: BlockRun): SnippetProgram {
    val blocks = program.blocksOf(run) ?: return SnippetProgram.Failure(BlockEditError.NotFound)
    val saying = blocks.filter { it !is Block.Comment && it !is Block.Blank }
    val routine = saying.singleOrNull()?.takeIf { it.head.form in DEFINITIONS }
    if (routine != null) return trialOfRoutine(program, routine)
    if (saying.all { it.head.form in DOING_NOTHING }) return SnippetProgram.Failure(BlockEditError.NothingToTry)
    return snippetOf(program, blocks.flatMapTo(mutableSetOf()) { it.lines })
}

/** A program of [text] alone, which is not in [program] yet, with what it needs from there. */
fun snippetOf(program: BlockProgram, text: String): SnippetProgram {
    val new = program.inWords(text.removeSuffix("\n"))
    val lines = blocksOf("${program.text}\n$new", program.messages, brick = program.brick)
    val count = lines.outline.lines.size
    return snippetOf(
        lines,
        (
            count - outlineRobolang(
                new,
                program.messages,
            ).lines.size..<count
        ).toMutableSet(),
    )
}

private fun trialOfRoutine(program: BlockProgram, routine: Block): SnippetProgram {
    val name = routine.head.parts.firstOrNull { it is PhrasePart.NamePart }?.let { program.nameAt(it.span) }
    if (name == null || name.kind != NameKind.PROCEDURE || name.parameters.isNotEmpty()) {
        return SnippetProgram.Failure(BlockEditError.NothingToTry)
    }
    return snippetOf(program, "${name.text}()")
}

/** @param lines the indices of the lines that were asked for; those that they need are added. */
private fun snippetOf(program: BlockProgram, lines: MutableSet<Int>): SnippetProgram {
    program.blocks.filter { it.head.form == LineForm.ROBOT }.forEach { lines += it.lines }
    val open = program.outline.names.toMutableList()
    do {
        val needed = open.filter { name -> name.uses.any { program.lineAt(it.start).index in lines } }
        open -= needed.toSet()
        for (name in needed) {
            val declaring = program.lineAt(name.declaredAt.start).index
            if (declaring in lines) continue
            lines += program.linesToDeclare(name, declaring)
                ?: return SnippetProgram.Failure(BlockEditError.ValueUnknown(name.text))
        }
    } while (needed.isNotEmpty())
    val kept = program.outline.lines.map { if (it.index in lines) it.span.textIn(program.text) else "" }
    return SnippetProgram.Success(kept.joinToString("\n"))
}

/** The lines that declare [name]; null if it has a value only while the lines around it run. */
private fun BlockProgram.linesToDeclare(name: DeclaredName, declaring: Int): Iterable<Int>? = when (name.kind) {
    NameKind.CONSTANT, NameKind.VARIABLE -> listOf(declaring)
    NameKind.PROCEDURE, NameKind.FUNCTION -> blockOfLine(declaring)?.lines ?: listOf(declaring)
    NameKind.PARAMETER, NameKind.LOOP_VARIABLE -> null
}

private val DEFINITIONS = setOf(LineForm.PROCEDURE, LineForm.FUNCTION)

/** What says something about other lines only. */
private val DOING_NOTHING = DEFINITIONS + LineForm.ROBOT + LineForm.entries.filter { it.isSetting }
