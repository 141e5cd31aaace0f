package robotran.robolang.python

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.robolang.robot.SensorPorts
import robotran.robolang.run.RobotDevice
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PaintColour
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.TurnDirection
import kotlin.math.abs

/**
 * A hub for the interpreter that moves nothing: it logs the calls that Pybricks would get, takes the time for them that
 * the fake modules in Python take, and measures what they measure.
 *
 * @param areApart whether each wheel has a speed of its own.
 */
internal class RecordingHub(private val robot: PybricksRobot, private val areApart: Boolean) : RobotDevice {
    val calls = mutableListOf<String>()
    private val motors = mutableMapOf<Char, RecordedMotor>()
    private var power = PybricksFigures.FIRST_POWER
    private var drivingUntil = 0L

    override var milliseconds: Long = 0
    override val collectsLists: Boolean get() = true
    override val isSetUp: Boolean get() = true
    override val longestTone: Int get() = Int.MAX_VALUE / HUNDREDTH
    override val isDriving: Boolean get() = milliseconds < drivingUntil
    override val isPenMoving: Boolean get() = robot.pen?.let { motor(it.port).isMoving } ?: false

    override fun setUp(ports: SensorPorts, at: (line: Int?) -> Unit) = at(null)

    private fun log(call: String) {
        calls += call
    }

    private fun motor(port: Char) = motors.getOrPut(port) { RecordedMotor(port) }

    override fun startMoving(direction: MoveDirection, sourceLine: Int) {
        val sign = if (direction == MoveDirection.FORWARD) 1 else -1
        if (areApart) return runWheels(sign, sign)
        val speed = robot.speedAhead(PybricksFigures.speedOf(power))
        drive(if (direction == MoveDirection.FORWARD) speed else -speed, 0)
    }

    private fun runWheels(left: Int, right: Int) {
        motor(robot.left.port).apply { run(left * speed) }
        motor(robot.right.port).apply { run(right * speed) }
    }

    override fun startTurning(direction: TurnDirection, sourceLine: Int) {
        val sign = if (direction == TurnDirection.RIGHT) 1 else -1
        if (areApart) return runWheels(sign, -sign)
        val rate = robot.turnRate(PybricksFigures.speedOf(power))
        drive(0, if (direction == TurnDirection.RIGHT) rate else -rate)
    }

    private fun drive(speed: Long, rate: Long) {
        drivingUntil = 0
        log("drive_base drive $speed $rate")
    }

    override fun stopDriving(sourceLine: Int) {
        drivingUntil = 0
        if (areApart) {
            motor(robot.left.port).stand("brake")
            motor(robot.right.port).stand("brake")
        } else {
            log("drive_base brake")
        }
    }

    override fun drive(direction: MoveDirection, distance: NumberValue, sourceLine: Int): Int {
        val sign = if (direction == MoveDirection.FORWARD) 1 else -1
        move("straight", roundAsPython(sign * MILLIMETRES * exact(distance)))
        return 0
    }

    override fun turn(direction: TurnDirection, angle: NumberValue, sourceLine: Int): Int {
        val sign = if (direction == TurnDirection.RIGHT) 1 else -1
        move("turn", roundAsPython(sign * exact(angle)))
        return 0
    }

    private fun exact(value: NumberValue): Double =
        if (value is NumberValue.Whole) value.value.toDouble() else value.decimal.toDouble()

    private fun move(what: String, amount: Long) {
        log("drive_base $what $amount")
        drivingUntil = milliseconds + abs(amount) * MS_OF_MOVE
    }

    override fun endDrive(sourceLine: Int) = Unit

    override fun startPen(position: PenPosition, sourceLine: Int): Int {
        val target = if (position == PenPosition.DOWN) PybricksFigures.PEN_DEGREES else 0
        robot.pen?.let { motor(it.port).runTo(target, "run_target ${PybricksFigures.PEN_SPEED} $target") }
        return 0
    }

    override fun stopPen(sourceLine: Int) = Unit

    override fun setPower(side: PowerSide, power: Int, sourceLine: Int) {
        this.power = power
        val degrees = PybricksFigures.speedOf(power)
        if (side != PowerSide.RIGHT) motor(robot.left.port).speed = degrees
        if (side != PowerSide.LEFT) motor(robot.right.port).speed = degrees
        if (!areApart) log("drive_base settings ${robot.speedAhead(degrees)} ${robot.turnRate(degrees)}")
    }

    override fun setPower(motor: MotorPort, power: Int, sourceLine: Int) {
        motor(motor.name.single()).speed = PybricksFigures.speedOf(power)
    }

