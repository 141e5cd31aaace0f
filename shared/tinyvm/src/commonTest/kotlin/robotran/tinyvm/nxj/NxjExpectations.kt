package robotran.tinyvm.nxj

import robotran.brick.controls.BrickButton

/**
 * What the comments of a test program for an NXT say about its run:
 *
 * - `// expect TEXT`: the next line that the program prints. The comments are in the order of the lines.
 * - `// fails NAME`: an exception that nobody catches, with the line of the comment; `// fails NAME somewhere` with any.
 * - `// runs on after MILLISECONDS`: the program has not ended then.
 * - `// takes MILLISECONDS`: when the program ends at the speed of a brick, within a tenth and 20 ms.
 * - `// screen TEXT`: the next row of the display in the last millisecond of the program; no empty rows follow.
 * - `// calls NAME ARGUMENTS | ..`: what the line makes the brick do, each time together; `?` stands for any argument.
 * - `// press BUTTON at MILLISECONDS`: for a tenth of a second, or with `for MILLISECONDS`.
 * - `// sensor PORT at MILLISECONDS: raw NUMBER`: what the analog pin of a port from 1 to 4 measures from then on.
 * - `// only here`: the JVM of a computer does something else.
 */
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

    val screen: List<String> = after("screen").map { it.second }

    /** The calls of each line. */
    val calls: Map<Int, List<String>> =
        after("calls").associate { (line, text) -> line to text.split('|').map { it.trim() } }

    val presses: List<Press> = after("press").map { (_, text) ->
        val words = text.split(' ')
        val from = words[2].toLong()
        Press(BrickButton.valueOf(words[0]), from, from + (words.getOrNull(LENGTH_OF_PRESS)?.toLong() ?: USUAL_PRESS))
    }

    val analog: List<NxjBrickRun.Analog> = after("sensor").map { (_, text) ->
        val (port, time, raw) = checkNotNull(SENSOR.matchEntire(text)) { "Not a sensor: $text" }.destructured
        NxjBrickRun.Analog(port.toInt() - 1, time.toLong(), raw.toInt())
    }

    val isOnlyHere: Boolean = comments.any { it.second == "only here" }

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
