package robotran.rcxrom.memory

/**
 * The named parts of the memory. Sources: leJOS `rcx.lds` and `rom.h`, brickEmu's ROM re-implementation.
 *
 * @property addresses the first to the last byte.
 */
enum class MemoryRegion(val addresses: IntRange) {
    /** The code of the routines, which is not present here; read-only. */
    ROM(0x0000..0x7FFF),

    /** The firmware, with the results of its calls, its sensor table and its timers, see [FirmwareMemory]. */
    FIRMWARE(0x8000..0xBFFF),

    /** Programs and their data. */
    PROGRAM(0xC000..0xEF31),

    /** Per sensor: the position of a rotation sensor, and the state of edge counting. */
    SENSOR_COUNTERS(0xEF32..0xEF3D),

    /**
     * The content of the display after the next refresh, with the bus bytes before it and the step counters of circle
     * and dots.
     */
    DISPLAY(0xEF3E..0xEF4F),
    INFRARED(0xEF50..0xEFC5),

    /**
     * Pointers to the firmware's timers, directions and waveforms of the motors, the ROM's own counters, powered
     * sensors.
     */
    MOTORS_AND_TIMERS(0xEFC6..0xEFD5),

    /** The sound queue and the current note. */
    SOUND(0xEFD6..0xEFFF),

    /** The latch that switches the output ports. */
    MOTOR_LATCH(0xF000..0xF000),
    EXTERNAL(0xF001..0xFD7F),

    /** Settings of the processor's pins, which cannot be read back; vectors; the stack. */
    ON_CHIP(0xFD80..0xFF7F),

    /** The processor's registers: buttons, converters. */
    REGISTERS(0xFF80..0xFFFF),
    ;

    companion object {
        fun of(address: Int): MemoryRegion = entries.first { (address and 0xFFFF) in it.addresses }
    }
}
