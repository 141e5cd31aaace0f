package josx.robotics;

import josx.platform.rcx.Motor;

/** Steers a robot by the clock: it knows how long the robot takes for a metre and for a full turn. */
public class TimingNavigator implements Navigator {
    private final Motor right;
    private final Motor left;
    private final float millisecondsPerDegree;
    private final float millisecondsPerCentimetre;
    private final Course course = new Course();
    private short momentumDelay;
    private boolean isDriving;
    private int began;
    private Thread traveller;

    /** Makes one with the right motor first, then the left one, the seconds for a metre and the seconds for a full turn. */
    public TimingNavigator(Motor right, Motor left, float secondsPerMetre, float secondsPerTurn) {
        this.right = right;
        this.left = left;
        millisecondsPerDegree = secondsPerTurn / 360f * 1000f;
        millisecondsPerCentimetre = secondsPerMetre / 100f * 1000f;
    }

    /** Adds so many milliseconds to each turn, since a robot is slow to begin one. */
    public void setMomentumDelay(short milliseconds) {
        momentumDelay = milliseconds;
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
        int duration = (int) (millisecondsPerDegree * (angle < 0f ? -angle : angle)) + momentumDelay;
        if (angle > 0f) {
            right.forward();
            left.backward();
        } else if (angle < 0f) {
            left.forward();
            right.backward();
        }
        try {
            Thread.sleep(duration);
        } catch (InterruptedException turnIsOver) {
            // Whoever interrupts a turn wants the robot to stop.
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
        if (distance > 0) {
            forward();
        } else {
            backward();
        }
        traveller = Thread.currentThread();
        try {
            Thread.sleep((int) (millisecondsPerCentimetre * Math.abs(distance)));
            traveller = null;
            stop();
        } catch (InterruptedException stoppedByAnother) {
            traveller = null;
        }
    }

    /** Drives forward until stop is called. */
    public void forward() {
        begin();
        right.forward();
        left.forward();
    }

    /** Drives backward until stop is called. */
    public void backward() {
        begin();
        right.backward();
        left.backward();
    }

    /** Stops, also a drive that another thread waits for, and works out where the robot is now. */
    public void stop() {
        if (traveller != null) traveller.interrupt();
        left.stop();
        right.stop();
        if (!isDriving) return;
        isDriving = false;
        // As on a brick, backward counts as forward.
        course.advance(((int) System.currentTimeMillis() - began) / millisecondsPerCentimetre);
    }

    private void begin() {
        began = (int) System.currentTimeMillis();
        isDriving = true;
    }
}
