package robotran.nqc.api

import robotran.nqc.config.ParameterLimit

/** The names of the API that the arguments of its functions are made for. */
internal object ExpectedNames {
    /** @param argument the number of the argument, from 0. */
    fun of(entry: NqcApiEntry, argument: Int): List<String> {
        BY_FUNCTION[entry.name to argument]?.let { return it }
        val function = entry.definition as? ApiDefinition.Function ?: return emptyList()
        val parameter = function.declaration.split(',').getOrNull(argument)?.trim() ?: return emptyList()
        if (parameter.startsWith("__sensor")) return SENSORS
        return BY_LIMIT[function.limits.getOrNull(argument)].orEmpty()
    }

    private val SENSORS = listOf("SENSOR_1", "SENSOR_2", "SENSOR_3", "IN_1", "IN_2", "IN_3")

    private val BY_LIMIT = mapOf(
        ParameterLimit.OUTPUTS to "OUT_A OUT_B OUT_C OUT_AB OUT_AC OUT_BC OUT_ABC",
        ParameterLimit.POWER to "OUT_FULL OUT_HALF OUT_LOW",
        ParameterLimit.SOUND to "SOUND_CLICK SOUND_DOUBLE_BEEP SOUND_DOWN SOUND_UP SOUND_LOW_BEEP SOUND_FAST_UP",
        ParameterLimit.TIMER to "T1 T2 T3 T4",
        ParameterLimit.DISPLAY to "DISPLAY_WATCH DISPLAY_SENSOR_1 DISPLAY_SENSOR_2 DISPLAY_SENSOR_3 DISPLAY_OUT_A " +
            "DISPLAY_OUT_B DISPLAY_OUT_C DISPLAY_USER",
        ParameterLimit.SENSOR_TYPE to "SENSOR_TYPE_TOUCH SENSOR_TYPE_LIGHT SENSOR_TYPE_ROTATION " +
            "SENSOR_TYPE_TEMPERATURE SENSOR_TYPE_NONE",
    ).mapValues { it.value.split(' ') }

    private val BY_FUNCTION = mapOf(
        ("SetSensor" to 1) to
            "SENSOR_TOUCH SENSOR_LIGHT SENSOR_ROTATION SENSOR_CELSIUS SENSOR_FAHRENHEIT SENSOR_PULSE " +
            "SENSOR_EDGE",
        ("Sensor" to 1) to "IN_SWITCH IN_LIGHT IN_ANGLE IN_PULSE IN_EDGE",
        ("SetSensorMode" to 1) to "SENSOR_MODE_RAW SENSOR_MODE_BOOL SENSOR_MODE_EDGE SENSOR_MODE_PULSE " +
            "SENSOR_MODE_PERCENT SENSOR_MODE_CELSIUS SENSOR_MODE_FAHRENHEIT SENSOR_MODE_ROTATION",
        ("SetOutput" to 1) to "OUT_ON OUT_OFF OUT_FLOAT",
        ("SetDirection" to 1) to "OUT_FWD OUT_REV OUT_TOGGLE",
        ("SetEvent" to 1) to "SENSOR_1 SENSOR_2 SENSOR_3 Timer Counter Message",
        ("SetEvent" to 2) to "EVENT_TYPE_PRESSED EVENT_TYPE_RELEASED EVENT_TYPE_PULSE EVENT_TYPE_EDGE " +
            "EVENT_TYPE_FASTCHANGE EVENT_TYPE_LOW EVENT_TYPE_NORMAL EVENT_TYPE_HIGH EVENT_TYPE_CLICK " +
            "EVENT_TYPE_DOUBLECLICK EVENT_TYPE_MESSAGE",
        ("SetTxPower" to 0) to "TX_POWER_LO TX_POWER_HI",
    ).mapValues { it.value.split(' ') }
}
