package robotran.rcxrom.sensors

import robotran.brick.sensors.ExpectedSensor

/**
 * Finds out which sensors a program expects: it sets the type of a port, or powers a port whose type is light or
 * rotation. leJOS's class `Sensor` sets all ports to light when a program first uses it. So the first time that a run
 * sets a port to light does not count.
 */
internal class SensorExpectations {
    private val hasBeenSet = BooleanArray(SensorCode.PORTS)

    /** What the current or last run expects, in the order in which it said so; each new one makes a new list. */
    var all: List<ExpectedSensor> = emptyList()
        private set

    /** Returns the place in the program that is being executed: its line and file. */
    var place: () -> Pair<Int, String?> = { 0 to null }

    /** Call it when a program starts. */
    fun startRun() {
        hasBeenSet.fill(false)
        all = emptyList()
    }

    /** The program has set [port], 0..2, to the code [type]. */
    fun typeSet(port: Int, type: Int) {
        val isFirst = !hasBeenSet[port]
        hasBeenSet[port] = true
        if (!isFirst || type != SensorCode.TYPE_LIGHT) expect(port, type)
    }

    /** The program has powered [port], 0..2, whose type has the code [type]. */
    fun powered(port: Int, type: Int) {
        if (type != SensorCode.TYPE_TOUCH) expect(port, type)
    }

    private fun expect(port: Int, type: Int) {
        val kind = SensorCode.kindOf(type) ?: return
        if (all.any { it.port == port + 1 && it.kind == kind }) return
        val (line, file) = place()
        all = all + ExpectedSensor(port + 1, kind, line, file)
    }
}
