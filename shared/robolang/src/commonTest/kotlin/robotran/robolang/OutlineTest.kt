package robotran.robolang

import robotran.language.Language
import robotran.robolang.format.FormatResult
import robotran.robolang.format.formatRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.LineRole
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.ProgramOutline
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueUse
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class OutlineTest {
    private val programs = testPrograms + examplePrograms

    private fun ProgramOutline.words(line: OutlineLine): List<String> = line.parts.map { it.span.textIn(source) }

    @Test
    fun `the lines of any program cover it`() {
        for ((name, program) in programs) {
            val outline = outlineRobolang(program, messages = RobolangMessages.of(Language.ENGLISH))
            var end = 0
            for (line in outline.lines) {
                assertEquals(end, line.span.start, name)
                assertTrue(line.parts.zipWithNext().all { (one, next) -> one.span.end <= next.span.start }, name)
                assertTrue(line.parts.all { it.span in line.span }, name)
                end = line.end
            }
            assertEquals(program.length, end, name)
        }
    }

    @Test
    fun `the blocks of a program without mistakes are those that the formatter indents`() {
        var lines = 0
        for ((name, program) in programs) {
            val formatted =
                (
                    formatRobolang(
                        program,
                        messages = RobolangMessages.of(Language.ENGLISH),
                    ) as? FormatResult.Success
                )?.text
                    ?: continue
            for (line in outlineRobolang(formatted, messages = RobolangMessages.of(Language.ENGLISH)).lines) {
                val text = line.span.textIn(formatted)
                if (line.role == LineRole.BLANK) continue
                assertEquals(2 * line.depth, text.length - text.trimStart().length, "$name: $text")
                assertEquals(line.role == LineRole.COMMENT, line.form == null, "$name: $text")
                lines++
            }
        }
        assertTrue(lines > 2_000, "$lines lines")
    }

    @Test
    fun `a line has its form, and values with what they are for`() {
        val outline =
            outlineRobolang(
                "turn  right 90 + x degrees // far\nmotor a float\nvar list = [1, 2]\nshow list[0]\n",
                messages = RobolangMessages.of(Language.ENGLISH),
            )
        val (turn, motor, list, show) = outline.lines
        assertEquals(LineForm.TURN, turn.form)
        assertEquals(listOf("turn", "right", "90 + x", "degrees"), outline.words(turn))
        assertEquals(ValueUse.ANGLE, (turn.parts[2] as PhrasePart.Value).use)
        assertEquals(listOf("left", "right"), (turn.parts[1] as PhrasePart.Choice).options)
        assertEquals("// far", turn.comment?.textIn(outline.source))
        assertEquals(listOf("A", "B", "C"), (motor.parts[1] as PhrasePart.Choice).options)
        assertEquals(
            listOf("[", "1", ",", "2", "]"),
            (list.parts.last() as PhrasePart.Value).value.parts.map { it.span.textIn(outline.source) },
        )
        val element = (show.parts.last() as PhrasePart.Value).value
        assertEquals(
            listOf(ValueUse.LIST, ValueUse.INDEX),
            element.parts.filterIsInstance<PhrasePart.Value>().map { it.use },
        )
    }

    @Test
    fun `a line with a mistake has no form but its message, and its neighbours keep theirs`() {
        val outline =
            outlineRobolang(
                "repeat 4 times\n  forwrd 20\n  beep\nend\nshow 3000000000\n\"\n",
                messages = RobolangMessages.of(Language.ENGLISH),
            )
        assertEquals(
            listOf(LineForm.REPEAT, null, LineForm.BEEP, LineForm.END, null, null, null),
            outline.lines.map { it.form },
        )
        assertEquals(listOf(0, 1, 1, 0, 0, 0, 0), outline.lines.map { it.depth })
        assertNotNull(outline.lines[1].error)
    }

    @Test
    fun `a block without its end keeps its form and has the message`() {
        val line = outlineRobolang(
            "repeat 4 times\nbeep",
            messages = RobolangMessages.of(Language.ENGLISH),
        ).lines.first()
        assertEquals(LineForm.REPEAT, line.form)
        assertNotNull(line.error)
        assertNull(
            outlineRobolang("show x", messages = RobolangMessages.of(Language.ENGLISH)).lines.first().error,
            "names are the checker's",
        )
    }

    @Test
    fun `names of inner blocks end with them`() {
        val outline =
            outlineRobolang(
                "var a = 1\nif a == 1\n  var b = a\n  beep\nelse\n  beep\nend\nbeep\n",
                messages = RobolangMessages.of(Language.ENGLISH),
            )

        fun names(line: Int) = outline.namesBefore(line).map { it.text }
        assertEquals(listOf("a", "b"), names(3))
        assertEquals(listOf("a"), names(5))
        assertEquals(listOf("a"), names(7))
        assertEquals(3, outline.names.first().uses.size)
    }
}
