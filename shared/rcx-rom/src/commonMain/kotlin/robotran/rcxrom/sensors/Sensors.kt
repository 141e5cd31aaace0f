package robotran.rcxrom.sensors

import robotran.rcxrom.memory.FirmwareMemory
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.Registers

/**
 * The three input ports and the firmware's sensor table. The table is in the firmware's part of the memory, one
 * `sensor_t` per port: type, mode, raw value (2 bytes), value (2 bytes), boolean. Programs read the table, not the
 * ports, so they see a change only after the firmware's next reading. Sources: leJOS `sensors.c`, brickEmu's ROM
 * re-implementation.
 */
internal class Sensors(private val memory: RcxMemory) {
    /** The last position of each rotation sensor that was read twice in a row. */
    private val lastPositions = IntArray(SensorCode.PORTS)

    init {
        memory.setBits(Registers.PORT_6_DIRECTIONS, Registers.SENSOR_PINS, on = true)
        for (port in 0..<SensorCode.PORTS) {
            measure(port, SensorCode.OPEN_RAW)
            memory.writeShort(tableAddress(port) + RAW_OFFSET, SensorCode.OPEN_RAW)
            set(port, SensorField.TYPE, SensorCode.TYPE_LIGHT)
            set(port, SensorField.MODE, SensorCode.MODE_PERCENT)
            read(port, tableAddress(port))
        }
    }

    /** The firmware's last reading of each port. */
    val states: List<SensorState>
        get() = (0..<SensorCode.PORTS).map { port ->
            SensorState(
                port + 1,
                SensorMode.of(memory.readByte(tableAddress(port) + MODE_OFFSET)),
                value(port, SensorRequest.RAW),
                value(port, SensorRequest.CANONICAL),
                value(port, SensorRequest.BOOLEAN) != 0,
                isActive(port),
            )
        }

    /** Sets what the converter of [port] measures from now on, 0..1023. */
    fun measure(port: Int, value: Int) {
        memory.writeShort(converter(port), value.coerceIn(0, SensorCode.OPEN_RAW) shl Registers.CONVERTER_SHIFT)
    }

    /** The code that a program has set as the type of [port]. */
    fun type(port: Int): Int = memory.readByte(tableAddress(port))

    fun set(port: Int, field: SensorField, value: Int) {
        val address = tableAddress(port)
        when (field) {
            SensorField.TYPE -> memory.writeByte(address, value)
            SensorField.MODE -> memory.writeByte(address + MODE_OFFSET, value)
            SensorField.VALUE -> memory.writeShort(address + VALUE_OFFSET, value)
            SensorField.BOOLEAN -> memory.writeByte(address + BOOLEAN_OFFSET, value)
        }
    }

    fun value(port: Int, request: SensorRequest): Int {
        val address = tableAddress(port)
        return when (request) {
            SensorRequest.RAW -> memory.readShort(address + RAW_OFFSET)
            SensorRequest.CANONICAL -> memory.readShort(address + VALUE_OFFSET)
            SensorRequest.BOOLEAN -> memory.readByte(address + BOOLEAN_OFFSET)
        }
    }

    /** Reads [port] into the `sensor_t` at [address], like the ROM. */
    fun read(port: Int, address: Int) {
        val raw = memory.readWord(converter(port)) shr Registers.CONVERTER_SHIFT
        val mode = memory.readByte(address + MODE_OFFSET)
        val rawBefore = memory.readShort(address + RAW_OFFSET)
        val boolean = SensorReading.boolean(raw, memory.readByte(address + BOOLEAN_OFFSET), rawBefore, mode)
        memory.writeShort(address + RAW_OFFSET, raw)
        when (SensorMode.of(mode)) {
            SensorMode.EDGE -> countEdges(port, address, boolean, everySecond = false)
            SensorMode.PULSE -> countEdges(port, address, boolean, everySecond = true)
            SensorMode.RAW -> write(address, boolean, raw)
            SensorMode.BOOLEAN -> write(address, boolean, boolean)
            SensorMode.PERCENT -> write(address, boolean, SensorReading.percent(raw))
            SensorMode.CELSIUS -> write(address, boolean, SensorReading.celsius(raw))
            SensorMode.FAHRENHEIT -> write(address, boolean, SensorReading.fahrenheit(raw))
            SensorMode.ANGLE -> write(address, boolean, memory.readShort(address + VALUE_OFFSET) + turn(port, raw))
        }
    }

