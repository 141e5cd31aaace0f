package robotran.blockediting

import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.textediting.EditHistory
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class RandomEditsTest {
    @Test
    fun `random edits make the blocks that they should, and can all be undone`() {
        val random = Random(SEED)
        val done = allPrograms.values.shuffled(random).take(PROGRAMS).sumOf { checkEdits(it, random, EDITS) }
        assertTrue(done > PROGRAMS * EDITS / 2, "$done edits were possible")
    }

    private companion object {
        const val SEED = 7
        const val PROGRAMS = 12
        const val EDITS = 200
    }
}

/** Makes [count] random edits and undoes them all. Returns how many were possible. */
internal fun checkEdits(text: String, random: Random, count: Int): Int {
    var program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))
    var history = EditHistory()
    val texts = mutableListOf(text)
    repeat(count) {
        val edit = randomEdit(program, random)
        val result = apply(program, edit)
        if (result !is BlockEditResult.Success) return@repeat
        checkEdit(program, edit, result)
        history = history.recorded(TextDocument(program.text), TextDocument(result.program.text), EditKind.OTHER)
        if (result.program.text != program.text) texts += result.program.text
        program = result.program
    }
    var draft = TextDocument(program.text)
    for (earlier in texts.asReversed().drop(1)) {
        val (undone, rest) = checkNotNull(history.undone(draft))
        assertEquals(earlier, undone.text)
        draft = undone
        history = rest
    }
    return texts.size - 1
}

private fun checkEdit(program: BlockProgram, edit: BlockEdit, result: BlockEditResult.Success) {
    val said = "$edit of\n${program.text}\nis\n${result.program.text}"
    try {
        checkConsistent(program, result)
    } catch (failure: IllegalStateException) {
        throw AssertionError(said, failure)
    }
    TreeModel.of(program).after(program, edit)?.let { assertEquals(it, TreeModel.of(result.program).toString(), said) }
    assertEquals(result.program.all.size, result.program.all.map { it.id }.toSet().size, said)
    if (edit is BlockEdit.Move || edit is BlockEdit.Insert || edit is BlockEdit.Delete || edit is BlockEdit.Duplicate) {
        checkUntouched(program, edit, result, said)
    }
}

/** Checks that all lines that the edit is not about are still there, byte for byte and in order. */
private fun checkUntouched(program: BlockProgram, edit: BlockEdit, result: BlockEditResult.Success, said: String) {
    val touched = when (edit) {
        is BlockEdit.Move -> checkNotNull(program.linesOf(edit.run))
        is BlockEdit.Delete -> checkNotNull(program[edit.blocks.single()]).lines
        else -> IntRange.EMPTY
    }
    val after = result.program.outline.lines.map { it.span.textIn(result.program.text) }
    var position = 0
    for (line in program.outline.lines.take(program.lineCount)) {
        if (line.index in touched) continue
        val content = line.span.textIn(program.text)
        while (position < after.size && after[position] != content) position++
        assertTrue(position < after.size, "line ${line.index + 1} is lost: $said")
        position++
    }
}
