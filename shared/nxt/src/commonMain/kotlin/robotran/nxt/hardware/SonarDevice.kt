package robotran.nxt.hardware

/** What an ultrasonic sensor hears. */
fun interface Echoes {
    /**
     * Distances in centimetres of what answers a ping now, nearest first, at most 8; empty if nothing does.
     *
     * @param ping the pings of the sensor before this one.
     */
    fun of(ping: Long): DoubleArray
}

/**
 * The ultrasonic sensor of the NXT: it pings once, or again and again, and keeps what it has heard in whole
 * centimetres. 255 is nothing.
 */
class SonarDevice(private val echoes: Echoes, private val clock: Clock) : I2cDevice {
    override val address: Int get() = ADDRESS

    /** The nearest distance that it has heard. */
    override val reading: Int get() = distances[0]

    override var hasMeasured = false
        private set

    private var mode = MODE_OFF
    private var interval = 1
    private val calibration = intArrayOf(0, 1, FACTORY_DIVISOR)
    private var distances = SILENCE
    private var register = 0
    private var pings = 0L
    private var nextPing = NEVER
    private var heard = SILENCE
    private var heardAt = NEVER

    /** When the last ping went out, on the clock of the brick; null if none did. */
    var pingedAt: Long? = null
        private set

    override fun write(data: ByteArray) {
        register = data[0].toInt() and BYTE
        for (index in 1..<data.size) store(register + index - 1, data[index].toInt() and BYTE)
    }

    override fun read(count: Int): ByteArray {
        val bytes = bytesFrom(register)
        return ByteArray(count) { bytes.getOrElse(it) { 0 }.toByte() }
    }

    override fun tick() {
        val now = clock.milliseconds()
        if (now >= heardAt) {
            distances = heard
            hasMeasured = true
            heardAt = NEVER
        }
        if (now >= nextPing) ping(now)
    }

    override fun switchOff() = begin(MODE_RESET)

    private fun ping(now: Long) {
        pingedAt = now
        val all = echoes.of(pings++).take(ECHOES).map { inCentimetres(it) }.filter { it < NOTHING }
        val kept = if (mode == MODE_CONTINUOUS) all.take(1) else all
        heard = IntArray(ECHOES) { kept.getOrElse(it) { NOTHING } }
        heardAt = now + FLIGHT_MILLISECONDS
        nextPing = if (mode == MODE_CONTINUOUS) now + CYCLE_MILLISECONDS * interval else NEVER
    }

    private fun store(register: Int, value: Int) {
        when (register) {
            INTERVAL -> interval = maxOf(1, value)
            MODE -> begin(value)
            in CALIBRATION..<CALIBRATION + calibration.size -> calibration[register - CALIBRATION] = value
        }
    }

    private fun begin(newMode: Int) {
        mode = if (newMode == MODE_RESET) MODE_OFF else newMode
        if (newMode == MODE_RESET) {
            interval = 1
            distances = SILENCE
            hasMeasured = false
        }
        heardAt = NEVER
        nextPing = if (mode == MODE_PING || mode == MODE_CONTINUOUS) clock.milliseconds() else NEVER
    }

    /** A text has its own register, so the ones within a text mean something else. */
    private fun bytesFrom(register: Int): List<Int> = when (register) {
        VERSION -> text("V1.0")
        VENDOR -> text("LEGO")
        PRODUCT -> text("Sonar")
        in FACTORY..FACTORY + FACTORY_DATA.lastIndex -> FACTORY_DATA.drop(register - FACTORY)
        UNITS -> text("10E-2m")

        in INTERVAL..LAST -> (
            listOf(
                interval,
                mode,
            ) + distances.toList() + calibration.toList()
        ).drop(register - INTERVAL)

        else -> emptyList()
    }

    private fun text(text: String): List<Int> = text.map { it.code }

    private fun inCentimetres(distance: Double): Int =
        if (distance < FARTHEST) maxOf(0, (distance + ROUNDING).toInt()) else NOTHING

    companion object {
        const val ADDRESS = 0x02

        /** Time from one ping to the next. Source: robojoy-club, by oscilloscope. */
        const val CYCLE_MILLISECONDS = 50L

        /** What it says when it hears nothing. */
        const val NOTHING = 255

        /** From a ping until an echo from the farthest distance is back. */
        private const val FLIGHT_MILLISECONDS = 15L

        private const val FARTHEST = 254.5
        private const val ROUNDING = 0.5
        private const val ECHOES = 8
        private const val BYTE = 0xFF
        private const val NEVER = Long.MAX_VALUE
        private val SILENCE = IntArray(ECHOES) { NOTHING }

        // Registers. Source: LEGO's table of I2C commands.
        private const val VERSION = 0x00
        private const val VENDOR = 0x08
        private const val PRODUCT = 0x10
        private const val FACTORY = 0x11
        private const val UNITS = 0x14
        private const val INTERVAL = 0x40
        private const val MODE = 0x41
        private const val CALIBRATION = 0x4A
        private const val LAST = 0x4C

        private const val FACTORY_DIVISOR = 14
        private val FACTORY_DATA = listOf(0, 1, FACTORY_DIVISOR)

        private const val MODE_OFF = 0
        private const val MODE_PING = 1
        private const val MODE_CONTINUOUS = 2
        private const val MODE_RESET = 4
    }
}
