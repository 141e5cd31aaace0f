package robotran.workshop.run

import robotran.legofirmware.device.DatalogEntry

/**
 * Where a value of the datalog comes from, in NQC's words, which are the same in all languages.
 *
 * @param variables the names of the variables by number.
 */
fun DatalogEntry.origin(variables: Map<Int, String>): String = when (type) {
    in VARIABLES -> variables[type - VARIABLES.first] ?: "var[${type - VARIABLES.first}]"
    in TIMERS -> "Timer(${type - TIMERS.first})"
    in SENSORS -> "SENSOR_${type - SENSORS.first + 1}"
    WATCH -> "Watch()"
    else -> "$type"
}

/**
 * A table with a line for each entry, to open in a spreadsheet.
 *
 * @param variables the names of the variables by number.
 */
internal fun List<DatalogEntry>.toCsv(variables: Map<Int, String>): String = buildString {
    append("number,source,value\r\n")
    this@toCsv.forEachIndexed { index, entry -> append("${index + 1},${entry.origin(variables)},${entry.value}\r\n") }
}

private val VARIABLES = 0x00..0x1F
private val TIMERS = 0x20..0x23
private val SENSORS = 0x40..0x42
private const val WATCH = 0x80
