package robotran.robolang

import robotran.rcxrom.call.RomCall

/** The expectations in the comments of a test program; `resources/programs/README.md` describes them. */
internal class Expectations(text: String) {
    /** The errors as `line:column message`, in source order. */
    val errors = mutableListOf<String>()

    /** The warnings as `line:column message`, in source order; empty if unspecified. */
    val warnings = mutableListOf<String>()

    /** The ROM calls of each line that has any. */
    val calls = mutableMapOf<Int, List<RomCall>>()

    /** All ROM calls with their times and lines; empty if unspecified. */
    val log = mutableListOf<RecordedCall>()

    /** The millisecond at which the program ends; null if unspecified. */
    var end: Long? = null
        private set

    /** The numbers that each line shows on the LCD, in order. */
    val shown = mutableMapOf<Int, List<String>>()

    val sensors = mutableListOf<SensorEvent>()

    /** The runtime error as `line message`; null if there is none. */
    var failure: String? = null
        private set

    /** What an NXT senses that is no number of a port: `distance`, `colour` or `button` from a millisecond on. */
    val senses = mutableListOf<NxtSense>()

    /** The calls of each line that has any, on an NXT. */
    val nxtCalls = mutableMapOf<Int, List<String>>()

    val isEmpty: Boolean
        get() = nxtCalls.isEmpty() && errors.isEmpty() && calls.isEmpty() && log.isEmpty() && end == null &&
            shown.isEmpty() &&
            failure == null &&
            warnings.isEmpty()

    init {
        text.lines().forEachIndexed { index, line -> read(line.substringAfter("//", "").trim(), index + 1) }
    }

    private fun read(comment: String, line: Int) {
        SHOWS.matchEntire(comment)?.let { shown[line] = it.groupValues[1].split(" ") }
        FAILS.matchEntire(comment)?.let { failure = it.groupValues[1] }
        SENSOR.matchEntire(comment)?.destructured?.let { (port, milliseconds, raw) ->
            sensors += SensorEvent(port.toInt(), milliseconds.toLong(), raw.toInt())
        }
        SENSE.matchEntire(comment)?.destructured?.let { (what, port, milliseconds, value) ->
            senses += NxtSense(what, port.toIntOrNull(), milliseconds.toLong(), value)
        }
        NXT.matchEntire(comment)?.let { nxtCalls[line] = it.groupValues[1].split(" | ") }
        ERROR.matchEntire(comment)?.let { errors += it.groupValues[1] }
        WARNING.matchEntire(comment)?.let { warnings += it.groupValues[1] }
        END.matchEntire(comment)?.let { end = it.groupValues[1].toLong() }
        ROM.matchEntire(comment)?.let {
            val once = it.groupValues[2].split("|").map(::callOf)
            val times = it.groupValues[1].ifEmpty { "1" }.toInt()
            calls[line] = (1..times).flatMap { once }
        }
        LOG.matchEntire(comment)?.let {
            log += RecordedCall(it.groupValues[1].toLong(), callOf(it.groupValues[2]), it.groupValues[3].toInt())
        }
    }

    private companion object {
        val ERROR = Regex("""error (\d+:\d+ .+)""")
        val WARNING = Regex("""warning (\d+:\d+ .+)""")
        val END = Regex("""ends at (\d+)""")
        val ROM = Regex("""rom(?: (\d+) times)?: (.+)""")
        val SHOWS = Regex("""shows: (.+)""")
        val FAILS = Regex("""fails (\d+ .+)""")
        val SENSOR = Regex("""sensor (\d) at (\d+): raw (\d+)""")
        val SENSE = Regex("""(distance|colour|button)(?: on (\d))? at (\d+): (\w+)""")
        val NXT = Regex("""nxt: (.+)""")
        val LOG = Regex("""log: (\d+) (.+) ; (\d+)""")
    }
}

/** From [milliseconds] on, [what] on the [port] 1..4, or on all if it is null, has a [value]. */
internal data class NxtSense(val what: String, val port: Int?, val milliseconds: Long, val value: String)

private fun callOf(text: String): RomCall {
    val words = text.trim().split(" ").map(::wordOf)
    return RomCall(words.first(), words.drop(1))
}

private fun wordOf(text: String): Int =
    (if (text.startsWith("0x")) text.drop(2).toInt(radix = 16) else text.toInt()) and 0xFFFF
