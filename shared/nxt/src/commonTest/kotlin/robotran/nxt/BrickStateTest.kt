package robotran.nxt

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallGroup
import robotran.brick.log.CallLogFilter
import robotran.brick.log.toCsv
import robotran.brick.log.toLogText
import robotran.brick.program.BrickProgram
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.nxt.display.BitBlt
import robotran.nxt.display.ByteArrayMemory
import robotran.nxt.display.Picture
import robotran.nxt.log.NxtLogEntry
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.program.NxtProgram
import robotran.nxt.state.NxtState
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertFalse
import kotlin.test.assertNotEquals
import kotlin.test.assertNull
import kotlin.test.assertSame
import kotlin.test.assertTrue

class BrickStateTest {
    private val brick = NxtBrick(listOf(scriptedProgram("endless")), messages = NxtMessages.of(Language.ENGLISH))

    @Test
    fun `parts of the state that do not change are the same objects`() {
        brick.push(BrickButton.ENTER)
        brick.setHubDegrees(MotorPort.B, 5)
        brick.nxt.call(NxtCall.of(NxtNative.LISTEN, 0), TEST_LINE)
        brick.tick(10)
        val one = brick.state
        brick.tick(1_000)
        val other = brick.state
        assertSame(one.display, other.display)
        assertSame(one.motors, other.motors)
        assertSame(one.motorDegrees, other.motorDegrees)
        assertSame(one.sensorPorts, other.sensorPorts)
        assertSame(one.bluetooth, other.bluetooth)
        assertEquals(one.copy(milliseconds = other.milliseconds), other)
    }

    @Test
    fun `the motors of a state can be those of another moment`() {
        val modes = listOf(MotorMode.FORWARD, MotorMode.BRAKE, MotorMode.BACKWARD)
        val state = brick.state.withRun(modes, RunState.Ended(stopped = true))
        assertEquals(modes, state.motors.map { it.mode })
        assertEquals(RunState.Ended(stopped = true), state.run)
    }

    @Test
    fun `it is an NXT with four ports`() {
        assertEquals(BrickKind.NXT, brick.kind)
        assertEquals(BrickKind.NXT, brick.state.kind)
        assertEquals(listOf(1, 2, 3, 4), brick.state.inputs.map { it.port })
        assertSame(brick.state.display, brick.state.screen)
    }

    @Test
    fun `what a program has drawn is known until the next one starts`() {
        var status: ProgramStatus = ProgramStatus.Running
        val drawing = CountingProgram(mutableListOf()) { status }
        val brick = NxtBrick(listOf(drawing, scriptedProgram("endless")), messages = NxtMessages.of(Language.ENGLISH))
        assertNull(brick.state.leftByProgram)
        brick.push(BrickButton.ENTER)
        brick.nxt.call(NxtCall.drawString("Hello", 0, 2), TEST_LINE)
        assertNull(brick.state.leftByProgram)
        status = ProgramStatus.Ended
        brick.tick()
        assertEquals(RunState.Ended(stopped = false), brick.state.run)
        assertEquals(listOf("Hello"), brick.state.leftByProgram?.texts)
        assertEquals("NXT", brick.state.menu?.title)
        brick.tick(1_000)
        assertEquals(listOf("Hello"), brick.state.leftByProgram?.texts)
        brick.runSnippet(checkNotNull(scriptedProgram("endless")))
        assertNull(brick.state.leftByProgram)
        brick.stopProgram()
        assertEquals(true, brick.state.leftByProgram?.isBlank)
    }

    @Test
    fun `what a program has not refreshed is not left`() {
        val brick = NxtBrick(listOf(scriptedProgram("endless")), messages = NxtMessages.of(Language.ENGLISH))
        brick.push(BrickButton.ENTER)
        brick.nxt.call(NxtCall.of(NxtNative.SET_AUTO_REFRESH_PERIOD, 0), TEST_LINE)
        brick.nxt.call(NxtCall.drawString("Hidden", 0, 2), TEST_LINE)
        brick.tick(1_000)
        brick.stopProgram()
        assertEquals(true, brick.state.leftByProgram?.isBlank)
    }

    @Test
    fun `pins can be sampled before time passes`() {
        brick.setAnalog(2, 300)
        assertEquals(1_023, brick.sensorPort(2).raw)
        brick.samplePins()
        assertEquals(300, brick.sensorPort(2).raw)
    }

