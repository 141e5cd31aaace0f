import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.robotics.RotationNavigator;

public class RotationNavigatorCounts {
    public static void main(String[] arguments) throws InterruptedException {
        RotationNavigator robot = new RotationNavigator(5f, 12f, 1f);
        robot.forward();
        Thread.sleep(200);
        // What rotation sensors would have counted after two turns of the wheels.
        Sensor.S1.setPreviousValue(32);
        Sensor.S3.setPreviousValue(32);
        robot.stop();
        LCD.showNumber(Math.round(robot.getX())); // shows: 31
        robot.backward();
        Thread.sleep(200);
        Sensor.S1.setPreviousValue(-16);
        Sensor.S3.setPreviousValue(-16);
        robot.stop();
        LCD.showNumber(Math.round(robot.getX())); // shows: 16
        robot.gotoPoint(robot.getX(), robot.getY());
        LCD.showNumber(Math.round(robot.getY())); // shows: 0
        System.exit(0);
    }
}
