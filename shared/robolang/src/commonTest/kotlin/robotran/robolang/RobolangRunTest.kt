package robotran.robolang

import robotran.brick.program.ProgramStatus
import robotran.robolang.robot.RobotTarget
import kotlin.test.Test
import kotlin.test.assertEquals

class RobolangRunTest {
    private val rom = RecordingRom()

    @Test
    fun `a program keeps its name`() = assertEquals("test", programOf("beep").name)

    @Test
    fun `an empty program ends at once`() {
        val run = programOf("").start(rom)
        assertEquals(0, run.sourceLine)
        assertEquals(ProgramStatus.Ended, run.resume(1))
        assertEquals(emptyList(), rom.calls)
    }

    @Test
    fun `nothing happens before a run is resumed`() {
        val run = programOf("\nbeep").start(rom)
        assertEquals(2, run.sourceLine)
        assertEquals(ProgramStatus.Running, run.resume(0))
        assertEquals(emptyList(), rom.calls)
    }

    @Test
    fun `a step is a statement`() {
        val run = programOf("beep\nshow 1\nbeep").start(rom)
        assertEquals(ProgramStatus.Running, run.resume(1))
        assertEquals(1, rom.calls.size)
        assertEquals(ProgramStatus.Running, run.resume(1))
        assertEquals(3, rom.calls.size)
        assertEquals(ProgramStatus.Ended, run.resume(1))
        assertEquals(4, rom.calls.size)
    }

    @Test
    fun `the line is the one about to be executed and in the end the last one`() {
        val run = programOf("repeat 2 times\n  beep\n\n  show 1\nend\nbeep").start(rom)
        val lines = mutableListOf(run.sourceLine)
        while (run.resume(1) != ProgramStatus.Ended) {
            lines += run.sourceLine
        }
        assertEquals(listOf(1, 2, 4, 1, 2, 4, 1, 6), lines)
        assertEquals(6, run.sourceLine)
    }

    @Test
    fun `a move waits until its time is over and only then stops the motors`() {
        rom.milliseconds = 1000
        val run = programOf("forward 2\nbeep").start(rom)
        assertEquals(ProgramStatus.Waiting(1100), run.resume(10))
        assertEquals(1, run.sourceLine)
        rom.milliseconds = 1099
        assertEquals(ProgramStatus.Waiting(1100), run.resume(10))
        assertEquals(2, rom.calls.size)
        rom.milliseconds = 1100
        assertEquals(ProgramStatus.Ended, run.resume(10))
        assertEquals(listOf(1, 1, 1, 1, 2), rom.calls.map { it.sourceLine })
    }

    @Test
    fun `the last wait of a program is waited for`() {
        val run = programOf("wait 1 second").start(rom)
        assertEquals(ProgramStatus.Waiting(1000), run.resume(1))
        rom.milliseconds = 1000
        assertEquals(ProgramStatus.Ended, run.resume(1))
    }

    @Test
    fun `an empty loop uses up its budget`() {
        val run = programOf("repeat 2000000000 times\n  repeat 0 times\n  end\nend").start(rom)
        repeat(100) { assertEquals(ProgramStatus.Running, run.resume(1000)) }
    }

    @Test
    fun `two runs of one program know nothing of each other`() {
        val program = programOf("repeat 2 times\n  beep\nend")
        val first = program.start(rom)
        first.resume(2)
        val other = RecordingRom()
        program.start(other).resume(100)
        assertEquals(1, rom.calls.size)
        assertEquals(2, other.calls.size)
    }

    @Test
    fun `how much is done at a time makes no difference`() {
        val program =
            programOf(
                "repeat 3 times\n  forward 1\n  repeat 2 times\n    beep\n  end\n  wait 5 milliseconds\nend\npen down",
            )
        val expected = runToEnd(program).calls
        for (steps in 1..7) {
            val clock = RecordingRom()
            val run = program.start(clock)
            while (run.resume(steps) != ProgramStatus.Ended) clock.milliseconds++
            assertEquals(expected.map { it.call }, clock.calls.map { it.call })
        }
    }

    @Test
    fun `distances and angles take as long as the robot's figures say`() {
        val program =
            programOf(
                "forward 10\nturn left 90",
                RobotTarget.Rcx(millisecondsPerCentimetre = 33.35, millisecondsPerDegree = 4.7),
            )
        assertEquals(
            listOf(0L, 0L, 334L, 334L, 334L, 334L, 757L, 757L),
            runToEnd(program).calls.map { it.milliseconds },
        )
    }
}
