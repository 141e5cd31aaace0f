package robotran.robolang.run

import robotran.rcxrom.sensors.SensorCode

/** Sets up the sensors at [ports] before the first statement. */
internal class SensorSetup(private val ports: SensorPorts) : StackInstruction {
    override fun execute(activity: Activity) {
        val senses = activity.machine.senses
        ports.bumpers.forEach { senses.setTypeAndMode(it, SensorCode.TYPE_TOUCH, SensorCode.MODE_BOOLEAN) }
        if (ports.usesLight) senses.activate(ports.lightPort, ports.lightLine)
    }
}
