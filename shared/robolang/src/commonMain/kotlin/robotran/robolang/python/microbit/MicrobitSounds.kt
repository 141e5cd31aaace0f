package robotran.robolang.python.microbit

import robotran.robolang.python.writer.PythonContext
import robotran.robolang.robot.Durations
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Command

/** Writes the commands that sound. A board whose tones would move something on its buggy is silent. */
internal class MicrobitSounds(
    private val robot: RobotTarget.Microbit,
    private val context: PythonContext,
    private val state: MicrobitState,
    private val numbers: MicrobitNumbers,
) {
    private val uses = context.uses
    private val notes = context.notes
    private val messages = notes.messages
    private val durations = Durations(robot)

    /** Begins a tone; the program goes on. */
    fun tone(command: Command, hertz: Int, milliseconds: Int): List<String> {
        if (isSilent(command)) return emptyList()
        return listOf("${uses.module("music")}.pitch($hertz, $milliseconds, ${state.pin}wait=False)")
    }

    /** Tells what a pupil should know of the sound of [command]; true if it must not be heard. */
    private fun isSilent(command: Command): Boolean {
        if (!robot.playsTones) {
            notes.tell(command.range, messages.tonesDisturb())
            return true
        }
        if (!robot.model.hasSpeaker && robot.buggy.buzzer == null) notes.tell(command.range, messages.noBuzzer())
        state.makesSounds = true
        return false
    }

    /** Plays a tone to its end. [waiting] writes how a program waits for so many milliseconds. */
    fun play(command: Command.Play, waiting: (String) -> List<String>): List<String> {
        val isSilent = isSilent(command)
        val hertz = numbers.whole(command.frequency)
        val time = numbers.ofTone(command.duration, durations)
        if (time == "0") return emptyList()
        // A pitch that is asked of a function may do more than tell it.
        if (isSilent) return listOf(hertz).filter { '(' in it } + waiting(time)
        val isSimple = time.toIntOrNull() != null && !context.isReacting
        if (isSimple) return listOf("${uses.module("music")}.pitch($hertz, $time, ${state.pin}".trimEnd(',', ' ') + ")")
        uses.use(if (context.isReacting) MicrobitHelper.WAIT else MicrobitHelper.PLAY)
        if (!context.isReacting) uses.import("microbit", "sleep")
        return listOf("${uses.use(MicrobitHelper.PLAY)}($hertz, $time)")
    }
}
