package robotran.legofirmware.device

/**
 * A datalog as a table for spreadsheets: a line of names, then a line for each entry, with commas between.
 *
 * `source` is `variable`, `timer`, `sensor`, `watch` or `other`; `number` is what a pupil calls it: variables from 0,
 * timers and sensors from 1, the type itself of others. A sensor has the value of its mode, a timer tenths of a second,
 * and the watch minutes since midnight.
 */
fun csvOf(entries: List<DatalogEntry>): String = buildString {
    append("entry,source,number,value\n")
    entries.forEachIndexed { index, entry ->
        val (source, number) = sourceOf(entry.type)
        append("${index + 1},$source,${number ?: ""},${entry.value}\n")
    }
}

private fun sourceOf(type: Int): Pair<String, Int?> = when (type) {
    in VARIABLES -> "variable" to type
    in TIMERS -> "timer" to type - TIMERS.first + 1
    in SENSORS -> "sensor" to type - SENSORS.first + 1
    WATCH -> "watch" to null
    else -> "other" to type
}

// Source: Proudfoot's opcode reference.
private val VARIABLES = 0x00..0x1F
private val TIMERS = 0x20..0x23
private val SENSORS = 0x40..0x42
private const val WATCH = 0x80
