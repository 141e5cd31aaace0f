package robotran.rcxrom.sensors

/**
 * The raw value conversions of the ROM's routine 0x14c0, with its integer formulas and their quirks. Sources: Kekoa
 * Proudfoot's disassembly as quoted on LUGNET, brickEmu's ROM re-implementation, leJOS `sensors.c`.
 */
internal object SensorReading {
    private const val SLOPES = 0x1F
    private const val TRUE_BELOW = 460
    private const val HUNDRED_PERCENT_BELOW = 391
    private const val PERCENT = 100

    /** The value of a temperature sensor that is missing or out of range. */
    const val NO_TEMPERATURE = 0x7FFF

    private const val COLDEST_FROM = 928
    private const val HOTTEST_BELOW = 290

    /** For raw values below the first number: slope and offset in hundredths of tenths of a degree. */
    private val TEMPERATURE_PIECES = listOf(
        Triple(340, -261, 145_200),
        Triple(390, -194, 123_000),
        Triple(478, -144, 103_500),
        Triple(520, -123, 93_600),
        Triple(790, -107, 85_200),
        Triple(886, -134, 106_600),
        Triple(COLDEST_FROM, -175, 142_600),
    )
    private const val HUNDREDTHS = 100

    /** The positions of a rotation sensor follow the cycle 0, 1, 3, 2. */
    private val ANGLE_STEPS = listOf(listOf(0, 1, -1, 0), listOf(-1, 0, 0, 1), listOf(1, 0, 0, -1), listOf(0, -1, 1, 0))
    private val ANGLE_BANDS = listOf(320..511, 512..767, 768..959, 960..1023)

    /**
     * 1 or 0. Without a slope a low value is true and a high one false. With a slope, a jump of [raw] by at least the
     * slope changes the result. Otherwise the result stays as it was.
     */
    fun boolean(raw: Int, before: Int, rawBefore: Int, modeAndSlope: Int): Int {
        val slope = modeAndSlope and SLOPES
        return when {
            slope == 0 -> if (raw < TRUE_BELOW) {
                1
            } else if (raw >= RomAssumptions.FALSE_FROM) {
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

    /** 0..100, and 101 for raw values of 391 and 392, as on a real brick. */
    fun percent(raw: Int): Int = if (raw < HUNDRED_PERCENT_BELOW) PERCENT else (SensorCode.OPEN_RAW - raw) * 25 / 156

    /** Tenths of a degree, or [NO_TEMPERATURE]. */
    fun celsius(raw: Int): Int {
        if (raw !in HOTTEST_BELOW..<COLDEST_FROM) return NO_TEMPERATURE
        val (_, slope, offset) = TEMPERATURE_PIECES.first { (below, _, _) -> raw < below }
        return (raw * slope + offset) / HUNDREDTHS
    }

    /** Tenths of a degree, or [NO_TEMPERATURE]. */
    fun fahrenheit(raw: Int): Int {
        val celsius = celsius(raw)
        return if (celsius == NO_TEMPERATURE) NO_TEMPERATURE else celsius * 18 / 10 + 320
    }

    /** The position of a rotation sensor, 0..3; null if [raw] fits none. */
    fun anglePosition(raw: Int): Int? = ANGLE_BANDS.indexOfFirst { raw in it }.takeIf { it >= 0 }

    /** The rotation between two positions, each 0..3: 1, -1, or 0 for a jump of two, which has no known direction. */
    fun angleStep(from: Int, to: Int): Int = ANGLE_STEPS[from][to]
}