    override fun run(motor: MotorPort, mode: MotorMode, sourceLine: Int) = motor(motor.name.single()).run {
        when (mode) {
            MotorMode.FORWARD -> run(speed)
            MotorMode.BACKWARD -> run(-speed)
            MotorMode.BRAKE -> stand("brake")
            MotorMode.FLOAT -> stand("stop")
        }
    }

    override fun brake(motor: MotorPort, sourceLine: Int) = motor(motor.name.single()).stand("brake")

    override fun turnMotor(motor: MotorPort, angle: NumberValue, waits: Boolean, sourceLine: Int) =
        motor(motor.name.single()).turn(roundAsPython(exact(angle)).toInt())

    override fun isTurning(motor: MotorPort): Boolean = motor(motor.name.single()).isMoving

    override fun resetMotor(motor: MotorPort, sourceLine: Int) = motor(motor.name.single()).reset()

    override fun beep(sourceLine: Int) = log("speaker beep 500 100")

    override fun buzz(sourceLine: Int) = log("speaker beep 100 500")

    override fun playTone(hertz: Int, hundredths: Int, sourceLine: Int) =
        log("speaker beep $hertz ${hundredths * HUNDREDTH}")

    override fun show(value: NumberValue, sourceLine: Int) {
        val text = if (value is NumberValue.Whole) "${value.value}" else "${value.decimal}"
        log("print \"$text\"")
        log("display number ${exact(value).toLong()}")
    }

    override fun showText(text: String, sourceLine: Int) {
        log("print \"$text\"")
        log(if (text.length == 1) "display char \"$text\"" else "display text \"$text\"")
    }

    override fun showColour(colour: Int, sourceLine: Int) =
        log("print \"Color.${PaintColour.entries.first { it.number == colour }.name}\"")

    override fun clearScreen(sourceLine: Int) = log("display off")

    override fun isPressed(port: Int): Boolean {
        val first = if (port == 1) 1500 else 2700
        return milliseconds % 4000 in first..<first + 300
    }

    override fun light(port: Int): Int = if (milliseconds % 2600 >= 1300) 20 else 60

    override fun value(port: Int): Int = light(port)

    override fun isHeld(button: BrickButton, sourceLine: Int): Boolean {
        val first = when (button) {
            BrickButton.LEFT, BrickButton.PRGM -> 600
            BrickButton.RIGHT, BrickButton.VIEW -> 1200
            else -> 1800
        }
        return milliseconds % 3000 in first..<first + 400
    }

    override fun batteryVolts(sourceLine: Int): Float = 7.5f

    override fun measureDistance(port: Int, sourceLine: Int) = Unit

    override fun hasDistance(port: Int): Boolean = true

    override fun distance(port: Int): Int = if (milliseconds % 5000 >= 3000) 15 else 90

    override fun loudness(port: Int): Int = if (milliseconds % 3000 >= 2000) 80 else 10

    override fun colour(port: Int): Int = COLOURS[(milliseconds / 700 % 6).toInt()].number

    override fun turned(motor: MotorPort): Int = motor(motor.name.single()).angle()

    private inner class RecordedMotor(private val port: Char) {
        var speed = PybricksFigures.speedOf(PybricksFigures.FIRST_POWER)
        private var rest = 0
        private var speedNow = 0
        private var since = 0L
        private var until = 0L

        val isMoving: Boolean get() = milliseconds < until

        fun angle(): Int = rest + Math.floorDiv(speedNow * (milliseconds - since), 1000L).toInt()

        private fun stand() {
            rest = angle()
            speedNow = 0
            since = milliseconds
            until = 0
        }

        fun stand(call: String) {
            stand()
            log("motor $port $call")
        }

        fun run(speed: Int) {
            stand("run $speed")
            speedNow = speed
        }

        fun runTo(target: Int, call: String) {
            stand(call)
            until = milliseconds + abs(target - rest) * MS_OF_TURN
            rest = target
        }

        fun turn(degrees: Int) = runTo(angle() + degrees, "run_angle ${PybricksFigures.TURNING_SPEED} $degrees")

        fun reset() {
            stand("reset_angle 0")
            rest = 0
        }
    }

    private companion object {
        const val HUNDREDTH = 10
        const val MILLIMETRES = 10

        /** How long a millimetre or a degree of the base takes in the fake modules, and a degree of a motor. */
        const val MS_OF_MOVE = 5
        const val MS_OF_TURN = 2
        val COLOURS = listOf("WHITE", "RED", "BLACK", "YELLOW", "BLUE", "GREEN").map(PaintColour::valueOf)
    }
}
