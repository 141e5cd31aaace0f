package robotran.nqc.api

import robotran.nqc.config.ParameterLimit
import robotran.nqc.tree.ParameterKind

/** The names of the API that the arguments of its functions are made for. */
internal object ExpectedNames {
    /** @param argument the number of the argument, from 0. */
    fun of(entry: NqcApiEntry, argument: Int): List<String> {
        val function = entry.function ?: return emptyList()
        val parameter = function.parameters.getOrNull(argument) ?: return emptyList()
        val names = entry.doc.namesFor(parameter.name)
        return when {
            names.isNotEmpty() -> names
            parameter.parameter == ParameterKind.SENSOR -> SENSORS
            else -> BY_LIMIT[function.limits[argument]].orEmpty()
        }
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
}
