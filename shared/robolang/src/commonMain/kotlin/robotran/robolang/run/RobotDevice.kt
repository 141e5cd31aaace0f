package robotran.robolang.run

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.TurnDirection

/** The robot as Robolang's commands and values see it. Each call belongs to a line of the program. */
internal interface RobotDevice : RobotSenses {
    /** The brick's clock. */
    val milliseconds: Long

    /** Whether the brick frees lists that are no longer in use. */
    val collectsLists: Boolean

    /** Sets up the sensors at [ports]; [at] receives the line that needs the next one, null behind the last. */
    fun setUp(ports: SensorPorts, at: (line: Int?) -> Unit)

    /** Whether the sensors are ready; asked each millisecond after [setUp] until they are. */
    val isSetUp: Boolean

    fun startMoving(direction: MoveDirection, sourceLine: Int)

    fun startTurning(direction: TurnDirection, sourceLine: Int)

    fun stopDriving(sourceLine: Int)

    /**
     * Begins to drive so many centimetres, the other way if [distance] is negative.
     *
     * @return how many milliseconds to wait before [isDriving] is asked.
     */
    fun drive(direction: MoveDirection, distance: NumberValue, sourceLine: Int): Int

    /** Begins to turn by so many degrees, the other way if [angle] is negative; returns the same as [drive]. */
    fun turn(direction: TurnDirection, angle: NumberValue, sourceLine: Int): Int

    /** Whether the wheels are still on their way. */
    val isDriving: Boolean

    /** After a drive or a turn, also one that is cut short. */
    fun endDrive(sourceLine: Int)

    /** Begins to move the pen; returns how many milliseconds to wait before [isPenMoving] is asked. */
    fun startPen(position: PenPosition, sourceLine: Int): Int

    val isPenMoving: Boolean

    fun stopPen(sourceLine: Int)

    /** [power] is 0..7. */
    fun setPower(side: PowerSide, power: Int, sourceLine: Int)

    fun setPower(motor: MotorPort, power: Int, sourceLine: Int)

    fun run(motor: MotorPort, mode: MotorMode, sourceLine: Int)

    fun brake(motor: MotorPort, sourceLine: Int)

    /**
     * Begins to turn a motor by so many degrees; only on a brick that counts, as the other members below.
     *
     * @param waits whether the program waits for it.
     */
    fun turnMotor(motor: MotorPort, angle: NumberValue, waits: Boolean, sourceLine: Int)

    fun isTurning(motor: MotorPort): Boolean

    /** Counts the degrees of a motor that stands from 0 again. */
    fun resetMotor(motor: MotorPort, sourceLine: Int)

    /** How long the brick itself waits for the tone of `beep`, `buzz` or the letters of a text, in milliseconds. */
    val outputMilliseconds: Int get() = 0

    /** After a tone that the brick waits for. */
    fun endTone(sourceLine: Int) = Unit

    fun beep(sourceLine: Int)

    fun buzz(sourceLine: Int)

    /** The longest tone in hundredths of a second; a longer one is played in parts. */
    val longestTone: Int

    fun playTone(hertz: Int, hundredths: Int, sourceLine: Int)

    fun show(value: NumberValue, sourceLine: Int)

    fun showText(text: String, sourceLine: Int)

    /** Shows the name of a colour by its number. */
    fun showColour(colour: Int, sourceLine: Int)

    fun clearScreen(sourceLine: Int)
}

/** What the robot measures; ports of sensors are numbered from 1. */
internal interface RobotSenses {
    fun isPressed(port: Int): Boolean

    /** 0..100. */
    fun light(port: Int): Int

    /** What leJOS calls the value of a sensor. */
    fun value(port: Int): Int

    fun isHeld(button: BrickButton, sourceLine: Int): Boolean

    fun batteryVolts(sourceLine: Int): Float

    /** Begins to measure a distance; only on an NXT, as the other members below. */
    fun measureDistance(port: Int, sourceLine: Int)

    /** Whether that is done; asked each millisecond until it is. */
    fun hasDistance(port: Int): Boolean

    /** In centimetres, 255 for nothing. */
    fun distance(port: Int): Int

    fun loudness(port: Int): Int

    /** The number of the colour in leJOS NXJ. */
    fun colour(port: Int): Int

    /** Degrees since the start or the last reset. */
    fun turned(motor: MotorPort): Int
}
