package robotran.robolang

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueForm
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull

/** What depends on the brick of the robot. */
class BrickTest {
    private fun onNxt(source: String): List<Diagnostic> = when (val result = read(source, testNxt)) {
        is RobolangResult.Success -> emptyList()
        is RobolangResult.Failure -> result.diagnostics
    }

    @Test
    fun `a program without a header is for the brick of the robot`() {
        assertEquals(emptyList(), onNxt("show distance\nmotor B turn 90"))
        assertEquals(BrickKind.NXT, assertIs<RobolangResult.Success>(read("beep", testNxt)).program.kind)
        assertEquals(BrickKind.RCX, assertIs<RobolangResult.Success>(read("beep")).program.kind)
        assertEquals(DiagnosticCode.BRICK_LACKS, errorsOf("show distance").single().code)
    }

    @Test
    fun `a header that names another brick is the only mistake`() {
        val header = "robot\n  brick nxt\nend\nshow distance\nshow \"sixteen letters.\""
        assertEquals(listOf(DiagnosticCode.WRONG_BRICK), errorsOf(header).map { it.code }.take(1))
        assertEquals(emptyList(), onNxt(header))
        assertEquals(DiagnosticCode.WRONG_BRICK, onNxt("robot\n  brick rcx\nend\nbeep").single().code)
    }

    @Test
    fun `the brick of a header is told without compiling`() {
        assertEquals(BrickKind.NXT, brickOfRobolang("beep\nROBOT\n  Brick NXT // new\nend"))
        assertEquals(BrickKind.RCX, brickOfRobolang("robot\nbrick rcx\n"))
        assertNull(brickOfRobolang("robot\nend\nbeep"))
        assertNull(brickOfRobolang("var brick = 1\nbrick = nxt"))
        assertNull(brickOfRobolang("\uD83E brick"))
    }

    @Test
    fun `a button of the other brick has a fix`() {
        val fixes = listOf("enter", "left", "right", "escape").map { button ->
            errorsOf("wait until button $button").single().fix?.replacement
        }
        assertEquals(listOf("button run", "button prgm", "button view", null), fixes)
        assertEquals(emptyList(), onNxt("wait until button run or button view or button prgm"))
    }

    @Test
    fun `the older names of variables stay names`() {
        val words = listOf("distance", "loudness", "colour", "turned", "red", "white", "brick", "nxt", "sonar", "enter")
        for (word in words) {
            assertEquals(emptyList(), errorsOf("var $word = 1\n$word = -$word - 1\nforward $word"), word)
            assertEquals(emptyList(), errorsOf("procedure p($word)\n  show $word\nend\np(1)"), word)
            assertEquals(emptyList(), errorsOf("for each $word in [1]\n  show $word\nend"), word)
        }
    }

    @Test
    fun `the outline knows the forms of an NXT`() {
        val source = "robot\n  brick nxt\n  sonar on 4\nend\nmotor A turn 90\nstart motor b turn 45 degrees\n" +
            "reset motor C\nshow turned A - 1\nwait until color == red"
        val outline = outlineRobolang(source, messages = RobolangMessages.of(Language.ENGLISH))
        val forms = listOf(
            LineForm.ROBOT,
            LineForm.BRICK,
            LineForm.SONAR,
            LineForm.END,
            LineForm.MOTOR_TURN,
            LineForm.START_MOTOR_TURN,
            LineForm.RESET_MOTOR,
            LineForm.SHOW,
            LineForm.WAIT_UNTIL,
        )
        assertEquals(forms, outline.lines.map { it.form })
        val motor = outline.lines[5].parts.filterIsInstance<PhrasePart.Choice>().first()
        assertEquals(listOf("A", "B", "C"), motor.options)
        val comparison = outline.lines.last().parts.filterIsInstance<PhrasePart.Value>().single().value
        val operands = comparison.parts.filterIsInstance<PhrasePart.Value>().map { it.value.form }
        assertEquals(listOf(ValueForm.COLOUR, ValueForm.COLOUR_NAME), operands)
    }
}
