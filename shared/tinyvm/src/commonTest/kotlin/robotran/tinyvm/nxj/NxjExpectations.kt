package robotran.tinyvm.nxj

import robotran.brick.controls.BrickButton

/** What the comments of a test program for an NXT say; the README of `shared/nxj-library` has the notation. */
internal class NxjExpectations(source: String) {
    private val lines: List<IndexedValue<String>> = source.lines().withIndex().map { IndexedValue(it.index + 1, it.value) }

    /** What each line prints, by its number. */
    val printed: Map<Int, List<String>> = lines.mapNotNull { (line, text) ->
        PRINTS.find(text)?.destructured?.let { (times, printed) ->
            line to if (times.isEmpty()) printed.split(" | ") else List(times.toInt()) { printed }
        }
    }.toMap()

    /** The exceptions that nobody catches, by the line that throws. */
    val failures: Map<Int, String> =
        lines.mapNotNull { (line, text) -> FAILS.find(text)?.let { line to it.groupValues[1] } }.toMap()

    /** The acting calls of each line that has a comment about them. */
    val calls: Map<Int, List<String>> = lines.mapNotNull { (line, text) ->
        CALLS.find(text)?.let { match -> line to match.groupValues[1].split('|').map { it.trim() } }
    }.toMap()

    /** The rows of the display at the end of the run, null if there is no comment about them. */
    val screen: List<String>? = lines.mapNotNull { (_, text) ->
        SCREEN.find(text)?.destructured?.let { (row, shown) -> row.toInt() to shown.trimEnd() }
    }.toMap().ifEmpty { null }?.let { rows -> List(ROWS) { rows[it].orEmpty() } }

    val inputs: List<NxjInput> = lines.mapNotNull { (_, text) ->
        SENSOR.find(text)?.destructured?.let { (port, time, raw) ->
            NxjInput.Analog(time.toLong(), port.toInt() - 1, raw.toInt())
        } ?: BUTTON.find(text)?.destructured?.let { (button, time, action) ->
            NxjInput.Button(time.toLong(), BrickButton.valueOf(button), action == "pressed")
        }
    }

    val endsAt: Long? = lines.firstNotNullOfOrNull { ENDS.find(it.value) }?.groupValues?.get(1)?.toLong()

    private companion object {
        const val ROWS = 8
        val PRINTS = Regex("""// prints(?: (\d+) times)?: ?(.*?)(?: // .*)?$""")
        val FAILS = Regex("""// fails (\w+)""")
        val CALLS = Regex("""// calls: (.*?)(?: // .*)?$""")
        val SCREEN = Regex("""// screen (\d): (.*)$""")
        val SENSOR = Regex("""// sensor (\d) at (\d+): raw (\d+)""")
        val BUTTON = Regex("""// button (\w+) at (\d+): (pressed|released)""")
        val ENDS = Regex("""// ends at (\d+)""")
    }
}

/** What happens to the brick at [milliseconds] after the start. */
internal sealed interface NxjInput {
    val milliseconds: Long

    /** The analog pin of a port, 0..3, measures [raw] from then on. */
    class Analog(override val milliseconds: Long, val port: Int, val raw: Int) : NxjInput

    class Button(override val milliseconds: Long, val button: BrickButton, val isPressed: Boolean) : NxjInput
}
