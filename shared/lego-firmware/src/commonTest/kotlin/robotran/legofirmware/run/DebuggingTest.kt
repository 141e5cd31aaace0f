package robotran.legofirmware.run

import robotran.brick.controls.BrickButton
import robotran.brick.program.CallFrame
import robotran.brick.program.DebugStatement
import robotran.brick.program.DebuggableRun
import robotran.brick.program.StatementWatch
import robotran.brick.program.ThreadActivity
import robotran.brick.program.VariableScope
import robotran.brick.program.VariableView
import robotran.language.Language
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.Vectors
import robotran.legofirmware.assembly.AssemblyResult
import robotran.legofirmware.assembly.assemble
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.VariableTable
import robotran.legofirmware.listing.assemblyListing
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

class DebuggingTest {
    @Test
    fun `a watch pauses before each instruction of an assembly text, and the brick's clock stands still`() {
        val brick = started(programOf("task 0\n setv 0, 2, 1\n calls 0\nendt\nsub 0\n setv 1, 2, 2\nends"))
        val seen = mutableListOf<DebugStatement>()
        run(brick).watch = StatementWatch { seen.add(it) }
        brick.tick()
        assertTrue(brick.isPaused)
        val now = brick.state.milliseconds
        assertEquals(listOf(DebugStatement(2, 0)), seen)
        assertTrue(run(brick).isBeforeStatement)
        brick.tick()
        assertEquals(now, brick.state.milliseconds)
        repeat(20) { brick.tick() }
        assertEquals(listOf(DebugStatement(2, 0), DebugStatement(3, 0), DebugStatement(6, 1)), seen)
        assertEquals(null, brick.debuggableRun)
    }

    @Test
    fun `a message that waits for another is one statement`() {
        val brick = started(programOf("task 0\n msg 2, 1\n msg 2, 2\n plays 0\nendt"))
        val seen = mutableListOf<Int>()
        run(brick).watch = StatementWatch {
            seen += it.sourceLine
            false
        }
        repeat(200) { brick.tick() }
        assertEquals(listOf(2, 3, 4), seen)
    }

    @Test
    fun `a watch that never pauses changes nothing`() {
        val histories = listOf(null, StatementWatch { false }).map { watch ->
            val brick = started(programOf(DRIVER))
            run(brick).watch = watch
            List(500) {
                brick.tick()
                brick.state
            }
        }
        assertEquals(histories[0], histories[1])
    }

    @Test
    fun `tasks are threads with their calls and variables`() {
        val brick = started(programOf(DRIVER))
        repeat(30) { brick.tick() }
        val threads = run(brick).threads
        assertEquals(listOf("main", "task 1"), threads.map { it.name })
        assertEquals(listOf(ThreadActivity.RUNNABLE, ThreadActivity.SLEEPING), threads.map { it.activity })
        assertEquals(listOf(true, false), threads.map { it.isCurrent })
        assertEquals(listOf(CallFrame("turn", 14), CallFrame("main", 7)), threads[0].callStack)
        assertEquals(
            listOf(
                VariableScope("main", listOf(VariableView("way", "7"))),
                VariableScope("test", listOf(VariableView("count / total", "-3"))),
            ),
            run(brick).variablesOf(0, 0),
        )
        assertEquals(ThreadActivity.SLEEPING, run(brick).activityOf(1))
        assertEquals(null, run(brick).activityOf(2))
    }

    @Test
    fun `a task that waits is at its wait, and its caller at the call`() {
        val brick = started(programOf("task 0\n calls 0\n wait 2, 20\n plays 0\nendt\nsub 0\n wait 2, 10\nends"))
        val places = mutableListOf<List<Int>>()
        val beginnings = mutableListOf<Boolean>()
        repeat(290) {
            brick.tick()
            places += run(brick).callStack.map { it.sourceLine }
            if (run(brick).activityOf(0) == ThreadActivity.SLEEPING) beginnings += run(brick).isBeforeStatement
        }
        assertEquals(listOf(listOf(7, 2), listOf(3)), places.distinct())
        assertTrue(places.count { it == listOf(7, 2) } in 100..110, "${places.count { it == listOf(7, 2) }}")
        assertTrue(beginnings.size > 250 && beginnings.none { it })
    }

    @Test
    fun `a wait that is over is left before the next instruction begins`() {
        val brick = started(programOf("task 0\n wait 2, 10\n plays 0\nendt"))
        run(brick).watch = StatementWatch { it.sourceLine == 3 }
        while (!brick.isPaused && brick.state.milliseconds < 300) brick.tick()
        assertTrue(brick.isPaused)
        assertEquals(3, run(brick).sourceLine)
        assertEquals(ThreadActivity.RUNNABLE, run(brick).activityOf(0))
        assertTrue(run(brick).isBeforeStatement)
    }

