// Drives ahead until it bumps into something, then turns away from it.
// A listener is told when a bumper is touched.
// Next: let it draw where it drives.

import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;
import josx.platform.rcx.SensorListener;

public class WallBouncer implements SensorListener {
    private Sensor touched;

    public static void main(String[] args) throws InterruptedException {
        WallBouncer robot = new WallBouncer();
        robot.listenTo(Sensor.S1); // left
        robot.listenTo(Sensor.S3); // right
        while (true) {
            Motor.A.forward();
            Motor.C.forward();
            if (robot.awaitTouch() == Sensor.S1) {
                backAway(Motor.A, Motor.C);
            } else {
                backAway(Motor.C, Motor.A);
            }
        }
    }

    private void listenTo(Sensor bumper) {
        bumper.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        bumper.addSensorListener(this);
    }

    public synchronized void stateChanged(Sensor bumper, int oldValue, int newValue) {
        if (newValue == 0) return; // it was let go
        touched = bumper;
        notifyAll();
    }

    synchronized Sensor awaitTouch() throws InterruptedException { // not private: a brick would not lock it
        touched = null;
        while (touched == null) wait();
        return touched;
    }

    /** Drives back, then turns away from the side of the near motor. */
    static void backAway(Motor near, Motor far) throws InterruptedException {
        near.backward();
        far.backward();
        Thread.sleep(250);
        near.forward();
        Thread.sleep(350);
    }
}
