package robotran.rcxrom

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.program.BrickProgram
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.RuntimeWarning
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.controls.romCode
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.messages.describe
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertTrue

class ProgramOnBrickTest {
    @Test
    fun `a program gets its steps each millisecond and no more`() {
        var steps = 0
        val brick = started(List(10) { { _: Rom -> ProgramStatus.Running.also { steps++ } } })
        val done = List(4) {
            brick.tick()
            steps
        }
        assertEquals(List(4) { (it + 1) * RcxBrick.STEPS_PER_MILLISECOND }, done)
    }

    @Test
    fun `a program that waits is left alone until the moment it waits for`() {
        val moments = mutableListOf<Long>()
        val note = { rom: Rom -> ProgramStatus.Running.also { moments += rom.milliseconds } }
        val brick = started(listOf(note, waiting(100), note, waiting(1), note))
        brick.tick(200)
        assertEquals(listOf(1L, 101L, 102L), moments)
    }

    @Test
    fun `a motor that a program drives for 400 milliseconds is on for 400`() {
        val forward = calling(RomAddress.CONTROL_MOTOR, 0x2000, MotorMode.FORWARD.code, 7)
        val brake = calling(RomAddress.CONTROL_MOTOR, 0x2000, MotorMode.BRAKE.code, 7)
        val brick = started(listOf(forward, waiting(400), brake, waiting(100)))
        val outputs = List(490) {
            brick.tick()
            brick.motorOutput(MotorPort.A)
        }
        assertEquals(400, outputs.count { it == MotorMode.FORWARD })
        assertEquals(MotorMode.BRAKE, outputs.last())
        assertEquals(MotorMode.FLOAT, brick.motorOutput(MotorPort.B))
    }

    @Test
    fun `a program that ends brakes its motors by calls of the firmware and shows the shell`() {
        val brick = started(listOf(calling(RomAddress.CONTROL_MOTOR, 0x2002, MotorMode.BACKWARD.code, 5)))
        val callsBefore = brick.log.total
        brick.tick()
        assertEquals(RunState.Ended(stopped = false), brick.state.run)
        assertEquals(
            listOf(
                "1 0x1a4e 0x2002 2 5 ; motor C backward 5 ; 7",
                "1 0x1a4e 0x2000 3 0 ; motor A brake 0 ; firmware",
                "1 0x1a4e 0x2001 3 0 ; motor B brake 0 ; firmware",
                "1 0x1a4e 0x2002 3 0 ; motor C brake 0 ; firmware",
                "1 0x299a 0x4004 1 ; queue system sound 1 (two beeps) ; firmware",
                "1 0x27ac ; clear the LCD ; firmware",
                "1 0x29f2 0x4001 0x8000 ; the battery measures 320 ; firmware",
                "1 0x1ff2 0x3001 90 0x3003 ; LCD number 9.0 ; firmware",
                "1 0x1ff2 0x3017 0 0x3002 ; LCD program digit 0 ; firmware",
                "1 0x1b62 0x3006 ; LCD show standing man ; firmware",
                "1 0x27c8 ; refresh the LCD ; firmware",
            ),
            brick.log.entries.drop(callsBefore.toInt()).map { it.text },
        )
        assertEquals("9.0 0", brick.state.glass.text)
    }

    @Test
    fun `a program that fails buzzes and brakes and keeps its failure`() {
        val failure = ProgramFailure("The number is too big.", sourceLine = 3)
        val brick = started(emptyList(), statusAtEnd = ProgramStatus.Failed(failure))
        brick.tick()
        assertEquals(RunState.Failed(failure), brick.state.run)
        assertTrue(brick.state.motors.all { it.mode == MotorMode.BRAKE })
        brick.tick(2_000)
        assertEquals(1_000, brick.tones().last().durationMilliseconds)
        assertEquals(RunState.Failed(failure), brick.state.run)
    }

