package robotran.hub.program

import robotran.hub.model.HubButton
import robotran.hub.model.HubColor
import robotran.hub.model.HubModel
import robotran.hub.model.HubPort

/**
 * The only interface between a program and a hub. What a program does to the robot is a [call], which the log keeps;
 * what it senses it reads from the other members. Nothing waits: a program that waits for a move asks whether it is
 * done.
 */
interface Hub {
    val model: HubModel

    /** Milliseconds of virtual time since the hub was first switched on; the clock continues while it is off. */
    val milliseconds: Long

    /**
     * Performs and logs a call.
     *
     * @param sourceLine the program line of the call, from 1.
     * @param sourceFile the file of the line; null if the program has only one.
     * @return why the hub refuses it; null if it did it.
     */
    fun call(call: HubCall, sourceLine: Int, sourceFile: String? = null): HubError?

    /** A motor that the program has made by [HubNative.DEVICE]; null if there is none at [port]. */
    fun motor(port: HubPort): HubMotorView?

    /** The driving base that the program has made; null if there is none. */
    val driveBase: HubDriveBaseView?

    /** What the sensor at [port] measures; null if nothing is plugged in there. */
    fun sensor(port: HubPort): HubReading?

    /**
     * The brightness that the colour or light sensor at [port] measures, 0..100 percent; null if there is none. The hub's
     * state shows that of the [mode] that a program asked for last.
     */
    fun brightness(port: HubPort, mode: LightMode): Int?

    /** The colour that the sensor at [port] sees, one of those that it is to tell apart. */
    fun color(port: HubPort): HubColor

    /** The buttons that are down and that a program sees. */
    val pressed: Set<HubButton>

    val batteryMillivolts: Int

    /** Degrees that the hub has turned to the right since the program started; null without a gyro. */
    val heading: Double?

    /** Milliseconds until the tone is over that a program waits for. */
    val beepMillisecondsLeft: Int

    /** Milliseconds until all letters of a text have been shown. */
    val textMillisecondsLeft: Int
}

/** A motor as a program sees it; angles and speeds in its own direction. */
interface HubMotorView {
    /** Whole degrees. */
    val angle: Int

    /** Degrees a second, the mean of the last 100 milliseconds. */
    val speed: Int

    /** Whether it does nothing more that it was told. */
    val isDone: Boolean

    /** How many commands it has got: who waits for a move waits no more when another has come. */
    val commands: Int

    /** Whether it has not moved for 200 milliseconds though it is driven with all the power it may have. */
    val isStalled: Boolean
}

/** A driving base as a program sees it; ahead and to the right are positive. */
interface HubDriveBaseView {
    /** Whole millimetres. */
    val distance: Int

    /** Degrees. */
    val angle: Double

    /** Millimetres a second. */
    val speed: Int

    /** Degrees a second. */
    val turnRate: Int

    val isDone: Boolean

    /** See [HubMotorView.commands]. */
    val commands: Int
    val isStalled: Boolean
    val settings: DriveBaseSettings

    /** The highest speed that [settings] can have, mm/s. */
    val straightLimit: Int

    /** The highest turn rate that [settings] can have, deg/s. */
    val turnLimit: Int
}

/**
 * How a driving base moves.
 *
 * @property straightSpeed mm/s.
 * @property straightAcceleration mm/s².
 * @property turnRate deg/s.
 * @property turnAcceleration deg/s².
 */
data class DriveBaseSettings(
    val straightSpeed: Int,
    val straightAcceleration: Int,
    val turnRate: Int,
    val turnAcceleration: Int,
)
