package robotran.rcxrom.program

import robotran.rcxrom.call.RomCall
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest

/**
 * The one seam between a program and the robot: everything a program does to the robot is a [call] of a ROM routine,
 * everything it senses is read from [memory], where the routines leave their results, or from the firmware's table of
 * the sensors, as on a real RCX.
 */
interface Rom {
    /** The brick's 64 KB address space; ROM routines with a pointer argument read and write here. */
    val memory: RcxMemory

    /** Milliseconds of virtual time since the brick was first switched on; they go on while it is off. */
    val milliseconds: Long

    /**
     * Calls a ROM routine. An unknown address or a wrong code has no effect on the robot and is reported in the ROM
     * log; the program goes on.
     *
     * @param sourceLine the line of the program that makes the call, from 1; 0 if there is none (the firmware itself).
     * @param sourceFile the file that the line is in; null if the program has only one.
     */
    fun call(call: RomCall, sourceLine: Int, sourceFile: String? = null)

    /**
     * What the firmware read of a sensor last, at most three milliseconds ago: josx `Sensor.readSensorValue`, which is
     * no ROM call.
     *
     * @param port 0..2 for the ports 1..3.
     */
    fun readSensor(port: Int, request: SensorRequest): Int

    /**
     * The buttons held down that belong to a program, as leJOS looks at them for josx `Poll`; looking is no ROM call.
     */
    val pressedButtons: Set<BrickButton> get() = emptySet()

    /**
     * Whether a message has come that nobody has taken yet, as leJOS looks for it for josx `Poll`; looking is no ROM
     * call.
     */
    val hasMessage: Boolean get() = false

    /**
     * How the firmware is to read a sensor from its next reading on: josx `Sensor.setTypeAndMode`, which is no ROM call
     * either.
     *
     * @param port 0..2 for the ports 1..3.
     * @param type see [SensorCode]; kept, but without effect, as in leJOS.
     * @param mode see [SensorCode]; a slope 0..31 may be added.
     */
    fun setSensorTypeAndMode(port: Int, type: Int, mode: Int)

    /**
     * Sets what is in the firmware's table of the sensors: josx `Sensor.setPreviousValue` and the native
     * `setSensorValue` under it.
     *
     * @param port 0..2 for the ports 1..3.
     * @param value only as much of it is kept as the field has room for: a byte, or a short for [SensorField.VALUE].
     */
    fun setSensorValue(port: Int, value: Int, field: SensorField)
}