    @Test
    fun `a program for another brick does nothing`() {
        val foreign = object : BrickProgram {
            override val name = "Foreign"
            override val kind = BrickKind.RCX
        }
        val brick = NxtBrick(listOf(foreign), messages = NxtMessages.of(Language.ENGLISH))
        brick.push(BrickButton.ENTER)
        brick.runSnippet(foreign)
        brick.tick(10)
        assertEquals(RunState.Idle, brick.state.run)
        assertEquals("NXT", brick.state.menu?.title)
    }

    @Test
    fun `buttons of another brick do nothing`() {
        brick.press(BrickButton.RUN)
        brick.press(BrickButton.ON_OFF)
        assertEquals(emptySet(), brick.state.pressed)
        assertTrue(brick.state.poweredOn)
    }

    @Test
    fun `there must be a slot for each program`() {
        assertFailsWith<IllegalArgumentException> {
            NxtBrick(List(BrickProgram.MAX_PROGRAMS + 1) { null }, messages = NxtMessages.of(Language.ENGLISH))
        }
        assertFailsWith<IllegalArgumentException> {
            NxtBrick(listOf(null), firstSlot = 1, messages = NxtMessages.of(Language.ENGLISH))
        }
        assertEquals(
            1,
            NxtBrick(listOf(null, null), firstSlot = 1, messages = NxtMessages.of(Language.ENGLISH)).state.selectedSlot,
        )
    }

    @Test
    fun `a paused millisecond goes on where it stood`() {
        val resumed = mutableListOf<Int>()
        val brick = NxtBrick(
            listOf(
                CountingProgram(resumed) {
                    if (resumed.size == 1) ProgramStatus.Paused(stepsLeft = 12) else ProgramStatus.Running
                },
            ),
            messages = NxtMessages.of(Language.ENGLISH),
        )
        brick.push(BrickButton.ENTER)
        brick.tick()
        assertTrue(brick.isPaused)
        brick.tick()
        assertFalse(brick.isPaused)
        assertEquals(1L, brick.state.milliseconds)
        assertEquals(listOf(NxtBrick.STEPS_PER_MILLISECOND, 12), resumed)
    }

    @Test
    fun `regulators take their share of the program's steps`() {
        val resumed = mutableListOf<Int>()
        val brick = NxtBrick(listOf(CountingProgram(resumed)), messages = NxtMessages.of(Language.ENGLISH))
        brick.push(BrickButton.ENTER)
        brick.tick(1)
        for (port in 0..1) brick.nxt.call(NxtCall.regulate(port, 360f, 6_000, 1_000, hold = true), TEST_LINE)
        brick.tick(3)
        resumed.clear()
        brick.tick(40)
        // Of 120 steps in four milliseconds, two motors need 68.
        assertEquals(List(10) { listOf(22, 30) }.flatten(), resumed)
    }

    @Test
    fun `calls of the regulator are heard when they tell something new`() {
        brick.push(BrickButton.ENTER)
        brick.tick(1)
        val motor = FreeMotor(MotorPort.A)
        brick.nxt.call(NxtCall.regulate(0, 360f, 6_000, 720, hold = true), TEST_LINE)
        repeat(2_000) {
            brick.tick()
            motor.tick(brick)
        }
        val powers = brick.log.entries.filter {
            it.sourceLocation == "library"
        }.map { (it as NxtLogEntry).call.numbers[1] }
        assertTrue(powers.size in 10..200, "${powers.size} calls")
        powers.zipWithNext { one, next ->
            assertTrue(
                next - one >= 10 || one - next >= 10 || (one > 0) != (next > 0) || (one < 0) != (next < 0),
                "$one $next",
            )
        }
    }

    @Test
    fun `the log can be read as lines and as a table`() {
        brick.push(BrickButton.ENTER)
        brick.tick(5)
        brick.nxt.call(NxtCall.controlMotor(0, 75, brakes = true), 7, "Square.java")
        brick.nxt.call(NxtCall.regulate(1, 180.25f, 6_000, 90, hold = false), 8)
        brick.nxt.call(NxtCall(NxtNative.I2C_START, intArrayOf(3, 2, 1), bytes = byteArrayOf(0x42)), 0)
        assertEquals(
            """
            5 controlMotorById 0 75 1 ; motor A forward 75 ; Square.java:7
            5 regulate 1 180.3 6000 90 0 ; motor B turns to 90 at 180.3 degrees a second and then rolls ; 8
            5 i2cStartById 3 2 1 [42] ; nothing is sent to sensor 4, it is not ready ; library

            """.trimIndent(),
            brick.log.entries.toLogText(),
        )
        assertEquals(
            "5,motors,controlMotorById,0 75 1,motor A forward 75,Square.java:7,done",
            brick.log.entries.toCsv().lines()[1].trim(),
        )
        assertEquals(2, brick.log.entries.count(CallLogFilter(groups = setOf(CallGroup.MOTORS))::accepts))
    }