    /** Whether [port] is powered. A light sensor needs power for its lamp. */
    fun isActive(port: Int): Boolean =
        memory.readByte(ACTIVE_PORTS) and memory.readByte(Registers.PORT_6_DIRECTIONS) and portBit(port) != 0

    /** Switches the power of the ports in [bits], see [portBit]. */
    fun setActive(bits: Int, active: Boolean) = memory.setBits(ACTIVE_PORTS, bits, active)

    /** Reads the ports every third millisecond, like the firmware. */
    fun tick(milliseconds: Long) {
        if (milliseconds % SensorCode.READING_MILLISECONDS == 0L) {
            for (port in 0..<SensorCode.PORTS) poll(port)
        }
    }

    /**
     * Like leJOS, accepts a rotation sensor's position only when it is read twice in a row, and counts itself instead
     * of the ROM.
     */
    private fun poll(port: Int) {
        val address = tableAddress(port)
        if (SensorMode.of(memory.readByte(address + MODE_OFFSET)) != SensorMode.ANGLE) return read(port, address)
        val placeAddress = RomAssumptions.ANGLE_STATES + port
        val placeBefore = memory.readByte(placeAddress)
        memory.writeByte(placeAddress, NO_POSITION)
        read(port, address)
        val place = memory.readByte(placeAddress)
        if (place != placeBefore || place !in PLACES) return
        val step = SensorReading.angleStep(lastPositions[port], place)
        memory.writeShort(address + VALUE_OFFSET, memory.readShort(address + VALUE_OFFSET) + step)
        lastPositions[port] = place
    }

    private fun write(address: Int, boolean: Int, value: Int) {
        memory.writeByte(address + BOOLEAN_OFFSET, boolean)
        memory.writeShort(address + VALUE_OFFSET, value)
    }

    private fun turn(port: Int, raw: Int): Int {
        val place = SensorReading.anglePosition(raw) ?: return 0
        val before = memory.readByte(RomAssumptions.ANGLE_STATES + port)
        memory.writeByte(RomAssumptions.ANGLE_STATES + port, place)
        return if (before in PLACES) SensorReading.angleStep(before, place) else 0
    }

    private fun countEdges(port: Int, address: Int, boolean: Int, everySecond: Boolean) {
        if (memory.readByte(EDGE_BEGUN + port) == 0) {
            memory.writeByte(EDGE_BEGUN + port, 1)
            memory.writeByte(EDGE_DEBOUNCE + port, 1)
            memory.writeByte(address + BOOLEAN_OFFSET, boolean)
            return
        }
        val wait = memory.readByte(EDGE_DEBOUNCE + port) - 1
        if (wait <= 0 && boolean != memory.readByte(address + BOOLEAN_OFFSET)) {
            memory.writeByte(EDGE_DEBOUNCE + port, RomAssumptions.EDGE_DEBOUNCE_READINGS)
            memory.writeByte(address + BOOLEAN_OFFSET, boolean)
            if (!everySecond || isFirstOfTwo(port)) {
                memory.writeShort(
                    address + VALUE_OFFSET,
                    memory.readShort(address + VALUE_OFFSET) + 1,
                )
            }
        } else {
            memory.writeByte(EDGE_DEBOUNCE + port, maxOf(1, wait))
        }
    }

    private fun isFirstOfTwo(port: Int): Boolean {
        val first = memory.readByte(PULSE_HALF + port) xor 1
        memory.writeByte(PULSE_HALF + port, first)
        return first != 0
    }

    private fun converter(port: Int): Int = Registers.CONVERTER_OF_PORT_1 - 2 * port

    private fun tableAddress(port: Int): Int = FirmwareMemory.SENSOR_TABLE + port * FirmwareMemory.SENSOR_ENTRY_BYTES

    companion object {
        /** The ROM's own byte of the powered ports: 4, 2 and 1 for ports 1, 2 and 3. */
        const val ACTIVE_PORTS = 0xEFD5

        /**
         * One byte per port each: whether edge counting has started, readings left to ignore edges, whether half a
         * pulse is over.
         */
        const val EDGE_BEGUN = 0xEF35
        const val EDGE_DEBOUNCE = 0xEF38
        const val PULSE_HALF = 0xEF3B

        private const val MODE_OFFSET = 1
        private const val RAW_OFFSET = 2
        private const val VALUE_OFFSET = 4
        private const val BOOLEAN_OFFSET = 6
        private const val NO_POSITION = 0xFF
        private val PLACES = 0..3

        /** The bit of [port], 0..2, in the byte of the powered ports. */
        fun portBit(port: Int): Int = SensorCode.FIRST_PORT_BIT shr port
    }
}
