package josx.platform.rcx;

/**
 * A motor with a rotation sensor that turns to a position and stops there.
 *
 * <p>As on a brick, it turns forward to a position that lies less than the slack ahead, and so to all behind it. Give it a slack of 0 if it is
 * to stay where it is right already.
 */
public class Servo implements SensorListener {
    private static final int FULL_POWER = 7;

    private final Sensor sensor;
    private final Motor motor;
    private final int slack;
    private int target;
    private boolean isOnItsWay;

    /** Makes one whose position now is 0. */
    public Servo(Sensor sensor, Motor motor) {
        this(sensor, motor, 0);
    }

    /** Makes one whose position now is 0 and that may stop so many counts too early. */
    public Servo(Sensor sensor, Motor motor, int slack) {
        this.sensor = sensor;
        this.motor = motor;
        this.slack = slack;
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_ROT, SensorConstants.SENSOR_MODE_ANGLE);
        sensor.setPreviousValue(0);
        sensor.activate();
        sensor.addSensorListener(this);
    }

    /** Begins to turn to a position, sixteen counts a turn of the sensor, and says whether it is there already. */
    public synchronized boolean rotateTo(int position) {
        int ahead = position - sensor.readValue();
        target = position;
        isOnItsWay = ahead != slack;
        motor.setPower(FULL_POWER);
        if (ahead < slack) motor.forward();
        if (ahead > slack) motor.backward();
        return !isOnItsWay;
    }

    /** Is called when the sensor counts; stops the motor at the position and wakes who waits for the servo. */
    public synchronized void stateChanged(Sensor source, int oldValue, int newValue) {
        if (!isOnItsWay || Math.abs(target - newValue) > slack) return;
        isOnItsWay = false;
        motor.stop();
        notifyAll();
    }
}