    @Test
    fun `a call is identified by all its arguments`() {
        val calls = listOf(
            NxtCall.of(NxtNative.CLEAR),
            NxtCall.controlMotor(0, 75, brakes = true),
            NxtCall.controlMotor(0, 75, brakes = false),
            NxtCall.controlMotor(1, 75, brakes = true),
            NxtCall.drawString("ab", 0, 0),
            NxtCall.drawString("ba", 0, 0),
            NxtCall.drawString("ab", 0, 1),
            NxtCall(NxtNative.WRITE, intArrayOf(0), bytes = byteArrayOf(1, 2)),
            NxtCall(NxtNative.WRITE, intArrayOf(0), bytes = byteArrayOf(1, 2, 0)),
        )
        val identities = calls.map { call -> buildList { call.identify(::add) } }
        assertEquals(identities.size, identities.distinct().size)
        assertEquals(listOf(20L, 0, 0, 0, 2, 97 * 31 + 98), identities[4])
    }

    @Test
    fun `no two natives have the same id and the log knows each by it`() {
        assertEquals(NxtNative.entries.size, NxtNative.entries.map { it.id }.distinct().size)
        assertEquals(NxtNative.CONTROL_MOTOR, NxtNative.of(1))
        assertEquals(null, NxtNative.of(0))
    }

    @Test
    fun `a picture is drawn onto the memory of the program and logged`() {
        brick.push(BrickButton.ENTER)
        val own = ByteArrayMemory(ByteArray(800))
        brick.nxt.displayMemory = own
        val source = Picture(ByteArrayMemory(byteArrayOf(3, 1)), 2, 8)
        brick.nxt.bitBlt(source, BitBlt(0, 0, 10, 8, 2, 8, BitBlt.COPY), TEST_LINE)
        assertEquals(listOf(3, 1), listOf(own[110], own[111]))
        val entry = brick.log.entries.last()
        assertEquals("0 bitBlt 2 8 0 0 10 8 2 8 65280 ; draw 2 by 8 dots at 10, 8 ; 7", entry.text)
        brick.tick(260)
        assertTrue(brick.state.display.isBlack(11, 8))
        brick.stopProgram()
        assertNotEquals(own, brick.nxt.displayMemory)
    }

    @Test
    fun `a run has its own display memory again after an exception of a thread`() {
        val brick = NxtBrick(listOf(scriptedProgram("tidy-thread")), messages = NxtMessages.of(Language.ENGLISH))
        brick.push(BrickButton.ENTER)
        val own = ByteArrayMemory(ByteArray(800))
        brick.nxt.displayMemory = own
        brick.tick(5)
        assertEquals("Exception: 28", brick.state.display.texts.first())
        assertNotEquals(own, brick.nxt.displayMemory)
        brick.push(BrickButton.ESCAPE)
        assertSame(own, brick.nxt.displayMemory)
    }

    @Test
    fun `a refresh shows what was drawn when it began`() {
        brick.push(BrickButton.ENTER)
        brick.nxt.call(NxtCall.drawString("one", 0, 0), TEST_LINE)
        brick.nxt.call(NxtCall.of(NxtNative.ASYNC_REFRESH), TEST_LINE)
        brick.nxt.call(NxtCall.of(NxtNative.CLEAR), TEST_LINE)
        brick.tick(6)
        assertEquals(listOf("one"), brick.state.display.texts)
        assertEquals(NxtState.HIGHEST_CONTRAST, brick.state.contrast)
    }

    /** A program of which each share of steps is kept in [resumed]. */
    private class CountingProgram(
        private val resumed: MutableList<Int>,
        private val status: () -> ProgramStatus = { ProgramStatus.Running },
    ) : NxtProgram {
        override val name = "Counting"

        override fun start(nxt: Nxt): ProgramRun = object : ProgramRun {
            override val sourceLine = 1

            override fun resume(steps: Int): ProgramStatus {
                resumed += steps
                return status()
            }
        }
    }
}
