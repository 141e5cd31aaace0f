package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.BrickButton
import robotran.brick.program.CallFrame
import robotran.brick.program.DebugStatement
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.StatementWatch
import robotran.brick.program.StepKind
import robotran.brick.program.ThreadActivity
import robotran.brick.program.VariableScope
import robotran.brick.program.VariableView
import robotran.language.Language
import robotran.lejoslibrary.LejosLibrary
import robotran.simulation.physics.loadPhysicsEngine
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.linkTinyVm
import robotran.tinyvm.messages.TinyVmMessages
import robotran.world.file.BuiltInWorlds
import kotlin.io.encoding.Base64
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Steps through `Stepped.java`, whose second thread counts while main sleeps. */
class ThreadSteppingTest {
    private suspend fun started(): Session {
        val classes = steppedPrograms.entries.associate { (path, bytes) ->
            path.substringAfter('/').removeSuffix(".class") to Base64.decode(bytes)
        }
        val library = LejosLibrary.classNames.associateWith { checkNotNull(LejosLibrary.classFile(it)) }
        val program = assertIs<TinyVmResult.Success>(
            linkTinyVm("Stepped", classes, library, messages = TinyVmMessages.of(Language.ENGLISH)),
        ).program
        return Session(BuiltInWorlds.plain, listOf(program), loadPhysicsEngine(), Language.ENGLISH).apply {
            apply(SessionInput.Press(BrickButton.RUN))
            apply(SessionInput.Release(BrickButton.RUN))
        }
    }

    private fun Session.current() = threads.single { it.isCurrent }

    @Test
    fun `a step over stays with its thread though others go on`() = runTest {
        val session = started()
        session.runTo(21)
        session.breakpoints = emptySet()
        assertEquals(listOf(22, 23), session.lines(StepKind.OVER, StepKind.OVER))
        assertEquals(listOf("main"), session.threads.map { it.name })
    }

    @Test
    fun `a breakpoint that names the only file stops there`() = runTest {
        val session = started()
        session.breakpoints = setOf(Breakpoint(21, "Stepped.java"))
        assertEquals(StopReason.Breakpoint(21), session.runUntilStop(1_000))
    }

    @Test
    fun `a step while all threads sleep stops behind the sleep`() = runTest {
        val session = started()
        session.advance(80)
        assertEquals(listOf(CallFrame("Stepped.main", 21)), session.callStack)
        assertEquals(listOf(22), session.lines(StepKind.INTO))
    }

    @Test
    fun `a step out stays with its thread`() = runTest {
        val session = started()
        session.runTo(13)
        assertEquals(listOf(21), session.lines(StepKind.OUT))
    }

    @Test
    fun `a step into something that waits goes on in another thread`() = runTest {
        val session = started()
        session.runTo(21)
        session.breakpoints = emptySet()
        assertEquals(listOf(7), session.lines(StepKind.INTO))
        assertEquals("Stepped", session.current().name)
        session.lines(StepKind.INTO)
        assertEquals("Stepped", session.current().name)
    }

    @Test
    fun `a step of a thread that ends goes on in another`() = runTest {
        val session = started()
        session.runTo(8)
        session.breakpoints = emptySet()
        assertEquals(listOf(22), session.lines(StepKind.OUT))
        assertEquals("main", session.current().name)
    }

    @Test
    fun `a step of a chosen thread waits for it, whatever the others do`() = runTest {
        val session = started()
        session.runTo(8)
        session.breakpoints = emptySet()
        val main = session.threads.single { it.name == "main" }.number
        for ((kind, line) in listOf(StepKind.INTO to 22, StepKind.INTO to 13, StepKind.OUT to 23)) {
            assertEquals(StopReason.StepDone, session.stepStatement(kind, thread = main))
            assertEquals(line, session.threads.single { it.number == main }.callStack.first().sourceLine)
        }
    }

    @Test
    fun `the first step from a while goes into its loop`() = runTest {
        val session = started()
        session.runTo(7)
        session.breakpoints = emptySet()
        assertEquals(listOf(8, 7, 8), session.lines(StepKind.OVER, StepKind.OVER, StepKind.OVER))
    }

    @Test
    fun `a breakpoint stops any thread and all can be looked into`() = runTest {
        val session = started()
        session.runTo(8)
        val (main, other) = session.threads
        assertEquals(ThreadActivity.SLEEPING to false, main.activity to main.isCurrent)
        assertEquals(ThreadActivity.RUNNABLE to true, other.activity to other.isCurrent)
        assertEquals(listOf(CallFrame("Stepped.main", 21)), main.callStack)
        assertEquals(listOf(CallFrame("Stepped.run", 8)), other.callStack)
        assertTrue(VariableView("first", "6") in session.variablesOf(main.number, 0).first().variables)
        assertTrue(
            VariableView("count", "0") in session.variablesOf(other.number, 0).first { it.name == "this" }.variables,
        )
        assertEquals(emptyList(), session.variablesOf(7, 0))
    }

    @Test
    fun `the variables of every call in a call stack can be seen`() = runTest {
        val session = started()
        session.runTo(14)
        val main = session.current().number
        assertEquals(listOf("Stepped.twice", "Stepped.main"), session.callStack.map { it.name })
        val twice = VariableScope("Stepped.twice", listOf(VariableView("number", "3"), VariableView("result", "6")))
        assertEquals(twice, session.variablesOf(main, 0).first())
        assertEquals(listOf("arguments", "other"), session.variablesOf(main, 1).first().variables.map { it.name })
    }

    @Test
    fun `a breakpoint of a file stops in this file only`() {
        val stepping = Stepping(0, StandingRun, setOf(Breakpoint(7, "Robot.java"), Breakpoint(9)))
        assertFalse(stepping.pausesBefore(DebugStatement(7, 0, sourceFile = "Other.java")))
        assertTrue(stepping.pausesBefore(DebugStatement(7, 0, sourceFile = "Robot.java")))
        assertEquals(StopReason.Breakpoint(7, "Robot.java"), stepping.reason)
        assertTrue(stepping.pausesBefore(DebugStatement(9, 0, sourceFile = "Other.java")))
    }

    /** A run that stays before its first statement. */
    private object StandingRun : DebuggableRun {
        override val callStack = listOf(CallFrame("main", 1))
        override val variables = emptyList<VariableScope>()
        override val statementsBegun = 0L
        override val isBeforeStatement = true
        override var watch: StatementWatch? = null
        override val sourceLine = 1

        override fun resume(steps: Int) = ProgramStatus.Running
    }
}
