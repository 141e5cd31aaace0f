package robotran.nxt.program

import robotran.brick.log.CallGroup

/**
 * The calls by which a program acts on the brick. All but those of the regulators, [OPEN] to [LISTEN_CABLE], [SET_TYPE] and
 * [CONSOLE_LINE] are native methods of leJOS NXJ.
 *
 * @property id never changes, because it identifies a call in the trace of a run.
 * @property nativeName the name in the log.
 * @property parameters how many numbers a call has.
 * @property speed index of the number that is a speed, the bits of a 32-bit float in degrees a second; -1 if there is
 * none.
 */
enum class NxtNative(
    val id: Int,
    val nativeName: String,
    val group: CallGroup,
    val parameters: Int,
    val speed: Int = -1,
) {
    /**
     * Port 0..2; power -100..100, clamped; whether to brake in the pauses of the pulses and with power 0, else roll.
     */
    CONTROL_MOTOR(1, "controlMotorById", CallGroup.MOTORS, parameters = 3),

    /** Port. */
    RESET_TACHO_COUNT(2, "resetTachoCountById", CallGroup.MOTORS, parameters = 1),

    /** Port; degrees behind; milliseconds. See [robotran.nxt.regulator.MotorRegulator.setStallThreshold]. */
    REGULATOR_STALL(4, "regulatorStallThreshold", CallGroup.MOTORS, parameters = 3),

    /**
     * Port; speed; acceleration; limit; whether to hold the motor at the end. Returns 1 if the motor was standing. See
     * [robotran.nxt.regulator.MotorRegulator.start].
     */
    REGULATE(5, "regulate", CallGroup.MOTORS, parameters = 5, speed = 1),

    /** Port; speed. See [robotran.nxt.regulator.MotorRegulator.setSpeed]. */
    REGULATOR_SPEED(6, "regulatorSpeed", CallGroup.MOTORS, parameters = 2, speed = 1),

    /** Port; acceleration. See [robotran.nxt.regulator.MotorRegulator.setAcceleration]. */
    REGULATOR_ACCELERATION(7, "regulatorAcceleration", CallGroup.MOTORS, parameters = 2),

    /** Port. See [robotran.nxt.regulator.MotorRegulator.roll]. */
    REGULATOR_ROLL(8, "regulatorRoll", CallGroup.MOTORS, parameters = 1),

    /** Port. Returns 1 if the motor was regulated. See [robotran.nxt.regulator.MotorRegulator.suspend]. */
    REGULATOR_SUSPEND(9, "regulatorSuspend", CallGroup.MOTORS, parameters = 1),

    /** Port 0..3; power, see [robotran.nxt.hardware.SensorPower]. */
    SET_POWER_TYPE(10, "setPowerTypeById", CallGroup.SENSORS, parameters = 2),

    /** Port; pin 0 or 1; mode: 0 off, 1 input, 2 output, 3 measures. */
    SET_SENSOR_PIN_MODE(11, "setSensorPinMode", CallGroup.SENSORS, parameters = 3),

    /** Port; pin 0 or 1; bit. */
    SET_SENSOR_PIN(12, "setSensorPin", CallGroup.SENSORS, parameters = 3),

    /** Port; mode, see [robotran.nxt.hardware.I2cMode]. */
    I2C_ENABLE(13, "i2cEnableById", CallGroup.SENSORS, parameters = 2),

    /** Port. */
    I2C_DISABLE(14, "i2cDisableById", CallGroup.SENSORS, parameters = 1),

    /** Port; address; how many bytes to receive; the bytes to send. Returns [robotran.nxt.hardware.I2cStatus]. */
    I2C_START(15, "i2cStartById", CallGroup.SENSORS, parameters = 3),

    /** Port; number, see [robotran.nxt.hardware.SensorType]. Tells the kind of sensor; does not set power or pins. */
    SET_TYPE(16, "setTypeById", CallGroup.SENSORS, parameters = 2),

    /** Text; column, row, whether it is inverted. */
    DRAW_STRING(20, "drawString", CallGroup.DISPLAY, parameters = 3),

    /** Number; places; column; row. */
    DRAW_INT(21, "drawInt", CallGroup.DISPLAY, parameters = 4),

    CLEAR(22, "clear", CallGroup.DISPLAY, parameters = 0),

    /** Width and height of the source; the numbers of [robotran.nxt.display.BitBlt]. See [Nxt.bitBlt]. */
    BIT_BLT(23, "bitBlt", CallGroup.DISPLAY, parameters = 9),

    /** Begins to copy the display's memory to the glass. */
    ASYNC_REFRESH(24, "asyncRefresh", CallGroup.DISPLAY, parameters = 0),

    /** Milliseconds from one refresh to the next, at least 6; 0 for none. Returns those before. */
    SET_AUTO_REFRESH_PERIOD(25, "setAutoRefreshPeriod", CallGroup.DISPLAY, parameters = 1),

    /** Contrast 0..96; clamped. */
    SET_CONTRAST(26, "setContrast", CallGroup.DISPLAY, parameters = 1),

    /** Hertz; milliseconds; volume 0..100. */
    PLAY_FREQ(30, "playFreq", CallGroup.SOUND, parameters = 3),

    /** Samples a second; volume; the samples. Returns how many there was room for. */
    PLAY_QUEUED_SAMPLE(32, "playQueuedSample", CallGroup.SOUND, parameters = 2),

    /** Switches the brick off. */
    SHUT_DOWN(40, "shutDown", CallGroup.POWER, parameters = 0),

    /** Name of another robot. Returns the number of the link, -1 if there is no such robot. */
    OPEN(50, "open", CallGroup.BLUETOOTH, parameters = 0),

    /** Mode, which does not matter. Returns the number of the link. */
    LISTEN(51, "listen", CallGroup.BLUETOOTH, parameters = 1),

    /** Number of the link; the bytes. Returns how many there was room for, -1 if the link is not open. */
    WRITE(52, "write", CallGroup.BLUETOOTH, parameters = 1),

    /** Number of the link. */
    CLOSE(53, "close", CallGroup.BLUETOOTH, parameters = 1),

    /** As [OPEN], by the cable of RS485. */
    OPEN_CABLE(54, "openCable", CallGroup.BLUETOOTH, parameters = 0),

    /** As [LISTEN], by the cable of RS485. */
    LISTEN_CABLE(55, "listenCable", CallGroup.BLUETOOTH, parameters = 1),

    /** Code. Only for the log: the run then ends. */
    EXIT(60, "halt", CallGroup.SYSTEM, parameters = 1),

    /** Number of the exception; number of the method. Only for the log: the brick makes it when it shows a failure. */
    EXCEPTION(61, "firmwareExceptionHandler", CallGroup.SYSTEM, parameters = 2),

    /** A text for the log of the run. */
    CONSOLE_LINE(62, "consoleLine", CallGroup.SYSTEM, parameters = 0),

    /** Page; its bytes. Returns 0, or -1 if there is no such page. See [robotran.nxt.storage.FlashMemory]. */
    FLASH_WRITE_PAGE(63, "flashWritePage", CallGroup.SYSTEM, parameters = 1),
    ;

    companion object {
        private val byId = entries.associateBy { it.id }

        /** The call with this id; null if there is none. */
        fun of(id: Int): NxtNative? = byId[id]
    }
}