    @Test
    fun `the buzz of a failure waits for the sounds before it`() {
        val tone = calling(RomAddress.PLAY_TONE, RomCode.TONE, 880, 100)
        val brick = started(listOf(tone), ProgramStatus.Failed(ProgramFailure("Too big.", sourceLine = 3)))
        brick.tick(3_000)
        val lastTones = brick.tones().takeLast(2)
        assertEquals(listOf(false, true), lastTones.map { it.isFirmware })
        assertTrue(lastTones[1].milliseconds >= lastTones[0].milliseconds + lastTones[0].durationMilliseconds)
        assertTrue("queue system sound 4 (buzz)" in brick.log.entries.joinToString("\n") { it.text })
    }

    @Test
    fun `a program that ends while it drives is told why the robot stops, until the next one begins`() {
        val brick =
            started(
                listOf(calling(RomAddress.CONTROL_MOTOR, MotorPort.A.romCode, MotorMode.FORWARD.code, 3), waiting(100)),
            )
        assertEquals(null, brick.state.explanation)
        brick.tick(200)
        assertEquals(BrickMessages.of(Language.ENGLISH).motorsBrakedAtEnd(), brick.state.explanation)
        brick.push(BrickButton.RUN)
        assertEquals(null, brick.state.explanation)
        brick.stopProgram()
        assertEquals(null, brick.state.explanation)
    }

    @Test
    fun `a program that has stopped its motors ends without a word`() {
        val brick = started(listOf(calling(RomAddress.CONTROL_MOTOR, MotorPort.A.romCode, MotorMode.BRAKE.code, 3)))
        brick.tick(200)
        assertEquals(RunState.Ended(stopped = false), brick.state.run)
        assertEquals(null, brick.state.explanation)
    }

    @Test
    fun `a thread that fails is shown and the others go on at On-Off`() {
        val failure = ProgramFailure("The number is too big.", sourceLine = 3, sourceFile = "Robot.java")
        val forward = calling(RomAddress.CONTROL_MOTOR, 0x2000, 1, 3)
        val brick = started(listOf(forward, { ProgramStatus.ThreadFailed(failure) }, calling(RomAddress.CLEAR_LCD)))
        brick.tick(50)
        assertEquals(RunState.Failed(failure), brick.state.run)
        assertEquals(MotorMode.FORWARD, brick.state.motors.first().mode)
        assertEquals(
            "A thread of the program cannot go on. Robot.java, line 3: The number is too big. Press On-Off to let " +
                "the others go on.",
            brick.state.explanation,
        )
        assertEquals(1, brick.log.entries.count { it.sourceLine == TEST_LINE })
        brick.push(BrickButton.ON_OFF)
        assertEquals(null, brick.state.explanation)
        brick.tick(5)
        assertEquals(2, brick.log.entries.count { it.sourceLine == TEST_LINE })
        assertEquals(RunState.Ended(stopped = false), brick.state.run)
    }

    @Test
    fun `a program whose thread has failed can be stopped`() {
        val brick = started(listOf({ ProgramStatus.ThreadFailed(ProgramFailure("Too big.", sourceLine = 3)) }))
        brick.tick(5)
        brick.stopProgram()
        assertEquals(RunState.Ended(stopped = true), brick.state.run)
        assertEquals(null, brick.state.explanation)
    }

    @Test
    fun `a slot without a program that could run is passed by Prgm and not started by Run`() {
        val program = ScriptedProgram(emptyList())
        val brick = RcxBrick(listOf(program, null), firstSlot = 1, messages = BrickMessages.of(Language.ENGLISH))
        brick.tick(10)
        assertEquals("9.0 1", brick.state.glass.describe(messages = BrickMessages.of(Language.ENGLISH)))
        brick.push(BrickButton.RUN)
        assertEquals(RunState.Idle, brick.state.run)
        brick.push(BrickButton.PRGM)
        assertEquals("9.0 0, standing man", brick.state.glass.describe(messages = BrickMessages.of(Language.ENGLISH)))
        brick.push(BrickButton.RUN)
        assertEquals(1, program.starts)
    }

