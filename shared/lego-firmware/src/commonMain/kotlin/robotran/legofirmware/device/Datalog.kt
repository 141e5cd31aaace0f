package robotran.legofirmware.device

/**
 * The datalog: entries of a type and a value. Entry 0 holds the number of entries, itself included.
 */
internal class Datalog {
    private val types = ArrayList<Int>()
    private val values = ArrayList<Int>()

    /** Entries that fit, without entry 0; 0 if there is no datalog. */
    var capacity = 0
        private set

    val used: Int get() = types.size

    /** Makes a new one for [entries]; 0 removes it. */
    fun create(entries: Int) {
        types.clear()
        values.clear()
        capacity = minOf(entries, MOST_ENTRIES)
    }

    /** Returns false if it is full. */
    fun add(type: Int, value: Int): Boolean {
        if (used >= capacity) return false
        types += type
        values += value
        return true
    }

    /** The type of entry [index]; 0 if there is none. */
    fun type(index: Int): Int = when {
        index == 0 && capacity > 0 -> SIZE_TYPE
        else -> types.getOrElse(index - 1) { 0 }
    }

    /** The value of entry [index]; 0 if there is none. */
    fun value(index: Int): Int = when {
        index == 0 && capacity > 0 -> used + 1
        else -> values.getOrElse(index - 1) { 0 }
    }

    fun setType(index: Int, type: Int) {
        if (index in 1..used) types[index - 1] = type and BYTE
    }

    fun setValue(index: Int, value: Int) {
        if (index in 1..used) values[index - 1] = value
    }

    /** A byte of the entries as they are in memory: three for each, its type, then its value, low byte first. */
    fun byte(index: Int): Int {
        if (index < 0) return 0
        val entry = index / ENTRY_BYTES
        return when (index % ENTRY_BYTES) {
            0 -> type(entry)
            1 -> value(entry) and BYTE
            else -> value(entry) shr Byte.SIZE_BITS and BYTE
        }
    }

    fun setByte(index: Int, byte: Int) {
        if (index < 0) return
        val entry = index / ENTRY_BYTES
        val low = byte and BYTE
        when (index % ENTRY_BYTES) {
            0 -> setType(entry, low)
            1 -> setValue(entry, (value(entry) and BYTE.inv()) or low)
            else -> setValue(entry, ((low shl Byte.SIZE_BITS) or (value(entry) and BYTE)).toShort().toInt())
        }
    }

    fun entries(): List<DatalogEntry> = types.indices.map { DatalogEntry(types[it], values[it]) }

    companion object {
        /** The type of entry 0. */
        private const val SIZE_TYPE = 0xFF
        private const val ENTRY_BYTES = 3
        private const val BYTE = 0xFF

        /** About 2000 fit into the memory of a brick. Source: its users. */
        const val MOST_ENTRIES = 2000
    }
}

/**
 * A value in the datalog.
 *
 * @property type 00..1f hex a variable, 20..23 a timer, 40..42 a sensor, 80 the watch.
 * @property value -32768..32767.
 */
data class DatalogEntry(val type: Int, val value: Int)
