package robotran.rom

/**
 * The three input ports and the firmware's table of what they measure. The table lies in the firmware's part of the memory, a `sensor_t` a
 * port: type, mode, raw value (2 bytes), value (2 bytes), boolean. Programs read the table, not the ports, so they see
 * a change only after the firmware's next reading. Source: leJOS `sensors.c`.
 */
internal class Sensors(private val memory: RcxMemory) {
    private val raw = IntArray(SensorCode.PORTS) { SensorCode.OPEN_RAW }

    init {
        for (port in 0..<SensorCode.PORTS) {
            memory.writeShort(tableAddress(port) + RAW_OFFSET, SensorCode.OPEN_RAW)
            setTypeAndMode(port, SensorCode.TYPE_LIGHT, SensorCode.MODE_PERCENT)
            read(port, tableAddress(port))
        }
    }

    /** What the converter of [port] measures from now on, 0..1023. */
    fun measure(port: Int, value: Int) {
        raw[port] = value.coerceIn(0, SensorCode.OPEN_RAW)
    }

    fun setTypeAndMode(port: Int, type: Int, mode: Int) {
        memory.writeByte(tableAddress(port), type)
        memory.writeByte(tableAddress(port) + MODE_OFFSET, mode)
    }

    fun value(port: Int, request: SensorRequest): Int {
        val address = tableAddress(port)
        return when (request) {
            SensorRequest.RAW -> memory.readShort(address + RAW_OFFSET)
            SensorRequest.CANONICAL -> memory.readShort(address + VALUE_OFFSET)
            SensorRequest.BOOLEAN -> memory.readByte(address + BOOLEAN_OFFSET)
        }
    }

    /** Reads [port] into the `sensor_t` at [address]; false if its mode is not modelled, then its value stays as it was. */
    fun read(port: Int, address: Int): Boolean {
        val mode = memory.readByte(address + MODE_OFFSET)
        val rawBefore = memory.readShort(address + RAW_OFFSET)
        val boolean = SensorReading.boolean(raw[port], memory.readByte(address + BOOLEAN_OFFSET), rawBefore, mode)
        memory.writeShort(address + RAW_OFFSET, raw[port])
        memory.writeByte(address + BOOLEAN_OFFSET, boolean)
        if (!SensorReading.isModelled(mode)) return false
        memory.writeShort(address + VALUE_OFFSET, SensorReading.canonical(raw[port], boolean, mode))
        return true
    }

    /** Whether [port] is supplied with power, as a light sensor needs it to shine. */
    fun isActive(port: Int): Boolean = memory.readByte(ACTIVE_PORTS) and activeBit(port) != 0

    fun setActive(port: Int, active: Boolean) {
        val others = memory.readByte(ACTIVE_PORTS) and activeBit(port).inv()
        memory.writeByte(ACTIVE_PORTS, if (active) others or activeBit(port) else others)
    }

    /** The firmware's reading, every third millisecond. */
    fun tick(milliseconds: Long) {
        if (milliseconds % SensorCode.READING_MILLISECONDS == 0L) {
            for (port in 0..<SensorCode.PORTS) read(port, tableAddress(port))
        }
    }

    private fun tableAddress(port: Int): Int = TABLE + port * ENTRY_BYTES

    private fun activeBit(port: Int): Int = FIRST_PORT_BIT shr port

    private companion object {
        /** In the firmware's part of the memory, behind the variable of its own calls. */
        const val TABLE = 0x8010

        /** Seven bytes, and one more so that shorts have even addresses. */
        const val ENTRY_BYTES = 8
        const val MODE_OFFSET = 1
        const val RAW_OFFSET = 2
        const val VALUE_OFFSET = 4
        const val BOOLEAN_OFFSET = 6

        /** The ROM's own byte of the active ports: 4, 2 and 1 for the ports 1, 2 and 3. */
        const val ACTIVE_PORTS = 0xEFD5
        const val FIRST_PORT_BIT = 4
    }
}