    @Test
    fun `the variables of a program without names are those that it uses`() {
        val image = Vectors.image("04-arithmetic.rcx2")
        val brick = started(FirmwareProgram("test", RcxImage(image.target, image.chunks), language = Language.ENGLISH))
        repeat(30) { brick.tick() }
        val scopes = run(brick).variables
        assertEquals(listOf("task 0", "test"), scopes.map { it.name })
        assertTrue(scopes.last().variables.any { it.name == "var[0]" })
    }

    @Test
    fun `a task knows its own variables and those of the subroutine it is in`() {
        val program = programOf("task 0\n start 1\n calls 0\nagain:\n jmp again\nendt\n$SECOND")
        val own = mapOf(
            ChunkId(ChunkKind.TASK, 1) to mapOf(47 to listOf("tone")),
            ChunkId(ChunkKind.SUB, 0) to mapOf(32 to listOf("a", "b")),
        )
        val table = VariableTable(mapOf(0 to listOf("rounds")), own)
        val brick =
            started(
                FirmwareProgram("test", program.image, program.lines, variables = table, language = Language.ENGLISH),
            )
        repeat(8) { brick.tick() }
        val shared = VariableScope("test", listOf(VariableView("rounds", "0")))
        assertEquals(2, run(brick).threads.first().callStack.size)
        val ofSub = VariableScope("task 0", listOf(VariableView("a / b", "0")))
        assertEquals(listOf(ofSub, shared), run(brick).variablesOf(0, 0))
        repeat(60) { brick.tick() }
        assertEquals(listOf(shared), run(brick).variablesOf(0, 0))
        val ofOther = VariableScope("task 1", listOf(VariableView("tone", "450")))
        assertEquals(listOf(ofOther, shared), run(brick).variablesOf(1, 0))
    }

    @Test
    fun `the firmware knows the names of a program that has ended`() {
        val brick = started(programOf("; Var 3 = rounds\n; Var 40 = own\ntask 0\n setv 3, 2, 7\nendt"))
        repeat(50) { brick.tick() }
        val state = assertIs<FirmwareState>(brick.firmwareState)
        assertEquals(null, brick.debuggableRun)
        assertEquals(mapOf(3 to "rounds"), state.variableNames)
        assertEquals(7, state.variables[3])
        assertEquals("test", state.program)
    }

    @Test
    fun `an image without a source runs with the lines of its listing`() {
        val image = Vectors.image("20-follow-line.rcx2")
        val brick = started(FirmwareProgram("test", image, image.assemblyListing().lines, language = Language.ENGLISH))
        repeat(200) { brick.tick() }
        val lines = image.assemblyListing().text.lines()
        val called = brick.log.entries.filter { it.sourceLine > 0 }.map { lines[it.sourceLine - 1].trim().take(4) }
        assertTrue(called.isNotEmpty())
        assertEquals(emptyList(), called - setOf("pwr\t", "dir\t", "out\t", "sent", "senm", "play"))
    }

    @Test
    fun `the state of the firmware is a value`() {
        val brick = started(programOf(DRIVER))
        repeat(30) { brick.tick() }
        val state = assertIs<FirmwareState>(brick.firmwareState)
        val variables = state.variables
        repeat(300) { brick.tick() }
        assertEquals(-3, variables[2])
        assertEquals(variables, state.variables)
        assertEquals(listOf(0, 1), state.tasks.map { it.number })
    }

    private fun programOf(source: String): FirmwareProgram {
        val result = assertIs<AssemblyResult.Success>(assemble(source, Language.ENGLISH))
        return FirmwareProgram("test", result.image, result.lines, language = Language.ENGLISH)
    }

    private fun started(program: FirmwareProgram): RcxBrick {
        val brick = RcxBrick(listOf(program), messages = BrickMessages.of(Language.ENGLISH))
        brick.press(BrickButton.RUN)
        brick.release(BrickButton.RUN)
        return brick
    }

    private fun run(brick: RcxBrick): DebuggableRun = assertNotNull(brick.debuggableRun)

    private companion object {
        const val SECOND = "task 1\n setv 47, 2, 450\nround:\n jmp round\nendt\nsub 0\n wait 2, 3\nends"

        val DRIVER = """
            |; Var 2 = count
            |; Var 2 = total
            |; Var 40 = way
            |; Task 0 = main, size: 0 bytes
            |	task 0
            |	start 1
            |	calls 1
            |	stop
            |	endt
            |; Sub 1 = turn, size: 0 bytes
            |	sub 1
            |	setv 2, 2, -3
            |	setv 40, 2, 7
            |again: jmp again
            |	ends
            |	task 1
            |	wait 2, 100
            |	endt
        """.trimMargin()
    }
}
