package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.BrickButton
import robotran.brick.program.CallFrame
import robotran.brick.program.StepKind
import robotran.brick.program.VariableScope
import robotran.brick.program.VariableView
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Penbot
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class SteppingTest {
    private suspend fun started(source: String): Session = startedForDebugging(source)

    @Test
    fun `a step does one statement and stops before the next`() = runTest {
        val session = started("repeat 2 times\n  beep\n  show 1\nend\nbeep")
        assertEquals(1, session.line())
        val steps = Array(7) { StepKind.INTO }
        assertEquals(listOf(2, 3, 1, 2, 3, 1, 5), session.lines(*steps))
        assertEquals(StopReason.Ended, session.stepStatement(StepKind.INTO))
    }

    @Test
    fun `statements of one millisecond are stopped between`() = runTest {
        val session = started("beep\nbeep\nbeep\nbeep")
        session.lines(StepKind.INTO)
        val calls = session.state.romCalls
        session.lines(StepKind.INTO)
        assertEquals(calls + 1, session.state.romCalls)
    }

    @Test
    fun `sensors read the same, with all their noise, whether a run is stepped or not`() = runTest {
        val noisy = BuiltInWorlds.plain.copy(realism = 1.0, seed = 7)
        val source = "repeat 200 times\n  show light\n  show light\n  wait 1 milliseconds\nend"
        val stepped = startedForDebugging(source, noisy)
        val whole = startedForDebugging(source, noisy)
        while (stepped.stepStatement(StepKind.INTO) != StopReason.Ended) assertTrue(stepped.state.milliseconds < 60_000)
        assertEquals(StopReason.Ended, whole.runUntilStop(60_000))
        assertEquals(whole.state.romCalls, stepped.state.romCalls)
        assertEquals(whole.traceHash, stepped.traceHash)
    }

    @Test
    fun `a step over a drive takes the time of the drive`() = runTest {
        val session = started("forward 10\nbeep")
        session.lines(StepKind.OVER)
        assertEquals(10.0 * Penbot.MILLISECONDS_PER_CENTIMETRE, session.state.milliseconds.toDouble(), 3.0)
    }

    @Test
    fun `a step that takes too long goes on at the next call`() = runTest {
        val session = started("forward 10\nbeep")
        assertEquals(StopReason.TimeUp, session.stepStatement(StepKind.INTO, milliseconds = 100))
        assertEquals(100, session.state.milliseconds)
        assertEquals(listOf(2), session.lines(StepKind.INTO))
    }

    @Test
    fun `a breakpoint in a loop stops in every round`() = runTest {
        val session = started("repeat 3 times\n  beep\n  wait 50 milliseconds\nend\nshow 1")
        session.breakpoints = setOf(Breakpoint(3))
        val times = (1..3).map {
            assertEquals(StopReason.Breakpoint(3), session.runUntilStop(1_000))
            assertEquals(3, session.line())
            session.state.milliseconds
        }
        assertEquals(times, times.sorted())
        assertTrue(times[1] - times[0] in 50..53)
        assertEquals(StopReason.Ended, session.runUntilStop(1_000))
    }

    @Test
    fun `a breakpoint on the first line stops before anything happens`() = runTest {
        val session = started("beep")
        val calls = session.state.romCalls
        session.breakpoints = setOf(Breakpoint(1))
        assertEquals(StopReason.Breakpoint(1), session.runUntilStop(1_000))
        assertEquals(calls, session.state.romCalls)
    }

    @Test
    fun `a run with no stop on its way ends with its time`() = runTest {
        val session = started("wait 5 seconds")
        session.breakpoints = setOf(Breakpoint(7))
        assertEquals(StopReason.TimeUp, session.runUntilStop(300))
        assertEquals(300, session.state.milliseconds)
    }

    @Test
    fun `with no program time passes and no step is made`() = runTest {
        val session = Session(BuiltInWorlds.plain, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH)
        assertEquals(StopReason.TimeUp, session.runUntilStop(20))
        assertEquals(StopReason.Ended, session.stepStatement(StepKind.INTO))
        assertEquals(20, session.state.milliseconds)
        assertEquals(emptyList(), session.callStack)
    }

    @Test
    fun `pausing changes nothing about a run`() = runTest {
        val source = "repeat 4 times\n  beep\n  forward 2\n  show 1\n  show 2\n  turn left 90\nend"
        val straight = started(source).apply { advance(9_000) }
        val stepped = started(source)
        stepped.breakpoints = setOf(Breakpoint(4))
        while (stepped.runUntilStop(9_000) != StopReason.Ended) {
            stepped.stepStatement(StepKind.INTO)
            stepped.stepStatement(StepKind.INTO, milliseconds = 1)
        }
        stepped.advance(9_000 - stepped.state.milliseconds.toInt())
        assertEquals(straight.traceHash, stepped.traceHash)
        assertEquals(straight.state, stepped.state)
    }

    @Test
    fun `what is done to a stopped session can be repeated`() = runTest {
        val session = started("beep\nbeep\nbeep\nforward 20")
        session.lines(StepKind.INTO)
        session.apply(SessionInput.Press(BrickButton.VIEW))
        session.advance(500)
        session.apply(SessionInput.Stop)
        session.advance(100)
        val target = RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
        val program =
            compileRobolang(
                "test",
                "beep\nbeep\nbeep\nforward 20",
                target,
                messages = RobolangMessages.of(Language.ENGLISH),
            )
        val loads = listOf(RobotProgramSet(listOf(assertIs<RobolangResult.Success>(program).program)))
        val again = Session.replay(
            BuiltInWorlds.plain,
            loads,
            loadPhysicsEngine(),
            session.inputs,
            session.state.milliseconds,
            language = Language.ENGLISH,
        )
        assertEquals(session.traceHash, again.traceHash)
    }

    @Test
    fun `a step goes into a routine, over it or out of it`() = runTest {
        val source = "procedure inner()\n  beep\n  beep\nend\nprocedure outer()\n  inner()\n  beep\nend\nouter()\nbeep"
        val into = started(source)
        assertEquals(9, into.line())
        assertEquals(listOf(6, 2, 3), into.lines(StepKind.INTO, StepKind.INTO, StepKind.INTO))
        assertEquals(listOf(7, 10), into.lines(StepKind.OUT, StepKind.OUT))
        assertEquals(listOf(10), started(source).lines(StepKind.OVER))
        assertEquals(listOf(6, 7, 10), started(source).lines(StepKind.INTO, StepKind.OVER, StepKind.OVER))
    }

    @Test
    fun `a step over a recursive call stays in its own call`() = runTest {
        val session = started("procedure down(n)\n  if n > 0\n    down(n - 1)\n    show n\n  end\nend\ndown(2)")
        assertEquals(listOf(2, 3, 4), session.lines(StepKind.INTO, StepKind.OVER, StepKind.OVER))
        assertEquals(listOf(VariableView("n", "2")), session.variables.first().variables)
    }

    @Test
    fun `the call stack names each call with its line`() = runTest {
        val session =
            started("function fall(n)\n  if n == 0\n    return 0\n  end\n  return fall(n - 1)\nend\nshow fall(2)")
        session.breakpoints = setOf(Breakpoint(3))
        assertEquals(StopReason.Breakpoint(3), session.runUntilStop(100))
        val expected = listOf(CallFrame("fall", 3), CallFrame("fall", 5), CallFrame("fall", 5), CallFrame("test", 7))
        assertEquals(expected, session.callStack)
    }

    @Test
    fun `variables are shown by scope`() = runTest {
        val session = started(
            "const side = 20\nvar tones = [1, 2]\nvar found = false\n" +
                "procedure go(way)\n  var half = way / 2.0\n  beep\n  show half\nend\n" +
                "show side + length(tones)\nif not found\n  go(5)\nend",
        )
        session.breakpoints = setOf(Breakpoint(6))
        assertEquals(StopReason.Breakpoint(6), session.runUntilStop(100))
        val routine = VariableScope("go", listOf(VariableView("way", "5"), VariableView("half", "2.5")))
        val main = VariableScope(
            "test",
            listOf(VariableView("side", "20"), VariableView("tones", "[1, 2]"), VariableView("found", "false")),
        )
        assertEquals(listOf(routine, main), session.variables)
    }
}
