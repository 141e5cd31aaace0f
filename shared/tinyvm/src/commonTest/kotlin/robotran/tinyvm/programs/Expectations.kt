package robotran.tinyvm.programs

import robotran.brick.controls.BrickButton
import robotran.brick.program.ProgramFailure
import robotran.tinyvm.config.TinyVmMode

/**
 * The expectations in the comments of a test program for a run in [mode]; the class library's README describes the
 * notation.
 */
internal class Expectations(source: String, val mode: TinyVmMode) {
    private val comments: List<Pair<Int, String>> = ExpectationComments(source).of(mode)

    /** Whether the compiler, not the machine, rejects the program. */
    val hasErrors: Boolean = values("error ").isNotEmpty()

    /** The instructions that the linker rejects, by line; 0 for any line. */
    val refused: Map<Int, String> = byLine("refused: ") + values("refused ").associateBy { 0 }

    /** The ROM calls of each line, with their words; null if no comment mentions calls. */
    val romCalls: Map<Int, List<String>>? = comments.mapNotNull { (line, comment) ->
        ROM.matchEntire(comment)?.destructured?.let { (times, calls) ->
            val once = calls.split('|').map { it.trim() }
            line to List(times.ifEmpty { "1" }.toInt()) { once }.flatten()
        }
    }.toMap().ifEmpty { null }

    /** The display content after each refresh of a line. */
    val shown: Map<Int, List<String>> = byLine("shows: ").mapValues { it.value.split(' ') }

    val endsAt: Long? = values("ends at ").singleOrNull()?.toLong()
    val runsOnAfter: Long? = values("runs on after ").singleOrNull()?.toLong()

    /** The uncaught exceptions, in order. */
    val failures: List<ExpectedFailure> = values("fails ").map { text ->
        val words = text.split(' ')
        ExpectedFailure(words[0].toInt(), words[1], words.drop(NUMBERS_OF_FAILURE).map { it.toInt() }.ifEmpty { null })
    }

    /** Button and sensor events. */
    val events: List<Event> = values("sensor ").map { sensorEvent(it) } + values("button ").map { buttonEvent(it) }

    private fun values(mark: String): List<String> = comments.map {
        it.second
    }.filter { it.startsWith(mark) }.map { it.removePrefix(mark) }

    private fun byLine(mark: String): Map<Int, String> =
        comments.filter { it.second.startsWith(mark) }.associate { it.first to it.second.removePrefix(mark) }

    private fun sensorEvent(text: String): Event {
        val (port, time, raw) = checkNotNull(SENSOR.matchEntire(text)) { "Not a sensor: $text" }.destructured
        return Event.Sensor(time.toLong(), port.toInt() - 1, raw.toInt())
    }

    private fun buttonEvent(text: String): Event {
        val (name, time, action) = checkNotNull(BUTTON.matchEntire(text)) { "Not a button: $text" }.destructured
        return Event.Button(time.toLong(), BrickButton.valueOf(name), action == "pressed")
    }

    companion object {
        /** The expectations of each run of a test program, one for each of its modes. */
        fun ofRuns(source: String): List<Expectations> =
            ExpectationComments(source).modes.map { Expectations(source, it) }

        private val ROM = Regex("""rom(?: (\d+) times)?: (.+)""")
        private val SENSOR = Regex("""(\d) at (\d+): raw (\d+)""")
        private val BUTTON = Regex("""(\w+) at (\d+): (pressed|released)""")

        /** Line, name and `shows` come first. */
        private const val NUMBERS_OF_FAILURE = 3
    }
}

/**
 * An exception that a thread does not catch.
 *
 * @property name of its class.
 * @property numbers the numbers of the method and of the class, null if they do not matter.
 */
internal class ExpectedFailure(val line: Int, val name: String, val numbers: List<Int>?) {
    fun matches(failure: ProgramFailure): Boolean = failure.sourceLine == line && name in failure.message &&
        (numbers == null || numbers == listOf(failure.methodNumber, failure.exceptionNumber))

    override fun toString() = "$line $name ${numbers.orEmpty()}"
}

/** An input to the brick while a program runs. */
internal sealed interface Event {
    val milliseconds: Long

    class Sensor(override val milliseconds: Long, val port: Int, val raw: Int) : Event

    class Button(override val milliseconds: Long, val button: BrickButton, val isPressed: Boolean) : Event
}
