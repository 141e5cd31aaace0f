package robotran.robolang.translate

/**
 * The class that drives in the Java for an NXT. Its methods are called as those of leJOS's `DifferentialPilot`, which
 * cuts off what is left of a degree: after a hundred moves that shows.
 */
internal object NxtPilotTexts {
    /** [isReacting] lets a behaviour take over from a move. */
    fun pilot(isReacting: Boolean): String {
        val throws = if (isReacting) " throws InterruptedException" else ""
        val waiting = if (isReacting) WAITING_IN_CONTROL else WAITING
        return CLASS.replace("THROWS", throws).replace("WAITING", waiting)
    }

    private const val CLASS =
        """/** Drives like a DifferentialPilot of leJOS, but keeps what is left of a degree for the next move. */
static class Pilot {
    private final float degreesPerCentimetre;
    private final float degreesPerDegree;
    private final NXTRegulatedMotor left;
    private final NXTRegulatedMotor right;
    private float leftGoal;
    private float rightGoal;

    Pilot(float wheelDiameter, float track, NXTRegulatedMotor left, NXTRegulatedMotor right) {
        degreesPerCentimetre = 360 / (3.1415927f * wheelDiameter);
        degreesPerDegree = track / wheelDiameter;
        this.left = left;
        this.right = right;
    }

    /** Drives so many centimetres ahead, or back if there is a minus. */
    void travel(float distance)THROWS {
        turnWheels(distance * degreesPerCentimetre, distance * degreesPerCentimetre);
    }

    /** Turns on the spot by so many degrees to the left, or to the right if there is a minus. */
    void rotate(float angle)THROWS {
        turnWheels(-angle * degreesPerDegree, angle * degreesPerDegree);
    }

    void forward() {
        left.forward();
        right.forward();
    }

    void backward() {
        left.backward();
        right.backward();
    }

    void rotateLeft() {
        left.backward();
        right.forward();
    }

    void rotateRight() {
        left.forward();
        right.backward();
    }

    /** Stops the wheels and waits until they stand. */
    void stop()THROWS {
        left.stop(true);
        right.stop(true);
        waitComplete();
    }

    /** Sets how many degrees the wheels turn in a second. */
    void setSpeed(int speed) {
        left.setSpeed(speed);
        right.setSpeed(speed);
    }

    private void turnWheels(float leftDegrees, float rightDegrees)THROWS {
        if (Math.abs(left.getPosition() - leftGoal) > 1) leftGoal = left.getPosition();
        if (Math.abs(right.getPosition() - rightGoal) > 1) rightGoal = right.getPosition();
        leftGoal += leftDegrees;
        rightGoal += rightDegrees;
        left.rotateTo(Math.round(leftGoal), true);
        right.rotateTo(Math.round(rightGoal), true);
        waitComplete();
    }

    private void waitComplete()THROWS {
WAITING
    }
}"""

    private const val WAITING = """        left.waitComplete();
        right.waitComplete();"""

    private const val WAITING_IN_CONTROL =
        """        while ((left.isMoving() || right.isMoving()) && !mustGiveWay()) Thread.sleep(1);
        if (left.isMoving()) left.stop(true);
        if (right.isMoving()) right.stop(true);
        giveWay();"""
}
