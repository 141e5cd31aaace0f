package lejos.robotics.navigation;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * Drives a robot with wheels that are steered, as a car: one motor drives, the other one steers.
 *
 * <p>It knows three positions of the wheels: straight on, to the left and to the right, each as far as possible. So
 * all curves have the same radius. Distances are in the unit of the wheels' diameter.
 */
public class SteeringPilot implements ArcMoveController, RegulatedMotorListener {
    private static final double TOLERANCE = 0.1;
    private static final int CALIBRATION_SPEED = 100;

    private final RegulatedMotor driveMotor;
    private final RegulatedMotor steeringMotor;
    private final double wheelDiameter;
    private double minRadius;
    private int leftCount;
    private int rightCount;
    private volatile Move move;
    private boolean isMoving;
    private int startCount;
    private MoveListener listener;

    /** Makes one of the wheels' diameter, both motors, the radius of curves, and where the steering motor is in them. */
    public SteeringPilot(double driveWheelDiameter, RegulatedMotor driveMotor, RegulatedMotor steeringMotor,
            double minTurnRadius, int leftTurnTacho, int rightTurnTacho) {
        this.driveMotor = driveMotor;
        this.steeringMotor = steeringMotor;
        driveMotor.addListener(this);
        wheelDiameter = driveWheelDiameter;
        minRadius = minTurnRadius;
        leftCount = leftTurnTacho;
        rightCount = rightTurnTacho;
    }

    /** Turns the steering motor until it stalls on both sides, and back to the middle, from where it counts then. */
    public void calibrateSteering() {
        steeringMotor.setSpeed(CALIBRATION_SPEED);
        steeringMotor.setStallThreshold(10, 100);
        steeringMotor.forward();
        waitForStall();
        int right = steeringMotor.getTachoCount();
        steeringMotor.backward();
        try {
            Thread.sleep(200);
        } catch (InterruptedException e) {
            e.printStackTrace();
        }
        waitForStall();
        int left = steeringMotor.getTachoCount();
        int centre = (left + right) / 2;
        rightCount = right - centre;
        leftCount = left - centre;
        steeringMotor.rotateTo(centre);
        steeringMotor.resetTachoCount();
        steeringMotor.setStallThreshold(50, 1000);
    }

    private void waitForStall() {
        while (!steeringMotor.isStalled()) Thread.yield();
    }

    /** Gives the radius of curves. */
    public double getMinRadius() {
        return minRadius;
    }

    /** Sets the radius of curves. */
    public void setMinRadius(double minTurnRadius) {
        minRadius = minTurnRadius;
    }

    /** Drives in a circle to the left; with a radius below 0 backward to the right, as leJOS NXJ does. */
    public void arcForward(double turnRadius) {
        arc(turnRadius, Double.POSITIVE_INFINITY, true);
    }

    /** Drives backward in a circle to the left; with a radius below 0 forward to the right, as leJOS NXJ does. */
    public void arcBackward(double turnRadius) {
        arc(turnRadius, Double.NEGATIVE_INFINITY, true);
    }

    /** Drives in a circle until the robot has turned by so many degrees, and waits until that is done. */
    public void arc(double turnRadius, double arcAngle) throws IllegalArgumentException {
        if (turnRadius == 0) throw new IllegalArgumentException("SteeringPilot can't do zero radius turns.");
        arc(turnRadius, arcAngle, false);
    }

    /** Drives in a circle until the robot has turned by so many degrees, and says whether to go on at once. */
    public void arc(double turnRadius, double arcAngle, boolean immediateReturn) {
        travelArc(turnRadius, Move.convertAngleToDistance((float) arcAngle, (float) turnRadius), immediateReturn);
    }

    /** Drives so far in a circle, and waits until the robot is there. */
    public void travelArc(double turnRadius, double distance) {
        travelArc(turnRadius, distance, false);
    }

    /** Drives so far in a circle, backward if there is a minus, and says whether to go on at once. */
    public void travelArc(double turnRadius, double distance, boolean immediateReturn) throws IllegalArgumentException {
        if (minRadius - Math.abs(turnRadius) > TOLERANCE) {
            throw new IllegalArgumentException("Turn radius can't be less than " + minRadius);
        }
        if (isMoving) stop();
        double radius = steer(turnRadius);
        float angle = Move.convertDistanceToAngle((float) distance, (float) radius);
        move = new Move((float) distance, angle, true);
        if (Double.isInfinite(distance)) driveMotor.backward();
        driveMotor.rotate((int) (distance * 360 / (wheelDiameter * Math.PI)), immediateReturn);
    }

    /** Turns the wheels, and gives the radius that this makes. */
    private double steer(double radius) {
        if (radius == Double.POSITIVE_INFINITY) {
            steeringMotor.rotateTo(0);
            return radius;
        }
        steeringMotor.rotateTo(radius > 0 ? leftCount : rightCount);
        return radius > 0 ? minRadius : -minRadius;
    }

    /** Drives forward until the robot is told otherwise. */
    public void forward() {
        travel(Double.POSITIVE_INFINITY, true);
    }

    /** Drives backward until the robot is told otherwise. */
    public void backward() {
        travel(Double.NEGATIVE_INFINITY, true);
    }

    /** Drives so far, backward if there is a minus, and waits until the robot is there. */
    public void travel(double distance) {
        travel(distance, false);
    }

    /** Drives so far, and says whether to go on at once. */
    public void travel(double distance, boolean immediateReturn) {
        travelArc(Double.POSITIVE_INFINITY, distance, immediateReturn);
    }

    /** Stops, and waits until the listeners have been told; without a move, it waits for ever, as in leJOS NXJ. */
    public void stop() {
        Move before = move;
        driveMotor.stop();
        while (move == before) Thread.yield();
    }

    /** Says whether the robot moves. */
    public boolean isMoving() {
        return isMoving;
    }

    /** Gives 0; the motor that drives has getMaxSpeed. */
    public double getMaxTravelSpeed() {
        return 0;
    }

    /** Gives 0; the motor that drives has getSpeed. */
    public double getTravelSpeed() {
        return 0;
    }

    /** Does nothing; set the speed of the motor that drives. */
    public void setTravelSpeed(double speed) {
    }

    /** Gives 0. */
    public float getMovementIncrement() {
        return 0;
    }

    /** Gives null. */
    public Move getMovement() {
        return null;
    }

    /** Tells a listener when a move begins and ends; only the last one is told. */
    public void addMoveListener(MoveListener listener) {
        this.listener = listener;
    }

    /** Is told by the motor; programs need not call it. */
    public void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stall, long timeStamp) {
        isMoving = true;
        startCount = tachoCount;
        if (listener != null) listener.moveStarted(move, this);
    }

    /** Is told by the motor; programs need not call it. */
    public void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stall, long timeStamp) {
        isMoving = false;
        float distance = (float) ((tachoCount - startCount) / 360f * Math.PI * wheelDiameter);
        float angle = Move.convertDistanceToAngle(distance, move.getArcRadius());
        move = new Move(distance, angle, false);
        if (listener != null) listener.moveStopped(move, this);
    }
}
