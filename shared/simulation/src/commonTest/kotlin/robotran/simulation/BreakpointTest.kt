package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.brick.program.StepKind
import robotran.brick.state.RunState
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class BreakpointTest {
    @Test
    fun `a breakpoint on a line without a statement never stops`() = runTest {
        val session = startedForDebugging("beep\n\n// a comment\nif false\n  beep\nelse\n  beep\nend\nbeep")
        session.breakpoints = setOf(Breakpoint(2), Breakpoint(3), Breakpoint(6), Breakpoint(8), Breakpoint(12))
        assertEquals(StopReason.Ended, session.runUntilStop(1_000))
    }

    @Test
    fun `a breakpoint stops again at each call and each round`() = runTest {
        val session = startedForDebugging("procedure p()\n  beep\nend\nrepeat 2 times\n  p()\nend\np()")
        session.breakpoints = setOf(Breakpoint(2))
        repeat(3) { assertEquals(StopReason.Breakpoint(2), session.runUntilStop(1_000)) }
        assertEquals(StopReason.Ended, session.runUntilStop(1_000))
    }

    @Test
    fun `a breakpoint set while the program runs stops it from then on`() = runTest {
        val session = startedForDebugging("repeat forever\n  wait 10 milliseconds\n  beep\nend")
        assertEquals(StopReason.TimeUp, session.runUntilStop(105))
        session.breakpoints = setOf(Breakpoint(3))
        assertEquals(StopReason.Breakpoint(3), session.runUntilStop(1_000))
        session.breakpoints = emptySet()
        assertEquals(StopReason.TimeUp, session.runUntilStop(100))
    }

    @Test
    fun `a breakpoint inside a whenever stops there with a call stack of its own`() = runTest {
        val session =
            startedForDebugging("var n = 0\nwhenever n == 2\n  n = 10\n  beep\nend\nrepeat forever\n  n = n + 1\nend")
        session.runTo(4)
        assertEquals(listOf("whenever" to 4, "test" to 6), session.callStack.map { it.name to it.sourceLine })
        assertEquals(listOf("10"), session.variables.last().variables.map { it.value })
    }

    @Test
    fun `a breakpoint on the first line of a whenever stops when its action begins`() = runTest {
        val session = startedForDebugging("var n = 0\nwhenever n == 2\n  n = 10\nend\nrepeat forever\n  n = n + 1\nend")
        session.runTo(2)
        assertEquals(listOf("2"), session.variables.last().variables.map { it.value })
        assertEquals(listOf(3), session.lines(StepKind.OVER))
    }

    @Test
    fun `a breakpoint inside a function stops while it works out a condition`() = runTest {
        val session =
            startedForDebugging("function f()\n  return false\nend\nwhenever f()\n  beep\nend\nwait 1 second\nhalt")
        session.runTo(2)
        assertEquals(listOf("f", "whenever", "test"), session.callStack.map { it.name })
    }

    @Test
    fun `a step out of a whenever comes to where the main program goes on`() = runTest {
        val session = startedForDebugging("var n = 0\nwhenever n == 2\n  n = 10\n  beep\nend\nn = 2\nbuzz\nhalt")
        session.runTo(3)
        assertEquals(listOf(7), session.lines(StepKind.OUT))
    }

    @Test
    fun `a step over is ended by a whenever that takes over only where it stops`() = runTest {
        val session = startedForDebugging("var n = 0\nwhenever n == 2\n  n = 10\n  beep\nend\nn = 2\nbuzz\nhalt")
        session.runTo(6)
        session.breakpoints = emptySet()
        assertEquals(listOf(7), session.lines(StepKind.OVER))
        assertEquals(listOf("10"), session.variables.single().variables.map { it.value })
    }

    @Test
    fun `a step at the end ends the program`() = runTest {
        for (step in StepKind.entries) {
            val session = startedForDebugging("beep\nbuzz")
            session.lines(StepKind.INTO)
            assertEquals(StopReason.Ended, session.stepStatement(step))
            assertIs<RunState.Ended>(session.state.brick.run)
            assertEquals(emptyList(), session.callStack)
            assertEquals(emptyList(), session.variables)
            assertEquals(StopReason.Ended, session.stepStatement(step))
        }
    }

    @Test
    fun `a step out of the main program runs to its end`() = runTest {
        assertEquals(StopReason.Ended, startedForDebugging("beep\nbuzz\nshow 1").stepStatement(StepKind.OUT))
    }

    @Test
    fun `a step into a failing statement tells the failure`() = runTest {
        val session = startedForDebugging("var n = 0\nshow 7 / n")
        session.lines(StepKind.INTO)
        session.stepStatement(StepKind.INTO)
        val failed = assertIs<RunState.Failed>(session.state.brick.run)
        assertEquals(2, failed.failure.sourceLine)
        assertEquals("7 cannot be divided by 0.", failed.failure.message)
    }
}
