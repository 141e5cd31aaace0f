package robotran.robolang.translate

import robotran.robolang.robot.SensorPorts

/** Writes the set-up of the sensors at [ports]. */
internal class JavaSensors(private val ports: SensorPorts) {
    fun setUp(writer: JavaWriter) {
        ports.bumpers.forEach { writer.line("Sensor.S${it.port}.setTypeAndMode($TOUCH);") }
        if (ports.usesLight) {
            writer.line("Sensor.S${ports.lightPort}.activate();", ports.settingLine ?: LineMap.NO_LINE)
        }
    }

    private companion object {
        const val TOUCH = "SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL"
    }
}
