package robotran.ui.sheet

import robotran.brick.sensors.MeasuringUnit
import robotran.brick.sensors.SensorKind
import robotran.brick.state.InputReading
import robotran.hub.state.HubInput
import robotran.microbit.state.MicrobitInput
import robotran.nxt.hardware.SensorPortState
import robotran.nxt.hardware.SensorType
import robotran.nxt.hardware.SonarDevice

/**
 * What a brick measures with a sensor of this [kind], null for none: that of all but an RCX in the unit of the sensor, whatever
 * its program chose, that of an RCX as its program reads it. Null if nothing is measured, because the sensor is off, or
 * no sensor is there.
 */
fun valueText(input: InputReading, kind: SensorKind?): String? = when {
    input is HubInput || input is MicrobitInput ->
        kind?.let { plugged -> input.measured(plugged)?.let { textOf(it, MeasuringUnit.of(plugged)) } }

    input !is SensorPortState -> "${input.value}"
    kind == null -> "${input.value}".takeUnless { input.type == SensorType.NO_SENSOR }
    else -> input.measured(kind)?.let { textOf(it, MeasuringUnit.of(kind)) }
}

/** A sonar that hears nothing has no distance to tell. */
private fun textOf(value: Int, unit: MeasuringUnit): String =
    if (unit == MeasuringUnit.CENTIMETRES && value == SonarDevice.NOTHING) "$value" else unit.text(value)
