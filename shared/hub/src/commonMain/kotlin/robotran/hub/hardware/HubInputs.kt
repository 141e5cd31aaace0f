package robotran.hub.hardware

import robotran.brick.sensors.ExpectedSensor
import robotran.brick.sensors.SensorKind
import robotran.hub.model.HubColor
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubModel
import robotran.hub.model.HubPort
import robotran.hub.program.HubReading
import robotran.hub.program.LightMode
import robotran.hub.state.HubInput

/** The ports for sensors: what is plugged in, what a program has made of it, and what it measures. */
internal class HubInputs(private val model: HubModel) {
    private val plugged = mutableMapOf<HubPort, HubDeviceKind>()
    private val readings = mutableMapOf<HubPort, HubReading>()
    private val made = mutableMapOf<HubPort, HubDeviceKind>()
    private val atFirst = mutableMapOf<HubPort, LightMode>()
    private val asked = mutableMapOf<HubPort, LightMode>()
    private val colors = mutableMapOf<HubPort, List<HubColor>>()

    /** The ports as a state shows them; the same objects until something changes. */
    var states: List<HubInput> = model.sensorPorts.mapIndexed { index, port -> HubInput(index + 1, port) }
        private set

    /** What the program expects, in the order in which it said so. */
    var expected: List<ExpectedSensor> = emptyList()
        private set

    /** Plugs in a sensor; [mode] is what a sensor of light shows until a program asks it. */
    fun plug(port: HubPort, kind: HubDeviceKind?, mode: LightMode) {
        atFirst[port] = mode
        if (kind == null) plugged.remove(port) else plugged[port] = kind
        if (kind == null) readings.remove(port)
        update(port)
    }

    /** What is plugged in; null if it is no sensor. */
    fun kindOf(port: HubPort): HubDeviceKind? = plugged[port]

    fun measure(port: HubPort, reading: HubReading) {
        if (readings[port] == reading) return
        readings[port] = reading
        update(port)
    }

    fun reading(port: HubPort): HubReading? = readings[port].takeIf { port in plugged }

    fun brightness(port: HubPort, mode: LightMode): Int? {
        val light = reading(port) as? HubReading.Light ?: return null
        if (asked[port] != mode) {
            asked[port] = mode
            update(port)
        }
        return light.brightness(mode)
    }

    fun isMade(port: HubPort): Boolean = port in made

    /** The program makes a sensor. */
    fun make(port: HubPort, kind: HubDeviceKind) {
        made[port] = kind
        update(port)
    }

    /** Tells that the program expects a sensor, whether or not it is there. */
    fun expect(port: HubPort, kind: HubDeviceKind, sourceLine: Int, sourceFile: String?) {
        val number = model.sensorPorts.indexOf(port) + 1
        val sensor = sensorKinds[kind] ?: return
        if (number == 0 || expected.any { it.port == number && it.kind == sensor }) return
        expected = expected + ExpectedSensor(number, sensor, sourceLine, sourceFile)
    }

    fun detect(port: HubPort, colors: List<HubColor>) {
        this.colors[port] = colors
    }

    fun color(port: HubPort): HubColor {
        val light = reading(port) as? HubReading.Light ?: return HubColor.NONE
        return ColorFinder.find(light, colors[port] ?: model.devices.colors)
    }

    /** A program starts: what the last one made is forgotten. */
    fun reset() {
        val before = made.keys.toList()
        made.clear()
        colors.clear()
        before.forEach(::update)
    }

    /** A program starts: what the last one asked for was shown until now, also after its end. */
    fun startRun() {
        expected = emptyList()
        val before = asked.keys.toList()
        asked.clear()
        before.forEach(::update)
    }

    private fun update(port: HubPort) {
        val index = model.sensorPorts.indexOf(port)
        if (index < 0) return
        val mode = asked[port] ?: atFirst[port] ?: LightMode.REFLECTION
        val now = HubInput(index + 1, port, plugged[port], readings[port], port in made, mode)
        if (states[index] != now) states = states.toMutableList().also { it[index] = now }
    }

    private companion object {
        val sensorKinds = mapOf(
            HubDeviceKind.COLOR_SENSOR to SensorKind.COLOUR,
            HubDeviceKind.ULTRASONIC_SENSOR to SensorKind.ULTRASONIC,
            HubDeviceKind.FORCE_SENSOR to SensorKind.TOUCH,
            HubDeviceKind.TOUCH_SENSOR to SensorKind.TOUCH,
            HubDeviceKind.LIGHT_SENSOR to SensorKind.LIGHT,
            HubDeviceKind.SOUND_SENSOR to SensorKind.SOUND,
        )
    }
}
