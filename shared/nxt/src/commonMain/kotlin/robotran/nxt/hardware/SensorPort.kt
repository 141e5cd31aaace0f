package robotran.nxt.hardware

/** One sensor port, [number] 1..4: its pins, what they measure, and its I2C bus. */
internal class SensorPort(private val number: Int, clock: Clock) {
    val i2c = I2cBus(clock)
    private var type = SensorType.NO_SENSOR
    private var power = SensorPower.NONE
    private val pins = BooleanArray(PINS)
    private var measured = OPEN
    private var measuredUnitValue: Int? = null
    private var sampledUnitValue: Int? = null
    private var measuredColour = NO_COLOUR
    private var sampledColour = NO_COLOUR

    /** The analog value that a program reads. */
    var analog = OPEN
        private set

    private var current: SensorPortState? = null

    /** The state; the same object until something changes. */
    val state: SensorPortState
        get() {
            val reading = i2c.device?.reading
            val hasMeasured = i2c.device?.hasMeasured ?: true
            val known = current
            if (known != null && known.distance == reading && known.hasMeasured == hasMeasured) return known
            return SensorPortState(
                number,
                type,
                power,
                pins[0],
                pins[1],
                analog,
                colour,
                reading,
                hasMeasured,
                sampledUnitValue,
            ).also { current = it }
        }

    /** What a colour sensor sees; null if the program has said nothing about one. */
    val colour: NxtColour? get() = sampledColour.takeIf { SensorType.isColour(type) }

    fun setType(type: Int) {
        this.type = type
        current = null
    }

    fun setPower(power: Int) {
        this.power = power
        current = null
    }

    fun pin(pin: Int): Boolean = pins[pin]

    fun setPin(pin: Int, high: Boolean) {
        pins[pin] = high
        current = null
    }

    /** Takes the power from the sensor and forgets its type. */
    fun reset() {
        setType(SensorType.NO_SENSOR)
        setPower(SensorPower.NONE)
        pins.fill(false)
        i2c.disable()
        i2c.device?.switchOff()
    }

    /**
     * Sets what the analog pin measures from now on; clamped to 0..1023.
     *
     * @param unitValue the same in the unit of the sensor, where [raw] alone does not tell; null while it is off.
     */
    fun measure(raw: Int, unitValue: Int? = null) {
        measured = raw.coerceIn(0, OPEN)
        measuredUnitValue = unitValue
    }

    fun measure(colour: NxtColour) {
        measuredColour = colour
    }

    /** Takes what the pins measure; call it every [SAMPLE_MILLISECONDS]. */
    fun sample() {
        if (analog == measured && sampledUnitValue == measuredUnitValue && sampledColour === measuredColour) return
        analog = measured
        sampledUnitValue = measuredUnitValue
        sampledColour = measuredColour
        current = null
    }

    companion object {
        const val PORTS = 4
        const val PINS = 2

        /** 333 times a second. */
        const val SAMPLE_MILLISECONDS = 3

        /** What a pin measures that nothing is plugged into. */
        const val OPEN = 1023

        private val NO_COLOUR = NxtColour(0, 0, 0, 0)
    }
}
