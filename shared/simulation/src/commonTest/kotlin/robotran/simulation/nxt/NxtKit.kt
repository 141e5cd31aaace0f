package robotran.simulation.nxt

import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.nxjlibrary.NxjLibrary
import robotran.nxt.hardware.I2cMode
import robotran.nxt.hardware.SensorType
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.program.NxtProgram
import robotran.nxt.program.SensorSetup
import robotran.nxt.regulator.MotorRegulator
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.nxjPrograms
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.pressRun
import robotran.tinyvm.NxjResult
import robotran.tinyvm.linkNxj
import robotran.tinyvm.messages.TinyVmMessages
import robotran.world.Paper
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.io.encoding.Base64
import kotlin.test.assertIs

/** A program for an NXT given as its calls and the pauses between them. */
class ScriptedNxt(build: ScriptedNxt.() -> Unit) : NxtProgram {
    override val name = "scripted"
    private val steps = mutableListOf<Step>()

    init {
        build()
    }

    fun call(vararg calls: NxtCall) {
        steps += Step(calls.toList(), 0)
    }

    fun pause(milliseconds: Long) {
        steps += Step(emptyList(), milliseconds)
    }

    /** Gives the motors A and C a power, -100..100, without regulation. */
    fun motors(left: Int, right: Int = left, brakes: Boolean = true) =
        call(NxtCall.controlMotor(A, left, brakes), NxtCall.controlMotor(C, right, brakes))

    /** Runs regulated motors on. */
    fun regulate(vararg motors: Int, speed: Float = 360f) = call(
        *motors.map {
            NxtCall.regulate(it, speed, ACCELERATION, MotorRegulator.FORWARD, hold = true)
        }.toTypedArray(),
    )

    fun sensor(port: Int, type: Int) = call(*SensorSetup.callsFor(port - 1, type).toTypedArray())

    /** Lets an ultrasonic sensor ping on and on. */
    fun sonar(port: Int) {
        sensor(port, SensorType.LOWSPEED_9V)
        call(NxtCall.of(NxtNative.I2C_ENABLE, port - 1, I2cMode.LEGO))
        call(NxtCall(NxtNative.I2C_START, intArrayOf(port - 1, 2, 0), bytes = byteArrayOf(0x41, 2)))
    }

    override fun start(nxt: Nxt): ProgramRun = Run(nxt, steps)

    private class Step(val calls: List<NxtCall>, val wait: Long)

    private class Run(private val nxt: Nxt, private val steps: List<Step>) : ProgramRun {
        private var next = 0
        override val sourceLine get() = next

        override fun resume(steps: Int): ProgramStatus {
            repeat(steps) {
                val step = this.steps.getOrNull(next++) ?: return ProgramStatus.Ended
                step.calls.forEach { nxt.call(it, next) }
                if (step.wait > 0) return ProgramStatus.Waiting(nxt.milliseconds + step.wait)
            }
            return ProgramStatus.Running
        }
    }

    companion object {
        const val A = 0
        const val B = 1
        const val C = 2
        const val ACCELERATION = 6000
    }
}

internal val nxtPlain = BuiltInWorlds.plainFor(BrickKind.NXT)

/** An open floor with [robot] at its middle, that looks along x. */
internal fun openWorld(robot: RobotDescription = ReadyRobots.NXT_PENBOT) = World(
    "Open",
    Paper(600.0, 600.0),
    listOf(RobotPlacement(Pose(300.0, 300.0, 0.0), description = robot)),
)

/** A session whose robots have been started with [programs], one each. */
internal suspend fun nxtSession(world: World, vararg programs: BrickProgram): Session = Session(
    world,
    programs.map {
        RobotProgramSet(listOf(it))
    },
    loadPhysicsEngine(),
    Language.ENGLISH,
).apply { pressRun() }

internal fun robolangNxt(source: String): BrickProgram = assertIs<RobolangResult.Success>(
    compileRobolang("test", source, RobotTarget.Nxt(5.6, 11.4), messages = RobolangMessages.of(Language.ENGLISH)),
).program

/** The compiled program of the class [name] in the resources of the tests. */
internal suspend fun nxj(name: String): BrickProgram {
    val prefix = "$name.java/"
    val classes = nxjPrograms.filterKeys { it.startsWith(prefix) }
        .entries.associate { it.key.removePrefix(prefix).removeSuffix(".class") to Base64.decode(it.value) }
    return assertIs<NxjResult.Success>(
        linkNxj(name, classes, NxjLibrary.load().classFiles, name, messages = TinyVmMessages.of(Language.ENGLISH)),
    ).program
}
