package robotran.robolang.translate

import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.Sense

/** The sensors of a program in Java. */
internal interface JavaSensors {
    /** Whether they are fields of the class, rather than set up in `main`. */
    val areFields: Boolean

    /** Whether a light sensor's lamp is switched on, which the brick must have measured with before its value counts. */
    val hasLamp: Boolean

    /** Writes the fields, or what sets them up. */
    fun write(writer: JavaWriter)

    /** The value that [sense] reads; never needs brackets. */
    fun valueOf(sense: Sense, helpers: UsedHelpers): String
}

/** Those on an RCX, at [ports]. */
internal class LejosSensors(private val ports: SensorPorts) : JavaSensors {
    override val areFields get() = false
    override val hasLamp get() = false

    override fun write(writer: JavaWriter) {
        ports.bumpers.forEach { writer.line("Sensor.S${it.port}.setTypeAndMode($TOUCH);") }
        if (ports.usesLight) {
            writer.line("Sensor.S${ports.lightPort}.activate();", ports.settingLine ?: LineMap.NO_LINE)
        }
    }

    override fun valueOf(sense: Sense, helpers: UsedHelpers): String = when (sense) {
        Sense.LeftBumper -> "Sensor.S1.readBooleanValue()"
        Sense.RightBumper -> "Sensor.S3.readBooleanValue()"
        Sense.Light -> "Sensor.S${ports.lightPort}.readValue()"
        is Sense.Sensor -> "Sensor.S${sense.port}.readValue()"
        is Sense.Button -> "Button.${sense.button.name}.isPressed()"
        Sense.Timer -> "${helpers.use(JavaHelper.TIMER)}()"
        Sense.Battery -> "Battery.getVoltage()"
        Sense.Distance, Sense.Colour, Sense.Loudness, is Sense.Turned -> error("An RCX has no $sense.")
    }

    private companion object {
        const val TOUCH = "SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL"
    }
}
