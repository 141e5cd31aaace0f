//// PILOT_FIELD

/** The diameter of the wheels in cm: let the robot draw 100 cm and correct it. */
static final float WHEEL_DIAMETER = @WHEEL_DIAMETER@;

/** How far apart the wheels are, in cm: let the robot turn ten times round and correct it. */
static final float TRACK_WIDTH = @TRACK_WIDTH@;

static final Pilot pilot = new Pilot(WHEEL_DIAMETER, TRACK_WIDTH, Motor.@LEFT_MOTOR@, Motor.@RIGHT_MOTOR@);

//// PILOT

/** Drives like a DifferentialPilot of leJOS, but keeps what is left of a degree for the next move. */
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
    void travel(float distance)@THROWS@ {
        turnWheels(distance * degreesPerCentimetre, distance * degreesPerCentimetre);
    }

    /** Turns on the spot by so many degrees to the left, or to the right if there is a minus. */
    void rotate(float angle)@THROWS@ {
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
    void stop()@THROWS@ {
        left.stop(true);
        right.stop(true);
        waitComplete();
    }

    /** Sets how many degrees the wheels turn in a second. */
    void setSpeed(int speed) {
        left.setSpeed(speed);
        right.setSpeed(speed);
    }

    private void turnWheels(float leftDegrees, float rightDegrees)@THROWS@ {
        if (Math.abs(left.getPosition() - leftGoal) > 1) leftGoal = left.getPosition();
        if (Math.abs(right.getPosition() - rightGoal) > 1) rightGoal = right.getPosition();
        leftGoal += leftDegrees;
        rightGoal += rightDegrees;
        left.rotateTo(Math.round(leftGoal), true);
        right.rotateTo(Math.round(rightGoal), true);
        waitComplete();
    }

    private void waitComplete()@THROWS@ {
@WAITING@
    }
}

//// WAITING

        left.waitComplete();
        right.waitComplete();

//// WAITING, reacting

        while ((left.isMoving() || right.isMoving()) && !mustGiveWay()) Thread.sleep(1);
        if (left.isMoving()) left.stop(true);
        if (right.isMoving()) right.stop(true);
        giveWay();
