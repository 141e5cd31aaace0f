package robotran.rom

/**
 * What the ROM's routine 0x14c0 makes of a raw value, by its own whole-number formulas and with their quirks.
 * Sources: Kekoa Proudfoot's disassembly as quoted on LUGNET, the re-implemented ROM of brickEmu.
 */
internal object SensorReading {
    private const val MODES = 0xE0
    private const val SLOPES = 0x1F
    private const val TRUE_BELOW = 460
    private const val FALSE_FROM = 564
    private const val HUNDRED_PERCENT_BELOW = 391
    private const val PERCENT = 100

    fun modeOf(modeAndSlope: Int): Int = modeAndSlope and MODES

    /** Whether the value of the port is worked out by [canonical]. */
    fun isModelled(modeAndSlope: Int): Boolean =
        modeOf(modeAndSlope) in setOf(SensorCode.MODE_RAW, SensorCode.MODE_BOOLEAN, SensorCode.MODE_PERCENT)

    /**
     * 1 or 0. Without a slope a low value is true and a high one false; with one, a jump of [raw] by so much. In between it stays as it was.
     */
    fun boolean(raw: Int, before: Int, rawBefore: Int, modeAndSlope: Int): Int {
        val slope = modeAndSlope and SLOPES
        return when {
            slope == 0 -> if (raw < TRUE_BELOW) {
                1
            } else if (raw >= FALSE_FROM) {
                0
            } else {
                before
            }

            raw < slope -> 1

            raw > SensorCode.OPEN_RAW - slope -> 0

            rawBefore - raw >= slope -> 1

            raw - rawBefore > slope -> 0

            else -> before
        }
    }

    /** The value in the port's mode; raw values of 391 and 392 are 101 percent on a real brick, too. */
    fun canonical(raw: Int, boolean: Int, modeAndSlope: Int): Int = when (modeOf(modeAndSlope)) {
        SensorCode.MODE_BOOLEAN -> boolean
        SensorCode.MODE_PERCENT -> percent(raw)
        else -> raw
    }

    private fun percent(raw: Int): Int = if (raw < HUNDRED_PERCENT_BELOW) PERCENT else (SensorCode.OPEN_RAW - raw) * 25 / 156
}
