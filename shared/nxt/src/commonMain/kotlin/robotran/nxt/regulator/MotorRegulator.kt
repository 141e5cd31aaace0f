package robotran.nxt.regulator

/**
 * Brings one motor where it should be, whatever the load is. The brick calls [tick] every [PERIOD]. A program acts on
 * it through calls of the brick, so that they appear in the log, and reads it here.
 */
class MotorRegulator(private val motor: RegulatedMotor) {
    private val plan = MotorPlan()
    private val control = PowerControl()
    private var state = State.FREE
    private var holds = true

    // The move after the motor has stopped.
    private var hasNext = false
    private var nextSpeed = 0f
    private var nextLimit = 0

    /** Milliseconds since the motor should stand or, if it rolls, until it should. */
    private var settleTime = 0

    private var stallError = STALL_ERROR
    private var stallCycles = STALL_CYCLES
    private var stalledFor = 0

    /** Whether something has kept the motor from going on, so that its last move has ended. */
    var isStalled = false
        private set

    /** Whether it sets the motor's power. */
    val isActive: Boolean get() = state != State.FREE && state != State.ROLLING

    /** Whether the motor is on its way, or settling at its end. */
    val isMoving: Boolean get() = state == State.MOVING || state == State.SETTLING || state == State.ROLLING

    /** Whether the motor goes on, rather than stopping or settling where it should be. */
    val isDriving: Boolean get() = state == State.MOVING && (hasNext || nextSpeed != 0f)

    /** Where the motor should be, in degrees. */
    val position: Float get() = if (isActive) plan.position else motor.tachoCount.toFloat()

    /** How fast the motor should be, in degrees a second; below 0 is backward. */
    val velocity: Float get() = if (isActive) plan.velocity else 0f

    /** Where the move ends, in degrees; [FORWARD] or [BACKWARD] if nowhere. */
    val limit: Int get() = if (hasNext) nextLimit else plan.limit

    /**
     * Begins a move, or stops if [speed] is 0 and there is no limit. A motor that is under way to the other side, or
     * too fast for the limit, stops first.
     *
     * @param speed degrees a second; a minus does not matter.
     * @param acceleration degrees a second squared.
     * @param limit degrees where the move ends, or [FORWARD] or [BACKWARD].
     * @param hold whether the motor is held where it ends; otherwise it then rolls.
     * @return whether the motor was standing.
     */
    fun start(speed: Float, acceleration: Int, limit: Int, hold: Boolean): Boolean {
        val wasStanding = !isMoving
        if (!isActive) takeOver()
        plan.accelerateBy(size(acceleration.toFloat()))
        isStalled = false
        stalledFor = 0
        hasNext = false
        holds = hold
        state = State.MOVING
        nextSpeed = size(speed)
        if (nextSpeed == 0f && (limit == FORWARD || limit == BACKWARD)) {
            plan.stop()
        } else if (plan.canReach(limit)) {
            plan.go(nextSpeed, limit)
        } else {
            hasNext = true
            nextLimit = limit
            plan.stop()
        }
        return wasStanding
    }

    /** Changes the speed, in degrees a second, of a move that goes on. */
    fun setSpeed(speed: Float) {
        nextSpeed = size(speed)
        if (state == State.MOVING) plan.setSpeed(nextSpeed)
    }

    /** Changes the acceleration, in degrees a second squared, of a move that goes on. */
    fun setAcceleration(acceleration: Int) = plan.accelerateBy(size(acceleration.toFloat()))

    /** Lets the motor roll. It counts as moving for as long as it would need to brake. */
    fun roll() {
        hasNext = false
        if (!isActive || state == State.HOLDING) {
            suspend()
            return
        }
        motor.control(0, brakes = false)
        val speed = size(plan.velocity)
        settleTime = if (plan.acceleration > 0) (MILLISECONDS * speed / plan.acceleration).toInt() else 0
        state = State.ROLLING
    }

    /** Lets the motor roll and stops regulating at once. Returns whether the motor was regulated. */
    fun suspend(): Boolean {
        val wasRegulated = state != State.FREE
        motor.control(0, brakes = false)
        state = State.FREE
        hasNext = false
        plan.stand()
        return wasRegulated
    }

    /**
     * Sets when a motor counts as stalled: when it has been more than [error] degrees behind for [milliseconds]. 50
     * degrees and 4,000 milliseconds if nobody sets it.
     */
    fun setStallThreshold(error: Int, milliseconds: Int) {
        stallError = error.toFloat()
        stallCycles = milliseconds / PERIOD
    }

    /** The motor's counter is about to be set to 0. */
    fun countReset() = plan.shift(motor.tachoCount)

    /** Back to what a program finds when it starts; leaves the motor alone. */
    internal fun reset() {
        state = State.FREE
        isStalled = false
        hasNext = false
        plan.standAt(0)
        stallError = STALL_ERROR
        stallCycles = STALL_CYCLES
    }

    /** Looks where the motor is and sets its power. */
    fun tick() {
        when (state) {
            State.FREE -> return
            State.ROLLING -> rollOn()
            State.MOVING -> moveOn()
            State.SETTLING, State.HOLDING -> regulate()
        }
    }

    private fun rollOn() {
        settleTime -= PERIOD
        if (settleTime <= 0) {
            state = State.FREE
            plan.stand()
        }
    }

    private fun moveOn() {
        val error = plan.error(motor.tachoCount)
        if (error > stallError || error < -stallError) {
            stalledFor++
            if (stalledFor > stallCycles) return stall()
        } else {
            stalledFor = stalledFor shr 1
            if (plan.isOver || plan.advance(SECONDS)) arrive()
        }
        regulate()
    }

    /** The motor should stand now: begins the next move, or waits until the motor really stands. */
    private fun arrive() {
        if (hasNext) {
            hasNext = false
            plan.go(nextSpeed, nextLimit)
        } else {
            state = State.SETTLING
            plan.standAt(plan.nearestDegrees)
            settleTime = 0
        }
    }

    private fun regulate() {
        val error = plan.error(motor.tachoCount)
        motor.control(control.power(error, isHolding = state == State.HOLDING), brakes = true)
        if (state == State.SETTLING) settle(error)
    }

    private fun settle(error: Float) {
        val isNear = settleTime >= SETTLE_TIME && error < NEAR && error > -NEAR
        if (isNear || settleTime > LONGEST_SETTLE_TIME) end() else settleTime += PERIOD
    }

    private fun stall() {
        isStalled = true
        takeOver()
        hasNext = false
        end()
    }

    private fun end() {
        if (holds) state = State.HOLDING else suspend()
    }

    private fun takeOver() {
        plan.standAt(motor.tachoCount)
        control.reset()
    }

    private enum class State { FREE, ROLLING, HOLDING, MOVING, SETTLING }

    companion object {
        /** Milliseconds from one [tick] to the next. */
        const val PERIOD = 4

        /** The limit of a move forward without end. */
        const val FORWARD = 0x7FFFFFFF

        /** The limit of a move backward without end. */
        const val BACKWARD = -0x7FFFFFFF

        private const val SECONDS = 0.004f
        private const val MILLISECONDS = 1000
        private const val STALL_ERROR = 50f
        private const val STALL_CYCLES = 1000

        /** The milliseconds after which a motor that is near enough has arrived. */
        private const val SETTLE_TIME = 100

        /** The milliseconds after which any motor has arrived. */
        private const val LONGEST_SETTLE_TIME = 500

        /** What is near enough, in degrees. */
        private const val NEAR = 2f

        private fun size(value: Float): Float = if (value < 0) -value else value
    }
}
