// hint: again
import josx.platform.rcx.*;

public class Feeler {
    public static void main(String[] args) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Sensor.S3.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Motor.A.forward();
        Motor.C.forward();
        while (!Sensor.S1.readBooleanValue() && !Sensor.S3.readBooleanValue()) {
            Thread.sleep(5);
        }
        back();
        turnLeft(450);
        drive(1250);
    }

    static void drive(int milliseconds) throws InterruptedException {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(milliseconds);
        Motor.A.stop();
        Motor.C.stop();
    }

    static void turnLeft(int milliseconds) throws InterruptedException {
        Motor.A.backward();
        Motor.C.forward();
        Thread.sleep(milliseconds);
        Motor.A.stop();
        Motor.C.stop();
    }

    static void turnRight(int milliseconds) throws InterruptedException {
        Motor.A.forward();
        Motor.C.backward();
        Thread.sleep(milliseconds);
        Motor.A.stop();
        Motor.C.stop();
    }

    static void back() throws InterruptedException {
        Motor.A.backward();
        Motor.C.backward();
        Thread.sleep(250);
    }
}
