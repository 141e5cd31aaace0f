// Visits three places and comes home. The navigator works out how far
// to turn and to drive.
// Next: draw the way with the pen.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.robotics.TimingNavigator;

public class Journey {
    static final float SECONDS_PER_METRE = 5.0f;
    static final float SECONDS_PER_TURN = 1.8f;

    public static void main(String[] args) {
        // The right motor stands before the left one.
        TimingNavigator robot = new TimingNavigator(Motor.C, Motor.A, SECONDS_PER_METRE, SECONDS_PER_TURN);
        robot.gotoPoint(30, 0);
        robot.gotoPoint(30, 20);
        robot.gotoPoint(0, 20);
        robot.gotoPoint(0, 0);
        robot.gotoAngle(0);
        LCD.showNumber((int) robot.getAngle());
    }
}
