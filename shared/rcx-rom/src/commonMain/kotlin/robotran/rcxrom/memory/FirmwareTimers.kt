package robotran.rcxrom.memory

/**
 * The counters of the ROM's millisecond handler: its own, and the firmware's at the address passed to routine 0x3b9a.
 * leJOS uses only the clock that it counts itself. Sources of addresses and periods: leJOS `rom.h`, brickEmu's ROM
 * re-implementation.
 */
internal class FirmwareTimers(private val memory: RcxMemory) {
    private val timers: Int get() = memory.readWord(TIMERS_POINTER)
    private val flags: Int get() = memory.readWord(FLAGS_POINTER)

    init {
        begin(FirmwareMemory.TIMERS, FirmwareMemory.HANDLER_FLAGS)
    }

    /** Sets the addresses of the timers and of the handler flags, and resets the ROM's own counters. */
    fun begin(timers: Int, flags: Int) {
        memory.writeShort(TIMERS_POINTER, timers)
        memory.writeShort(FLAGS_POINTER, flags)
        memory.writeByte(MILLISECONDS, 0)
        memory.writeByte(TENTH, 0)
        memory.writeByte(HANDLER_COUNTER, 1)
        resetMinute()
    }

    fun resetMinute() = memory.writeShort(HUNDREDTHS_OF_MINUTE, 0)

    /** Advances by one millisecond. */
    fun tick() {
        val millisecond = memory.readByte(MILLISECONDS) % MILLISECOND_PERIOD + 1
        memory.writeByte(MILLISECONDS, millisecond)
        countDown(timers)
        for (motor in 0..<MOTOR_TIMERS) {
            if (countDown(timers + MOTOR_TIMER + 2 * motor) == 0) flag(MOTOR_FLAG)
        }
        countDown(timers + WAKEUP_DELAY + 2 * (millisecond % WAKEUP_DELAYS))
        if (millisecond % HUNDREDTH == 0) hundredth()
        val tenth = (memory.readByte(TENTH) + 1) % MILLISECONDS_IN_TENTH
        memory.writeByte(TENTH, tenth)
        if (tenth == 0) repeat(TIMERS) { countUp(timers + FIRST_TIMER + 2 * it) }
    }

    private fun hundredth() {
        val count = memory.readByte(HANDLER_COUNTER) + 1
        memory.writeByte(HANDLER_COUNTER, if (count >= HANDLER_PERIOD) 0 else count)
        if (count >= HANDLER_PERIOD) HANDLER_FLAGS.forEach(::flag)
        val hundredths = memory.readWord(HUNDREDTHS_OF_MINUTE) + 1
        memory.writeShort(HUNDREDTHS_OF_MINUTE, if (hundredths >= HUNDREDTHS_IN_MINUTE) 0 else hundredths)
        if (hundredths >= HUNDREDTHS_IN_MINUTE) minute()
    }

    private fun minute() {
        countDown(timers + POWER_OFF_MINUTES)
        val minutes = memory.readWord(timers + CLOCK_MINUTES) + 1
        memory.writeShort(timers + CLOCK_MINUTES, if (minutes >= MINUTES_IN_DAY) 0 else minutes)
    }

    /** Decrements a word that is above 0. Returns the new value, or null if it was 0. */
    private fun countDown(address: Int): Int? {
        val count = memory.readWord(address)
        if (count == 0) return null
        memory.writeShort(address, count - 1)
        return count - 1
    }

    private fun countUp(address: Int) = memory.writeShort(address, (memory.readWord(address) + 1) and LARGEST_TIMER)

    private fun flag(number: Int) = memory.setBits(flags + number, HANDLER_RUNS, on = true)

    companion object {
        /** Addresses of the pointers to the firmware's timers and to the flags of its handlers. */
        const val TIMERS_POINTER = 0xEFC6
        const val FLAGS_POINTER = 0xEFC8

        /**
         * The ROM's own counters: 1..30 milliseconds, milliseconds of a tenth, hundredths of a minute, hundredths until
         * handlers run.
         */
        const val MILLISECONDS = 0xEFCF
        const val TENTH = 0xEFD0
        const val HUNDREDTHS_OF_MINUTE = 0xEFD2
        const val HANDLER_COUNTER = 0xEFD4

        /** Offsets of the firmware's timers, all words; the infrared receive timer is at 0. */
        const val FIRST_TIMER = 0x02
        const val CLOCK_MINUTES = 0x0A
        const val POWER_OFF_MINUTES = 0x0C
        const val WAKEUP_DELAY = 0x0E
        const val MOTOR_TIMER = 0x22

        /** A minute is one hundredth of a second too long, as on a real brick. */
        const val HUNDREDTHS_IN_MINUTE = 6001
        const val MINUTES_IN_DAY = 1440

        private const val TIMERS = 4
        private const val MOTOR_TIMERS = 3
        private const val WAKEUP_DELAYS = 10
        private const val MILLISECOND_PERIOD = 30
        private const val HUNDREDTH = 10
        private const val MILLISECONDS_IN_TENTH = 100
        private const val HANDLER_PERIOD = 13
        private const val LARGEST_TIMER = 0x7FFF
        private const val HANDLER_RUNS = 0x80
        private const val MOTOR_FLAG = 1
        private val HANDLER_FLAGS = listOf(2, 3)
    }
}
