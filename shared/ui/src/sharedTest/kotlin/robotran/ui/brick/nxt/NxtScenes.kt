package robotran.ui.brick.nxt

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorPort
import robotran.brick.program.FailureFrame
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.nxt.NxtBrick
import robotran.nxt.display.DisplaySize
import robotran.nxt.hardware.I2cDevice
import robotran.nxt.hardware.NxtColour
import robotran.nxt.hardware.SensorType
import robotran.nxt.hardware.SonarDevice
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.program.NxtProgram
import robotran.nxt.state.NxtState
import robotran.simulation.state.SessionState
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.Pane
import robotran.workshop.state.WindowForm
import robotran.workshop.state.WorkshopState
import robotran.world.ReadyRobots
import robotran.world.RobotDescription

/** States of an NXT for tests and pictures. */
internal object NxtScenes {
    /** The robot of [running] and all others: bumpers on 1 and 2, a light sensor on 3, a sonar on 4. */
    val robot: RobotDescription = ReadyRobots.NXT_PENBOT

    /** Just switched on. */
    val menu: NxtState = NxtBrick(
        listOf(Shown("Square"), Shown("Follow")),
        name = "yellow",
        messages = NxtMessages.of(Language.ENGLISH),
    ).state

    /** The same with its sensors plugged in. The sonar is off. */
    val idle: NxtState = NxtBrick(emptyList(), messages = NxtMessages.of(Language.ENGLISH)).run {
        setAnalog(0, 183)
        setAnalog(2, 430)
        connect(3, SonarDevice({ doubleArrayOf(45.0) }, clock))
        repeat(600) { tick() }
        state
    }

    /** It drives ahead and tells how far the wall is. */
    val running: NxtState = started(Shown("Follow") { it.drive() }) {
        setHubDegrees(MotorPort.A, 1234)
        setHubDegrees(MotorPort.C, 1198)
        setAnalog(0, 183)
        setAnalog(2, 430)
        connect(3, Sonar(45))
    }.let { it.copy(pressed = setOf(BrickButton.RIGHT)) }

    /** A tone, messages and a colour. */
    val loud: NxtState = started(
        Shown("Loud") {
            it.call(NxtCall.of(NxtNative.PLAY_FREQ, 440, 2_000, 80), 3)
            it.call(NxtCall.of(NxtNative.SET_TYPE, 1, SensorType.COLOUR_FULL), 4)
            it.draw("Red", 6, 3)
        },
    ) { setColour(1, NxtColour(900, 200, 150, 50)) }.copy(isSending = true)

    /** A text, and in two rows below it dots that are no text. */
    val drawing: NxtState = started(
        Shown("Face") {
            it.draw("Face", 0, 0)
            for (row in 2..3) for (dot in 0..<40) it.displayMemory[row * DisplaySize.WIDTH + dot] = 0x2A
        },
    )

    val failed: NxtState = started(Shown("Fail", FAILURE))

    val off: NxtState = NxtBrick(emptyList(), messages = NxtMessages.of(Language.ENGLISH)).apply {
        press(BrickButton.ESCAPE)
        repeat(400) { tick() }
    }.state

    private val FAILURE get() = ProgramFailure(
        "The program divides by 0.",
        sourceLine = 12,
        methodNumber = 20,
        exceptionNumber = 5,
        sourceFile = "Follow.java",
        stack = listOf(
            FailureFrame(20, 14, "speed", 12, "Follow.java"),
            FailureFrame(19, 33, "main", 5, "Follow.java"),
            FailureFrame(2, 8, "Thread.run"),
        ),
        thrownText = "/ by zero",
    )

    /** The screen of a workshop, with [pane], whose first robot is [robot] with this brick. */
    fun screen(
        brick: NxtState,
        robot: RobotDescription = this.robot,
        isWhole: Boolean = false,
        pane: Pane = Pane.WORLD,
    ): WorkshopState {
        val workshop = runBlocking { openWorkshop() }
        for (form in WindowForm.entries) workshop.handle(SettingsEvent.BrickSizeChosen(form, isWhole))
        val state = workshop.state.also { workshop.close() }

        fun SessionState.with() = copy(robots = listOf(robots.first().copy(brick = brick)) + robots.drop(1))
        val first = state.world.robots.first().copy(description = robot)
        val run = state.run.copy(
            world = state.world.copy(robots = listOf(first)),
            session = state.run.session.with(),
            drawn = state.run.drawn.with(),
        )
        return object : WorkshopState by state {
            override val run = run
            override val pane = pane
        }
    }

    private fun started(program: NxtProgram, prepare: NxtBrick.() -> Unit = { }): NxtState =
        NxtBrick(listOf(program), name = "yellow", messages = NxtMessages.of(Language.ENGLISH)).run {
            prepare()
            press(BrickButton.ENTER)
            release(BrickButton.ENTER)
            repeat(600) { tick() }
            state
        }

    private fun Nxt.drive() {
        for ((port, type) in listOf(0 to SensorType.SWITCH, 1 to SensorType.SWITCH, 2 to SensorType.LIGHT_ACTIVE)) {
            call(NxtCall.of(NxtNative.SET_TYPE, port, type), 2)
        }
        call(NxtCall.of(NxtNative.SET_SENSOR_PIN, 2, 0, 1), 2)
        call(NxtCall.controlMotor(0, 75, brakes = true), 3)
        call(NxtCall.controlMotor(1, 0, brakes = true), 3)
        call(NxtCall.controlMotor(2, -60, brakes = true), 4)
        draw("Follow the wall", 0, 0)
        draw("Distance: 45 cm", 0, 2)
        draw("Light:    58 %", 0, 3)
        draw("gjpqy äöü |{}~", 0, 5)
        draw("ENTER stops ", 2, 7, inverted = true)
    }

    private fun Nxt.draw(text: String, column: Int, row: Int, inverted: Boolean = false) {
        call(NxtCall.drawString(text, column, row, inverted), 5)
    }

    /** Does [act] at its start and then waits, or fails with [failure]. */
    private class Shown(
        override val name: String,
        private val failure: ProgramFailure? = null,
        private val act: (Nxt) -> Unit = { },
    ) : NxtProgram {
        override fun start(nxt: Nxt): ProgramRun {
            act(nxt)
            return object : ProgramRun {
                override val sourceLine = 5

                override fun resume(steps: Int): ProgramStatus =
                    failure?.let { ProgramStatus.Failed(it) } ?: ProgramStatus.Waiting(Long.MAX_VALUE)
            }
        }
    }

    private class Sonar(override val reading: Int) : I2cDevice {
        override val address = 2

        override fun write(data: ByteArray) = Unit

        override fun read(count: Int) = ByteArray(count)
    }
}
