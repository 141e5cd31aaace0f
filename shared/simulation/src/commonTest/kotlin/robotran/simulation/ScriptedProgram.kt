package robotran.simulation

import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.world.Penbot

/** A program given as its ROM calls and the pauses between them, like those of a Robolang program. */
class ScriptedProgram(build: ScriptedProgram.() -> Unit) : RcxProgram {
    override val name = "scripted"
    private val steps = mutableListOf<Step>()

    init {
        build()
    }

    fun forward(centimetres: Double) = drive(FORWARD, FORWARD, centimetres * Penbot.MILLISECONDS_PER_CENTIMETRE)

    fun backward(centimetres: Double) = drive(BACKWARD, BACKWARD, centimetres * Penbot.MILLISECONDS_PER_CENTIMETRE)

    fun turnLeft(degrees: Double) = drive(BACKWARD, FORWARD, degrees * Penbot.MILLISECONDS_PER_DEGREE)

    fun turnRight(degrees: Double) = drive(FORWARD, BACKWARD, degrees * Penbot.MILLISECONDS_PER_DEGREE)

    fun penDown() = movePen(FORWARD)

    fun penUp() = movePen(BACKWARD)

    fun pause(milliseconds: Long) {
        steps += Step(emptyList(), milliseconds)
    }

    /** Sets mode and power of motors A and C. */
    fun motors(mode: Int, power: Int) {
        steps += Step(listOf(motor(A, mode, power), motor(C, mode, power)), 0)
    }

    /** Powers an input port, 0..2, as light and rotation sensors need. */
    fun activate(port: Int) {
        steps += Step(listOf(RomCall(0x1946, listOf(0x1000 + port))), 0)
    }

    override fun start(rom: Rom): ProgramRun = Run(rom, steps)

    private fun drive(left: Int, right: Int, milliseconds: Double) {
        steps +=
            Step(listOf(motor(A, left, DEFAULT_POWER), motor(C, right, DEFAULT_POWER)), (milliseconds + 0.5).toLong())
        motors(BRAKE, FULL_POWER)
    }

    private fun movePen(mode: Int) {
        steps += Step(listOf(motor(B, mode, DEFAULT_POWER)), 200)
        steps += Step(listOf(motor(B, BRAKE, FULL_POWER)), 0)
    }

    private fun motor(port: Int, mode: Int, power: Int) = RomCall(0x1a4e, listOf(port, mode, power))

    private class Step(val calls: List<RomCall>, val wait: Long)

    private class Run(private val rom: Rom, private val steps: List<Step>) : ProgramRun {
        private var next = 0
        override val sourceLine get() = next

        override fun resume(steps: Int): ProgramStatus {
            repeat(steps) {
                val step = this.steps.getOrNull(next++) ?: return ProgramStatus.Ended
                step.calls.forEach { rom.call(it, next) }
                if (step.wait > 0) return ProgramStatus.Waiting(rom.milliseconds + step.wait)
            }
            return ProgramStatus.Running
        }
    }

    companion object {
        const val FORWARD = 1
        const val BACKWARD = 2
        const val BRAKE = 3
        const val FLOAT = 4
        const val DEFAULT_POWER = 3
        const val FULL_POWER = 7
        private const val A = 0x2000
        private const val B = 0x2001
        private const val C = 0x2002

        /** A closed square to the left of the robot, drawn with the pen. */
        val square = ScriptedProgram {
            penDown()
            repeat(4) {
                forward(20.0)
                turnLeft(90.0)
            }
            penUp()
        }
    }
}
