package josx.robotics;

import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;

/** Steers a robot with a rotation sensor at each wheel, which makes it drive straight and stop at the right place. */
public class RotationNavigator implements Navigator {
    private static final int COUNTS_PER_TURN = 16;

    private static final int STOP = 0;
    private static final int FORWARD = 1;
    private static final int BACKWARD = -1;

    private final Motor left;
    private final Motor right;
    private final Sensor leftSensor;
    private final Sensor rightSensor;
    private final float countsPerCentimetre;
    private final float countsPerDegree;
    private final Course course = new Course();
    private int command = STOP;
    private boolean isMoving;

    /** Makes one for motors A, left, and C, right, and sensors 1, left, and 3, right. */
    public RotationNavigator(float wheelDiameter, float driveLength, float ratio) {
        this(wheelDiameter, driveLength, ratio, Motor.A, Motor.C, Sensor.S1, Sensor.S3);
    }

    /**
     * Makes one, the left motor and sensor first.
     *
     * <p>It has to know how wide a wheel is and how far the wheels are apart, in centimetres, and how many times a sensor turns for each
     * turn of its wheel.
     */
    public RotationNavigator(
        float wheelDiameter, float driveLength, float ratio, Motor left, Motor right, Sensor leftSensor, Sensor rightSensor
    ) {
        this.left = left;
        this.right = right;
        this.leftSensor = leftSensor;
        this.rightSensor = rightSensor;
        prepare(leftSensor);
        prepare(rightSensor);
        countsPerCentimetre = COUNTS_PER_TURN * ratio / (wheelDiameter * (float) Math.PI);
        countsPerDegree = driveLength / wheelDiameter * COUNTS_PER_TURN * ratio / 360f;
        new SteerThread().start();
    }

    /** Gives how far to the front of the beginning the robot stopped last. */
    public float getX() {
        return course.x;
    }

    /** Gives how far to the left of the beginning the robot stopped last. */
    public float getY() {
        return course.y;
    }

    /** Gives where the robot looks, in whole degrees, counted to the left. */
    public float getAngle() {
        return course.angle;
    }

    /** Turns by so many degrees: to the left, or to the right if there is a minus. */
    public void rotate(float angle) {
        course.turn(angle);
        int count = (int) (countsPerDegree * angle);
        restart();
        if (angle > 0f) {
            right.forward();
            left.backward();
            while (leftSensor.readValue() > -count || rightSensor.readValue() < count) Thread.yield();
        } else if (angle < 0f) {
            right.backward();
            left.forward();
            while (leftSensor.readValue() < -count || rightSensor.readValue() > count) Thread.yield();
        }
        right.stop();
        left.stop();
    }

    /** Turns the shorter way until the robot looks there. */
    public void gotoAngle(float angle) {
        rotate(course.wayTo(angle));
    }

    /** Turns to a point and drives there. */
    public void gotoPoint(float x, float y) {
        float direction = course.directionOf(x, y);
        int distance = course.distanceOf(x, y);
        gotoAngle(direction);
        travel(distance);
    }

    /** Drives so many centimetres, backward if there is a minus. */
    public void travel(int distance) {
        int count = (int) (countsPerCentimetre * Math.abs(distance));
        int direction = distance > 0 ? FORWARD : BACKWARD;
        if (distance != 0) {
            drive(direction);
            while (command != STOP && leastCount(direction) < count) Thread.yield();
        }
        stop();
    }

    /** Drives forward until stop is called. */
    public void forward() {
        drive(FORWARD);
    }

    /** Drives backward until stop is called. */
    public void backward() {
        drive(BACKWARD);
    }

    /** Stops, and works out where the robot is now. */
    public void stop() {
        if (command == STOP) return;
        command = STOP;
        while (isMoving) Thread.yield();
        left.stop();
        right.stop();
        course.advance((leftSensor.readValue() + rightSensor.readValue()) / 2 / countsPerCentimetre);
    }

    private static void prepare(Sensor sensor) {
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_ROT, SensorConstants.SENSOR_MODE_ANGLE);
        sensor.setPreviousValue(0);
        sensor.activate();
    }

    private void restart() {
        leftSensor.setPreviousValue(0);
        rightSensor.setPreviousValue(0);
    }

    private void drive(int direction) {
        restart();
        command = direction;
    }

    /** The count of the wheel that is behind. */
    private int leastCount(int direction) {
        return Math.min(direction * leftSensor.readValue(), direction * rightSensor.readValue());
    }

    /** How many counts the left wheel is ahead of the right one. */
    private int lead() {
        return command * (leftSensor.readValue() - rightSensor.readValue());
    }

    private static void turn(Motor motor, int direction) {
        if (direction > 0) {
            motor.forward();
        } else {
            motor.backward();
        }
    }

    /** Keeps the robot straight: it lets the wheel that is ahead roll until the other has caught up. */
    private class SteerThread extends Thread {
        public void run() {
            while (true) {
                while (command != STOP) {
                    steer(command);
                    Thread.yield();
                }
                isMoving = false;
                Thread.yield();
            }
        }

        private void steer(int direction) {
            isMoving = true;
            turn(left, direction);
            turn(right, direction);
            if (lead() > 0) {
                left.flt();
                while (lead() > 0) Thread.yield();
                turn(left, direction);
            }
            if (lead() < 0) {
                right.flt();
                while (lead() < 0) Thread.yield();
                turn(right, direction);
            }
        }
    }
}
