package robotran.robolang.run

import robotran.rcxrom.sensors.SensorCode

/** Sets up the sensors at [ports] before the first statement. */
internal class SensorSetup(private val ports: SensorPorts) : StackInstruction {
    override fun execute(activity: Activity) {
        val senses = activity.machine.senses
        for (bumper in ports.bumpers) {
            activity.machine.setUpLine = bumper.line
            senses.setTypeAndMode(bumper.port, SensorCode.TYPE_TOUCH, SensorCode.MODE_BOOLEAN)
        }
        if (ports.usesLight) {
            activity.machine.setUpLine = ports.lightLine
            senses.activate(ports.lightPort, ports.lightLine)
        }
        activity.machine.setUpLine = null
    }
}
