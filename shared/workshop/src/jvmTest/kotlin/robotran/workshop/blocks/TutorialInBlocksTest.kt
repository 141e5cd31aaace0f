package robotran.workshop.blocks

import robotran.blockediting.BlockEdit
import robotran.blockediting.messages.BlockMessages
import robotran.blockediting.palette.Palette
import robotran.blockediting.palette.PaletteBlock
import robotran.blockediting.palette.ownBlocks
import robotran.language.Language
import robotran.learning.Lesson
import robotran.learning.Lessons
import robotran.robolang.words.LineForm
import robotran.workshop.event.BlockEvent
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNull

class TutorialInBlocksTest {
    @Test
    fun `lessons are solved in blocks with what they have introduced, from the groups that their solution names`() {
        for (step in SOLUTIONS.keys.map { checkNotNull(Lessons.named(it)) }) {
            onBlocks(step.program.text) {
                val pupil = Pupil(this, blocksIntroducedBy(Lessons.all.indexOf(step)))
                SOLUTIONS.getValue(step.name)(pupil)
                assertEquals(linesOf(step.solution.text), linesOf(text), step.name)
                assertHintNames(step, pupil.taken)
            }
        }
    }

    private fun assertHintNames(step: Lesson, taken: List<PaletteBlock>) {
        for (language in Language.entries) {
            val hint = step.text(language, inBlocks = true).solution
            for (block in taken) {
                assertContains(hint, BlockMessages.of(language).group(block.group), message = "${step.name}: $hint")
            }
        }
    }

    private fun linesOf(text: String) = text.lines().filter { it.isNotBlank() }

    private companion object {
        val SOLUTIONS: Map<String, Pupil.() -> Unit> = mapOf(
            "first-drive" to {
                touch("forward 20")
                change("20", "30")
                touch("turn left 90")
                take("move")
                change("20", "25")
            },
            "pen" to {
                touch("pen up")
                take("move")
                change("20", "10")
                take("pen")
                take("move")
                take("pen")
                change("down", "up")
            },
            "repeat" to {
                touch("repeat 4 times")
                change("4", "6")
                touch("turn left 90")
                change("90", "60")
            },
            "variables" to {
                touch("side = side + 2")
                change("2", "5")
            },
            "counting" to {
                touch("for i from 1 to 3")
                makeIt(LineForm.FOR_WITH_STEP)
                change("1", "5")
                change("3", "1")
                changeLast("-1")
                touch("end")
                take("move")
                change("20", "45")
            },
            "bumpers" to {
                touch("if left bumper")
                addElse()
                touch("else")
                take("move")
                change("forward", "backward")
                change("20", "5")
                take("turn")
            },
            "light" to {
                touch("end")
                take("repeat-until")
                change("<", ">")
                change("40", "45")
                take("move")
                change("20", "2")
                touch("end", isLast = true)
                take("repeat-until")
                take("move")
                change("20", "2")
            },
            "own-commands" to {
                touch("square(20)")
                take("move")
                change("20", "30")
                take("call")
                changeLast("10")
                take("move")
                take("call")
                changeLast("15")
            },
            "whenever" to {
                touch("end")
                take("whenever")
                change("left", "right")
                take("move")
                change("forward", "backward")
                change("20", "5")
                take("turn")
                change("90", "20")
            },
        )
    }
}

/** A pupil who types nothing and sees a palette with the blocks [introduced]. */
private class Pupil(private val blocks: OnBlocks, private val introduced: Set<String>) {
    val taken = mutableListOf<PaletteBlock>()
    private val line get() = checkNotNull(blocks.state.program.lineOf(checkNotNull(blocks.state.cursor)))

    fun touch(words: String, isLast: Boolean = false) {
        val found = blocks.state.list.rows.filter { it.line?.span?.textIn(blocks.text)?.trim() == words }
        blocks.send(BlockEvent.CursorPut(if (isLast) found.last().cursor else found.first().cursor))
    }

    fun take(id: String) {
        assertContains(introduced, id)
        val state = blocks.state
        val block = (Palette.blocks + ownBlocks(state.program, state.placeForNew)).first { it.id == id }
        blocks.send(BlockEvent.Taken(block))
        taken += block
        assertNull(blocks.state.error)
    }

    /** Touches [old] in the line that was touched or taken last, and chooses or types [new]. */
    fun change(old: String, new: String) =
        put(line.editableParts.indexOfFirst { it.span.textIn(blocks.text) == old }, new)

    fun changeLast(new: String) = put(line.editableParts.lastIndex, new)

    private fun put(part: Int, new: String) {
        blocks.send(BlockEvent.DialogShown(BlockDialog.Part(line.editableParts[part].span)))
        blocks.send(BlockEvent.Put(new))
        blocks.send(BlockEvent.DialogShown(null))
        assertNull(blocks.state.error)
    }

    fun makeIt(form: LineForm) = blocks.edit(BlockEdit.ChangeForm(line.index, form))

    fun addElse() = blocks.edit(BlockEdit.AddElse(checkNotNull(blocks.state.cursor).block))
}
