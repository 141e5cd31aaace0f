package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.Sense

/** Those on an NXT, at [ports]: objects of leJOS NXJ, each in a field. */
internal class NxtSensorFields(private val ports: SensorPorts, private val brick: BrickKind) : JavaSensors {
    override val areFields get() = true

    private val byPort: Map<Int, SensorPorts.NxtUse> = ports.nxtSensors.associateBy { it.port }

    override fun write(writer: JavaWriter) {
        if (byPort.isEmpty()) return
        writer.blank()
        for (use in ports.nxtSensors) {
            val type = typeOf(use.sense)
            val lamp = if (use.isLampOff) ", false" else ""
            val line = "static final $type ${nameAt(use.port)} = new $type(SensorPort.S${use.port}$lamp);"
            writer.line(line, if (use.isSetting) use.line else LineMap.NO_LINE)
        }
    }

    override val hasLamp: Boolean = ports.nxtSensors.any { it.sense == Sense.Light && !it.isLampOff }

    override fun valueOf(sense: Sense, helpers: UsedHelpers): String = when (sense) {
        Sense.Timer -> "${helpers.use(JavaHelper.TIMER)}()"
        Sense.Battery -> "Battery.getVoltage()"
        is Sense.Button -> "Button.${checkNotNull(sense.button.on(brick)).name}.isPressed()"
        is Sense.Turned -> "Motor.${sense.port.name}.getTachoCount()"
        is Sense.Sensor -> fieldValue(sense).let { if (isTouch(sense)) "($it ? 1 : 0)" else it }

        Sense.LeftBumper, Sense.RightBumper, Sense.Light, Sense.Distance, Sense.Colour, Sense.Loudness -> {
            fieldValue(sense)
        }
    }

    private fun fieldValue(sense: Sense): String {
        val port = checkNotNull(ports.portOf(sense))
        val name = nameAt(port)
        return when (byPort.getValue(port).sense) {
            Sense.Light -> "$name.getLightValue()"
            Sense.Distance -> "$name.getDistance()"
            Sense.Colour -> "$name.getColorID()"
            Sense.Loudness -> "$name.readValue()"
            else -> "$name.isPressed()"
        }
    }

    /** Whether the sensor that [sense] reads is a touch sensor. */
    private fun isTouch(sense: Sense): Boolean =
        typeOf(byPort.getValue(checkNotNull(ports.portOf(sense))).sense) == TOUCH

    private fun nameAt(port: Int): String {
        val name = NAMES.getValue(byPort.getValue(port).sense)
        val first = ports.nxtSensors.first { NAMES.getValue(it.sense) == name }
        return if (first.port == port) name else name + port
    }

    private fun typeOf(sense: Sense): String = when (sense) {
        Sense.Light -> "LightSensor"
        Sense.Distance -> "UltrasonicSensor"
        Sense.Colour -> "ColorSensor"
        Sense.Loudness -> "SoundSensor"
        else -> TOUCH
    }

    companion object {
        private const val TOUCH = "TouchSensor"

        private val NAMES: Map<Sense, String> = mapOf(
            Sense.LeftBumper to "leftBumper",
            Sense.RightBumper to "rightBumper",
            Sense.Light to "lightSensor",
            Sense.Distance to "sonar",
            Sense.Colour to "colourSensor",
            Sense.Loudness to "soundSensor",
        )

        /** All names that these fields can have. */
        val ALL: Set<String> = NAMES.values.flatMapTo(mutableSetOf()) { name ->
            listOf(name) + (1..4).map { name + it }
        }
    }
}
