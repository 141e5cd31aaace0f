package robotran.legofirmware.device

/**
 * A datalog as a table for spreadsheets: a line of names, then a line for each entry, with commas between.
 *
 * `source` is a [DatalogSource] in lower case, `number` is [DatalogEntry.sourceNumber]. A sensor has the value of its
 * mode, a timer tenths of a second, and the watch minutes since midnight.
 */
fun csvOf(entries: List<DatalogEntry>): String = buildString {
    append("entry,source,number,value\n")
    entries.forEachIndexed { index, entry ->
        append("${index + 1},${entry.source.name.lowercase()},${entry.sourceNumber ?: ""},${entry.value}\n")
    }
}

/** Where a value of the datalog is from. */
enum class DatalogSource {
    VARIABLE,
    TIMER,
    SENSOR,
    WATCH,

    /** A type that the firmware does not write. */
    OTHER,
}

val DatalogEntry.source: DatalogSource
    get() = when (type) {
        in VARIABLES -> DatalogSource.VARIABLE
        in TIMERS -> DatalogSource.TIMER
        in SENSORS -> DatalogSource.SENSOR
        WATCH -> DatalogSource.WATCH
        else -> DatalogSource.OTHER
    }

/**
 * Which variable, timer or sensor, as a pupil calls it: variables from 0, timers and sensors from 1. The type itself for
 * others; null for the watch.
 */
val DatalogEntry.sourceNumber: Int?
    get() = when (source) {
        DatalogSource.VARIABLE -> type
        DatalogSource.TIMER -> type - TIMERS.first + 1
        DatalogSource.SENSOR -> type - SENSORS.first + 1
        DatalogSource.WATCH -> null
        DatalogSource.OTHER -> type
    }

// Source: Proudfoot's opcode reference.
private val VARIABLES = 0x00..0x1F
private val TIMERS = 0x20..0x23
private val SENSORS = 0x40..0x42
private const val WATCH = 0x80
