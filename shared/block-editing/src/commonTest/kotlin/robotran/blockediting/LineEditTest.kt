package robotran.blockediting

import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.words.LineForm
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class LineEditTest {
    @Test
    fun `blocks are wrapped in a construct, and unwrapped`() {
        val text = "beep\nforward 20 // far\nstop\n"
        val wrapped = "beep\nif left bumper\n  forward 20 // far\n  stop\nelse\nend\n"
        assertEquals(wrapped, after(text) { BlockEdit.Wrap(BlockRun(idOf("forward"), 2), "if left bumper\nelse\nend") })
        assertEquals(text, after(wrapped) { BlockEdit.Unwrap(idOf("if")) })
        assertEquals(
            "// four\n  beep\n// done\n".replace("  beep", "beep"),
            after("repeat 4 times // four\n  beep\nend // done\n") {
                BlockEdit.Unwrap(idOf("repeat"))
            },
        )
    }

    @Test
    fun `an if gets and loses its else`() {
        val text = "if left bumper\n  beep\nend\n"
        val both = "if left bumper\n  beep\nelse if light < 40\nelse\nend\n"
        val otherwise = after(text) { BlockEdit.AddElse(idOf("if")) }
        assertEquals("if left bumper\n  beep\nelse\nend\n", otherwise)
        assertEquals(both, after(otherwise) { BlockEdit.AddElse(idOf("if"), "light < 40") })
        assertEquals(otherwise, after(both) { BlockEdit.RemoveElse(idOf("if"), 1) })
        assertEquals(BlockEditError.ElseExists, editError(both) { BlockEdit.AddElse(idOf("if")) })
        assertEquals(BlockEditError.ConditionNeeded, editError(both) { BlockEdit.AddElse(idOf("if"), "5") })
        assertEquals(BlockEditError.NoSuchConstruct, editError(SQUARE) { BlockEdit.AddElse(idOf("repeat")) })
    }

    @Test
    fun `a comment is written, changed and deleted`() {
        assertEquals("beep  // hi\n", after("beep\n") { BlockEdit.SetNote(0, "hi") })
        assertEquals("beep   // ho\n", after("beep   // hi\n") { BlockEdit.SetNote(0, "ho") })
        assertEquals("beep\nstop\n", after("beep   // hi\nstop\n") { BlockEdit.SetNote(0, null) })
        assertEquals("stop\n", after("  // hi\nstop\n") { BlockEdit.SetNote(0, null) })
        assertEquals("  // hi\n", after("  \n") { BlockEdit.SetNote(0, "hi") })
        assertEquals("beep  // one two\n", after("beep\n") { BlockEdit.SetNote(0, "one\r\ntwo") })
        assertEquals(BlockEditError.NoNote, editError("show \"HI\n") { BlockEdit.SetNote(0, "hi") })
    }

    @Test
    fun `a loose line becomes what the pupil types, and its fix can be applied`() {
        assertEquals("  forward 20\n", after("  forwrd 20\n") { BlockEdit.ReplaceLine(0, "forward 20") })
        assertEquals("  beep\r\n  stop\r\n", after("  bep\r\n") { BlockEdit.ReplaceLine(0, "beep\nstop") })
        assertEquals("  forward 20\n", after("  forwrd 20\n") { BlockEdit.ApplyFix(0) })
        assertEquals(
            "\uFEFFrepeat 2 times\r\n  beep\r\nend",
            after("\uFEFFrepeat 2 times\r\n  beep") {
                BlockEdit.ApplyFix(0)
            },
        )
        assertEquals(BlockEditError.NoFix, editError("beep\n") { BlockEdit.ApplyFix(0) })
    }

    @Test
    fun `a line changes its form and keeps what fits`() {
        fun changed(line: String, form: LineForm) =
            after("$line\n") { BlockEdit.ChangeForm(0, form) }.substringBefore('\n')
        assertEquals("  backward for 2 seconds // far", changed("  backward 30 // far", LineForm.MOVE_FOR_TIME))
        assertEquals("turn right 90", changed("turn  right for 3 seconds", LineForm.TURN))
        assertEquals("power left 3", changed("power 3", LineForm.POWER_OF_SIDE))
        assertEquals("motor B power 5", changed("motor B stop", LineForm.POWER_OF_MOTOR))
        assertEquals("repeat until light > 50", changed("repeat while light > 50", LineForm.REPEAT_UNTIL))
        assertEquals("for n from 2 to 8 step 2", changed("for n from 2 to 8", LineForm.FOR_WITH_STEP))
        assertEquals("const side = 7 * 2", changed("var side = 7 * 2", LineForm.DECLARE_CONSTANT))
        assertEquals(BlockEditError.NoSuchForm, editError("beep\n") { BlockEdit.ChangeForm(0, LineForm.STOP) })
        assertEquals(BlockEditError.NoSuchForm, editError("bep\n") { BlockEdit.ChangeForm(0, LineForm.BUZZ) })
    }

    @Test
    fun `every form can change to each of its related forms`() {
        for (form in LineForm.entries) {
            for (other in formsFor(form)) {
                val text = checkNotNull(form.example)
                val changed = blocksOf(
                    text,
                    messages = RobolangMessages.of(Language.ENGLISH),
                ).done(BlockEdit.ChangeForm(0, other)).program
                assertEquals(other, changed.outline.lines.first().form, "$text to $other")
                assertTrue(form in formsFor(other))
            }
        }
    }
}
