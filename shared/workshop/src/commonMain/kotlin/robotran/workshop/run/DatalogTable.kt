package robotran.workshop.run

import robotran.legofirmware.device.DatalogEntry

/** Where a value of the datalog comes from, in NQC's words, which are the same in all languages. */
val DatalogEntry.origin: String
    get() = when (type) {
        in VARIABLES -> "var[${type - VARIABLES.first}]"
        in TIMERS -> "Timer(${type - TIMERS.first})"
        in SENSORS -> "SENSOR_${type - SENSORS.first + 1}"
        WATCH -> "Watch()"
        else -> "$type"
    }

/** A table with a line for each entry, to open in a spreadsheet. */
internal fun List<DatalogEntry>.toCsv(): String = buildString {
    append("number,source,value\r\n")
    this@toCsv.forEachIndexed { index, entry -> append("${index + 1},${entry.origin},${entry.value}\r\n") }
}

private val VARIABLES = 0x00..0x1F
private val TIMERS = 0x20..0x23
private val SENSORS = 0x40..0x42
private const val WATCH = 0x80
