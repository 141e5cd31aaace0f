package robotran.nxt

import robotran.brick.controls.BrickButton
import robotran.brick.program.FailureCall
import robotran.brick.program.FailureCause
import robotran.brick.program.FailureFrame
import robotran.brick.program.ProgramFailure
import robotran.nxt.display.ByteArrayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.NxtDisplay
import robotran.nxt.shell.ExceptionScreen
import kotlin.test.Test
import kotlin.test.assertEquals

class ExceptionScreenTest {
    private fun rows(screen: ExceptionScreen): List<String> {
        val memory = ByteArrayMemory(ByteArray(DisplaySize.BYTES))
        screen.draw(memory)
        return NxtDisplay.of(memory).lines.map { it.trimEnd() }
    }

    private fun failure(text: String?, causes: List<FailureCause> = emptyList()) = ProgramFailure(
        "",
        sourceLine = 1,
        exceptionNumber = 28,
        stack = listOf(FailureFrame(36, 3, "main")),
        thrownText = text,
        causes = causes,
    )

    @Test
    fun `a text has one row and is cut off at the edge`() {
        val rows = rows(ExceptionScreen(failure("a text that is too long for it")))
        assertEquals(listOf("Exception: 28", "a text that is t", " at:   36:3", ""), rows.take(4))
    }

    @Test
    fun `without a text the calls follow at once`() {
        assertEquals(listOf("Exception: 28", " at:   36:3", ""), rows(ExceptionScreen(failure(null))).take(3))
    }

    @Test
    fun `what caused it follows, and RIGHT moves to it`() {
        val causes = listOf(
            FailureCause(66, "first", listOf(FailureCall(40, 7), FailureCall(36, 1))),
            FailureCause(16, null, listOf(FailureCall(1234, 12), FailureCall(36, 0))),
        )
        val screen = ExceptionScreen(failure("out", causes))
        repeat(9) { screen.press(BrickButton.RIGHT) }
        assertEquals(
            listOf(
                " at:   36:3",
                "Caused by: 66",
                "first",
                " at:   40:7",
                " at:   36:1",
                "Caused by: 16",
                " at: 1234:12",
                " at:   36:0",
            ),
            rows(screen),
        )
    }
}
