package robotran.robolang.run

import robotran.brick.controls.MotorPort
import robotran.hub.model.HubPort
import robotran.hub.program.Hub
import robotran.hub.program.HubReading
import robotran.hub.program.LightMode
import robotran.robolang.robot.HubFigures
import robotran.robolang.robot.HubUses
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.PaintColour
import robotran.robolang.syntax.Sense

/** Reads the sensors of a robot with a hub: the words of the language mean the first sensor of their kind. */
internal class HubSenses(private val hub: Hub, private val uses: HubUses) : RobotSenses {
    private val mode = if (uses.looksAhead) LightMode.AMBIENT else LightMode.REFLECTION

    /** What the sensor at [port], from 1, measures. */
    private fun reading(port: Int): HubReading? = portOf(port)?.let(hub::sensor)

    private fun portOf(port: Int): HubPort? = hub.model.sensorPorts.getOrNull(port - 1)

    private fun read(sense: Sense): HubReading? = uses.portOf(sense)?.let(::reading)

    /** [port] is that of the left bumper on other bricks, or of the right one. */
    override fun isPressed(port: Int): Boolean = isTouched(read(if (port == 1) Sense.LeftBumper else Sense.RightBumper))

    override fun light(port: Int): Int = uses.portOf(Sense.Light)?.let(::brightness) ?: 0

    override fun value(port: Int): Int = when (val reading = reading(port)) {
        null -> 0
        is HubReading.Light -> brightness(port)
        is HubReading.Distance -> centimetres(reading)
        is HubReading.Force -> if (isTouched(reading)) 1 else 0
        is HubReading.Sound -> reading.intensity
    }

    override fun isHeld(button: BrickButton, sourceLine: Int): Boolean = HubUses.buttonOf(button) in hub.pressed

    override fun batteryVolts(sourceLine: Int): Float = hub.batteryMillivolts / MILLIVOLTS

    override fun measureDistance(port: Int, sourceLine: Int) = Unit

    override fun hasDistance(port: Int): Boolean = true

    override fun distance(port: Int): Int =
        (read(Sense.Distance) as? HubReading.Distance)?.let(::centimetres) ?: HubFigures.NOTHING

    override fun loudness(port: Int): Int = (read(Sense.Loudness) as? HubReading.Sound)?.intensity ?: 0

    override fun colour(port: Int): Int {
        val place =
            (port.takeIf { it in uses.coloured } ?: uses.portOf(Sense.Colour))?.let(::portOf) ?: return NO_COLOUR
        val color = hub.color(place)
        return PaintColour.entries.firstOrNull { it.name == color.name }?.number ?: NO_COLOUR
    }

    override fun turned(motor: MotorPort): Int = hub.motor(HubPort.of(motor))?.angle ?: 0

    private fun brightness(port: Int): Int = portOf(port)?.let { hub.brightness(it, mode) } ?: 0

    private fun isTouched(reading: HubReading?) = (reading as? HubReading.Force)?.isTouched == true

    private fun centimetres(reading: HubReading.Distance): Int {
        val isNothing = hub.model.kind.hasLetteredInputs && reading.millimetres >= HubReading.FAR
        return if (isNothing) HubFigures.NOTHING else reading.millimetres / MILLIMETRES
    }

    private companion object {
        const val NO_COLOUR = -1
        const val MILLIMETRES = 10
        const val MILLIVOLTS = 1000f
    }
}
