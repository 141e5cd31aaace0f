package lejos.robotics.navigation;

import java.util.ArrayList;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * Drives a robot with a motor for each of two wheels.
 *
 * <p>The diameter of the wheels and the distance between them are given in any unit; all other distances are in the
 * same unit then.
 */
public class DifferentialPilot implements ArcRotateMoveController, LineFollowingMoveController,
        RegulatedMotorListener {
    private static final double PART_OF_MAXIMUM = 0.8;
    private static final int QUICK = 9999;

    /** The left motor. */
    protected final RegulatedMotor _left;

    /** The right motor. */
    protected final RegulatedMotor _right;

    /** The motor of the outer wheel of the last curve, or null. */
    protected RegulatedMotor _outside;

    /** How many degrees the left wheel turns for 1. */
    protected final float _leftDegPerDistance;

    /** How many degrees the right wheel turns for 1. */
    protected final float _rightDegPerDistance;

    /** The kind of the present move. */
    protected Move.MoveType _type = Move.MoveType.STOP;

    /** How many degrees each wheel turns for 1 degree of the robot. */
    private final float leftTurnRatio;
    private final float rightTurnRatio;
    private final float leftDiameter;
    private final float trackWidth;

    /** -1 if the motors turn the wheels backward. */
    private final int parity;

    private final ArrayList<MoveListener> listeners = new ArrayList<MoveListener>();
    private float travelSpeed;
    private float rotateSpeed;
    private int acceleration;
    private double minRadius;
    private int leftStart;
    private int rightStart;
    private float plannedDistance;
    private float plannedAngle;
    private boolean isUnderWay;

    /** Whether the present move was begun by steer or steerBackward, so that the next of them goes on with it. */
    private boolean isSteering;

    /** Makes one of the diameter of the wheels, how far they are apart, and the motors. */
    public DifferentialPilot(double wheelDiameter, double trackWidth, RegulatedMotor leftMotor,
            RegulatedMotor rightMotor) {
        this(wheelDiameter, trackWidth, leftMotor, rightMotor, false);
    }

    /** Makes one, and says whether the motors turn the wheels backward. */
    public DifferentialPilot(double wheelDiameter, double trackWidth, RegulatedMotor leftMotor,
            RegulatedMotor rightMotor, boolean reverse) {
        this(wheelDiameter, wheelDiameter, trackWidth, leftMotor, rightMotor, reverse);
    }

    /** Makes one with a diameter for each wheel, and says whether the motors turn the wheels backward. */
    public DifferentialPilot(double leftWheelDiameter, double rightWheelDiameter, double trackWidth,
            RegulatedMotor leftMotor, RegulatedMotor rightMotor, boolean reverse) {
        _left = leftMotor;
        _right = rightMotor;
        _left.addListener(this);
        _right.addListener(this);
        leftDiameter = (float) leftWheelDiameter;
        _leftDegPerDistance = (float) (360 / (Math.PI * leftWheelDiameter));
        _rightDegPerDistance = (float) (360 / (Math.PI * rightWheelDiameter));
        leftTurnRatio = (float) (trackWidth / leftWheelDiameter);
        rightTurnRatio = (float) (trackWidth / rightWheelDiameter);
        this.trackWidth = (float) trackWidth;
        parity = reverse ? -1 : 1;
        setTravelSpeed(PART_OF_MAXIMUM * getMaxTravelSpeed());
        setRotateSpeed(PART_OF_MAXIMUM * getMaxRotateSpeed());
        setAcceleration((int) (4 * travelSpeed));
    }

    /** Sets how far the robot drives in a second. */
    public void setTravelSpeed(double speed) {
        float old = travelSpeed;
        travelSpeed = (float) speed;
        if (isMoving() && old > 0) {
            float factor = travelSpeed / old;
            setMotorSpeeds(_left.getSpeed() * factor, _right.getSpeed() * factor);
        }
    }

    /** Gives how far the robot drives in a second. */
    public double getTravelSpeed() {
        return travelSpeed;
    }

    /** Gives how far the robot can drive in a second. */
    public double getMaxTravelSpeed() {
        return maxMotorSpeed() / Math.max(_leftDegPerDistance, _rightDegPerDistance);
    }

    /** Sets how many degrees the robot turns in a second. */
    public void setRotateSpeed(double speed) {
        rotateSpeed = (float) speed;
        setMotorSpeeds(rotateSpeed * leftTurnRatio, rotateSpeed * rightTurnRatio);
    }

    /** Gives how many degrees the robot turns in a second. */
    public double getRotateSpeed() {
        return rotateSpeed;
    }

    /** Gives how many degrees the robot can turn in a second. */
    public float getMaxRotateSpeed() {
        return maxMotorSpeed() / Math.max(leftTurnRatio, rightTurnRatio);
    }

    /** Gives how many degrees the robot can turn in a second. */
    public double getRotateMaxSpeed() {
        return getMaxRotateSpeed();
    }

    /** Sets how much faster the robot gets in a second. */
    public void setAcceleration(int acceleration) {
        this.acceleration = acceleration;
        setMotorAccelerations(acceleration);
    }

    /** Gives the radius of the smallest circle that the robot can drive. */
    public double getMinRadius() {
        return minRadius;
    }

    /** Sets the radius of the smallest circle that the robot can drive. */
    public void setMinRadius(double radius) {
        minRadius = radius;
    }

    /** Drives forward until the robot is told otherwise. */
    public void forward() {
        begin(Move.MoveType.TRAVEL, Float.POSITIVE_INFINITY, 0);
        setMotorSpeeds(travelSpeed * _leftDegPerDistance, travelSpeed * _rightDegPerDistance);
        drive(1, 1);
    }

    /** Drives backward until the robot is told otherwise. */
    public void backward() {
        begin(Move.MoveType.TRAVEL, Float.NEGATIVE_INFINITY, 0);
        setMotorSpeeds(travelSpeed * _leftDegPerDistance, travelSpeed * _rightDegPerDistance);
        drive(-1, -1);
    }

    /** Drives so far, backward if there is a minus, and waits until the robot is there. */
    public void travel(double distance) {
        travel(distance, false);
    }

    /** Drives so far, and says whether to go on at once. */
    public void travel(double distance, boolean immediateReturn) {
        if (distance == Double.POSITIVE_INFINITY) {
            forward();
        } else if (distance == Double.NEGATIVE_INFINITY) {
            backward();
        } else {
            begin(Move.MoveType.TRAVEL, (float) distance, 0);
            setMotorSpeeds(travelSpeed * _leftDegPerDistance, travelSpeed * _rightDegPerDistance);
            turnWheels((int) (distance * _leftDegPerDistance), (int) (distance * _rightDegPerDistance), immediateReturn);
        }
    }

    /** Turns by so many degrees, to the right if there is a minus, and waits until that is done. */
    public void rotate(double angle) {
        rotate(angle, false);
    }

    /** Turns by so many degrees, and says whether to go on at once. */
    public void rotate(double angle, boolean immediateReturn) {
        begin(Move.MoveType.ROTATE, 0, (float) angle);
        setMotorSpeeds(rotateSpeed * leftTurnRatio, rotateSpeed * rightTurnRatio);
        turnWheels(-(int) (angle * leftTurnRatio), (int) (angle * rightTurnRatio), immediateReturn);
    }

    /** Turns to the left until the robot is told otherwise; the motors keep the speed that they have. */
    public void rotateLeft() {
        begin(Move.MoveType.ROTATE, 0, Float.POSITIVE_INFINITY);
        drive(-1, 1);
    }

    /** Turns to the right until the robot is told otherwise; the motors keep the speed that they have. */
    public void rotateRight() {
        begin(Move.MoveType.ROTATE, 0, Float.NEGATIVE_INFINITY);
        drive(1, -1);
    }

    /** Stops, and waits until the robot stands. */
    public void stop() {
        _left.stop(true);
        _right.stop(true);
        waitComplete();
    }

    /** Stops as fast as the motors can. */
    public void quickStop() {
        setMotorAccelerations(QUICK);
        stop();
        setMotorAccelerations(acceleration);
    }

    /** Drives forward in a circle, with its centre on the left if there is no minus. */
    public void arcForward(double radius) {
        steer(turnRate(radius), 1, false);
    }

    /** Drives backward in a circle, with its centre on the left if there is no minus. */
    public void arcBackward(double radius) {
        steer(turnRate(radius), -1, false);
    }

    /** Drives in a circle until the robot has turned by so many degrees, and waits until that is done. */
    public void arc(double radius, double angle) {
        arc(radius, angle, false);
    }

    /** Drives in a circle until the robot has turned by so many degrees, and says whether to go on at once. */
    public void arc(double radius, double angle, boolean immediateReturn) {
        if (radius == 0) {
            rotate(angle, immediateReturn);
        } else if (angle == Double.POSITIVE_INFINITY || angle == Double.NEGATIVE_INFINITY) {
            if (angle > 0 == radius > 0) {
                arcForward(radius);
            } else {
                arcBackward(radius);
            }
        } else {
            steer(turnRate(radius), angle, immediateReturn);
        }
    }

    /** Drives so far in a circle, and waits until the robot is there. */
    public void travelArc(double radius, double distance) {
        travelArc(radius, distance, false);
    }

    /** Drives so far in a circle, and says whether to go on at once. */
    public void travelArc(double radius, double distance, boolean immediateReturn) {
        if (radius == Double.POSITIVE_INFINITY || radius == Double.NEGATIVE_INFINITY) {
            travel(distance, immediateReturn);
        } else if (radius == 0) {
            throw new IllegalArgumentException();
        } else {
            arc(radius, distance * 180 / (Math.PI * radius), immediateReturn);
        }
    }

    /**
     * Drives forward in a curve: 0 straight on, 100 round the left wheel, 200 on the spot; below 0 to the right.
     *
     * <p>If the robot is in a curve of steer already, it is the same move: its distance and its degrees count on.
     */
    public void steer(double turnRate) {
        steer(turnRate, 1, true);
    }

    /** Drives backward in a curve; if the robot is in a curve of steer already, it is the same move. */
    public void steerBackward(double turnRate) {
        steer(turnRate, -1, true);
    }

    /** Drives in a curve until the robot has turned by so many degrees, and waits until that is done. */
    public void steer(double turnRate, double angle) {
        steer(turnRate, angle, false);
    }

    /** Drives in a curve until the robot has turned by so many degrees, and says whether to go on at once. */
    public void steer(double turnRate, double angle, boolean immediateReturn) {
        if (angle == 0) return;
        double rate = limited(turnRate);
        if (rate == 0) {
            forward();
            return;
        }
        float ratio = ratio(rate);
        float outer = (float) (angle * trackWidth * 2 / (leftDiameter * (1 - ratio)));
        if (rate < 0) outer = -outer;
        float middle = (float) (Math.toRadians(angle) * trackWidth * (1 + ratio) / (2 * (1 - ratio)));
        begin(Move.MoveType.ARC, rate < 0 ? -middle : middle, (float) angle);
        setSteerSpeeds(rate, ratio);
        int inside = (int) (outer * ratio);
        int outside = (int) outer;
        turnWheels(rate > 0 ? inside : outside, rate > 0 ? outside : inside, immediateReturn);
    }

    /** Says whether the robot moves. */
    public boolean isMoving() {
        return _left.isMoving() || _right.isMoving();
    }

    /** Says whether something keeps one of the motors from moving on. */
    public boolean isStalled() {
        return _left.isStalled() || _right.isStalled();
    }

    /** Counts how far the robot moves from here. */
    public void reset() {
        leftStart = _left.getTachoCount();
        rightStart = _right.getTachoCount();
    }

    /** Gives how far the robot has moved since it began to. */
    public float getMovementIncrement() {
        float leftWay = (_left.getTachoCount() - leftStart) / _leftDegPerDistance;
        float rightWay = (_right.getTachoCount() - rightStart) / _rightDegPerDistance;
        return parity * (leftWay + rightWay) / 2;
    }

    /** Gives by how many degrees the robot has turned since it began to move. */
    public float getAngleIncrement() {
        float leftTurn = (_left.getTachoCount() - leftStart) / leftTurnRatio;
        float rightTurn = (_right.getTachoCount() - rightStart) / rightTurnRatio;
        return parity * (rightTurn - leftTurn) / 2;
    }

    /** Gives how the robot has moved since it began to. */
    public Move getMovement() {
        return new Move(_type, getMovementIncrement(), getAngleIncrement(), travelSpeed, rotateSpeed, isMoving());
    }

    /** Tells a listener from now on when a move begins and ends. */
    public void addMoveListener(MoveListener listener) {
        listeners.add(listener);
    }

    /** Is told by the motors; programs need not call it. */
    public void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stall, long timeStamp) {
    }

    /** Is told by the motors; programs need not call it. */
    public void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stall, long timeStamp) {
        if (stall) {
            _left.stop(true);
            _right.stop(true);
        }
        if (!isMoving()) end();
    }

    /** Ends the present move, and begins one of the kind _type, as far as the last one was planned to go. */
    protected void movementStart(boolean alert) {
        begin(_type, plannedDistance, plannedAngle);
    }

    private void begin(Move.MoveType type, float distance, float angle) {
        if (isMoving()) end();
        reset();
        _type = type;
        plannedDistance = distance;
        plannedAngle = angle;
        isUnderWay = true;
        isSteering = false;
        Move move = new Move(type, distance, angle, travelSpeed, rotateSpeed, true);
        for (MoveListener listener : listeners) listener.moveStarted(move, this);
    }

    private synchronized void end() {
        if (!isUnderWay) return;
        isUnderWay = false;
        isSteering = false;
        Move move = new Move(_type, getMovementIncrement(), getAngleIncrement(), travelSpeed, rotateSpeed, false);
        for (MoveListener listener : listeners) listener.moveStopped(move, this);
    }

    private void waitComplete() {
        do {
            _left.waitComplete();
            _right.waitComplete();
        } while (isMoving());
    }

    private void turnWheels(int leftAngle, int rightAngle, boolean immediateReturn) {
        _left.rotate(parity * leftAngle, true);
        _right.rotate(parity * rightAngle, true);
        if (!immediateReturn) waitComplete();
    }

    private void drive(int leftDirection, int rightDirection) {
        drive(_left, parity * leftDirection);
        drive(_right, parity * rightDirection);
    }

    private static void drive(RegulatedMotor motor, int direction) {
        if (direction > 0) {
            motor.forward();
        } else if (direction < 0) {
            motor.backward();
        } else {
            motor.stop(true);
        }
    }

    private void steer(double turnRate, int direction, boolean goesOn) {
        double rate = limited(turnRate);
        if (rate == 0) {
            if (direction > 0) {
                forward();
            } else {
                backward();
            }
            return;
        }
        float ratio = ratio(rate);
        float way = direction > 0 ? Float.POSITIVE_INFINITY : Float.NEGATIVE_INFINITY;
        if (!goesOn || !isSteering) begin(Move.MoveType.ARC, way, rate > 0 ? way : -way);
        isSteering = goesOn;
        setSteerSpeeds(rate, ratio);
        int inside = ratio > 0 ? direction : ratio < 0 ? -direction : 0;
        drive(rate > 0 ? inside : direction, rate > 0 ? direction : inside);
    }

    private static double limited(double turnRate) {
        return turnRate > 200 ? 200 : turnRate < -200 ? -200 : turnRate;
    }

    /** How fast the inner wheel is, compared with the outer one. */
    private static float ratio(double rate) {
        return (float) (1 - Math.abs(rate) / 100);
    }

    private void setSteerSpeeds(double rate, float ratio) {
        _outside = rate > 0 ? _right : _left;
        float outer = travelSpeed * (rate > 0 ? _rightDegPerDistance : _leftDegPerDistance);
        float inner = outer * Math.abs(ratio);
        setMotorSpeeds(rate > 0 ? inner : outer, rate > 0 ? outer : inner);
    }

    private double turnRate(double radius) {
        double width = radius < 0 ? -trackWidth : trackWidth;
        return 200 * trackWidth / (2 * radius + width);
    }

    private float maxMotorSpeed() {
        return Math.min(_left.getMaxSpeed(), _right.getMaxSpeed());
    }

    private void setMotorSpeeds(float leftSpeed, float rightSpeed) {
        _left.setSpeed(Math.round(leftSpeed));
        _right.setSpeed(Math.round(rightSpeed));
    }

    private void setMotorAccelerations(int acceleration) {
        _left.setAcceleration(Math.round(acceleration * _leftDegPerDistance));
        _right.setAcceleration(Math.round(acceleration * _rightDegPerDistance));
    }
}
