import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.robotics.TimingNavigator;

public class TimingNavigatorFindsPoints {
    public static void main(String[] arguments) {
        TimingNavigator robot = new TimingNavigator(Motor.C, Motor.A, 5f, 3.6f);
        robot.gotoPoint(0, 10);
        LCD.showNumber((int) robot.getAngle()); // shows: 90
        LCD.showNumber(Math.round(robot.getY())); // shows: 10
        robot.gotoPoint(-10, 10);
        LCD.showNumber(-Math.round(robot.getX())); // shows: 10
    }
}
// ends at 2800
