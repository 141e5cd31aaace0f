package josx.platform.rcx;

/** A motor with a rotation sensor that turns to a position and stops there. */
public class Servo implements SensorListener {
    private static final int FULL_POWER = 7;

    private final Motor motor;
    private final int slack;
    private int position;
    private int target;

    /** Makes one whose position now is 0. */
    public Servo(Sensor sensor, Motor motor) {
        this(sensor, motor, 0);
    }

    /** Makes one that is content if it is wrong by no more than the slack. */
    public Servo(Sensor sensor, Motor motor, int slack) {
        this.motor = motor;
        this.slack = slack;
        sensor.addSensorListener(this);
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_ROT, SensorConstants.SENSOR_MODE_ANGLE);
        sensor.setPreviousValue(0);
        sensor.activate();
    }

    /** Begins to turn to a position, in sixteenths of the sensor's turns, and says whether it is there already. */
    public synchronized boolean rotateTo(int position) {
        target = position;
        motor.setPower(FULL_POWER);
        int way = target - this.position;
        // As on a brick, a small step backward of less than the slack begins forward, too.
        if (way < slack) {
            motor.forward();
        } else if (way > slack) {
            motor.backward();
        } else {
            return true;
        }
        return false;
    }

    /** Is called when the sensor counts; stops the motor where it should be and wakes who waits for the servo. */
    public synchronized void stateChanged(Sensor sensor, int oldValue, int newValue) {
        position = newValue;
        int way = target - newValue;
        if (way > slack || way < -slack) return;
        motor.stop();
        notifyAll();
    }
}
