package robotran.rcxrom.program

import robotran.brick.controls.BrickButton
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.infrared.InfraredLine
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest

/**
 * The only interface between a program and the robot. Everything a program does to the robot is a [call] of a ROM
 * routine, but for plain bytes on the [infraredLine]. Everything it senses it reads from [memory], where the routines
 * leave their results, or from the firmware's sensor table, as on a real RCX.
 */
interface Rom {
    /** The brick's 64 KB address space; ROM routines with a pointer argument read and write here. */
    val memory: RcxMemory

    /** Milliseconds of virtual time since the brick was first switched on; the clock continues while it is off. */
    val milliseconds: Long

    /**
     * Calls a ROM routine. An unknown address or a wrong code has no effect on the robot and is reported in the ROM
     * log; the program continues.
     *
     * @param sourceLine the program line of the call, from 1; 0 if there is none (the firmware itself).
     * @param sourceFile the file of the line; null if the program has only one.
     */
    fun call(call: RomCall, sourceLine: Int, sourceFile: String? = null)

    /**
     * The firmware's last reading of a sensor, at most three milliseconds old: josx `Sensor.readSensorValue`, which is
     * no ROM call.
     *
     * @param port 0..2 for the ports 1..3.
     */
    fun readSensor(port: Int, request: SensorRequest): Int

    /** The held buttons that belong to a program, as leJOS reads them for josx `Poll`; reading is no ROM call. */
    val pressedButtons: Set<BrickButton> get() = emptySet()

    /** Whether a received message is waiting, as leJOS checks it for josx `Poll`; checking is no ROM call. */
    val hasMessage: Boolean get() = false

    /** Plain bytes over infrared light, without the ROM: josx `LLC`. */
    val infraredLine: InfraredLine get() = InfraredLine.DARK

    /**
     * Sets how the firmware reads a sensor from its next reading on: josx `Sensor.setTypeAndMode`, which is no ROM call
     * either.
     *
     * @param port 0..2 for the ports 1..3.
     * @param type see [SensorCode]; stored, but without effect, as in leJOS.
     * @param mode see [SensorCode]; a slope 0..31 may be added.
     */
    fun setSensorTypeAndMode(port: Int, type: Int, mode: Int)

    /**
     * Sets a field of the firmware's sensor table: josx `Sensor.setPreviousValue` and the native `setSensorValue` under
     * it.
     *
     * @param port 0..2 for the ports 1..3.
     * @param value truncated to the size of the field: a byte, or a short for [SensorField.VALUE].
     */
    fun setSensorValue(port: Int, value: Int, field: SensorField)
}