    @Test
    fun `a brick takes five programs and no more`() {
        RcxBrick(List(BrickProgram.MAX_PROGRAMS) { endlessProgram() }, messages = BrickMessages.of(Language.ENGLISH))
        assertFailsWith<IllegalArgumentException> {
            RcxBrick(
                List(BrickProgram.MAX_PROGRAMS + 1) {
                    endlessProgram()
                },
                messages = BrickMessages.of(Language.ENGLISH),
            )
        }
    }

    @Test
    fun `remarks stay until the next program is started`() {
        val warning = RuntimeWarning("This divisor is too large.", sourceLine = 2)
        var isFirst = true
        val program = object : RcxProgram {
            override val name = "remarking"

            override fun start(rom: Rom) = object : ProgramRun {
                override val sourceLine = 2
                override val warnings = if (isFirst) listOf(warning) else emptyList()

                override fun resume(steps: Int) = ProgramStatus.Ended
            }.also { isFirst = false }
        }
        val brick = RcxBrick(listOf(program), messages = BrickMessages.of(Language.ENGLISH))
        assertEquals(emptyList(), brick.warnings)
        for (expected in listOf(listOf(warning), emptyList())) {
            brick.push(BrickButton.RUN)
            brick.tick(5)
            assertEquals(expected, brick.warnings)
        }
    }

    @Test
    fun `looking at buttons and messages is no ROM call`() {
        var seen: Set<BrickButton> = emptySet()
        var hasMessage = true
        val brick =
            started(
                listOf({ rom -> ProgramStatus.Running.also { seen = rom.pressedButtons } }, { rom ->
                    ProgramStatus.Running.also {
                        hasMessage = rom.hasMessage
                    }
                }),
            )
        val calls = brick.log.total
        brick.press(BrickButton.VIEW)
        brick.tick()
        assertEquals(setOf(BrickButton.VIEW), seen)
        assertEquals(false, hasMessage)
        assertEquals(calls, brick.log.total)
    }

    @Test
    fun `a program can be run again from its beginning`() {
        val program = ScriptedProgram(listOf(calling(RomAddress.REFRESH_LCD)))
        val brick = RcxBrick(listOf(program), messages = BrickMessages.of(Language.ENGLISH))
        repeat(3) {
            brick.push(BrickButton.RUN)
            brick.tick()
        }
        assertEquals(3, program.starts)
        assertEquals(3, brick.log.entries.count { it.sourceLine == TEST_LINE })
    }

    @Test
    fun `the state tells the line that is about to be executed`() {
        val brick = started(List(5) { waiting(10) })
        assertEquals(RunState.Running(sourceLine = 1), brick.state.run)
        brick.tick(1)
        assertEquals(RunState.Running(sourceLine = 2), brick.state.run)
        brick.tick(10)
        assertEquals(RunState.Running(sourceLine = 3), brick.state.run)
    }

    @Test
    fun `a program reads the buttons through memory`() {
        var seen = -1
        val read = calling(RomAddress.READ_BUTTONS, RomCode.BUTTONS, RESULT)
        val brick = started(listOf(read, { rom -> ProgramStatus.Running.also { seen = rom.memory.readShort(RESULT) } }))
        brick.press(BrickButton.VIEW)
        brick.tick(2)
        assertEquals(2, seen)
    }

    @Test
    fun `the same presses at the same moments give the same log`() {
        val logs = List(2) {
            val brick =
                started(listOf(calling(RomAddress.PLAY_TONE, RomCode.TONE, 440, 5), waiting(50), calling(0x1234, 5)))
            brick.tick(200)
            brick.push(BrickButton.PRGM)
            brick.log.entries.map { it.text }
        }
        assertEquals(logs[0], logs[1])
    }

    private fun started(
        actions: List<(Rom) -> ProgramStatus>,
        statusAtEnd: ProgramStatus = ProgramStatus.Ended,
    ): RcxBrick =
        RcxBrick(listOf(ScriptedProgram(actions, statusAtEnd)), messages = BrickMessages.of(Language.ENGLISH)).apply {
            push(BrickButton.RUN)
        }
}
