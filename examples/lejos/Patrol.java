// Walks to and fro until the left bumper is touched: the activity with
// the higher priority then has the robot for a while.
// Next: add an activity that is more important than both.

import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;
import josx.platform.rcx.SensorListener;
import josx.platform.rcx.Sound;
import josx.robotics.Activity;
import josx.robotics.StopException;

public class Patrol {
    public static void main(String[] args) throws InterruptedException {
        Walk walk = new Walk();
        walk.setPriority(3);
        walk.start();
        Alarm alarm = new Alarm();
        alarm.setPriority(6);
        alarm.start();
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Sensor.S1.addSensorListener(alarm);
        Thread.sleep(60000); // then the program ends
    }

    /** Always wants the robot. */
    static class Walk extends Activity {
        protected void resetRunnable() {
            super.resetRunnable();
            iWantToRun();
        }

        protected void action() throws StopException {
            while (true) {
                try {
                    Motor.A.forward();
                    Motor.C.forward();
                    pause(2000);
                    Motor.A.backward();
                    Motor.C.backward();
                    pause(2000);
                } catch (InterruptedException calledAgain) {
                    // It begins with the first leg.
                }
            }
        }
    }

    /** Wants the robot when the bumper is touched. */
    static class Alarm extends Activity implements SensorListener {
        public void stateChanged(Sensor bumper, int oldValue, int newValue) {
            if (newValue == 1) iWantToRun();
        }

        protected void action() throws StopException {
            Motor.A.stop();
            Motor.C.stop();
            Sound.buzz();
            try {
                pause(1500);
            } catch (InterruptedException calledAgain) {
                Sound.beep();
            }
        }
    }
}
