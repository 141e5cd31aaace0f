package robotran.tinyvm.nxj

import robotran.brick.controls.BrickButton

/** What the comments of a test program for an NXT say; the README of `shared/nxj-library` has the notation. */
internal class NxjExpectations(source: String) {
    private val comments: List<Pair<Int, String>> = source.lines().mapIndexedNotNull { index, line ->
        COMMENT.find(line)?.let { index + 1 to it.groupValues[1] }
    }

    val printed: List<String> = after("expect").map { it.second }

    /** The uncaught exceptions, each with its line; 0 for any. */
    val failures: List<Pair<String, Int>> = after("fails").map { (line, text) ->
        text.substringBefore(' ') to if (text.endsWith(" somewhere")) 0 else line
    }

    val runsOnAfter: Long? = after("runs on after").singleOrNull()?.second?.toLong()

    val takes: Long? = after("takes").singleOrNull()?.second?.toLong()

    /** The rows of the display at the end, without empty ones behind them; null if there is no comment about them. */
    val screen: List<String>? = after("screen").map { it.second.trimEnd() }.ifEmpty { null }

    /** A program with comments about the display may say nothing of what it prints. */
    val saysWhatIsPrinted: Boolean get() = printed.isNotEmpty() || screen == null

    /** The calls of each line. */
    val calls: Map<Int, List<String>> =
        after("calls").associate { (line, text) -> line to text.split('|').map { it.trim() } }

    val inputs: List<NxjInput> = after("press").flatMap { (_, text) ->
        val words = text.split(' ')
        val button = BrickButton.valueOf(words[0])
        val from = words[2].toLong()
        val until = from + (words.getOrNull(LENGTH_OF_PRESS)?.toLong() ?: USUAL_PRESS)
        listOf(NxjInput.Button(from, button, isPressed = true), NxjInput.Button(until, button, isPressed = false))
    } + after("sensor").map { (_, text) ->
        val (port, time, raw) = checkNotNull(SENSOR.matchEntire(text)) { "Not a sensor: $text" }.destructured
        NxjInput.Analog(time.toLong(), port.toInt() - 1, raw.toInt())
    }

    private fun after(mark: String): List<Pair<Int, String>> =
        comments.filter { it.second == mark || it.second.startsWith("$mark ") }
            .map { (line, text) -> line to text.removePrefix(mark).removePrefix(" ") }

    private companion object {
        const val LENGTH_OF_PRESS = 4
        const val USUAL_PRESS = 100L
        val SENSOR = Regex("""(\d) at (\d+): raw (\d+)""")
        val COMMENT = Regex("""// ((?:expect|fails|runs on after|takes|only here|screen|calls|press|sensor)\b.*)$""")
    }
}

/** What happens to the brick at [milliseconds] after the start. */
internal sealed interface NxjInput {
    val milliseconds: Long

    /** The analog pin of a port, 0..3, measures [raw] from then on. */
    class Analog(override val milliseconds: Long, val port: Int, val raw: Int) : NxjInput

    class Button(override val milliseconds: Long, val button: BrickButton, val isPressed: Boolean) : NxjInput
}
