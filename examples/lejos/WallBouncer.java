import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;
import josx.platform.rcx.SensorListener;

/** Drives around and backs away from whatever a bumper touches. A listener hears of the bumpers. */
public class WallBouncer implements SensorListener {
    private static Sensor touched;

    public static void main(String[] arguments) throws InterruptedException {
        WallBouncer listener = new WallBouncer();
        listen(Sensor.S1, listener);
        listen(Sensor.S3, listener);
        while (true) {
            Motor.A.forward();
            Motor.C.forward();
            synchronized (listener) {
                while (touched == null) listener.wait();
            }
            backAway(touched == Sensor.S1 ? Motor.C : Motor.A);
            touched = null;
        }
    }

    public synchronized void stateChanged(Sensor source, int oldValue, int newValue) {
        if (newValue == 0) return;
        touched = source;
        notify();
    }

    static void listen(Sensor bumper, WallBouncer listener) {
        bumper.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        bumper.addSensorListener(listener);
    }

    /** The motor that goes on backward for longer turns the robot away. */
    static void backAway(Motor longer) throws InterruptedException {
        Motor.A.backward();
        Motor.C.backward();
        Thread.sleep(500);
        Motor.A.stop();
        Motor.C.stop();
        longer.backward();
        Thread.sleep(400);
        longer.stop();
    }
}
